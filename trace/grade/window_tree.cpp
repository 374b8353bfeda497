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

bool WindowTree::push(const Window& window, std::uint64_t step) {
    std::optional<std::size_t> parent;
    if (!nodes_.empty()) {
        // A program that calls itself pushes a part when it comes to it, long after its window was split.
        parent = current_;
        while (parent && !(nodes_[*parent].split && holds(nodes_[*parent].window, window)))
            parent = nodes_[*parent].parent;
        if (!parent) return false;
        if (*parent != current_) recursive_ = true;
        nodes_[*parent].parts.push_back(window);
        nodes_[*parent].step = step;
    }
    stack_.push_back(nodes_.size());
    nodes_.push_back({window, parent, false, step, {}});
    return true;
}

void WindowTree::skip(const Window& window) {
    if (!nodes_.empty()) nodes_[current_].parts.push_back(window);
}

void WindowTree::pop(const Window& window) {
    const auto is_it = [&](std::size_t i) { return nodes_[i].window == window; };
    const auto found = std::find_if(stack_.rbegin(), stack_.rend(), is_it);
    if (found == stack_.rend()) return;
    current_ = *found;
    stack_.erase(std::next(found).base());
}

void WindowTree::split(std::uint64_t step) {
    if (nodes_.empty()) return;
    nodes_[current_].split = true;
    nodes_[current_].step = step;
}

std::optional<WindowTree::Uncovered> WindowTree::uncovered(const Node& node) const {
    if (!node.split) return std::nullopt;
    const PixelRectangle pixels = Picture(area_, {}).pixels_of(node.window);
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
    if (nodes_.empty() || nodes_[current_].parts.size() < 2) return std::nullopt;
    return uncovered(nodes_[current_]);
}

std::optional<WindowTree::Uncovered> WindowTree::uncovered() const {
    for (const auto& node : nodes_) {
        if (const auto found = uncovered(node)) return found;
    }
    return std::nullopt;
}

}  // namespace vidno::grading
