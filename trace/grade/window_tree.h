/// WindowTree: which windows came from which, and whether the parts of each cover it.
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

    /// False if it is no part of a window that was split.
    bool push(const Window& window, std::uint64_t step);
    void skip(const Window& window);
    /// The window becomes the current one.
    void pop(const Window& window);
    void split(std::uint64_t step);

    /// What the parts of the current window leave uncovered, if it was split and they come all at once.
    std::optional<Uncovered> uncovered_now() const;
    /// The same for any window.
    std::optional<Uncovered> uncovered() const;

    bool is_recursive() const { return recursive_; }

    /// The parts of the current window, in their order.
    const std::vector<Window>& parts() const { return nodes_[current_].parts; }
    bool empty() const { return nodes_.empty(); }

private:
    struct Node {
        Window window;
        std::optional<std::size_t> parent;
        bool split = false;
        std::uint64_t step = 0;
        std::vector<Window> parts;
    };

    std::optional<Uncovered> uncovered(const Node& node) const;

    Area area_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> stack_;
    std::size_t current_ = 0;
    bool recursive_ = false;
};

}  // namespace vidno::grading
