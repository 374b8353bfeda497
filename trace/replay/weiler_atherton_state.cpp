#include "replay/weiler_atherton_state.h"

#include <algorithm>

namespace vidno {

WeilerAthertonState::Pieces WeilerAthertonState::shared(const std::vector<PolygonPart>& parts) {
    Pieces pieces;
    for (const auto& part : parts) pieces.push_back(shared(part));
    return pieces;
}

void WeilerAthertonState::take(const event::CutToArea& e, Screen&) {
    crossings_ = {};
    if (!e.region.empty()) facets_.push_back(shared({e.polygon, e.region}));
}

void WeilerAthertonState::take(const event::Facets& e, Screen&) {
    facets_ = shared(e.pieces);
    piercing_.reset();
}

void WeilerAthertonState::take(const event::PopList& e, Screen&) {
    if (lists_.empty()) throw Impossible{"the stack of lists is empty"};
    auto& top = lists_.back();
    if (top.empty() || top.front()->polygon != e.clip || int(top.size()) != e.count) {
        throw Impossible{"not the list on top of the stack"};
    }
    current_list_ = CurrentList{std::move(top), 1, {}, {}, {}};
    lists_.pop_back();
}

WeilerAthertonState::CurrentList& WeilerAthertonState::list_to_change() {
    if (!current_list_) throw Impossible{"no current list"};
    return *current_list_;
}

/// The next piece of the current list, which must be one of this polygon.
const WeilerAthertonState::Piece& WeilerAthertonState::next_piece(CurrentList& list, PolygonPlace polygon) const {
    const auto next = std::size_t(list.seen);
    if (next >= list.pieces.size() || list.pieces[next]->polygon != polygon) {
        throw Impossible{"not the next polygon of the current list"};
    }
    ++list.seen;
    return list.pieces[next];
}

void WeilerAthertonState::take(const event::Beside& e, Screen&) {
    CurrentList& list = list_to_change();
    list.outside.push_back(next_piece(list, e.polygon));
}

void WeilerAthertonState::take(const event::Clipped& e, Screen&) {
    piercing_.reset();
    crossings_ = {};
    if (e.at != Line::WA5) return;  // otherwise SplitPiercing examines the common part of two polygons
    CurrentList& list = list_to_change();
    const bool ground = next_piece(list, e.polygon)->ground;
    if (!e.inside.empty()) list.inside.push_back(shared({e.polygon, e.inside, ground}));
    if (!e.outside.empty()) list.outside.push_back(shared({e.polygon, e.outside, ground}));
}

void WeilerAthertonState::take(const event::NearerOnes&, Screen&) {
    auto& inside = list_to_change().inside;
    auto& behind = list_to_change().behind;
    const auto is_ground = [](const Piece& piece) { return piece->ground; };
    const auto grounds = std::count_if(inside.begin(), inside.end(), is_ground);
    if (inside.size() - std::size_t(grounds) != behind.size()) throw Impossible{"not a depth for each part inside"};
    std::size_t next = 0;
    std::erase_if(inside, [&](const Piece& piece) { return piece->ground || behind[next++]; });
    behind.clear();
}

void WeilerAthertonState::take(const event::Paint& e, Screen& screen) {
    for (const auto& run : e.runs) screen.paint(run, e.color);
}

}  // namespace vidno
