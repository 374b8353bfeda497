/// Losses: what a command's output lacks. The command writes its output nevertheless, says each loss on standard error,
/// and its exit status is 1.
#pragma once

#include <string>
#include <vector>

#include "format/trace_reader.h"
#include "loss.h"

namespace vidno::cli {

class Losses {
public:
    /// The losses of an input file.
    void add(const std::string& file, const std::vector<Loss>& losses);

    /// Says what has no effect on the output, and for which reason. That is no loss.
    void note(const std::string& file, const std::vector<Loss>& without_effect, const std::string& reason);

    /// After the last event that is needed: what the trace lacks, and what its run lost. Reads on to the end of the
    /// file.
    void add(TraceFile& trace);

    bool any() const { return any_; }

    /// Says them, once the output is written. Returns the exit status.
    int report() const;

private:
    void say(const std::string& file, const std::vector<Loss>& losses);

    bool any_ = false;
    std::vector<std::string> messages_;
};

}  // namespace vidno::cli
