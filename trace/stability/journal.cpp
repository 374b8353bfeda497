#include "stability/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "json/document_format.h"
#include "output.h"
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

}  // namespace

Journal::Journal(const std::string& name, std::string_view first_line) : name_(name), file_(opened(name)) {
    try {
        if (flock(file_, LOCK_EX | LOCK_NB) != 0) throw Refused(name + ": another run is writing it");
        text_ = read_file(name);
        expect_format_in(text_, document_format(first_line), name);
        if (!text_.starts_with(first_line) && !first_line.starts_with(text_)) {
            throw Refused(name + ": belongs to another campaign, or is not a file of results");
        }
        text_.resize(text_.rfind('\n') + 1);  // empty if there is no newline
        if (ftruncate(file_, off_t(text_.size())) != 0) refuse(name);
        if (text_.empty()) append(text_ = first_line);
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
