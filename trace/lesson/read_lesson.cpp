#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "choice/method.h"
#include "choice/read_choice.h"
#include "choice/read_texts.h"
#include "json/document_format.h"
#include "json/json_node.h"
#include "lesson.h"
#include "output.h"

namespace vidno {

namespace {

constexpr std::string_view lesson_format = "vidno-lesson/1";

/// The line that a refusal names, or the line of the value at its JSON pointer, as close as its keys lead.
int line_of(std::string_view text, const std::string& place) {
    int line = 0;
    if (std::sscanf(place.c_str(), "line %d", &line) == 1) return line;
    std::string_view pointer = place;
    std::size_t position = 0;
    while (pointer.starts_with('/')) {
        pointer.remove_prefix(1);
        const std::string key = '"' + std::string(pointer.substr(0, pointer.find('/'))) + '"';
        const auto found = text.find(key, position);
        if (found != text.npos) position = found;
        pointer.remove_prefix(std::min(pointer.size(), pointer.find('/')));
    }
    return 1 + int(line_start(text, position).lines_before);
}

/// The methods that a lesson may use.
std::vector<std::string_view> lesson_methods() {
    std::vector<std::string_view> names(method_names.begin(), method_names.end());
    names.push_back(floating_horizon_method);
    return names;
}

/// A name, by its index among the allowed ones.
std::size_t choice(const JsonNode& node, std::string_view key, const auto& names, std::size_t otherwise = 0) {
    if (!node.has(key)) return otherwise;
    return node.at(key).place_among(names, node.at(key).text() + ": does not exist");
}

/// Reads lesson.json.
class LessonReader {
public:
    LessonReader(Lesson& lesson, Problems& problems)
        : lesson_(lesson), problems_(problems), file_(lesson.file("lesson.json")) {
        if (!std::filesystem::exists(file_)) throw Refused(file_ + " is missing, so this is not a lesson");
        text_ = read_text(file_);
        expect_format_in(text_, lesson_format, file_);
    }

    void read() {
        guarded([&] {
            const nlohmann::json document = parse_json(text_);
            const JsonNode root(document);
            root.object();
            root.expect_format(lesson_format);
            root.require_keys({"format", "runs", "pins"}, {"shows", "minutes", "prerequisites", "assumes", "sources"});
            const JsonNode runs = root.at("runs");
            if (runs.size() == 0) runs.refuse("a lesson needs at least one run");
            for (std::size_t i = 0; i < runs.size(); ++i) read_run(runs.at(i));
            if (root.has("shows")) read_shows(root.at("shows"));
            guarded([&] { read_frame(root); });
            const JsonNode pins = root.at("pins");
            for (const auto& name : pins.keys()) {
                guarded([&] { read_pin(name, pins.at(name)); });
            }
        });
    }

private:
    /// A refusal gives the place as a pointer, but an author needs a line.
    void guarded(auto&& read) {
        try {
            read();
        } catch (const Refused& refused) {
            const std::string what = refused.what();
            problems_.push_back({file_, line_of(text_, what.substr(0, what.find(": "))), what});
        }
    }

    void read_shows(const JsonNode& node) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            const std::string& part = node.at(i).text();
            if (std::find(state_parts.begin(), state_parts.end(), part) == state_parts.end()) {
                node.at(i).refuse(part + ": no state has such a part");
            }
            lesson_.shows.push_back(part);
        }
    }

    void read_frame(const JsonNode& root) {
        Frame& frame = lesson_.frame;
        if (root.has("minutes")) frame.minutes = root.at("minutes").whole_number(5, 180);
        if (root.has("assumes")) frame.assumes = read_texts(root.at("assumes"));
        if (root.has("prerequisites")) {
            const JsonNode node = root.at("prerequisites");
            frame.prerequisites.emplace();
            for (std::size_t i = 0; i < node.size(); ++i) frame.prerequisites->push_back(read_prerequisite(node.at(i)));
        }
        if (root.has("sources")) {
            const JsonNode node = root.at("sources");
            frame.sources.emplace();
            for (std::size_t i = 0; i < node.size(); ++i) frame.sources->push_back(read_reading(node.at(i)));
        }
    }

