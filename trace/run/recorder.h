/// Recorder: the visitor that turns the calls of a run into events of the chosen level and passes them to a sink.
#pragma once

#include <algorithm>
#include <concepts>
#include <utility>

#include "format/event_sink.h"
#include "vidno/trace.h"
#include "vidno/z_buffer/active_edge_list.h"

namespace vidno {

/// The state that a recorder points at. The recorder is copied into the run; this is not.
struct Recording {
    Detail detail;
    EventSink& sink;
    event::Span span{};                  // of the ShowLine that is running
    event::Horizon horizon{};            // of the Horizon that is running
    std::vector<event::Paint> paints{};  // of the region that is painted
};

template <Kernel K>
class Recorder : public NoTrace {
public:
    explicit Recorder(Recording& recording) : recording_(&recording) {}

    void plane(Line at, const auto& polygon, const auto& plane) {
        emit<event::Plane>([&] {
            return event::Plane{at, place(polygon), {value(plane.a), value(plane.b), value(plane.c), value(plane.d)}};
        });
    }
    void call(Line at, Procedure procedure) {
        if (procedure == Procedure::show_line) recording_->span = {};
        if (procedure == Procedure::horizon) recording_->horizon = {};
        if (recording_->detail < event::calls_from(procedure)) return;
        emit<event::Call>([&] { return event::Call{at, procedure}; });
    }
    void depth(Line at, const auto& polygon, const auto& where, const auto& z) {
        emit<event::Depth>([&] { return event::Depth{at, place(polygon), point(where), number_or_depth(z)}; });
    }
    void fault(Line at, std::string_view reason) {
        emit<event::Fault>([&] { return event::Fault{at, std::string(reason), {}, {}}; });
    }
    void fault(Line at, std::string_view reason, int x, int y) {
        emit<event::Fault>([&] { return event::Fault{at, std::string(reason), x, y}; });
    }

    void push_root(Line at, const auto& active_windows) {
        emit<event::Push>([&] {
            std::vector<AplEntry> apl;
            for (const auto& [polygon, surrounding] : *active_windows.back().polygons) {
                apl.emplace_back(place(*polygon), surrounding);
            }
            return event::Push{at, active_windows.back().window, std::move(apl), {}};
        });
    }
    void push_part(Line at, const auto& active_windows, bool shares_list) {
        emit<event::Push>([&] {
            return event::Push{at, active_windows.back().window, {}, shares_list ? std::optional(true) : std::nullopt};
        });
    }
    void skip(Line at, const Window& window) {
        emit<event::Skip>([&] { return event::Skip{at, window}; });
    }
    void pop(Line at, const Window& window) {
        emit<event::Pop>([&] { return event::Pop{at, window}; });
    }
    void decide(Line at, Case which) {
        emit<event::Decide>([&] { return event::Decide{at, which}; });
    }
    void fill(Line at, const PixelRectangle& pixels, const Color& color) {
        emit<event::Fill>([&] { return event::Fill{at, pixels, color}; });
    }

