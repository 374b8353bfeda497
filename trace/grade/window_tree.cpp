#include "grade/window_tree.h"

#include <algorithm>

#include "vidno/picture.h"

namespace vidno::grading {

namespace {

bool holds(const Window& window, const Window& part) {
    return window.x <= part.x && part.right() <= window.right() && window.y <= part.y &&
           part.bottom() <= window.bottom();
}

bool holds_centre(const Window& window, int column, int row) {
    const double x = column + 0.5, y = row + 0.5;
    return window.x <= x && x < window.right() && window.y <= y && y < window.bottom();
}

}  // namespace

WindowTree::Node* WindowTree::parent_of(const Window& window) {
    Node* smallest = nullptr;
    for (Node& node : nodes_) {
        if (!node.split || !holds(node.window, window)) continue;
        const bool is_smaller =
            !smallest || node.window.width * node.window.height <= smallest->window.width * smallest->window.height;
        if (is_smaller) smallest = &node;
    }
    return smallest;
}

bool WindowTree::push(const Window& window, std::uint64_t step) {
    const auto waits = [&](const Node& node) { return node.waits && node.window == window; };
    if (std::any_of(nodes_.begin(), nodes_.end(), waits)) return true;
    if (!nodes_.empty()) {
        Node* const parent = parent_of(window);
        if (!parent) return false;
        parent->parts.push_back(window);
        parent->step = step;
        if (parent == &nodes_[current_]) ++parent->at_once;
        in_turn_ = in_turn_ || parent != &nodes_[current_];
        breadth_first_ = breadth_first_ || !holds(parent->window, nodes_[current_].window);
    }
    nodes_.push_back({window});
    nodes_.back().step = step;
    return true;
}

void WindowTree::skip(const Window& window) {
    if (Node* const parent = parent_of(window)) parent->parts.push_back(window);
}

void WindowTree::pop(const Window& window) {
    const auto is_it = [&](const Node& node) { return node.waits && node.window == window; };
    const auto found = std::find_if(nodes_.begin(), nodes_.end(), is_it);
    if (found == nodes_.end()) return;
    found->waits = false;
    const Window& before = nodes_[current_].window;
    const bool skips_parts = nodes_[current_].split && !nodes_[current_].parts.empty() && !holds(before, window);
    breadth_first_ = breadth_first_ || skips_parts;
    current_ = std::size_t(found - nodes_.begin());
}

void WindowTree::split(std::uint64_t step) {
    if (nodes_.empty()) return;
    nodes_[current_].split = true;
    nodes_[current_].step = step;
}

std::optional<WindowTree::Uncovered> WindowTree::uncovered(const Node& node) const {
    if (!node.split) return std::nullopt;
    const PixelRectangle pixels = pixels_of(area_, node.window);
    for (int row = pixels.y; row < pixels.y + pixels.height; ++row) {
        for (int column = pixels.x; column < pixels.x + pixels.width; ++column) {
            const auto has_it = [&](const Window& part) { return holds_centre(part, column, row); };
            if (std::any_of(node.parts.begin(), node.parts.end(), has_it)) continue;
            return Uncovered{node.window, column, row, node.step};
        }
    }
    return std::nullopt;
}

std::optional<WindowTree::Uncovered> WindowTree::uncovered_now() const {
    if (nodes_.empty() || nodes_[current_].at_once < 2) return std::nullopt;
    return uncovered(nodes_[current_]);
}

std::optional<WindowTree::Uncovered> WindowTree::uncovered() const {
    for (const auto& node : nodes_) {
        if (const auto found = uncovered(node)) return found;
    }
    return std::nullopt;
}

}  // namespace vidno::grading
