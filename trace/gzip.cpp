#include "gzip.h"

#include <isa-l/igzip_lib.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <new>
#include <vector>

namespace vidno {

std::string gzipped(std::string_view bytes) {
    z_stream stream{};
    constexpr int gzip_window = 15 + 16;
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    std::string packed;
    std::string part(std::size_t{1} << 16, '\0');
    int status = Z_OK;
    while (status != Z_STREAM_END) {
        if (stream.avail_in == 0 && !bytes.empty()) {
            const auto given = bytes.substr(0, std::size_t{1} << 30);
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(given.data()));
            stream.avail_in = uInt(given.size());
            bytes.remove_prefix(given.size());
        }
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = uInt(part.size());
        status = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
        packed.append(part, 0, part.size() - stream.avail_out);
    }
    deflateEnd(&stream);
    return packed;
}

/// ISA-L compresses a trace ten times as fast as zlib at level 6; the file is two fifths larger.
struct QuickPacker::Stream {
    explicit Stream(std::FILE* out) : file(out) {
        isal_deflate_init(&stream);
        stream.gzip_flag = IGZIP_GZIP;
        stream.level = 1;
        stream.level_buf = room.data();
        stream.level_buf_size = std::uint32_t(room.size());
    }

    bool pack(std::string_view bytes, bool is_last) {
        stream.next_in = reinterpret_cast<std::uint8_t*>(const_cast<char*>(bytes.data()));
        stream.avail_in = std::uint32_t(bytes.size());
        stream.end_of_stream = is_last ? 1 : 0;
        do {
            stream.next_out = packed.data();
            stream.avail_out = std::uint32_t(packed.size());
            isal_deflate(&stream);
            const std::size_t size = packed.size() - stream.avail_out;
            if (std::fwrite(packed.data(), 1, size, file) != size) return false;
        } while (stream.avail_out == 0);
        return true;
    }

    std::FILE* file;
    isal_zstream stream;
    std::vector<std::uint8_t> room = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
    std::vector<std::uint8_t> packed = std::vector<std::uint8_t>(std::size_t{1} << 16);
};

QuickPacker::QuickPacker(std::FILE* file) : stream_(std::make_unique<Stream>(file)) {}
QuickPacker::~QuickPacker() = default;

bool QuickPacker::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const auto part = bytes.substr(0, std::size_t{1} << 30);
        if (!stream_->pack(part, false)) return false;
        bytes.remove_prefix(part.size());
    }
    return true;
}

bool QuickPacker::finish() { return stream_->pack({}, true); }

struct PackedFile::Stream {
    explicit Stream(gzFile opened) : file(opened) {}
    ~Stream() {
        if (file) gzclose(file);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    gzFile file;
    bool is_cut = false;
};

PackedFile::PackedFile(const std::string& name)
    : stream_(std::make_unique<Stream>(name == "-" ? gzdopen(dup(STDIN_FILENO), "rb") : gzopen(name.c_str(), "rb"))) {}
PackedFile::~PackedFile() = default;
PackedFile::PackedFile(PackedFile&&) noexcept = default;

bool PackedFile::is_open() const { return stream_->file; }

std::size_t PackedFile::read(char* to, std::size_t room) {
    const int count = gzread(stream_->file, to, unsigned(room));
    if (count < 0 || (count == 0 && !gzeof(stream_->file))) stream_->is_cut = true;
    return count > 0 ? std::size_t(count) : 0;
}

bool PackedFile::is_cut() const { return stream_->is_cut; }

}  // namespace vidno
