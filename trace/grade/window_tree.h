/// WindowTree: which windows came from which, in whatever order they are looked at, and whether the parts of each cover it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vidno/window.h"

namespace vidno::grading {

class WindowTree {
public:
    explicit WindowTree(const Area& area) : area_(area) {}

    /// A window without parts that cover it, and the step at which its last part was told.
    struct Uncovered {
        Window window;
        int column, row;  // a pixel that no part has
        std::uint64_t step;
    };

    /// A part belongs to the smallest window that was split and holds it: a program that tells a part when its turn comes may have
    /// looked at any others since. A window that waits already may be told again. False if it is no part of any.
    bool push(const Window& window, std::uint64_t step);
    void skip(const Window& window);
    /// The window becomes the current one.
    void pop(const Window& window);
    void split(std::uint64_t step);

    /// What the parts of the current window leave uncovered, if it was split and they come all at once.
    std::optional<Uncovered> uncovered_now() const;
    /// The same for any window.
    std::optional<Uncovered> uncovered() const;

    /// Each part was told when its turn came, and its own parts came right after it.
    bool is_recursive() const { return in_turn_ && !breadth_first_; }
    /// Other windows came between a window and its parts.
    bool is_breadth_first() const { return breadth_first_; }

    /// The parts of the current window, in their order.
    const std::vector<Window>& parts() const { return nodes_[current_].parts; }
    bool empty() const { return nodes_.empty(); }

private:
    struct Node {
        Window window;
        bool split = false;
        bool waits = true;
        std::uint64_t step = 0;
        std::size_t at_once = 0;  // parts that were told while this was the current window
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
