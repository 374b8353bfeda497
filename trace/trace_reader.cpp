#include "trace_reader.h"

#include <nlohmann/json.hpp>

#include "run.h"
#include "scene_json.h"

namespace vidno {

namespace {

using nlohmann::json;

/// A value of the wrong kind: where in the line, and why.
struct Misfit {
    std::string path;
    std::string reason;
};

json parse_line(const std::string& line) {
    json value = json::parse(line, nullptr, false);
    if (value.is_discarded()) throw Misfit{"", "not JSON"};
    if (!value.is_object()) throw Misfit{"", "not an object"};
    return value;
}

template <std::size_t count>
std::size_t index_of(const json& value, const std::array<std::string_view, count>& names, const std::string& path) {
    if (value.is_string()) {
        const auto found = std::find(names.begin(), names.end(), value.get_ref<const std::string&>());
        if (found != names.end()) return std::size_t(found - names.begin());
    }
    throw Misfit{path, "unknown word"};
}

int read_int(const json& value, const std::string& path) {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= std::uint64_t(largest)) return value.get<int>();
    if (value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() >= -largest) {
        return value.get<int>();
    }
    throw Misfit{path, "not a whole number, or too large"};
}

bool is_fraction(std::string_view text) {
    const auto is_digits = [](std::string_view part) {
        return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (text.starts_with('-')) text.remove_prefix(1);
    const auto slash = text.find('/');
    return slash != std::string_view::npos && is_digits(text.substr(0, slash)) && is_digits(text.substr(slash + 1));
}

Color read_color(const json& value, const std::string& path) {
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        unsigned number = 0;
        const char* end = text.data() + text.size();
        if (text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, number, 16).ptr == end) {
            return {std::uint8_t(number >> 16), std::uint8_t(number >> 8 & 255), std::uint8_t(number & 255)};
        }
    }
    throw Misfit{path, "not a colour #rrggbb"};
}

/// Reads the fields of one event out of its object.
class EventReader {
public:
    EventReader(const json& object, const std::map<std::string, int, std::less<>>& places, bool exact)
        : object_(object), places_(places), exact_(exact) {}

    template <class E>
    E read() {
        E event;
        event.at = Line(index_of(member("at"), line_names, "/at"));
        fields_ = 2;  // e and at
        E::fields(event, [&](std::string_view key, auto& target) { field(key, target); });
        if (object_.size() != fields_) throw Misfit{"", "unknown key " + unknown_key(event)};
        return event;
    }

private:
    const json& member(std::string_view key) const {
        const auto found = object_.find(std::string(key));
        if (found == object_.end()) throw Misfit{"", "no key " + std::string(key)};
        return *found;
    }

    template <class T>
    void field(std::string_view key, T& target) {
        value(member(key), target, "/" + std::string(key));
        ++fields_;
    }
    template <class T>
    void field(std::string_view key, std::optional<T>& target) {
        if (object_.contains(std::string(key))) field(key, target.emplace());
    }

