#include "new_lesson.h"

#include <array>
#include <optional>

#include "event_lines.h"
#include "refused.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

/// With more windows, or more columns of curves, there would be too many signs to follow.
constexpr std::uint64_t most_with_signs = 1000;

constexpr Bilingual story_of_polygons{R"(# TODO: the title

- TODO: what the reader can do afterwards

TODO: what there is to see, in two or three sentences.

## Window by window

Warnock's algorithm begins with [the window over the whole area](#start). TODO: what it finds there.

It looks at [COUNT windows](#windows). TODO: explain this number.

## Row by row

The Z-buffer begins with [the first row of the first polygon](#row). TODO: what there is to see.
)",
                                      R"(# TODO: название

- TODO: что читатель сможет делать

TODO: что здесь можно увидеть, в двух-трёх предложениях.

## Окно за окном

Алгоритм Варнока начинает с [окна во всю область](#start). TODO: что он в нём находит.

Всего он рассматривает [окон: COUNT](#windows). TODO: почему так много или так мало.

## Строка за строкой

Z-буфер начинает с [первой строки первого многоугольника](#row). TODO: что здесь видно.
)"};

constexpr Bilingual story_of_curves{R"(# TODO: the title

- TODO: what the reader can do afterwards

TODO: what there is to see, in two or three sentences.

## Curve by curve

The floating horizon takes [COUNT curves](#curves), the nearest first. TODO: of what surface.

The first one [is visible everywhere](#first). TODO: what becomes of the others.
)",
                                    R"(# TODO: название

- TODO: что читатель сможет делать

TODO: что здесь можно увидеть, в двух-трёх предложениях.

## Кривая за кривой

Плавающий горизонт берёт [кривых: COUNT](#curves), начиная с ближайшей. TODO: какой поверхности.

Первая [видна вся](#first). TODO: что будет с остальными.
)"};

constexpr Bilingual ending{R"(
## Summary

TODO: what to remember, in three to five sentences.

## Questions

1. TODO: a question to think about.

   > TODO: its answer.

2. TODO: another one.

   > TODO: its answer.

## Exercises

1. TODO: something to compute by hand.

   > TODO: the result, with the calculation.

2. TODO: another one.

   > TODO: its result.
)",
                           R"(
## Итоги

TODO: что надо запомнить, в трёх-пяти предложениях.

## Вопросы

1. TODO: вопрос для размышления.

   > TODO: ответ на него.

2. TODO: ещё один.

   > TODO: ответ на него.

## Упражнения

1. TODO: что вычислить от руки.

   > TODO: результат и вычисление.

2. TODO: ещё одно.

   > TODO: его результат.
)"};

std::string with_count(std::string_view story, std::uint64_t count) {
    constexpr std::string_view place = "COUNT";
    std::string text(story);
    return text.replace(text.find(place), place.size(), std::to_string(count));
}

/// The fields that identify an event; the others are its results.
Json subject_of(const Json& event) {
    Json subject;
    for (const char* key : {"e", "at", "window", "polygon", "edge", "corner", "side", "row", "x", "y", "point", "curve",
                            "segment", "fromColumns"}) {
        if (event.contains(key)) subject[key] = event[key];
    }
    return subject;
}

bool is_about(const Json& event, const Json& subject) {
    for (const auto& [key, value] : subject.items()) {
        if (!event.contains(key) || event[key] != value) return false;
    }
    return true;
}

/// The events that lead to a place: a window, a polygon and a row in it, or a curve and a column on it.
std::vector<Json> way_to(const std::vector<Json>& events) {
    std::vector<Json> way;
    for (const Json& event : events) {
        const auto& name = event["e"];
        if (name == "pop" || name == "polygon" || name == "curve") way = {subject_of(event)};
        if (name == "scanline" || name == "visibility") way = {way.front(), subject_of(event)};
    }
    return way;
}

/// The position after the last event of the path.
std::size_t end_of(const std::vector<Json>& way, const std::vector<Json>& events) {
    std::size_t place = 0;
    for (const Json& subject : way) {
        while (!is_about(events[place], subject)) ++place;
        ++place;
    }
    return place;
}

/// A run, with only those fields that differ from the default.
std::string run_json(const LessonRun& run) {
    Json json{{"name", run.name}, {"method", run.method}};
    if (run.detail != Detail::signs) json["detail"] = detail_names[std::size_t(run.detail)];
    return json.dump();
}

std::string pin_json(const std::string& name, const Json& pin) { return Json(name).dump() + ": " + pin.dump(); }

/// One per line, as an author would write them.
std::string lines_of(const std::vector<std::string>& items) {
    std::string lines;
    for (const auto& item : items) lines += (lines.empty() ? "\n  " : ",\n  ") + item;
    return lines + "\n ";
}

/// The number of events of the run that begin like this.
std::uint64_t count_of(std::string_view beginning, const AnyScene& scene, const LessonRun& run) {
    std::uint64_t count = 0;
    EventLines lines;
    trace_run(scene, run, [&](std::string_view text) {
        lines.take(text, [&](std::uint64_t, std::string_view line) { count += line.starts_with(beginning) ? 1 : 0; });
    });
    return count;
}

using Files = std::map<std::string, std::string>;

Files files_of(const std::vector<std::string>& runs, const std::vector<std::string>& pins, const Bilingual& story,
               std::uint64_t count) {
    const std::string lesson =
        "{\"format\": \"vidno-lesson/1\",\n \"minutes\": 45, \"prerequisites\": [], \"sources\": [],\n"
        " \"runs\": [" +
        lines_of(runs) + "],\n \"pins\": {" + lines_of(pins) + "}}\n";
    Files files{{"lesson.json", lesson}};
    for (const Language language : languages) {
        files[story_file(language)] = with_count(story.in(language), count).append(ending.in(language));
    }
    return files;
}

Files lesson_on(const AdmittedScene& scene) {
    LessonRun windows, rows;
    windows.name = "windows";
    windows.method = method_names[std::size_t(Method::warnock)];
    rows.name = "rows";
    rows.method = method_names[std::size_t(Method::zbuffer)];
    windows.detail = Detail::windows;
    const std::uint64_t count = count_of(R"({"e":"pop",)", scene, windows);
    windows.detail = rows.detail = count > most_with_signs ? Detail::windows : Detail::signs;

    const std::vector<std::string> runs{run_json(windows), run_json(rows)};
    const Json pop{{"e", "pop"}}, scanline{{"e", "scanline"}};
    const std::vector<std::string> pins{pin_json("start", {{"find", {pop}}}),
                                        pin_json("windows", {{"find", {pop}}, {"times", count}}),
                                        pin_json("row", {{"run", rows.name}, {"find", {scanline}}})};
    return files_of(runs, pins, story_of_polygons, count);
}

Files lesson_on(const Surface& surface) {
    LessonRun lines;
    lines.name = "lines";
    lines.method = floating_horizon_method;
    lines.detail = column_count(surface.curves) > most_with_signs ? Detail::windows : Detail::signs;
    const auto count = std::uint64_t(surface.curves->curves.size());
    const Json curve{{"e", "curve"}}, line{{"e", "draw_line"}};
    const std::vector<std::string> pins{pin_json("curves", {{"find", {curve}}, {"times", count}}),
                                        pin_json("first", {{"find", {line}}})};
    return files_of({run_json(lines)}, pins, story_of_curves, count);
}

}  // namespace

std::map<std::string, std::string> new_lesson(const AnyScene& scene) {
    return std::visit([](const auto& each) { return lesson_on(each); }, scene);
}

std::string pin_of_step(const AnyScene& scene, const LessonRun& run, std::uint64_t step) {
    std::vector<Json> events;
    EventLines lines;
    trace_run(scene, run, [&](std::string_view text) {
        lines.take(text, [&](std::uint64_t number, std::string_view line) {
            if (number <= step) events.push_back(Json::parse(line));
        });
    });
    if (step == 0 || events.size() < step) throw Refused("run " + run.name + ": has no step " + std::to_string(step));

    const Json subject = subject_of(events.back());
    std::vector<Json> way = way_to(events);
    if (way.empty() || way.back() != subject) {
        for (std::size_t i = end_of(way, events); i < events.size(); ++i) {
            if (is_about(events[i], subject)) way.push_back(subject);
        }
    }
    return Json{{"run", run.name}, {"find", way}}.dump();
}

}  // namespace vidno
