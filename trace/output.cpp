#include "output.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "characters.h"

namespace vidno {

namespace {

[[noreturn]] void refuse(const std::string& name, const char* what) {
    throw Refused(name + ": " + what + ": " + std::strerror(errno));
}

/// The reason may have been lost: a full device is noticed when a buffer is written, which may be long before.
[[noreturn]] void lose(const std::string& name) {
    throw OutputLost((name == "-" ? "standard output" : name) + ": cannot write" +
                     (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
}

std::size_t size_of_mark(std::string_view bytes, const std::string& name) {
    try {
        return bytes.size() - without_mark(bytes).size();
    } catch (const Refused& refused) {
        throw Refused(name + ": " + refused.what());
    }
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
        // The stream would copy a large file several times while it grows. A pipe has no size, and a file in /proc has
        // 0.
        std::error_code error;
        const auto size = std::filesystem::file_size(name, error);
        if (!error && size > 0) {
            std::string whole(size, '\0');
            in.read(whole.data(), std::streamsize(size));
            whole.resize(std::size_t(in.gcount()));
            return whole;
        }
        bytes << in.rdbuf();
    }
    return std::move(bytes).str();
}

std::string read_text(const std::string& name) {
    std::string bytes = read_file(name);
    bytes.erase(0, size_of_mark(bytes, name));
    return bytes;
}

namespace {

/// The name of an unfinished file, for `remove_unfinished_files`.
class Unfinished {
public:
    explicit Unfinished(const std::string& name) {
        for (auto& each : all) {
            const char* none = nullptr;
            if (!each.compare_exchange_strong(none, name.c_str())) continue;
            own_ = &each;
            return;
        }
        throw Refused(name + ": cannot write: too many files are open for writing");
    }
    ~Unfinished() { *own_ = nullptr; }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    static void remove_all() noexcept {
        for (const auto& each : all) {
            if (const char* name = each) unlink(name);
        }
    }

private:
    using Name = std::atomic<const char*>;
    static_assert(Name::is_always_lock_free, "a signal handler reads it");
    static inline std::array<Name, 8> all{};

    Name* own_ = nullptr;
};

}  // namespace

void flush_standard_output() {
    errno = 0;
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout) lose("standard output");
}

void remove_unfinished_files() noexcept { Unfinished::remove_all(); }

struct OutputFile::Stream {
    std::FILE* file = nullptr;
    std::optional<Unfinished> unfinished;
    std::optional<QuickPacker> packer;  // for a file that is packed

    bool write(std::string_view bytes) {
        return packer ? packer->write(bytes) : std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    }
    bool close() {
        const bool packed = !packer || packer->finish();
        return (std::fclose(std::exchange(file, nullptr)) == 0) && packed;
    }
};

OutputFile::OutputFile(const std::string& name, Packing packing) : name_(name), stream_(std::make_unique<Stream>()) {
    if (name == "-") {
        stream_->file = stdout;
        return;
    }
    // A file that is renamed would replace a device or a pipe, even /dev/null.
    std::error_code error;
    const auto found = std::filesystem::status(name, error);
    if (!std::filesystem::exists(found) || std::filesystem::is_regular_file(found)) {
        temporary_ = name + ".part-" + std::to_string(getpid());
        stream_->unfinished.emplace(temporary_);
    }
    errno = 0;
    stream_->file = std::fopen((temporary_.empty() ? name : temporary_).c_str(), "wb");
    if (!stream_->file) refuse(name, "cannot write");
    if (packing == Packing::quick && name.ends_with(".gz")) stream_->packer.emplace(stream_->file);
}

OutputFile::~OutputFile() {
    if (stream_->file && stream_->file != stdout) std::fclose(stream_->file);
    if (temporary_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    stream_->unfinished.reset();
}

void OutputFile::write(std::string_view bytes) {
    errno = 0;
    if (!stream_->write(bytes)) lose(name_);
}

void OutputFile::commit() {
    errno = 0;
    if (stream_->file == stdout) {
        flush_standard_output();
        return;
    }
    if (!stream_->close()) lose(name_);
    if (temporary_.empty()) return;
    std::error_code error;
    std::filesystem::rename(temporary_, name_, error);
    if (error) throw Refused(name_ + ": cannot write: " + error.message());
    stream_->unfinished.reset();
    temporary_.clear();
}

void write_file(const std::string& name, std::string_view bytes, Packing packing) {
    OutputFile file(name, packing);
    file.write(bytes);
    file.commit();
}

/// A file, or none for text that the buffer holds from the start.
struct LineReader::Source {
    std::optional<PackedFile> file;
    std::string name = "text";
};

LineReader::LineReader(std::unique_ptr<Source> source) : source_(std::move(source)) {}
LineReader::LineReader(LineReader&&) noexcept = default;
LineReader::~LineReader() = default;

LineReader::LineReader(const std::string& name) : LineReader(std::make_unique<Source>()) {
    if (name != "-" && std::filesystem::is_directory(name)) throw Refused(name + ": is a directory");
    errno = 0;
    source_->file.emplace(name);
    source_->name = name;
    if (!source_->file->is_open()) refuse(name, "cannot read");
}

bool LineReader::damaged() const { return source_->file && source_->file->is_cut(); }

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
    const std::size_t count = source_->file->read(buffer_.data() + size, block);
    buffer_.resize(size + count);
    if (count == 0 && source_->file->is_cut()) cut_ = true;
    return count > 0;
}

/// Passes over a byte order mark and finds how lines end.
void LineReader::begin() {
    std::size_t end = 0;
    do {
        end = buffer_.find_first_of("\r\n");
    } while ((end == std::string::npos || end + 1 == buffer_.size()) && refill());
    position_ = size_of_mark(buffer_, source_->name);
    const bool has_next = end != std::string::npos && end + 1 < buffer_.size();
    const bool is_cr_alone = has_next && buffer_[end] == '\r' && buffer_[end + 1] != '\n';
    line_end_ = is_cr_alone ? '\r' : '\n';
}

bool LineReader::next(std::string& line) {
    if (line_end_ == '\0') begin();
    std::size_t searched = position_;
    for (;;) {
        const std::size_t end = buffer_.find(line_end_, searched);
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
