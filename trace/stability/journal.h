/// Journal: a file that grows by whole lines, even if the program is killed.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

class Journal {
public:
    /// Begins a file with its first line, or continues one that has it; a partial line at the end, from a run that was
    /// killed, is dropped. Throws Refused, without a change, if the file begins differently, if another program writes
    /// it, or if its file system has no locks.
    Journal(const std::string& name, std::string_view first_line);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    void append(std::string_view line);

private:
    std::string name_;
    int file_;
};

}  // namespace vidno