    void value(const json& v, Value& target, const std::string& path) const {
        // Rows stand as plain numbers under every kernel.
        const std::string text = v.is_string() ? v.get<std::string>() : "";
        if (v.is_number()) {
            target.number = v.get<double>();
        } else if (text == "inf") {
            target = Value::infinite();
        } else if (text == "-inf") {
            target = Value::minus_infinite();
        } else if (text == "nan" && !exact_) {
            target.number = std::numeric_limits<double>::quiet_NaN();
        } else if (exact_ && is_fraction(text)) {
            target = Value(text);
        } else {
            throw Misfit{path, "not a number of this kernel"};
        }
    }
    void value(const json& v, int& target, const std::string& path) const { target = read_int(v, path); }
    void value(const json& v, bool& target, const std::string& path) const {
        if (!v.is_boolean()) throw Misfit{path, "not true or false"};
        target = v.get<bool>();
    }
    void value(const json& v, double& target, const std::string& path) const {
        if (!v.is_number()) throw Misfit{path, "not a number"};
        target = v.get<double>();
    }
    void value(const json& v, std::string& target, const std::string& path) const {
        if (!v.is_string()) throw Misfit{path, "not a text"};
        target = v.get<std::string>();
    }
    void value(const json& v, Color& target, const std::string& path) const { target = read_color(v, path); }
    void value(const json& v, PolygonPlace& target, const std::string& path) const {
        const auto found = v.is_string() ? places_.find(v.get_ref<const std::string&>()) : places_.end();
        if (found == places_.end()) throw Misfit{path, "no polygon of the scene"};
        target.index = found->second;
    }
    void value(const json& v, Sign& target, const std::string& path) const {
        const int sign = read_int(v, path);
        if (sign < -1 || sign > 1) throw Misfit{path, "not -1, 0 or 1"};
        target = Sign{sign};
    }
    void value(const json& v, VisibilityFlag& target, const std::string& path) const {
        const int flag = read_int(v, path);
        if (flag < -1 || flag > 2) throw Misfit{path, "not -1, 0, 1 or 2"};
        target = VisibilityFlag(flag);
    }
    void value(const json& v, Corner& target, const std::string& path) const {
        target = Corner(index_of(v, corner_names, path));
    }
    void value(const json& v, Case& target, const std::string& path) const {
        target = Case(index_of(v, case_names, path));
    }
    void value(const json& v, Lies& target, const std::string& path) const {
        target = Lies(index_of(v, lies_names, path));
    }
    void value(const json& v, Relation& target, const std::string& path) const {
        target = Relation(index_of(v, relation_names, path));
    }
    void value(const json& v, Procedure& target, const std::string& path) const {
        target = Procedure(index_of(v, procedure_names, path));
    }
    void value(const json& v, Decision& target, const std::string& path) const {
        target = Decision(index_of(v, decision_names, path));
    }
    void value(const json& v, FilterStage& target, const std::string& path) const {
        target = FilterStage(index_of(v, filter_stage_names, path));
    }
    void value(const json& v, Cause& target, const std::string& path) const {
        target = Cause(index_of(v, cause_names, path));
    }
    void value(const json& v, Answer& target, const std::string& path) const {
        if (v.is_boolean()) {
            target = v.get<bool>();
        } else if (v.is_array()) {
            value(v, target.emplace<std::pair<int, int>>(), path);
        } else {
            target = read_int(v, path);
        }
    }
    void value(const json& v, Truth& target, const std::string& path) const {
        if (!v.is_null()) value(v, target.answer.emplace(), path);
    }
    void value(const json& v, ValuePoint& t, const std::string& path) const { list(v, path, t.x, t.y); }
    void value(const json& v, ValueVertex& t, const std::string& path) const { list(v, path, t.x, t.y, t.z); }
    void value(const json& v, PolygonPart& t, const std::string& path) const {
        list(v, path, t.polygon, t.region, t.ground);
    }
    void value(const json& v, Window& t, const std::string& path) const { list(v, path, t.x, t.y, t.width, t.height); }
    void value(const json& v, PixelRectangle& t, const std::string& path) const {
        list(v, path, t.x, t.y, t.width, t.height);
    }
    void value(const json& v, PixelRun& t, const std::string& path) const { list(v, path, t.row, t.first, t.end); }
    void value(const json& v, ColumnRun& t, const std::string& path) const { list(v, path, t.first, t.end); }
    template <class A, class B>
    void value(const json& v, std::pair<A, B>& t, const std::string& path) const {
        list(v, path, t.first, t.second);
    }
    void value(const json& v, std::array<Value, 4>& t, const std::string& path) const {
        list(v, path, t[0], t[1], t[2], t[3]);
    }
    template <class T>
    void value(const json& v, std::vector<T>& target, const std::string& path) const {
        if (!v.is_array()) throw Misfit{path, "not a list"};
        for (std::size_t i = 0; i < v.size(); ++i) value(v[i], target.emplace_back(), path + "/" + std::to_string(i));
    }

    void list(const json& v, const std::string& path, auto&... targets) const {
        if (!v.is_array() || v.size() != sizeof...(targets)) {
            throw Misfit{path, "not a list of " + std::to_string(sizeof...(targets))};
        }
        std::size_t i = 0;
        const auto next = [&](auto& target) {
            value(v[i], target, path + "/" + std::to_string(i));
            ++i;
        };
        (next(targets), ...);
    }

    template <class E>
    std::string unknown_key(const E& event) const {
        for (const auto& item : object_.items()) {
            const std::string& key = item.key();
            bool known = key == "e" || key == "at";
            E::fields(event, [&](std::string_view name, const auto&) { known = known || name == key; });
            if (!known) return key;
        }
        return "";
    }

    const json& object_;
    const std::map<std::string, int, std::less<>>& places_;
    bool exact_;
    std::size_t fields_ = 0;
};

template <std::size_t i = 0>
Event read_event(EventReader& reader, std::string_view name, Detail detail) {
    if constexpr (i == std::variant_size_v<AnyEvent>) {
        throw Misfit{"/e", "unknown event"};
    } else {
        using E = std::variant_alternative_t<i, AnyEvent>;
        if (name != E::kind.name) return read_event<i + 1>(reader, name, detail);
        if (E::kind.from > detail) throw Misfit{"/e", "an event above the trace's level of detail"};
        return reader.read<E>();
    }
}

void expect_keys(const json& object, std::initializer_list<std::string_view> keys, const std::string& path) {
    for (const auto& [key, unused] : object.items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) throw Misfit{path, "unknown key " + key};
    }
}

const json& required(const json& object, std::string_view key, const std::string& path) {
    const auto found = object.find(key);
    if (found == object.end()) throw Misfit{path, "no key " + std::string(key)};
    return *found;
}

TraceEnd read_end(const json& object, std::string_view result) {
    expect_keys(object, {"end"}, "");
    const json& end = object["end"];
    if (!end.is_object()) throw Misfit{"/end", "not an object"};
    expect_keys(end, {"events", result, "partial"}, "/end");
    TraceEnd found;
    const json& events = required(end, "events", "/end");
    if (!events.is_number_unsigned()) throw Misfit{"/end/events", "not a count"};
    found.events = events.get<std::uint64_t>();
    if (end.contains("partial")) {
        if (end["partial"] != true || end.contains(result)) throw Misfit{"/end/partial", "not true and alone"};
        found.partial = true;
        return found;
    }
    const json& hash = required(end, result, "/end");
    if (!hash.is_string()) throw Misfit{"/end/" + std::string(result), "not a text"};
    found.hash = hash.get<std::string>();
    return found;
}

