#include "gzip.h"

#include <cstdint>

// Node compresses and expands. Both calls return the size of the result, which `packing_take` then copies to the given
// place. Expanding returns -1 - size if the data are damaged or end too early; what could be read is kept.
#define FROM_NODE(name) [[clang::import_module("vidno"), clang::import_name(name)]] extern "C"
FROM_NODE("packed") std::uint32_t vidno_packed(const char* bytes, std::size_t size);
FROM_NODE("unpacked") std::int32_t vidno_unpacked(const char* bytes, std::size_t size);
FROM_NODE("packing_take") void vidno_packing_take(char* to);
#undef FROM_NODE

namespace vidno {

std::string gzipped(std::string_view bytes) {
    std::string packed(vidno_packed(bytes.data(), bytes.size()), '\0');
    vidno_packing_take(packed.data());
    return packed;
}

struct QuickPacker::Stream {
    explicit Stream(std::FILE* out) : file(out) {}

    std::FILE* file;
    std::string bytes;
};

QuickPacker::QuickPacker(std::FILE* file) : stream_(std::make_unique<Stream>(file)) {}
QuickPacker::~QuickPacker() = default;

bool QuickPacker::write(std::string_view bytes) {
    stream_->bytes += bytes;
    return true;
}

bool QuickPacker::finish() {
    const std::string packed = gzipped(stream_->bytes);
    return std::fwrite(packed.data(), 1, packed.size(), stream_->file) == packed.size();
}

struct PackedFile::Stream {
    bool is_open = false, is_cut = false;
    std::string bytes;
    std::size_t position = 0;
};

namespace {

/// False if the file cannot be read.
bool read_all(std::FILE* file, std::string& bytes) {
    if (!file) return false;
    char part[1 << 16];
    for (std::size_t size; (size = std::fread(part, 1, sizeof part, file)) > 0;) bytes.append(part, size);
    const bool is_read = !std::ferror(file);
    if (file != stdin) std::fclose(file);
    return is_read;
}

}  // namespace

PackedFile::PackedFile(const std::string& name) : stream_(std::make_unique<Stream>()) {
    auto& [is_open, is_cut, bytes, position] = *stream_;
    is_open = read_all(name == "-" ? stdin : std::fopen(name.c_str(), "rb"), bytes);
    if (!bytes.starts_with("\x1f\x8b")) return;
    const std::int32_t size = vidno_unpacked(bytes.data(), bytes.size());
    is_cut = size < 0;
    bytes.resize(std::size_t(is_cut ? -1 - size : size));
    vidno_packing_take(bytes.data());
}
PackedFile::~PackedFile() = default;
PackedFile::PackedFile(PackedFile&&) noexcept = default;

bool PackedFile::is_open() const { return stream_->is_open; }

std::size_t PackedFile::read(char* to, std::size_t room) {
    const std::size_t count = stream_->bytes.copy(to, room, stream_->position);
    stream_->position += count;
    return count;
}

bool PackedFile::is_cut() const { return stream_->is_cut; }

}  // namespace vidno
