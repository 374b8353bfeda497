#include "check/seen_failure.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "check/judged_run.h"
#include "choice/method.h"
#include "format/decision_words.h"
#include "format/fault_reason.h"
#include "format/paints.h"
#include "run/floating_horizon_run.h"
#include "run/run.h"
#include "run/write_trace.h"

namespace vidno {

namespace {

using Words = Failure::Words;

/// A longer run shows its failure within this many steps.
constexpr std::uint64_t most_steps = 20'000;

/// Thrown to end a run once it has shown its failure.
struct Enough {};

using HearStep = std::function<void(std::uint64_t step, const EventView& event)>;

Method method_of(const NamedRun& run) { return method_named(run.method); }

/// Passes each step of a run to `hear`, up to the end or until it has enough.
void follow(const AnyScene& scene, const NamedRun& named, const HearStep& hear, const Judge* judge = nullptr) {
    std::uint64_t steps = 0;
    FunctionSink sink([&](const EventView& event) {
        hear(++steps, event);
        if (steps == most_steps) throw Enough();
    });
    const NamedKernel& kernel = named.kernel;
    const Edition edition = named.edition;
    try {
        if (const auto* surface = std::get_if<Surface>(&scene)) {
            traced_floating_horizon({kernel, edition, surface->curves, Detail::signs, &sink}, {.judge = judge});
        } else {
            RunRequest request{method_of(named), kernel, edition, std::get<AdmittedScene>(scene), Detail::signs, &sink};
            if (judge) {
                judged_run(request, {.judge = judge});
            } else {
                traced_run(request);
            }
        }
    } catch (const Enough&) {
    }
}

std::string signed_text(int number) { return number < 0 ? "−" + std::to_string(-number) : std::to_string(number); }

/// An answer in both languages.
Words words_of(bool answer) { return answer ? Words{"yes", "да"} : Words{"no", "нет"}; }
Words words_of(int answer) { return {signed_text(answer), signed_text(answer)}; }
Words words_of(const std::pair<int, int>& range) {
    const auto [first, end] = range;
    if (end <= first) return {"none", "пусто"};
    if (end - first == 1) return words_of(first);
    const std::string from = signed_text(first), to = signed_text(end - 1);
    return {from + " to " + to, "от " + from + " до " + to};
}
std::string text_of(double number) {
    Text text;
    append_number(text, number);
    return text.string();
}

/// The first decision on which exact arithmetic differs.
std::optional<SeenFailure> first_wrong(const Failure& failure) {
    std::optional<Verdict> wrong;
    const Judge judge = [&](const Verdict& verdict) {
        if (!wrong && verdict.wrong()) wrong = verdict;
    };
    std::uint64_t step = 0;
    std::optional<Event> seen;
    const auto hear = [&](std::uint64_t at, const EventView& event) {
        step = at;
        if (!wrong) return;
        seen = event.copy();
        throw Enough();
    };
    follow(*failure.scene, failure.fails, hear, &judge);
    if (!wrong) return std::nullopt;
    const auto words = [](const Answer& answer) {
        return std::visit([](const auto& each) { return words_of(each); }, answer);
    };
    const Words taken = words(wrong->taken), exact = words(*wrong->truth.answer);
    constexpr Bilingual computed{": computed ", ": вычислено "}, exactly{", exact ", ", точный ответ — "};
    const auto there = in_each_language([&](Language language) {
        return std::string(decision_words[std::size_t(wrong->of)].in(language)) + std::string(computed.in(language)) +
               taken.in(language) + std::string(exactly.in(language)) + exact.in(language);
    });
    return SeenFailure{step, there, seen};
}

/// The last step that painted a pixel, and the colour.
struct Painted {
    std::optional<std::uint64_t> step;
    std::optional<Color> color;
};

Painted painted(const AnyScene& scene, const NamedRun& run, const std::pair<int, int>& pixel) {
    const int x = pixel.first, y = pixel.second;
    Painted last;
    Color of_polygon;
    follow(scene, run, [&](std::uint64_t step, const EventView& event) {
        if (const auto* polygon = event.get_if<event::Polygon>()) of_polygon = polygon->color;
        event.visit([&](const auto& e) {
            if (!paints(e, x, y)) return;
            if constexpr (requires { Color(e.color); }) {
                last = {step, e.color};
            } else {
                last = {step, of_polygon};
            }
        });
    });
    return last;
}

/// The polygon that shows where this was painted.
Words shown(const Painted& last, const Scene& scene) {
    const auto of_color = [&](const ScenePolygon& polygon) { return polygon.color == last.color; };
    const auto found = std::find_if(scene.polygons.begin(), scene.polygons.end(), of_color);
    if (found == scene.polygons.end()) return {"the background", "фон"};
    return {found->id, found->id};
}

SeenFailure seen_pixel(const Failure& failure, const std::pair<int, int>& pixel) {
    const auto& scene = std::get<AdmittedScene>(*failure.scene);
    const Painted wrong = painted(*failure.scene, failure.fails, pixel);
    const Words taken = shown(wrong, scene);
    const Words right = shown(painted(*failure.scene, failure.holds, pixel), scene);
    return {
        wrong.step,
        {taken.english + " is painted, not " + right.english, "закрашен " + taken.russian + ", а не " + right.russian},
        {}};
}

bool is_over_column(const event::DrawLine& line, int x) {
    return line.from_columns.second <= x && x <= line.to_columns.first;
}
bool is_over_place(const event::DrawLine& line, double x) {
    return number_of(line.from.x) <= x && x <= number_of(line.to.x);
}

/// Whether a curve is drawn at a place, and the step that shows it.
struct Drawn {
    std::optional<std::uint64_t> step;
    bool is_drawn = false;
};

/// The step that draws a curve over an x or, if none does, the last that examines its segment there.
Drawn drawn_over(const Failure& failure, int curve, auto x, auto&& is_over) {
    bool is_in_curve = false;
    std::optional<std::uint64_t> drawn, looked;
    follow(*failure.scene, failure.fails, [&](std::uint64_t step, const EventView& event) {
        if (const auto* begun = event.get_if<event::Curve>()) is_in_curve = begun->curve == curve;
        if (!is_in_curve) return;
        if (const auto* line = event.get_if<event::DrawLine>()) {
            if (!drawn && is_over(*line, x)) drawn = step;
        } else if (const auto* visibility = event.get_if<event::Visibility>()) {
            if (visibility->segment.first <= x && x <= visibility->segment.second) looked = step;
        }
    });
    return {drawn ? drawn : looked, drawn.has_value()};
}

SeenFailure seen_curve(const Drawn& found, int curve, const std::string& there, const std::string& there_in_russian) {
    const std::string number = std::to_string(curve);
    return {found.step,
            {"curve " + number + " is " + (found.is_drawn ? "" : "not ") + "drawn " + there,
             "кривая " + number + " " + there_in_russian + (found.is_drawn ? " нарисована" : " не нарисована")},
            {}};
}

SeenFailure seen_column(const Failure& failure, const std::pair<int, int>& column) {
    const auto [curve, x] = column;
    const std::string number = std::to_string(x);
    return seen_curve(drawn_over(failure, curve, x, is_over_column), curve, "over column " + number,
                      "над столбцом " + number);
}

SeenFailure seen_place(const Failure& failure, const std::pair<int, double>& place) {
    const auto [curve, x] = place;
    std::string number = text_of(x);
    const std::string there = "at x = " + number;
    std::replace(number.begin(), number.end(), '.', ',');
    return seen_curve(drawn_over(failure, curve, x, is_over_place), curve, there, "при x = " + number);
}

SeenFailure seen_fault(const Failure& failure) {
    SeenFailure found{{}, {"it does not end by itself", "сам не кончается"}, {}};
    follow(*failure.scene, failure.fails, [&](std::uint64_t step, const EventView& event) {
        const auto* fault = event.get_if<event::Fault>();
        if (!fault || line_names[std::size_t(fault->at)] != failure.shows.fault) return;
        found = {step, {fault->reason, std::string(reason_in(Language::russian, fault->reason))}, {}};
        throw Enough();
    });
    return found;
}

/// The first step at a line of the listing.
std::optional<std::uint64_t> step_at(const std::string& line, const AnyScene& scene, const NamedRun& run) {
    std::optional<std::uint64_t> found;
    follow(scene, run, [&](std::uint64_t step, const EventView& event) {
        if (event.get_if<event::Call>()) return;
        const Line at = event.visit([](const auto& e) { return e.at; });
        if (line_names[std::size_t(at)] != line) return;
        found = step;
        throw Enough();
    });
    return found;
}

SeenFailure seen_windows(const Failure& failure) {
    const auto windows = [&](const NamedRun& run) {
        int count = 0;
        follow(*failure.scene, run,
               [&](std::uint64_t, const EventView& event) { count += event.get_if<event::Pop>() ? 1 : 0; });
        return std::to_string(count);
    };
    const std::string more = windows(failure.fails), fewer = windows(failure.holds);
    return {{}, {more + " windows, not " + fewer, "окон " + more + ", а не " + fewer}, {}};
}

/// The intersection that differs most between the two runs, compared in their order.
SeenFailure seen_off(const Failure& failure) {
    using Cut = std::pair<std::uint64_t, double>;
    const auto cuts = [&](const NamedRun& run) {
        std::vector<Cut> found;
        follow(*failure.scene, run, [&](std::uint64_t step, const EventView& event) {
            if (const auto* cut = event.get_if<event::ClipCross>()) found.emplace_back(step, cut->vertex.x.number);
        });
        return found;
    };
    const auto computed = cuts(failure.fails), right = cuts(failure.holds);
    std::optional<std::size_t> farthest;
    const auto off = [&](std::size_t i) { return std::abs(computed[i].second - right[i].second); };
    for (std::size_t i = 0; i < std::min(computed.size(), right.size()); ++i) {
        if (!farthest || off(i) > off(*farthest)) farthest = i;
    }
    if (!farthest) return {{}, {"no intersection", "пересечений нет"}, {}};
    const std::string x = text_of(computed[*farthest].second), exactly = text_of(right[*farthest].second);
    return {computed[*farthest].first,
            {"an intersection at x = " + x + ", not " + exactly, "пересечение при x = " + x + ", а не " + exactly},
            {}};
}

}  // namespace

SeenFailure seen(const Failure& failure) {
    const Shows& shows = failure.shows;
    const AnyScene& scene = *failure.scene;
    if (!shows.fault.empty()) return seen_fault(failure);
    if (!shows.missing.empty()) {
        const std::string& line = shows.missing;
        return {step_at(line, scene, failure.holds), {line + " is not reached", line + " не достигнута"}, {}};
    }
    if (!shows.present.empty()) {
        const std::string& line = shows.present;
        return {step_at(line, scene, failure.fails), {line + " is reached", line + " достигнута"}, {}};
    }
    if (shows.more_windows) return seen_windows(failure);
    if (shows.off) return seen_off(failure);
    if (failure.fails.edition == Edition::corrected) {
        if (const auto wrong = first_wrong(failure)) return *wrong;
    }
    if (shows.column) return seen_column(failure, *shows.column);
    if (shows.place) return seen_place(failure, *shows.place);
    if (shows.pixel) return seen_pixel(failure, *shows.pixel);
    return {{}, failure.title, {}};
}

void write_failing_run(const Failure& failure, std::function<void(std::string_view)> write) {
    const NamedKernel& kernel = failure.fails.kernel;
    const Edition edition = failure.fails.edition;
    if (const auto* surface = std::get_if<Surface>(&*failure.scene)) {
        TraceWriter writer(FloatingHorizonHeader{edition, kernel.name(), Detail::signs, *surface}, std::move(write),
                           most_steps);
        write_trace(FloatingHorizonRequest{kernel, edition, surface->curves, Detail::signs}, writer);
    } else {
        const auto& scene = std::get<AdmittedScene>(*failure.scene);
        const Method method = method_of(failure.fails);
        TraceWriter writer(TraceHeader{method, edition, kernel.name(), Detail::signs, scene}, std::move(write),
                           most_steps);
        write_trace(RunRequest{method, kernel, edition, scene, Detail::signs}, writer);
    }
}

}  // namespace vidno