std::string read_kernel(const json& value) {
    if (!value.is_string() || !kernel_named(value.get<std::string>())) {
        throw Misfit{"/kernel", "not one of " + kernel_names()};
    }
    return value.get<std::string>();
}

json parse_header(const std::string& line) {
    json object = parse_line(line);
    if (!object.contains("format") || object["format"] != "vidno-trace/1") {
        throw Misfit{"/format", "not a trace of format vidno-trace/1"};
    }
    expect_keys(object, {"format", "method", "edition", "kernel", "detail", "scene"}, "");
    return object;
}

/// What headers of both kinds have.
void read_run(const json& object, auto& header) {
    header.edition = Edition(index_of(required(object, "edition", ""), edition_names, "/edition"));
    header.kernel = read_kernel(required(object, "kernel", ""));
    header.detail = Detail(index_of(required(object, "detail", ""), detail_names, "/detail"));
}

TraceHeader read_header(const std::string& line, const std::string& file) {
    const json object = parse_header(line);
    const json& method = required(object, "method", "");
    if (method == curve_method) throw Misfit{"/method", "floating-horizon, which this command does not take"};
    TraceHeader header;
    header.method = Method(index_of(method, method_names, "/method"));
    read_run(object, header);
    header.scene = read_scene(required(object, "scene", "").dump(), file + ":1: /scene").scene;
    return header;
}

CurveHeader read_curve_header(const std::string& line, const std::string& file) {
    const json object = parse_header(line);
    CurveHeader header;
    read_run(object, header);
    if (!kernel_named(header.kernel)->choice->runs_curves(header.edition)) {
        throw Misfit{"/kernel", "no kernel and edition of floating-horizon"};
    }
    const json& scene = required(object, "scene", "");
    if (scene.contains("function")) throw Misfit{"/scene/function", "a trace has the samples"};
    header.scene = read_surface(scene.dump(), file + ":1: /scene");
    return header;
}

std::string message(const std::string& place, const Misfit& misfit) {
    return place + ": " + (misfit.path.empty() ? "" : misfit.path + ": ") + misfit.reason;
}

}  // namespace

TraceFile::TraceFile(LineReader lines, std::string file) : lines_(std::move(lines)), file_(std::move(file)) {
    if (!lines_.next(first_line_)) throw Refused(file_ + ": empty, not a trace");
}

bool TraceFile::is_of_curves() const {
    const json object = json::parse(first_line_, nullptr, false);
    return object.is_object() && object.contains("method") && object["method"] == curve_method;
}

template <class Header>
Header TraceFile::header_by(Header (*read)(const std::string& line, const std::string& file)) {
    try {
        Header header = read(first_line_, file_);
        first_line_.clear();
        reading_.detail = header.detail;
        reading_.exact = header.kernel == "exact";
        return header;
    } catch (const Misfit& misfit) {
        throw Refused(message(place(), misfit));
    }
}

TraceReader::TraceReader(TraceFile file) : TraceFile(std::move(file)), header_(header_by(read_header)) {
    const auto& polygons = header_.scene.polygons;
    for (std::size_t i = 0; i < polygons.size(); ++i) reading_.places.emplace(polygons[i].id, int(i));
    reading_.result = "picture";
}

CurveTraceReader::CurveTraceReader(TraceFile file) : TraceFile(std::move(file)), header_(header_by(read_curve_header)) {
    reading_.result = "lines";
}

AnyTraceReader open_trace(LineReader lines, std::string file) {
    TraceFile opened(std::move(lines), std::move(file));
    if (opened.is_of_curves()) return CurveTraceReader(std::move(opened));
    return TraceReader(std::move(opened));
}

std::optional<Event> TraceFile::next() {
    std::string line;
    if (end_ || !lines_.next(line)) return std::nullopt;
    ++line_number_;
    try {
        return parse(line);
    } catch (const Misfit& misfit) {
        if (lines_.cut()) return std::nullopt;
        throw Refused(message(place(), misfit));
    }
}

std::optional<Event> TraceFile::parse(const std::string& line) {
    const json object = parse_line(line);
    const auto name = object.find("e");
    if (name == object.end() && object.contains("end")) {
        end_ = read_end(object, reading_.result);
        if (end_->events != events_) throw Misfit{"/end/events", "not the number of events read"};
        std::string rest;
        if (lines_.next(rest)) throw Misfit{"", "text after the last line"};
        return std::nullopt;
    }
    if (name == object.end() || !name->is_string()) throw Misfit{"/e", "no name of an event"};
    EventReader reader(object, reading_.places, reading_.exact);
    Event event = read_event(reader, name->get_ref<const std::string&>(), reading_.detail);
    ++events_;
    return event;
}

}  // namespace vidno
