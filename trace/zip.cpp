#include "zip.h"

#include <cstddef>
#include <cstdint>

#include "gzip.h"
#include "refused.h"

namespace vidno {

namespace {

constexpr std::size_t most = std::size_t{1}
                             << 31;  // a size is stored in four bytes, and some readers take it as signed

void append(std::string& to, std::uint32_t number, int bytes) {
    for (; bytes > 0; --bytes, number >>= 8) to += char(number & 0xff);
}

/// A file as its two headers describe it.
struct Entry {
    std::string_view name;
    std::string packed;  // a file of gzip
    std::size_t size;    // of the file itself

    // Zip and gzip hold the same data and the same checksum between headers of their own.
    static constexpr std::size_t gzip_header = 10, gzip_checksum = 4, gzip_size = 4;
    std::size_t data_size() const { return packed.size() - gzip_header - gzip_checksum - gzip_size; }
    std::string_view data() const { return std::string_view(packed).substr(gzip_header, data_size()); }
    std::string_view checksum() const {
        return std::string_view(packed).substr(gzip_header + data_size(), gzip_checksum);
    }

    /// The fields that both headers have.
    void append_to(std::string& header) const {
        append(header, 20, 2);  // the version of the format that has compression
        append(header, 0, 2);
        append(header, 8, 2);  // compressed by deflate
        append(header, 0, 2);
        append(header, 1 << 5 | 1, 2);  // 1 January 1980, the first date
        header += checksum();
        append(header, std::uint32_t(data_size()), 4);
        append(header, std::uint32_t(size), 4);
        append(header, std::uint32_t(name.size()), 2);
        append(header, 0, 2);
    }
};

}  // namespace

std::string zipped(const std::vector<std::pair<std::string_view, std::string_view>>& files) {
    std::string archive, directory;
    for (const auto& [name, bytes] : files) {
        const Entry entry{name, gzipped(bytes), bytes.size()};
        if (bytes.size() > most || archive.size() + entry.packed.size() > most)
            throw Refused(std::string(name) + ": too large for an archive");
        const std::size_t place = archive.size();
        archive += "PK\3\4";
        entry.append_to(archive);
        archive.append(name).append(entry.data());
        directory += "PK\1\2";
        append(directory, 20, 2);
        entry.append_to(directory);
        append(directory, 0, 4);
        append(directory, 0, 4);
        append(directory, 0, 2);
        append(directory, std::uint32_t(place), 4);
        directory += name;
    }
    const std::size_t place = archive.size();
    archive += directory + "PK\5\6";
    append(archive, 0, 4);
    for (int times = 0; times < 2; ++times) append(archive, std::uint32_t(files.size()), 2);
    append(archive, std::uint32_t(directory.size()), 4);
    append(archive, std::uint32_t(place), 4);
    append(archive, 0, 2);
    return archive;
}

}  // namespace vidno