    /// A lesson beside this one and, by its name, before it: so no two lessons require each other.
    Frame::Prerequisite read_prerequisite(const JsonNode& node) {
        const std::string& id = node.text();
        const auto folder = lesson_.place.parent_path() / id;
        if (!std::filesystem::exists(folder / "lesson.json")) node.refuse("there is no lesson " + id);
        if (id >= lesson_.id) node.refuse(id + " does not come before this lesson");
        return {id, in_each_language([&](Language language) {
                    const std::string file = (folder / story_file(language)).string();
                    Problems of_that_lesson;
                    if (!std::filesystem::exists(file)) return id;
                    return read_story(read_text(file), language, file, of_that_lesson).plain_title;
                })};
    }

    Frame::Reading read_reading(const JsonNode& node) {
        node.require_keys({"key"}, {"chapter"});
        Frame::Reading reading{node.at("key").text()};
        if (node.has("chapter")) reading.chapter = node.at("chapter").text();
        auto& bibliography = lesson_.frame.bibliography;
        const auto file = lesson_.place.parent_path() / "sources.json";
        if (bibliography.is_null() && std::filesystem::exists(file)) {
            bibliography = parse_json(read_text(file.string()));
        }
        if (!bibliography.contains(reading.key)) node.at("key").refuse(reading.key + ": not in " + file.string());
        return reading;
    }

    void read_run(const JsonNode& node) {
        node.require_keys({"name", "method"}, {"title", "scene", "kernel", "edition", "detail", "check"});
        LessonRun run;
        run.name = node.at("name").text();
        if (has_run(run.name)) node.at("name").refuse(run.name + ": another run has this name");
        if (node.has("title")) run.title = read_texts(node.at("title"));
        if (node.has("scene")) run.scene = node.at("scene").text();
        const auto methods = lesson_methods();
        run.method = methods[choice(node, "method", methods)];
        run.detail = Detail(choice(node, "detail", detail_names, std::size_t(Detail::signs)));
        if (node.has("edition")) run.edition = read_edition(node.at("edition"));
        if (node.has("kernel")) run.kernel = read_kernel(node.at("kernel"));
        const KernelChoice& kernel = *run.kernel.choice;
        const bool runs =
            run.of_curves() ? kernel.runs_floating_horizon(run.edition) : kernel.runs(method_of(run), run.edition);
        if (!runs) node.refuse(std::string(kernel.name) + " does not run this method in this edition");
        run.check = node.has("check") && node.at("check").truth();
        lesson_.runs.push_back(std::move(run));
    }

    void read_pin(const std::string& name, const JsonNode& node) {
        node.require_keys({"find"}, {"run", "says", "times"});
        Pin pin;
        pin.name = name;
        pin.line = line_of(text_, "/pins/" + name);
        pin.run = node.has("run") ? node.at("run").text() : lesson_.runs.front().name;
        if (!has_run(pin.run)) node.at("run").refuse(pin.run + ": no run has this name");
        const JsonNode find = node.at("find");
        for (std::size_t i = 0; i < find.size(); ++i) pin.find.push_back(find.at(i).object());
        if (pin.find.empty()) find.refuse("contains no event");
        if (node.has("says")) pin.says = node.at("says").object();
        if (node.has("times")) {
            pin.times = node.at("times").whole_number(1, 1 << 30);
            if (find.size() != 1)
                find.refuse("a pin with \"times\" counts events of one kind, so its path has one event");
        }
        lesson_.pins.push_back(std::move(pin));
    }

    bool has_run(const std::string& name) const {
        return std::any_of(lesson_.runs.begin(), lesson_.runs.end(),
                           [&](const LessonRun& run) { return run.name == name; });
    }

    Lesson& lesson_;
    Problems& problems_;
    std::string file_, text_;
};

Story story_in(const Lesson& lesson, Language language, Problems& problems) {
    const std::string file = lesson.file(story_file(language));
    if (std::filesystem::exists(file)) return read_story(read_text(file), language, file, problems);
    problems.push_back({file, 1, "is not there"});
    return {};
}

}  // namespace

Lesson read_lesson(const std::string& folder, Problems& problems) {
    Lesson lesson;
    const auto without_slash = [](const std::filesystem::path& path) { return (path / "").parent_path(); };
    lesson.folder = without_slash(folder).string();
    lesson.place = without_slash(std::filesystem::absolute(folder).lexically_normal());
    lesson.id = lesson.place.filename().string();
    LessonReader(lesson, problems).read();
    lesson.stories = in_each_language([&](Language language) { return story_in(lesson, language, problems); });
    return lesson;
}

}  // namespace vidno
