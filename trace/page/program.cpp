#include "page/program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "refused.h"

namespace vidno {

namespace {

/// Files, unlike pipes, cannot make the two programs wait for each other.
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File temporary_file() {
    File file(std::tmpfile(), std::fclose);
    if (!file) throw Refused(std::string("cannot make a temporary file: ") + std::strerror(errno));
    return file;
}

std::string whole(std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += char(c);
    return text;
}

int run_to_end(const std::vector<std::string>& command, std::FILE* input, std::FILE* output, std::FILE* complaints) {
    std::vector<char*> words;
    for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));  // NOLINT: the call's own type
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, fileno(input), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(output), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(complaints), STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawnp(&child, words[0], &files, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw Refused(command[0] + ": cannot be run: " + std::strerror(error));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// The last line of the text that is not blank; empty if there is none.
std::string last_line(std::string text) {
    text.erase(text.find_last_not_of(" \n") + 1);
    return text.substr(text.rfind('\n') + 1);
}

}  // namespace

std::string output_of(const std::vector<std::string>& command, std::string_view input) {
    const File in = temporary_file();
    const File out = temporary_file();
    std::fwrite(input.data(), 1, input.size(), in.get());
    std::rewind(in.get());  // and is written before
    const File complaints = temporary_file();
    const int status = run_to_end(command, in.get(), out.get(), complaints.get());
    const std::string said = whole(complaints.get());
    if (status != 0) throw Refused(command[0] + (said.empty() ? " failed" : ": " + last_line(said)));
    std::fputs(said.c_str(), stderr);
    return whole(out.get());
}

}  // namespace vidno
