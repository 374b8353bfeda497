#include "replay/warnock_state.h"

#include <algorithm>
#include <utility>

namespace vidno {

namespace {

bool holds(const Window& window, const Window& part) {
    return window.x <= part.x && window.y <= part.y && part.right() <= window.right() &&
           part.bottom() <= window.bottom();
}

}  // namespace

void WarnockState::take(const event::Depth& e, Screen&) {
    if (e.at != Line::PW5 && e.at != Line::HP3) return;
    if (depths_.size() == 4) depths_.clear();
    depths_.push_back(e.z);
    are_depths_compared_ = false;
}

void WarnockState::take(const event::Push& e, Screen& screen) {
    const bool is_first = e.at == Line::W3 || e.at == Line::WS1 || e.at == Line::WF1;
    if (is_first != e.apl.has_value()) throw Impossible{"only the first window has a list"};
    if (!is_first && !current_) throw Impossible{"a part of no window"};
    if (is_first || !root_) root_ = e.window;
    screen.divide(e.window, *root_);
    int list = next_list_;
    if (e.shared.value_or(false)) {
        list = current_->list;
    } else {
        lists_.emplace(next_list_++, e.apl ? PolygonList(*e.apl) : lists_.at(current_->list));
    }
    stack_.push_back({e.window, list});
}

void WarnockState::take(const event::Pop& e, Screen&) {
    if (stack_.empty()) throw Impossible{"the stack AW is empty"};
    if (!(stack_.back().window == e.window)) throw Impossible{"not the window on top of AW"};
    if (current_) {
        way_.push_back(current_->window);
        const auto has_its_list = [&](const StackedWindow& window) { return window.list == current_->list; };
        if (std::none_of(stack_.begin(), stack_.end(), has_its_list)) lists_.erase(current_->list);
    }
    std::erase_if(way_, [&](const Window& window) { return !holds(window, e.window); });
    current_ = stack_.back();
    stack_.pop_back();
    found_ = {};
    covering_.reset();
    nearest_.reset();
}

void WarnockState::take(const event::Corners& e, Screen&) {
    CornerDepths corners;
    corners.of.fill(e.z);
    found_ = last_ = {.corners = corners, .k = {}, .count = 0, .has_surround = false, .color = {}, .insider = false};
    covering_.reset();
    depths_.clear();
}

PolygonList& WarnockState::current_list() {
    if (!current_) throw Impossible{"no current window"};
    return lists_.at(current_->list);
}

void WarnockState::take(const event::Join& e, Screen&) {
    current_list().remove(e.polygon);
    list_of(e.list).push_back({e.polygon, e.level});
}

void WarnockState::take(const event::Rejoin& e, Screen&) {
    auto& list = list_of(e.list);
    if (list.empty() || list.back().polygon != e.polygon) throw Impossible{"not the polygon that joined last"};
    list.pop_back();
    current_list().insert(e.polygon);
}

void WarnockState::take(const event::Count& e, Screen&) {
    set(&Findings::count, e.count);
    depths_.clear();
}

void WarnockState::take(const event::Nearer& e, Screen&) {
    if (!found_.corners || depths_.size() != 4 || are_depths_compared_) throw Impossible{"not preceded by four depths"};
    are_depths_compared_ = true;
    CornerDepths corners = *found_.corners;
    for (const Corner corner : e.corners) corners.of[std::size_t(corner)] = depths_[std::size_t(corner)];
    set(&Findings::corners, corners);
    set(&Findings::k, e.k);
}

void WarnockState::take(const event::Uncover&, Screen&) {
    set(&Findings::has_surround, false);
    uncovered_ = std::exchange(covering_, std::nullopt);
}

void WarnockState::take(const event::Cover& e, Screen&) {
    set(&Findings::has_surround, true);
    set(&Findings::color, e.color);
    covering_ = e.polygon;
}

void WarnockState::take(const event::Insider& e, Screen&) { set(&Findings::insider, e.inside); }

void WarnockState::take(const event::Summary& e, Screen&) {
    set(&Findings::count, e.count);
    set(&Findings::has_surround, e.has_surround);
    set(&Findings::color, e.color);
    set(&Findings::insider, e.insider);
}

void WarnockState::take(const event::PointColor& e, Screen&) { set(&Findings::color, e.color); }

void WarnockState::take(const event::Hiding& e, Screen&) {
    set(&Findings::has_surround, e.polygon.has_value());
    covering_ = e.polygon;
}

WarnockState::Clip& WarnockState::clipping() {
    if (!clip_) throw Impossible{"nothing is being clipped"};
    return *clip_;
}

void WarnockState::take(const event::ClipBegin& e, Screen&) {
    clip_.emplace();
    for (const auto& v : scene_->polygons[std::size_t(e.polygon.index)].vertices) {
        clip_->vertices.push_back({v.x, v.y, v.z});
    }
}

void WarnockState::take(const event::ClipList& e, Screen&) {
    Clip& clip = clipping();
    if (int(clip.next.size()) != e.count) throw Impossible{"a list of another length"};
    clip.vertices = std::move(clip.next);
    clip.next.clear();
}

void WarnockState::take(const event::Draw& e, Screen& screen) {
    for (const auto& run : e.runs) screen.paint(run, e.color);
}

}  // namespace vidno