    void corners(Line at, const auto& z) {
        emit<event::Corners>([&] { return event::Corners{at, depth_value(z)}; });
    }
    void box(Line at, const auto& polygon, bool outside) {
        emit<event::Box>([&] {
            const auto& [xmin, ymin, xmax, ymax] = polygon.box;
            return event::Box{at, place(polygon), {value(xmin), value(ymin), value(xmax), value(ymax)}, outside, {}};
        });
    }
    void discard(Line at, const auto& polygon) {
        emit<event::Discard>([&] { return event::Discard{at, place(polygon)}; });
    }
    void count(Line at, const auto& polygon, int polygon_count) {
        emit<event::Count>([&] { return event::Count{at, place(polygon), polygon_count}; });
    }
    void compare_corner(Line at, const auto& polygon, int corner, const auto& z, const auto& against, bool nearer) {
        emit<event::Compare>([&] {
            return event::Compare{at, place(polygon), Corner(corner), depth_value(z), depth_value(against), nearer, {}};
        });
    }
    void nearer(Line at, const auto& polygon, const std::array<bool, 4>& at_corner, int k) {
        emit<event::Nearer>([&] {
            std::vector<Corner> corners;
            for (int i = 0; i < 4; ++i) {
                if (at_corner[i]) corners.push_back(Corner(i));
            }
            return event::Nearer{at, place(polygon), std::move(corners), k};
        });
    }
    void uncover(Line at, const auto& polygon) {
        emit<event::Uncover>([&] { return event::Uncover{at, place(polygon)}; });
    }
    void mark(Line at, const auto& polygon) {
        emit<event::Mark>([&] { return event::Mark{at, place(polygon)}; });
    }
    void cover(Line at, const auto& polygon) {
        emit<event::Cover>([&] { return event::Cover{at, place(polygon), polygon.color}; });
    }
    void insider(Line at, const auto& polygon, bool inside) {
        emit<event::Insider>([&] { return event::Insider{at, place(polygon), inside, {}}; });
    }
    void summary(Line at, const auto& found) {
        emit<event::Summary>([&] {
            const auto color = found.has_surround ? std::optional(found.color) : std::nullopt;
            return event::Summary{at, found.polygon_count, found.has_surround, color, found.insider};
        });
    }

    void compare(Line at, const auto& polygon, const auto& z, const auto& against, bool nearer) {
        emit<event::Compare>(
            [&] { return event::Compare{at, place(polygon), {}, depth_value(z), depth_value(against), nearer, {}}; });
    }
    void nearest(Line at, const auto& polygon, const auto& z) {
        emit<event::Nearest>([&] { return event::Nearest{at, place(polygon), depth_value(z), polygon.color}; });
    }
    void color(Line at, const auto& where, const Color& color) {
        emit<event::PointColor>([&] { return event::PointColor{at, point(where), color}; });
    }
    void orient(Line at, const auto& polygon, int edge, const auto& where, const auto& cross, Sign sign) {
        emit<event::Orient>(
            [&] { return event::Orient{at, place(polygon), edge, point(where), value(cross), sign, {}}; });
    }
    void surround(Line at, const auto& polygon, const auto& where, bool inside) {
        emit<event::Surround>([&] { return event::Surround{at, place(polygon), point(where), inside}; });
    }

    void clip_begin(Line at, const auto& polygon, const Window& window) {
        emit<event::ClipBegin>([&] { return event::ClipBegin{at, place(polygon), window}; });
    }
    void clip_side(Line at, int side, const auto& from, const auto& to) {
        emit<event::ClipSide>([&] { return event::ClipSide{at, side, point(from), point(to)}; });
    }
    void clip_sign(Line at, const auto& where, const auto& cross, Sign sign) {
        emit<event::ClipSign>([&] { return event::ClipSign{at, vertex(where), value(cross), sign, {}}; });
    }
    void clip_cross(Line at, const auto& where) {
        emit<event::ClipCross>([&] { return event::ClipCross{at, vertex(where)}; });
    }
    void clip_keep(Line at, const auto& where) {
        emit<event::ClipKeep>([&] { return event::ClipKeep{at, vertex(where)}; });
    }
    void clip_drop(Line at, const auto& where) {
        emit<event::ClipDrop>([&] { return event::ClipDrop{at, vertex(where)}; });
    }
    void clip_list(Line at, const auto& vertices) {
        emit<event::ClipList>([&] { return event::ClipList{at, int(vertices.size())}; });
    }
    void clip_result(Line at, const auto& polygon, const auto& vertices) {
        emit<event::ClipResult>([&] {
            std::vector<ValueVertex> copies;
            for (const auto& each : vertices) copies.push_back(vertex(each));
            return event::ClipResult{at, place(polygon), std::move(copies)};
        });
    }
    void row(Line at, int row, const auto& left, const auto& right, int first, int end) {
        emit<event::Row>([&] { return event::Row{at, row, value(left), value(right), first, end, {}}; });
    }
    void draw(Line at, const auto& polygon, const std::vector<PixelRun>& runs) {
        emit<event::Draw>([&] { return event::Draw{at, place(polygon), polygon.color, runs}; });
    }

