// A place for the files of a test, and the program as its users call it.

#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

inline std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// A directory that is removed with the test.
struct Workplace {
    std::filesystem::path directory =
        std::filesystem::temp_directory_path() / ("vidno-test-" + std::to_string(getpid()));
    Workplace() { std::filesystem::create_directories(directory); }
    ~Workplace() { std::filesystem::remove_all(directory); }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    std::string file(const std::string& name) const { return (directory / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((directory / name).parent_path());
        std::ofstream(file(name), std::ios::binary) << text;
        return file(name);
    }
    std::string read(const std::string& name) const { return text_of(file(name)); }
    bool has(const std::string& name) const { return std::filesystem::exists(file(name)); }
    /// Temporary files included.
    std::size_t files() const {
        return std::size_t(
            std::distance(std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
    }
};

struct Outcome {
    int status;
    std::string text;  // standard output and error
};

inline Outcome program(const std::string& arguments, const std::string& file = VIDNO_FILE) {
    std::FILE* pipe = popen(("'" + file + "' " + arguments + " 2>&1 </dev/null").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe)) text.append(block.data(), count);
    const int status = pclose(pipe);
    REQUIRE_MESSAGE(WIFEXITED(status), "ended by a signal: " << arguments << '\n' << text);
    return {WEXITSTATUS(status), text};
}
