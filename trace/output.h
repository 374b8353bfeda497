/// Input and output files. An output file appears complete or not at all.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "gzip.h"
#include "refused.h"

namespace vidno {

/// The contents of a file, "-" for standard input. Throws Refused.
std::string read_file(const std::string& name);

/// Reads a text: without its byte order mark, and refused in UTF-16.
std::string read_text(const std::string& name);

/// For a file whose name ends in ".gz": whether to compress it, quickly, or to write bytes that are already compressed.
enum class Packing : unsigned char { quick, done };

/// Writes a temporary file and renames it at `commit`; without that nothing remains. "-" is standard output. A device
/// or a pipe is written to directly. Throws Refused if the system refuses, or if more than eight files are written at
/// once, and OutputLost if the device is full.
class OutputFile {
public:
    explicit OutputFile(const std::string& name, Packing packing = Packing::quick);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void commit();

private:
    struct Stream;

    std::string name_;
    std::string temporary_;  // empty: standard output, a device or a pipe
    std::unique_ptr<Stream> stream_;
};

/// Writes what standard output still buffers. Throws OutputLost if anything that the program printed could not be
/// written.
void flush_standard_output();

/// Removes the temporary files that are not committed. A signal handler may call it.
void remove_unfinished_files() noexcept;

/// Writes a complete output file.
void write_file(const std::string& name, std::string_view bytes, Packing packing = Packing::quick);

/// The lines of a file one by one, gzipped or not, "-" for standard input. All lines end like the first: at LF, or at
/// CR alone. A byte order mark is passed over; text in UTF-16 is refused.
class LineReader {
public:
    /// Throws Refused if the file cannot be opened.
    explicit LineReader(const std::string& name);
    /// Reads a text already in memory.
    static LineReader of_text(std::string text);
    ~LineReader();
    LineReader(LineReader&&) noexcept;

    /// False at the end. A last line without a newline, or truncated compressed data, sets `cut`.
    bool next(std::string& line);
    bool cut() const { return cut_; }
    /// At the end: whether compressed data ended too early or fail their checksum.
    bool damaged() const;

private:
    struct Source;

    explicit LineReader(std::unique_ptr<Source> source);
    void begin();
    bool refill();

    std::unique_ptr<Source> source_;
    std::string buffer_;
    std::size_t position_ = 0;
    char line_end_ = '\0';  // until the first line is read
    bool cut_ = false;
};

}  // namespace vidno