    void clear(Line at, const Color& color, const auto& z) {
        emit<event::Clear>([&] { return event::Clear{at, color, depth_value(z)}; });
    }
    void polygon(Line at, const auto& polygon) {
        emit<event::Polygon>([&] { return event::Polygon{at, place(polygon), polygon.color}; });
    }
    void edge(Line at, const auto& edge) {
        emit<event::Edge>([&] {
            return event::Edge{at, edge.index, vertex(edge.upper), vertex(edge.lower), rows(edge)};
        });
    }
    void extent(Line at, const auto& ymin, const auto& ymax) {
        emit<event::Extent>([&] { return event::Extent{at, value(ymin), value(ymax)}; });
    }
    void scanline(Line at, const auto& y, int row) {
        emit<event::Scanline>([&] { return event::Scanline{at, value(y), row}; });
    }
    void ael_add(Line at, const auto& entry) {
        emit<event::AelAdd>([&] {
            return event::AelAdd{at,           entry.index,     value(entry.x), value(entry.z),
                                 until(entry), value(entry.dx), value(entry.dz)};
        });
    }
    void horizontal(Line at, const auto& edge) {
        emit<event::Horizontal>([&] { return event::Horizontal{at, edge.index}; });
    }
    void leave(Line at, const auto& edges, const auto& next) {
        emit<event::Leave>([&] { return event::Leave{at, indices(edges), next_value(next)}; });
    }
    void ael_sort(Line at, const auto& entries, const auto& next) {
        emit<event::AelSort>([&] { return event::AelSort{at, indices(entries), next_value(next)}; });
    }
    void ael_drop(Line at, const auto& entries, const auto& next) {
        emit<event::AelDrop>([&] { return event::AelDrop{at, indices(entries), next_value(next)}; });
    }
    void ael_step(Line at, const auto& entry) {
        emit<event::AelStep>([&] { return event::AelStep{at, entry.index, value(entry.x), value(entry.z)}; });
    }

    void line(Line at, int row, const auto& from, const auto& to) {
        recording_->span.row = row;
        emit<event::ShownLine>([&] {
            return event::ShownLine{at, row, {value(from.x), value(from.z)}, {value(to.x), value(to.z)}};
        });
    }
    void miss(Line at) {
        emit<event::Miss>([&] { return event::Miss{at}; });
    }
    void slope(Line at, const auto& dz) {
        emit<event::Slope>([&] { return event::Slope{at, value(dz)}; });
    }
    void columns(Line at, int first, int end, const auto& z) {
        emit<event::Columns>([&] { return event::Columns{at, first, end, value(z), {}}; });
    }
    void pixel(Line at, int x, int y, const auto& z, const auto& stored, bool shown) {
        if (shown) add_to_span(x, z);
        emit<event::Pixel>([&] { return event::Pixel{at, x, y, value(z), depth_value(stored), shown, {}}; });
    }
    void span(Line at) {
        recording_->span.at = at;
        emit<event::Span>([&]() -> const event::Span& { return recording_->span; });
    }

