/// Keeper: a process between the grader and a program. However the grader ends, the keeper ends the program and all
/// that it started.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace vidno {

/// Owns a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    int number() const { return number_; }
    void close();

private:
    int number_;
};

/// Why the last system call failed.
std::string system_reason();

/// Does the work in a process of its own, to which all that it starts returns when its parent ends. `grader` becomes
/// readable when the grader ends; the work then has to stop. Returns the result of the work, or throws its Refused.
std::string in_keeper(const std::function<std::string(int grader)>& work);

/// What the descendants of this process use together. Memory that several of them share counts for each of them.
struct Used {
    std::uint64_t memory = 0;  // bytes in memory or swapped out, without those of files
    int processes = 0;         // their threads
    std::chrono::duration<double> time{};
};
Used used_by_descendants();

/// Whether the system tells a process its descendants.
bool can_find_descendants();

/// The first process that this one started and that has not ended; 0 if there is none.
int first_child_of(int process);

/// Ends all descendants of this process and waits for them.
void end_descendants() noexcept;

}  // namespace vidno
