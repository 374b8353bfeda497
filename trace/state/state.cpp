#include "state/state.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "choice/method.h"

namespace vidno {

namespace {

bool fits(const auto& rectangle, const Area& area) {
    const auto& [x, y, width, height] = rectangle;
    return width >= 0 && height >= 0 && x >= area.x && y >= area.y && x <= area.right() && y <= area.bottom() &&
           width <= area.right() - x && height <= area.bottom() - y;
}

std::int64_t cell(const Area& area, int x, int y) { return std::int64_t(y - area.y) * area.width + (x - area.x); }

}  // namespace

State::State(const TraceHeader& header)
    : header_(&header),
      picture_(header.scene.area, header.scene.background),
      calls_(choice_of(header.method).procedure, header.detail) {}

void State::apply(const EventView& event) {
    event.visit([this](const auto& e) {
        calls_.take(e);
        take(e);
    });
    ++step_;
}

void State::take(const event::Depth& e) {
    if (e.at == Line::PW5 || e.at == Line::HP3) depths_.push_back(e.z);
}

void State::take(const event::Push& e) {
    const bool is_first = e.at == Line::W3 || e.at == Line::WS1 || e.at == Line::WF1;
    if (is_first != e.apl.has_value()) throw Impossible{"only the first window has a list"};
    if (choice_of(header_->method).cuts_anywhere) expect_in_area(e.window);
    std::shared_ptr<Apl> apl;
    if (e.apl) {
        apl = std::make_shared<Apl>(*e.apl);
    } else {
        if (!current_) throw Impossible{"a part of no window"};
        const bool shared = e.shared.value_or(false);
        apl = shared ? current_->apl : std::make_shared<Apl>(*current_->apl);
    }
    stack_.push_back({e.window, std::move(apl)});
}

void State::take(const event::Pop& e) {
    if (stack_.empty()) throw Impossible{"the stack AW is empty"};
    if (!(stack_.back().window == e.window)) throw Impossible{"not the window on top of AW"};
    current_ = std::move(stack_.back());
    stack_.pop_back();
    has_corners_ = false;
}

/// A window that is cut anywhere still consists of whole pixels.
void State::expect_in_area(const Window& window) const {
    const auto is_whole = [](double x) { return x == std::floor(x); };
    const bool whole = is_whole(window.x) && is_whole(window.y) && is_whole(window.width) && is_whole(window.height);
    if (!whole || !fits(window, picture_.area())) throw Impossible{"a window outside the area"};
}

void State::take(const event::Fill& e) {
    if (!fits(e.rect, picture_.area())) throw Impossible{"a rectangle outside the area"};
    picture_.paint(e.rect, e.color);
}

void State::take(const event::Corners& e) {
    has_corners_ = true;
    corners_.emplace();
    corners_->fill(e.z);
    k_.reset();
    count_ = 0;
    has_surround_ = false;
    color_.reset();
    insider_ = false;
    depths_.clear();
}

State::Apl& State::current_apl() {
    if (!current_) throw Impossible{"no current window"};
    return *current_->apl;
}

AplEntry& State::entry(PolygonPlace polygon) {
    Apl& apl = current_apl();
    const auto found = std::find_if(apl.begin(), apl.end(), [&](const auto& e) { return e.first == polygon; });
    if (found == apl.end()) throw Impossible{"a polygon that is not in the current APL"};
    return *found;
}

void State::remove_from_apl(PolygonPlace polygon) {
    const AplEntry& removed = entry(polygon);
    current_apl().erase(current_apl().begin() + (&removed - current_apl().data()));
}

void State::take(const event::Discard& e) { remove_from_apl(e.polygon); }

std::vector<State::Joined>& State::list_of(OtherList list) {
    return list == OtherList::surrounding ? surrounding_ : outside_;
}

void State::take(const event::Join& e) {
    remove_from_apl(e.polygon);
    list_of(e.list).push_back({e.polygon, e.level});
}

void State::take(const event::Rejoin& e) {
    auto& list = list_of(e.list);
    if (list.empty() || list.back().polygon != e.polygon) throw Impossible{"not the polygon that joined last"};
    list.pop_back();
    Apl& third = current_apl();
    const auto before = [](const AplEntry& a, const AplEntry& b) { return a.first.index < b.first.index; };
    const AplEntry back{e.polygon, false};
    third.insert(std::lower_bound(third.begin(), third.end(), back, before), back);
}

void State::take(const event::Count& e) {
    count_ = e.count;
    depths_.clear();
}

void State::take(const event::Nearer& e) {
    if (!has_corners_ || depths_.size() != 4) throw Impossible{"not preceded by four depths"};
    for (const Corner corner : e.corners) (*corners_)[std::size_t(corner)] = depths_[std::size_t(corner)];
    k_ = e.k;
    depths_.clear();
}

void State::take(const event::Mark& e) { entry(e.polygon).second = true; }

void State::take(const event::Cover& e) {
    has_surround_ = true;
    color_ = e.color;
}

void State::take(const event::Summary& e) {
    count_ = e.count;
    has_surround_ = e.has_surround;
    color_ = e.color;
    insider_ = e.insider;
}

void State::take(const event::PointColor& e) { color_ = e.color; }

State::Clip& State::clipping() {
    if (!clip_) throw Impossible{"nothing is being clipped"};
    return *clip_;
}

void State::take(const event::ClipBegin& e) {
    clip_.emplace();
    for (const auto& v : header_->scene.polygons[std::size_t(e.polygon.index)].vertices) {
        clip_->vertices.push_back({v.x, v.y, v.z});
    }
}

void State::take(const event::ClipList& e) {
    Clip& clip = clipping();
    if (int(clip.next.size()) != e.count) throw Impossible{"a list of another length"};
    clip.vertices = std::move(clip.next);
    clip.next.clear();
}

void State::expect_in_area(int row, int first, int end) const {
    const Area& area = picture_.area();
    const bool fits = area.y <= row && row < area.bottom() && area.x <= first && first <= end && end <= area.right();
    if (!fits) throw Impossible{"a run of pixels outside the area"};
}

void State::paint(const std::vector<PixelRun>& runs, const Color& color) {
    for (const auto& run : runs) {
        expect_in_area(run.row, run.first, run.end);
        picture_.paint(run, color);
    }
}

void State::take(const event::Draw& e) { paint(e.runs, e.color); }

void State::take(const event::Paint& e) { paint(e.runs, e.color); }

void State::take(const event::CutToArea& e) {
    if (!e.region.empty()) facets_.push_back({e.polygon, e.region});
}

void State::take(const event::PopList& e) {
    if (lists_.empty()) throw Impossible{"the stack of lists is empty"};
    auto& top = lists_.back();
    if (top.empty() || top.front().polygon != e.clip || int(top.size()) != e.count) {
        throw Impossible{"not the list on top of the stack"};
    }
    list_in_hand_ = ListInHand{std::move(top), {}, {}};
    lists_.pop_back();
    clipped_ = 1;
    behind_.clear();
}

/// The current list, whose next piece must be one of this polygon.
State::ListInHand& State::list_in_hand(PolygonPlace polygon) {
    if (!list_in_hand_) throw Impossible{"no current list"};
    const auto& pieces = list_in_hand_->pieces;
    if (clipped_ >= pieces.size() || pieces[clipped_].polygon != polygon) {
        throw Impossible{"not the next polygon of the current list"};
    }
    return *list_in_hand_;
}

void State::take(const event::Beside& e) {
    auto& [pieces, inside, outside] = list_in_hand(e.polygon);
    outside.push_back(pieces[clipped_++]);
}

void State::take(const event::Clipped& e) {
    if (e.at != Line::WA5) return;  // otherwise SplitPiercing examines the common part of two polygons
    auto& [pieces, inside, outside] = list_in_hand(e.polygon);
    const bool ground = pieces[clipped_++].ground;
    if (!e.inside.empty()) inside.push_back({e.polygon, e.inside, ground});
    if (!e.outside.empty()) outside.push_back({e.polygon, e.outside, ground});
}

void State::take(const event::Behind& e) {
    if (!list_in_hand_) throw Impossible{"no current list"};
    behind_.push_back(e.behind);
}

void State::take(const event::NearerOnes&) {
    if (!list_in_hand_) throw Impossible{"no current list"};
    auto& inside = list_in_hand_->inside;
    const auto grounds = std::count_if(inside.begin(), inside.end(), [](const auto& part) { return part.ground; });
    if (inside.size() - std::size_t(grounds) != behind_.size()) throw Impossible{"not a depth for each part inside"};
    std::size_t next = 0;
    std::erase_if(inside, [&](const auto& part) { return part.ground || behind_[next++]; });
    behind_.clear();
}

void State::take(const event::Clear& e) {
    const Area& area = picture_.area();
    picture_.paint(PixelRectangle{area.x, area.y, area.width, area.height}, e.color);
    if (header_->detail >= Detail::polygons) cleared_depth_ = e.z;
    depths_stored_.clear();
}

void State::take(const event::Polygon& e) {
    polygon_ = e.polygon.index;
    edges_.clear();
    ael_.clear();
}

void State::take(const event::Scanline& e) {
    y_ = e.y;
    row_ = e.row;
}

void State::take(const event::AelAdd& e) {
    const bool is_there =
        std::any_of(ael_.begin(), ael_.end(), [&](const auto& entry) { return entry.edge == e.edge; });
    if (is_there) throw Impossible{"an edge that is already in AEL"};
    ael_.push_back({e.edge, e.x, e.z, e.until, e.dx, e.dz});
}

void State::take(const event::Leave& e) {
    for (const int edge : e.edges) {
        if (std::find(edges_.begin(), edges_.end(), edge) == edges_.end()) throw Impossible{"an edge that is not in S"};
    }
    std::erase_if(edges_, [&](int edge) { return std::find(e.edges.begin(), e.edges.end(), edge) != e.edges.end(); });
    next_start_ = e.next;
}

State::AelEntry& State::active_edge(int edge) {
    const auto found = std::find_if(ael_.begin(), ael_.end(), [&](const auto& entry) { return entry.edge == edge; });
    if (found == ael_.end()) throw Impossible{"an edge that is not in AEL"};
    return *found;
}

void State::take(const event::AelSort& e) {
    std::vector<AelEntry> sorted;
    for (const int edge : e.edges) sorted.push_back(active_edge(edge));
    const std::set<int> edges(e.edges.begin(), e.edges.end());
    if (edges.size() != ael_.size() || sorted.size() != ael_.size()) {
        throw Impossible{"an order of entries that are not those of AEL"};
    }
    ael_ = std::move(sorted);
    next_end_ = e.next;
}

void State::take(const event::AelDrop& e) {
    for (const int edge : e.edges) ael_.erase(ael_.begin() + (&active_edge(edge) - ael_.data()));
    next_end_ = e.next;
}

void State::take(const event::AelStep& e) {
    AelEntry& entry = active_edge(e.edge);
    entry.x = e.x;
    entry.z = e.z;
}

void State::take(const event::Span& e) {
    if (!polygon_) throw Impossible{"a span of no polygon"};
    std::size_t pixels = 0;
    for (const auto& [first, end] : e.runs) {
        expect_in_area(e.row, first, end);
        pixels += std::size_t(end - first);
    }
    if (e.depths && e.depths->size() != pixels) throw Impossible{"not one depth for each pixel"};
    const Color color = header_->scene.polygons[std::size_t(*polygon_)].color;
    std::size_t next = 0;
    for (const auto& [first, end] : e.runs) {
        picture_.paint(PixelRun{e.row, first, end}, color);
        if (!e.depths) continue;
        for (int x = first; x < end; ++x) depths_stored_[cell(picture_.area(), x, e.row)] = (*e.depths)[next++];
    }
}

std::optional<Value> State::depth(int x, int y) const {
    if (!cleared_depth_) return std::nullopt;
    const auto found = depths_stored_.find(cell(picture_.area(), x, y));
    return found == depths_stored_.end() ? *cleared_depth_ : found->second;
}

}  // namespace vidno
