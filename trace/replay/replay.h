/// Replay: a trace in memory, and the state of its run after any step.
///
/// The trace grows at its end while it is read. Each line is checked and its event applied once; the states that are
/// kept on the way make every step quick to reach, in either direction.
#pragma once

#include <memory>
#include <span>
#include <variant>

#include "format/event_reader.h"
#include "format/trace_header.h"
#include "replay/values.h"

namespace vidno {

/// The state of a run of polygons or of curves.
using AnyState = std::variant<State, FloatingHorizonState>;

class Replay {
public:
    /// Why there are fewer steps than the run has: the file ends too early, the run was stopped at a limit of events,
    /// or a line is wrong.
    struct Shortened {
        enum class Why : unsigned char { cut, partial, wrong };
        Why why;
        std::uint64_t line;  // from 1
        std::string reason;  // of a wrong line: its path and the reason
    };

    Replay() = default;
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    /// Adds the next bytes of the file. They may end anywhere. After a wrong line nothing more is added; if the first
    /// line is wrong, the file is not a trace: throws Refused.
    void append(std::string bytes);
    /// There are no more bytes. Throws Refused if the file is not a trace.
    void finish();

    /// Whether the first line was read. The other functions need it.
    bool has_begun() const { return run_ != nullptr; }
    const AnyHeader& header() const { return run_->header; }
    /// The number of steps read so far.
    std::uint64_t length() const { return run_->names.size(); }
    /// The index of each step's event in AllEvents; that of step n is at n - 1.
    std::span<const std::uint8_t> names() const { return run_->names; }
    /// The text of a step's line, without its line feed; 1 <= step <= length().
    std::string_view line(std::uint64_t step) const;
    const std::optional<TraceEnd>& end() const { return run_->reader.end(); }
    const std::optional<Shortened>& shortened() const { return shortened_; }

    /// The state after the first `step` events, at most length(). It changes with the next call.
    const AnyState& seek(std::uint64_t step);
    /// The state of the last seek, at first that before all steps.
    const AnyState& shown() const { return run_->current; }

    /// The event of a step, and the state after it. They stay until the next call; the state that is shown stays as it
    /// is.
    struct Looked {
        EventView event;
        const AnyState& after;
    };
    Looked look_at(std::uint64_t step);

    /// The event of a step alone, until the next call.
    EventView event(std::uint64_t step) { return run_->reader.again(line(step)); }

    /// Appends the values after a step as JSON (values.h), and goes there: from the second call on as they differ from
    /// those of the last one.
    void append_values(Text& out, std::uint64_t step);

private:
    /// Whole lines, each with its line feed.
    struct Block {
        std::uint64_t before;  // the number of steps before its first
        std::string bytes;
        std::vector<std::uint32_t> starts{};  // of each step's line
    };
    struct Run {
        AnyHeader header;
        EventReader reader;
        AnyState end, current;  // after the last step; after the one that is shown
        AnyState beside;        // after one that was looked at
        std::vector<Block> blocks{};
        std::vector<std::uint8_t> names{};
        std::vector<AnyState> keyframes{};  // by step, the beginning first
        std::size_t bytes = 0;              // of lines since the last of these
        std::size_t spacing;                // that many between them
        ValuesText values;
        std::optional<std::variant<State::Values, FloatingHorizonState::Values>>
            written;  // those that were written last

        explicit Run(AnyHeader of);
        const AnyState& kept_before(std::uint64_t step) const;
        std::string_view line(std::uint64_t step) const;
        void go(AnyState& state, std::uint64_t step);
        const Block& block_of(std::uint64_t step) const;
        void keep();
    };

    void read(std::string bytes);
    void read_line(Block& block, std::size_t start, std::size_t end);

    std::unique_ptr<Run> run_;
    std::string rest_;  // a line that has not ended yet
    std::optional<Shortened> shortened_;
};

}  // namespace vidno