    void join(Line at, Relation relation, const auto& list) { change_list<event::Join>(at, relation, list); }
    void rejoin(Line at, Relation relation, const auto& list) { change_list<event::Rejoin>(at, relation, list); }
    void relation(Line at, const auto& polygon, Relation found) {
        emit<event::RelationFound>([&] { return event::RelationFound{at, place(polygon), found}; });
    }
    void trial(Line at, const auto& polygon, int edge, bool meets) {
        emit<event::Trial>([&] { return event::Trial{at, place(polygon), edge, meets}; });
    }
    void meets(Line at, const auto& polygon, bool any) {
        emit<event::Meets>([&] { return event::Meets{at, place(polygon), any}; });
    }
    void ray(Line at, const auto& polygon, int edge, int counts) {
        emit<event::Ray>([&] { return event::Ray{at, place(polygon), edge, counts}; });
    }
    void crossings(Line at, const auto& polygon, int count) {
        emit<event::Crossings>([&] { return event::Crossings{at, place(polygon), count}; });
    }
    void octants(Line at, const auto& polygon, int edge, int from, int to, int difference) {
        emit<event::Octants>([&] { return event::Octants{at, place(polygon), edge, from, to, difference}; });
    }
    void angle(Line at, const auto& polygon, int octants) {
        emit<event::Angle>([&] { return event::Angle{at, place(polygon), octants}; });
    }
    void hiding(Line at, const auto* polygon) {
        emit<event::Hiding>([&] { return event::Hiding{at, polygon ? std::optional(place(*polygon)) : std::nullopt}; });
    }
    void split_vertex(Line at, const auto& polygon, int vertex, int column, int row, bool splits) {
        emit<event::SplitVertex>([&] { return event::SplitVertex{at, place(polygon), vertex, column, row, splits}; });
    }
    void edge_depth(Line at, const auto& polygon, int edge, const auto& z) {
        emit<event::EdgeDepth>([&] { return event::EdgeDepth{at, place(polygon), edge, depth_value(z)}; });
    }
    void back_face(Line at, const auto& polygon, bool away) {
        emit<event::BackFace>([&] { return event::BackFace{at, place(polygon), away}; });
    }

    void cut_to_area(Line at, const auto& polygon, const auto& region) {
        emit<event::CutToArea>([&] { return event::CutToArea{at, place(polygon), loops(region)}; });
    }
    void facets(Line at, const auto& pieces) {
        emit<event::Facets>([&] { return event::Facets{at, parts(pieces)}; });
    }
    void sorted(Line at, const auto& pieces) {
        emit<event::Sorted>([&] { return event::Sorted{at, places(pieces)}; });
    }
    void push_list(Line at, const auto& pieces) {
        emit<event::PushList>([&] { return event::PushList{at, parts(pieces)}; });
    }
    void pop_list(Line at, const auto& pieces) {
        emit<event::PopList>([&] { return event::PopList{at, place(*pieces.front().polygon), int(pieces.size())}; });
    }
    void beside(Line at, const auto& polygon) {
        emit<event::Beside>([&] { return event::Beside{at, place(polygon)}; });
    }
    void clipped(Line at, const auto& polygon, const auto& clip, const auto& inside, const auto& outside) {
        emit<event::Clipped>([&] {
            return event::Clipped{at, place(polygon), place(clip), loops(inside), loops(outside)};
        });
    }
    void nearer_ones(Line at, const auto& pieces) {
        emit<event::NearerOnes>([&] { return event::NearerOnes{at, places(pieces)}; });
    }
    void show_region(Line at, const auto& polygon, const auto& region) {
        emit<event::Show>([&] { return event::Show{at, place(polygon), loops(region)}; });
    }
    void pierce(Line at, const auto& polygon, const auto& other, const auto& line) {
        emit<event::Pierce>([&] {
            return event::Pierce{at, place(polygon), place(other), {value(line.a), value(line.b)}, point(line.on)};
        });
    }
    void split(Line at, const auto& polygon, const auto& region, const auto& other) {
        emit<event::Split>([&] { return event::Split{at, place(polygon), loops(region), loops(other)}; });
    }
    void greatest_depth(Line at, const auto& polygon, const auto& z) {
        emit<event::GreatestDepth>([&] { return event::GreatestDepth{at, place(polygon), value(z)}; });
    }
    void edge_piece(Line at, const auto& from, const auto& to, Lies lies) {
        emit<event::EdgePiece>([&] { return event::EdgePiece{at, point(from), point(to), lies}; });
    }
    void enter(Line at, const auto& where) {
        emit<event::Entering>([&] { return event::Entering{at, point(where)}; });
    }
    void leave(Line at, const auto& where) {
        emit<event::Leaving>([&] { return event::Leaving{at, point(where)}; });
    }
    void behind(Line at, const auto& polygon, const auto& clip, const auto& where, const auto& z, const auto& clip_z,
                Sign order, bool behind) {
        emit<event::Behind>([&] {
            return event::Behind{at,    place(polygon), place(clip), point(where), value(z), value(clip_z),
                                 order, behind,         {}};
        });
    }
    void order(Line at, const auto& polygon, const auto& other, const auto& where, const auto& z, const auto& other_z,
               Sign order) {
        emit<event::Order>([&] {
            return event::Order{at, place(polygon), place(other), point(where), value(z), value(other_z), order, {}};
        });
    }
    void paint(Line at, const auto& polygon, int x, int y) {
        auto& paints = recording_->paints;
        const auto found = std::find_if(paints.begin(), paints.end(),
                                        [&](const auto& paint) { return paint.polygon == place(polygon); });
        auto& runs = found != paints.end()
                         ? found->runs
                         : paints.emplace_back(event::Paint{at, place(polygon), polygon.color, {}}).runs;
        if (runs.empty() || runs.back().row != y || runs.back().end != x) runs.push_back({y, x, x});
        runs.back().end = x + 1;
    }
    void region_painted(Line) {
        for (const auto& paint : std::exchange(recording_->paints, {})) emit<event::Paint>([&] { return paint; });
    }
    void painted(Line at) {
        emit<event::Painted>([&] { return event::Painted{at}; });
    }

