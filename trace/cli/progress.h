/// Progress: what goes on, on a terminal; nothing anywhere else.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace vidno::cli {

class Progress {
public:
    explicit Progress(std::string what = {}) : what_(std::move(what)), on_(isatty(STDERR_FILENO) != 0) {}
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// What is being done where nothing is counted.
    void say(const std::string& text) {
        if (!on_) return;
        shown_ = true;
        std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
    }

    /// Before anything else is written to the terminal.
    void clear() {
        if (shown_) std::fputs("\r\x1b[K", stderr);
        shown_ = false;
    }

    void show(unsigned long long count) {
        if (!on_) return;
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(200)) return;
        last_ = now;
        say(std::to_string(count) + " " + what_);
    }

private:
    std::string what_;
    bool on_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace vidno::cli
