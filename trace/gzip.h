/// Compression by gzip, from the available library: gzip.cpp uses zlib and ISA-L, wasm/gzip.cpp uses Node's.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace vidno {

/// The bytes compressed by gzip at its best level, the same on every machine.
std::string gzipped(std::string_view bytes);

/// Compresses quickly into a file, as one gzip member without a name or a time.
class QuickPacker {
public:
    explicit QuickPacker(std::FILE* file);
    ~QuickPacker();
    QuickPacker(const QuickPacker&) = delete;
    QuickPacker& operator=(const QuickPacker&) = delete;

    /// Both return whether the write succeeded.
    bool write(std::string_view bytes);
    bool finish();

private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
};

/// Reads a file, gzipped or not; "-" is standard input.
class PackedFile {
public:
    explicit PackedFile(const std::string& name);
    ~PackedFile();
    PackedFile(PackedFile&&) noexcept;

    bool is_open() const;
    /// How many bytes were read; 0 at the end.
    std::size_t read(char* to, std::size_t room);
    /// Once `read` has returned 0: whether compressed data ended too early or were damaged.
    bool is_cut() const;

private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
};

}  // namespace vidno
