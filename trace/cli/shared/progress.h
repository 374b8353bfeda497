/// Progress: reports progress on a terminal, and nothing elsewhere.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace vidno::cli {

class Progress {
public:
    explicit Progress(std::string what = {}) : what_(std::move(what)), on_(isatty(STDERR_FILENO) != 0) {}
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Names the current work where nothing is counted.
    void say(const std::string& text) {
        if (!on_) return;
        shown_ = true;
        std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
    }

    /// Clears the line; call it before anything else is written to the terminal.
    void clear() {
        if (shown_) std::fputs("\r\x1b[K", stderr);
        shown_ = false;
    }

    void show(unsigned long long count) {
        if (on_ && is_time()) say(std::to_string(count) + " " + what_);
    }

    /// "N of M", and the estimated time for the rest.
    void show(unsigned long long count, unsigned long long all) {
        if (!on_ || count == 0 || !is_time()) return;
        const std::chrono::duration<double, std::ratio<60>> minutes = last_ - start_;
        const double left = minutes.count() / double(count) * double(all - count);
        const std::string rest = left < 1 ? "less than a minute" : std::to_string(std::lround(left)) + " min";
        say(std::to_string(count) + " of " + std::to_string(all) + " " + what_ + ", " + rest + " left");
    }

private:
    using Clock = std::chrono::steady_clock;

    bool is_time() {
        const auto now = Clock::now();
        if (now - last_ < std::chrono::milliseconds(200)) return false;
        last_ = now;
        return true;
    }

    std::string what_;
    bool on_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

}  // namespace vidno::cli
