/// Events as lines of JSON, written field by field.
#pragma once

#include <span>

#include "event.h"

namespace vidno {

/// The ids of a scene's polygons as JSON strings, in the scene's order.
using PolygonNames = std::vector<std::string>;

inline PolygonNames polygon_names(const Scene& scene) {
    PolygonNames names;
    for (const auto& polygon : scene.polygons) append_string(names.emplace_back(), polygon.id);
    return names;
}

/// Appends to a std::string or a Text.
template <class Out>
class EventText {
public:
    EventText(Out& out, const PolygonNames& names) : out_(out), names_(names) {}

    /// Appends the event as one line, newline included.
    template <class E>
    void line(const E& event) {
        out_ += std::string_view(R"({"e":")");
        out_ += E::kind.name;
        out_ += std::string_view(R"(","at":")");
        out_ += line_names[std::size_t(event.at)];
        out_ += '"';
        E::fields(event, [&](std::string_view key, const auto& value) { field(key, value); });
        out_ += std::string_view("}\n");
    }

    void value(const Value& v) {
        if (v.fraction) {
            append_string(out_, *v.fraction);
        } else {
            append_number(out_, v.number);
        }
    }

private:
    void field(std::string_view key, const auto& v) {
        out_ += std::string_view(",\"");
        out_ += key;
        out_ += std::string_view("\":");
        value(v);
    }
    template <class T>
    void field(std::string_view key, const std::optional<T>& v) {
        if (v) field(key, *v);
    }

    void value(int v) { append_integer(out_, v); }
    void value(bool v) { out_ += std::string_view(v ? "true" : "false"); }
    void value(double v) { append_number(out_, v); }
    void value(const std::string& v) { append_string(out_, v); }
    void value(const Color& v) { append_color(out_, v); }
    void value(PolygonPlace v) { out_ += std::string_view(names_[std::size_t(v.index)]); }
    void value(Sign v) { append_integer(out_, int(v)); }
    void value(Corner v) { name(corner_names[std::size_t(v)]); }
    void value(Case v) { name(case_names[std::size_t(v)]); }
    void value(Procedure v) { name(procedure_names[std::size_t(v)]); }
    void value(const ValuePoint& v) { list(v.x, v.y); }
    void value(const ValueVertex& v) { list(v.x, v.y, v.z); }
    void value(const Window& v) { list(v.x, v.y, v.width, v.height); }
    void value(const PixelRectangle& v) { list(v.x, v.y, v.width, v.height); }
    void value(const PixelRun& v) { list(v.row, v.first, v.end); }
    void value(const ColumnRun& v) { list(v.first, v.end); }
    void value(const AplEntry& v) { list(v.first, v.second); }
    void value(const std::pair<int, int>& v) { list(v.first, v.second); }
    void value(const std::array<Value, 4>& v) { list(v[0], v[1], v[2], v[3]); }
    template <class T>
    void value(const std::vector<T>& items) {
        out_ += '[';
        bool first = true;
        for (const auto& item : items) {
            if (!std::exchange(first, false)) out_ += ',';
            value(item);
        }
        out_ += ']';
    }

    void name(std::string_view text) {
        out_ += '"';
        out_ += text;
        out_ += '"';
    }
    void list(const auto& first, const auto&... rest) {
        out_ += '[';
        value(first);
        ((out_ += ',', value(rest)), ...);
        out_ += ']';
    }

    Out& out_;
    const PolygonNames& names_;
};

}  // namespace vidno