    void horizons(Line at, const auto& horizons) {
        emit<event::Horizons>([&] {
            return event::Horizons{at, height_value(horizons.upper.leftmost()),
                                   height_value(horizons.lower.leftmost())};
        });
    }
    void curve(Line at, int curve) {
        emit<event::Curve>([&] { return event::Curve{at, curve}; });
    }
    void side_edge(Line at, const auto& sample) {
        emit<event::SideEdge>([&] { return event::SideEdge{at, {sample.x, sample.y}}; });
    }
    void visibility(Line at, const auto& segment, int column, VisibilityFlag flag) {
        emit<event::Visibility>([&] { return event::Visibility{at, ends_of(segment), column, flag, {}}; });
    }
    void horizon(Line at, const auto& /*segment*/, int first, int last) {
        event::Horizon& changed = recording_->horizon;
        changed.at = at;
        changed.first = first;
        changed.last = last;
        emit<event::Horizon>([&]() -> const event::Horizon& { return changed; });
    }
    void intersection(Line at, const auto& segment, const auto& end) {
        emit<event::Intersection>([&] {
            return event::Intersection{at, ends_of(segment), point(end.point), {end.left, end.right}};
        });
    }
    void draw_line(Line at, const auto& segment, const auto& from, const auto& to) {
        emit<event::DrawLine>([&] {
            return event::DrawLine{
                at, ends_of(segment), point(from.point), {from.left, from.right}, point(to.point), {to.left, to.right}};
        });
    }
    void height(Line at, int column, const auto& y, const auto& upper, const auto& lower) {
        emit<event::Height>([&] {
            return event::Height{at, column, value(y), height_value(upper), height_value(lower)};
        });
    }
    void raise(Line at, int column, const auto& y) { change<event::Raise>(recording_->horizon.upper, at, column, y); }
    void lower(Line at, int column, const auto& y) { change<event::Lower>(recording_->horizon.lower, at, column, y); }
    void step(Line at, int column, bool changes) {
        emit<event::Step>([&] { return event::Step{at, column, changes}; });
    }

private:
    template <class E>
    void emit(auto&& make) {
        if (recording_->detail >= E::kind.from) recording_->sink.hear(make());
    }

