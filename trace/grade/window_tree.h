/// WindowTree: records which window each window is part of, in any order of processing, and whether the parts of a
/// window cover it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vidno/window.h"

namespace vidno::grading {

class WindowTree {
public:
    explicit WindowTree(const Area& area) : area_(area) {}

    /// A split window that its parts do not cover, and the step at which its last part came.
    struct Uncovered {
        Window window;
        int column, row;  // the first pixel in none of the parts
        std::uint64_t step;
    };

    /// Adds a window that waits to be processed. Its parent is the smallest split window that contains it, not always
    /// the current one: a program may report a part only just before it processes that part. A waiting window may be
    /// reported again. False if there is no parent.
    bool push(const Window& window, std::uint64_t step);
    /// Adds a part that will not be processed.
    void skip(const Window& window);
    /// The window becomes the current one.
    void pop(const Window& window);
    /// Splits the current window.
    void split(std::uint64_t step);

    /// What the parts of the current window leave uncovered, if the trace has reported at least two of them since it
    /// became current.
    std::optional<Uncovered> uncovered_now() const;
    /// The first of all windows that its parts do not cover.
    std::optional<Uncovered> uncovered() const;

    /// The program processes each part as soon as it reports it, and the part's own parts next.
    bool is_recursive() const { return in_turn_ && !breadth_first_; }
    /// The program processes other windows between a window and its parts.
    bool is_breadth_first() const { return breadth_first_; }

    /// The parts of the current window in the order of the trace.
    const std::vector<Window>& parts() const { return nodes_[current_].parts; }
    bool empty() const { return nodes_.empty(); }

private:
    struct Node {
        Window window;
        bool split = false;
        bool waits = true;
        std::uint64_t step = 0;
        std::size_t at_once = 0;  // the number of parts that came while this was the current window
        std::vector<Window> parts{};
    };

    Node* parent_of(const Window& window);
    std::optional<Uncovered> uncovered(const Node& node) const;

    Area area_;
    std::vector<Node> nodes_;
    std::size_t current_ = 0;
    bool in_turn_ = false, breadth_first_ = false;
};

}  // namespace vidno::grading
