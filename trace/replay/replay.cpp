#include "replay/replay.h"

#include <algorithm>

namespace vidno {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 28;  // bytes

// A seek reads at most the lines between two kept states: at the rate of the reader, these bytes take a fraction of a
// frame.
constexpr std::size_t least_spacing = std::size_t{1} << 16;
constexpr std::size_t most_kept = 512;
constexpr std::size_t most_kept_bytes = std::size_t{1} << 26;

AnyState start_of(const AnyHeader& header) {
    if (const auto* of_polygons = std::get_if<TraceHeader>(&header)) return State(*of_polygons);
    return FloatingHorizonState(std::get<FloatingHorizonHeader>(header));
}

EventContext context_of(const AnyHeader& any) {
    return std::visit(
        [](const auto& header) {
            return EventContext{header.detail, header.kernel == "exact", KnownPolygons(polygon_names(header.scene))};
        },
        any);
}

std::uint64_t step_of(const AnyState& state) {
    return std::visit([](const auto& of_kind) { return of_kind.step(); }, state);
}

void take(AnyState& state, const EventView& event) {
    std::visit([&](auto& of_kind) { of_kind.apply(event); }, state);
}

/// How many states may be kept.
std::size_t most_kept_of(const AnyState& state) {
    const auto* of_polygons = std::get_if<State>(&state);
    const std::size_t bytes = of_polygons ? of_polygons->screen().bytes_of_copy() : 0;
    return std::clamp(most_kept_bytes / (bytes + 1), std::size_t{4}, most_kept);
}

}  // namespace

Replay::Run::Run(AnyHeader of)
    : header(std::move(of)),
      reader(context_of(header), header.index() == 0 ? "picture" : "lines"),
      end(start_of(header)),
      current(end),
      beside(end),
      keyframes{end},
      spacing(least_spacing),
      values(std::visit([](const auto& any) { return polygon_names(any.scene); }, header)) {}

void Replay::append(std::string bytes) {
    if (shortened_) return;
    const auto last = bytes.rfind('\n');
    if (last == bytes.npos) {
        rest_ += bytes;
        if (rest_.size() <= longest_line) return;
        const std::string reason = "a line of more than 256 MiB";
        if (!run_) throw Refused(reason);
        shortened_ = {Shortened::Why::wrong, length() + 2, reason};
        return;
    }
    std::string after = bytes.substr(last + 1);
    bytes.resize(last + 1);
    if (!rest_.empty()) bytes.insert(0, rest_);
    rest_ = std::move(after);
    read(std::move(bytes));
}

void Replay::read(std::string bytes) {
    std::size_t start = 0;
    if (!run_) {
        const auto end = bytes.find('\n');
        run_ = std::make_unique<Run>(read_header(std::string_view(bytes).substr(0, end)));
        start = end + 1;
    }
    Block& block = run_->blocks.emplace_back(Block{length(), std::move(bytes)});
    while (start < block.bytes.size() && !shortened_) {
        const auto end = block.bytes.find('\n', start);
        read_line(block, start, end);
        start = end + 1;
    }
}

void Replay::read_line(Block& block, std::size_t start, std::size_t end) {
    Run& run = *run_;
    const std::uint64_t line = length() + 2 + (run.reader.end() ? 1 : 0);
    try {
        const auto event = run.reader.next(std::string_view(block.bytes).substr(start, end - start));
        if (!event) {
            if (run.reader.end()->partial) shortened_ = {Shortened::Why::partial, line, {}};
            return;
        }
        take(run.end, *event);
        block.starts.push_back(std::uint32_t(start));
        run.names.push_back(std::uint8_t(event->place()));
        run.bytes += end - start;
        if (run.bytes >= run.spacing) run.keep();
    } catch (const Refused& refused) {
        shortened_ = {Shortened::Why::wrong, line, refused.what()};
    } catch (const Impossible& impossible) {
        shortened_ = {Shortened::Why::wrong, line, impossible.reason};
    }
    // After an event that was refused the state may be inconsistent.
    if (shortened_) run.end = run.keyframes.back();
}

void Replay::finish() {
    if (shortened_) return;
    if (!run_) {
        if (rest_.empty()) throw Refused("empty, not a trace");
        run_ = std::make_unique<Run>(read_header(std::exchange(rest_, {})));
    }
    // A last line without a line feed counts if it is whole.
    if (!rest_.empty()) read(std::exchange(rest_, {}) + '\n');
    if (!end()) shortened_ = {Shortened::Why::cut, length() + 2, {}};
}

void Replay::Run::keep() {
    keyframes.push_back(end);
    bytes = 0;
    if (keyframes.size() <= most_kept_of(end)) return;
    for (std::size_t i = 2; i < keyframes.size(); i += 2) keyframes[i / 2] = std::move(keyframes[i]);
    keyframes.erase(keyframes.begin() + std::ptrdiff_t((keyframes.size() + 1) / 2), keyframes.end());
    spacing *= 2;
}

/// The last state that is kept of those at or before the step.
const AnyState& Replay::Run::kept_before(std::uint64_t step) const {
    if (step_of(end) <= step) return end;
    const auto after = [](std::uint64_t goal, const AnyState& state) { return goal < step_of(state); };
    return *std::prev(std::upper_bound(keyframes.begin(), keyframes.end(), step, after));
}

const Replay::Block& Replay::Run::block_of(std::uint64_t step) const {
    const auto after = [](std::uint64_t goal, const Block& block) { return goal <= block.before; };
    return *std::prev(std::upper_bound(blocks.begin(), blocks.end(), step, after));
}

std::string_view Replay::Run::line(std::uint64_t step) const {
    const Block& block = block_of(step);
    const std::size_t start = block.starts[step - 1 - block.before];
    return std::string_view(block.bytes).substr(start, block.bytes.find('\n', start) - start);
}

std::string_view Replay::line(std::uint64_t step) const { return run_->line(step); }

/// Lets a state go to a step.
void Replay::Run::go(AnyState& state, std::uint64_t step) {
    const AnyState& kept = kept_before(step);
    if (step_of(state) > step || step_of(state) < step_of(kept)) state = kept;
    for (std::uint64_t at = step_of(state) + 1; at <= step; ++at) {
        take(state, reader.again(line(at)));
    }
}

const AnyState& Replay::seek(std::uint64_t step) {
    run_->go(run_->current, step);
    return run_->current;
}

Replay::Looked Replay::look_at(std::uint64_t step) {
    Run& run = *run_;
    const bool is_shown = step_of(run.current) == step;
    if (!is_shown) run.go(run.beside, step);
    return {run.reader.again(line(step)), is_shown ? run.current : run.beside};
}

void Replay::append_values(Text& out, std::uint64_t step) {
    std::visit(
        [&](const auto& state) {
            using Values = std::decay_t<decltype(state.values())>;
            run_->values.append(out, state, run_->written ? &std::get<Values>(*run_->written) : nullptr);
            run_->written = state.values();
        },
        seek(step));
}

}  // namespace vidno
