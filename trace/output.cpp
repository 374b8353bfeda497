#include "output.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <utility>

namespace vidno {

namespace {

[[noreturn]] void refuse(const std::string& name, const char* what) {
    throw Refused(name + ": " + what + ": " + std::strerror(errno));
}

gzFile open_to_read(const std::string& name) {
    errno = 0;
    if (name == "-") return gzdopen(dup(STDIN_FILENO), "rb");
    if (std::filesystem::is_directory(name)) throw Refused(name + ": is a directory");
    const gzFile file = gzopen(name.c_str(), "rb");
    if (!file) refuse(name, "cannot read");
    return file;
}

}  // namespace

std::string read_file(const std::string& name) {
    std::ostringstream bytes;
    if (name == "-") {
        bytes << std::cin.rdbuf();
    } else {
        if (std::filesystem::is_directory(name)) throw Refused(name + ": is a directory");
        errno = 0;
        std::ifstream in(name, std::ios::binary);
        if (!in) refuse(name, "cannot read");
        bytes << in.rdbuf();
    }
    return std::move(bytes).str();
}

std::string gzipped(std::string_view bytes) {
    z_stream stream{};
    constexpr int gzip_window = 15 + 16;
    if (deflateInit2(&stream, 6, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
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

struct OutputFile::Stream {
    std::FILE* plain = nullptr;
    gzFile packed = nullptr;
};

OutputFile::OutputFile(const std::string& name) : name_(name), stream_(std::make_unique<Stream>()) {
    if (name == "-") {
        stream_->plain = stdout;
        return;
    }
    temporary_ = name + ".part-" + std::to_string(getpid());
    errno = 0;
    // Level 6 and no name or time in the header: the same bytes each time.
    if (name.ends_with(".gz")) {
        stream_->packed = gzopen(temporary_.c_str(), "wb6");
    } else {
        stream_->plain = std::fopen(temporary_.c_str(), "wb");
    }
    if (!stream_->plain && !stream_->packed) refuse(name, "cannot write");
}

OutputFile::~OutputFile() {
    if (temporary_.empty()) return;
    if (stream_->plain) std::fclose(stream_->plain);
    if (stream_->packed) gzclose(stream_->packed);
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view bytes) {
    errno = 0;
    if (stream_->plain) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), stream_->plain) != bytes.size()) refuse(name_, "cannot write");
        return;
    }
    while (!bytes.empty()) {
        const auto part = bytes.substr(0, std::size_t{1} << 30);
        if (gzwrite(stream_->packed, part.data(), unsigned(part.size())) <= 0) refuse(name_, "cannot write");
        bytes.remove_prefix(part.size());
    }
}

void OutputFile::commit() {
    errno = 0;
    if (temporary_.empty()) {
        if (std::fflush(stdout) != 0) refuse("standard output", "cannot write");
        return;
    }
    const bool closed = stream_->plain ? std::fclose(std::exchange(stream_->plain, nullptr)) == 0
                                       : gzclose(std::exchange(stream_->packed, nullptr)) == Z_OK;
    if (!closed) refuse(name_, "cannot write");
    std::error_code error;
    std::filesystem::rename(temporary_, name_, error);
    if (error) throw Refused(name_ + ": cannot write: " + error.message());
    temporary_.clear();
}

/// A file, or none for a text that the buffer holds from the start.
void write_file(const std::string& name, std::string_view bytes) {
    OutputFile file(name);
    file.write(bytes);
    file.commit();
}

struct LineReader::Source {
    gzFile file = nullptr;
    ~Source() {
        if (file) gzclose(file);
    }
};

LineReader::LineReader(std::unique_ptr<Source> source) : source_(std::move(source)) {}
LineReader::LineReader(LineReader&&) noexcept = default;
LineReader::~LineReader() = default;

LineReader::LineReader(const std::string& name) : LineReader(std::make_unique<Source>()) {
    source_->file = open_to_read(name);
}

LineReader LineReader::of_text(std::string text) {
    LineReader reader(std::make_unique<Source>());
    reader.buffer_ = std::move(text);
    return reader;
}

bool LineReader::refill() {
    if (!source_->file) return false;
    buffer_.erase(0, position_);
    position_ = 0;
    constexpr std::size_t block = std::size_t{1} << 16;
    const std::size_t size = buffer_.size();
    buffer_.resize(size + block);
    const int count = gzread(source_->file, buffer_.data() + size, block);
    buffer_.resize(size + std::size_t(std::max(count, 0)));
    if (count < 0) cut_ = true;
    if (count <= 0 && !gzeof(source_->file)) cut_ = true;
    return count > 0;
}

bool LineReader::next(std::string& line) {
    std::size_t searched = position_;
    for (;;) {
        const std::size_t end = buffer_.find('\n', searched);
        if (end != std::string::npos) {
            line.assign(buffer_, position_, end - position_);
            position_ = end + 1;
            return true;
        }
        searched = buffer_.size() - position_;
        if (!refill()) break;
    }
    line.assign(buffer_, position_);
    position_ = buffer_.size();
    if (line.empty()) return false;
    cut_ = true;
    return true;
}

}  // namespace vidno
