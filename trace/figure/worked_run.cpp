#include "worked_run.h"

#include "format/trace_reader.h"
#include "run/run.h"

namespace vidno::figures {

WorkedRun::WorkedRun(const AdmittedScene& scene, Method method)
    : header_{method, Edition::corrected, "exact", Detail::signs, scene}, start_(header_), end_(header_) {
    std::string text;
    TraceWriter writer(header_, [&](std::string_view part) { text += part; });
    RunRequest request{method, kernel_of(KernelKind::exact), Edition::corrected, scene, Detail::signs};
    request.sink = &writer;
    writer.finish(run(request));
    TraceReader reader(LineReader::of_text(std::move(text)), scene->name);
    while (const auto event = reader.next()) {
        end_.take(*event);
        event->visit([this](const auto& e) { hear(e); });
    }
}

std::optional<int> WorkedRun::shown(int x, int y) const {
    const auto found = shown_.find({x, y});
    return found == shown_.end() ? std::nullopt : std::optional(found->second);
}

void WorkedRun::hear(const event::Pop& e) {
    windows_.push_back({e.window});
    windows_.back().step = end_.state().step();
    if (has_relations()) return;
    const WarnockState& warnock = end_.state().warnock();
    for (const auto& [polygon, surrounds] : warnock.list(*warnock.current()).entries()) {
        entry(polygon).surrounds = surrounds;
    }
}

void WorkedRun::hear(const event::Decide& e) {
    windows_.back().line = e.at;
    windows_.back().which = e.which;
    if (e.which == Case::surrounded) windows_.back().painted = covering_;
}

void WorkedRun::hear(const event::ShownLine& e) {
    const auto& caller = end_.state().calls().end()[-2];
    const bool is_level = caller.at == Line::Z9;
    const ZBufferState& scan = end_.state().z_buffer();
    const auto edges = is_level ? std::vector<ZBufferState::ActiveEdge>{} : scan.active_edges();
    rows_.push_back({scan.polygon()->index, e.row, edges});
    rows_.back().step = end_.state().step();
}

void WorkedRun::hear(const event::Box& e) {
    // The simplest member of the family has no relations but the boxes.
    if (header_.method != Method::warnock_simplest) return;
    entry(e.polygon).relation = e.outside ? Relation::outside : Relation::intersecting;
}

void WorkedRun::hear(const event::PopList&) {
    auto& list = lists_.emplace_back();
    list.step = end_.state().step();
    for (const auto& piece : end_.state().weiler_atherton().current_list()->pieces) {
        list.polygons.push_back(piece->polygon.index);
    }
}

void WorkedRun::hear(const event::Clipped& e) {
    if (e.at != Line::WA5) return;
    if (!e.inside.empty()) lists_.back().inside.push_back(e.polygon.index);
    if (!e.outside.empty()) lists_.back().outside.push_back(e.polygon.index);
}

void WorkedRun::hear(const event::NearerOnes& e) {
    for (const auto& polygon : e.polygons) lists_.back().nearer.push_back(polygon.index);
}

void WorkedRun::hear(const event::Columns& e) {
    rows_.back().first = e.first;
    rows_.back().end = e.end;
}

void WorkedRun::hear(const event::Span& e) {
    for (const auto& [first, end] : e.runs) {
        for (int x = first; x < end; ++x) shown_[{x, e.row}] = end_.state().z_buffer().polygon()->index;
    }
}

}  // namespace vidno::figures
