#include "stability/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "json/document_format.h"
#include "refused.h"

namespace vidno {

namespace {

[[noreturn]] void refuse(const std::string& name) { throw Refused(name + ": cannot write: " + std::strerror(errno)); }

int opened(const std::string& name) {
    if (name == "-") throw Refused("-: results need a file, so that an interrupted campaign can continue");
    const int file = open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) refuse(name);
    return file;
}

void lock(int file, const std::string& name) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0) return;
    if (errno == EWOULDBLOCK) throw Refused(name + ": another run is writing it");
    throw Refused(name + ": cannot be locked (" + std::strerror(errno) +
                  "): put the results on a file system that has locks, such as one of this machine");
}

/// The bytes at a place, fewer at the end.
std::string read_at(int file, const std::string& name, off_t place, std::size_t size) {
    std::string bytes(size, '\0');
    std::size_t read = 0;
    while (read < size) {
        const ssize_t count = pread(file, bytes.data() + read, size - read, place + off_t(read));
        if (count < 0 && errno != EINTR) throw Refused(name + ": cannot read: " + std::strerror(errno));
        if (count == 0) break;
        if (count > 0) read += std::size_t(count);
    }
    bytes.resize(read);
    return bytes;
}

/// The size of a file without what follows its last line feed.
off_t size_of_lines(int file, const std::string& name) {
    constexpr off_t block = 1 << 16;
    off_t end = lseek(file, 0, SEEK_END);
    if (end < 0) refuse(name);
    while (end > 0) {
        const off_t begin = std::max<off_t>(0, end - block);
        const std::size_t last = read_at(file, name, begin, std::size_t(end - begin)).rfind('\n');
        if (last != std::string::npos) return begin + off_t(last) + 1;
        end = begin;
    }
    return 0;
}

/// The first bytes of a file, as many as say what kind it is.
constexpr std::size_t most_of_a_format = 4096;

}  // namespace

Journal::Journal(const std::string& name, std::string_view first_line) : name_(name), file_(opened(name)) {
    try {
        lock(file_, name);
        const std::string start = read_at(file_, name, 0, std::max(first_line.size(), most_of_a_format));
        expect_format_in(start, document_format(first_line), name);
        if (!start.starts_with(first_line) && !first_line.starts_with(start)) {
            throw Refused(name + ": belongs to another campaign, or is not a file of results");
        }
        const off_t size = size_of_lines(file_, name);
        if (ftruncate(file_, size) != 0) refuse(name);
        if (size == 0) append(first_line);
    } catch (...) {
        close(file_);
        throw;
    }
}

Journal::~Journal() { close(file_); }

void Journal::append(std::string_view line) {
    while (!line.empty()) {
        const ssize_t written = write(file_, line.data(), line.size());
        if (written < 0 && errno != EINTR) refuse(name_);
        if (written > 0) line.remove_prefix(std::size_t(written));
    }
}

}  // namespace vidno