    void add_to_span(int x, const auto& z) {
        auto& [at, row, runs, depths] = recording_->span;
        if (runs.empty() || runs.back().end != x) runs.push_back({x, x});
        runs.back().end = x + 1;
        if (recording_->detail < Detail::polygons) return;
        if (!depths) depths.emplace();
        depths->push_back(value(z));
    }

    /// The polygon that joins or leaves a list is its last.
    template <class E>
    void change_list(Line at, Relation relation, const auto& list) {
        const OtherList joined = relation == Relation::surrounding ? OtherList::surrounding : OtherList::outside;
        emit<E>([&] { return E{at, place(*list.back().polygon), joined, list.back().level}; });
    }

    /// A horizon over a column.
    template <class E>
    void change(std::vector<ColumnHeight>& changed, Line at, int column, const auto& y) {
        if (recording_->detail < event::Horizon::kind.from) return;
        changed.emplace_back(column, value(y));
        emit<E>([&] { return E{at, column, changed.back().second}; });
    }

    static PolygonPlace place(const auto& polygon) { return {polygon.index}; }

    static Value value(const auto& number) { return as_value<K>(number); }
    static Value depth_value(const typename K::Depth& z) {
        if constexpr (requires { K::reported(z); } || K::has_infinity) {
            return value(z);
        } else {
            return z ? value(*z) : Value::minus_infinite();
        }
    }
    /// The depth of a plane is a depth of the kernel or, for the polygon of a region, a number.
    static Value number_or_depth(const auto& z) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(z)>, typename K::Depth>) {
            return depth_value(z);
        } else {
            return value(z);
        }
    }
    static std::optional<Value> height_value(const auto& cell) {
        return cell ? std::optional(value(*cell)) : std::nullopt;
    }
    static SegmentColumns ends_of(const Segment& segment) { return {segment.from.x, segment.to.x}; }
    /// The minimum of an empty list is plus infinity.
    static Value next_value(int row) { return row == no_row ? Value::infinite() : Value(row); }
    static Value next_value(const std::optional<typename K::Number>& y) { return y ? value(*y) : Value::infinite(); }

    static RegionLoops loops(const auto& region) {
        RegionLoops copies;
        for (const auto& loop : region.loops) {
            copies.emplace_back();
            for (const auto& corner : loop) copies.back().push_back(point(corner.at));
        }
        return copies;
    }
    static std::vector<PolygonPart> parts(const auto& pieces) {
        std::vector<PolygonPart> copies;
        for (const auto& piece : pieces)
            copies.push_back({place(*piece.polygon), loops(piece.region), piece.is_ground});
        return copies;
    }
    static std::vector<PolygonPlace> places(const auto& pieces) {
        std::vector<PolygonPlace> found;
        for (const auto& piece : pieces) found.push_back(place(*piece.polygon));
        return found;
    }

    static ValuePoint point(const auto& p) { return {value(p.x), value(p.y)}; }
    static ValueVertex vertex(const auto& v) { return {value(v.x), value(v.y), value(v.z)}; }

    static Value until(const auto& entry) {
        if constexpr (requires { entry.last_row; }) {
            return {double(entry.last_row)};
        } else {
            return value(entry.until);
        }
    }
    static std::optional<std::pair<int, int>> rows(const auto& edge) {
        if constexpr (requires { edge.first_row; }) {
            return std::pair(edge.first_row, edge.last_row);
        } else {
            return std::nullopt;
        }
    }
    static std::vector<int> indices(const auto& edges) {
        std::vector<int> found;
        for (const auto& edge : edges) found.push_back(edge.index);
        return found;
    }

    Recording* recording_;
};

}  // namespace vidno
