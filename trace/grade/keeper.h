/// Keeper: a process between the grader and its programs. However the grader ends, the keeper ends the program and all
/// that it started.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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

/// A process that does pieces of work for this one, one after another. All that the work starts returns to the keeper
/// when its parent ends. The keeper keeps the memory that this process had when it was made, so that a piece of work
/// costs no copy of what has come since.
class Keeper {
public:
    /// `grader` becomes readable when this process ends; the work then has to stop.
    using Texts = std::vector<std::string>;
    using Work = std::function<Texts(const Texts& request, int grader)>;
    explicit Keeper(const Work& work);
    ~Keeper();
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    /// What the work comes to. Throws its Refused, and Refused if the keeper was ended.
    Texts answer_to(const Texts& request);

private:
    Descriptor line_;
    int process_ = -1;
};

/// What the descendants of this process have used together, those that have ended included. Memory that several of them
/// share counts for each of them.
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
