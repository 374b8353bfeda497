/// Events as lines of JSON, written field by field.
#pragma once

#include "format/event_fields.h"

namespace vidno {

/// The ids of a scene's polygons as JSON strings, in the scene's order.
using PolygonNames = std::vector<std::string>;

inline PolygonNames polygon_names(const Scene& scene) {
    PolygonNames names;
    for (const auto& polygon : scene.polygons) {
        Text name;
        append_string(name, polygon.id);
        names.push_back(name.string());
    }
    return names;
}

/// The most bytes that an event may take as a line, the sum of the limits of its pieces.
class LineBound {
public:
    explicit LineBound(const PolygonNames& names) : names_(names) {}

    template <class E>
    std::size_t operator()(const E& event) {
        bytes_ = 100;  // the longest names of an event and of a line, with the characters around them
        E::fields(event, [&](std::string_view key, const auto& value, const Meaning& = any_number) {
            bytes_ += key.size() + std::string_view(R"(,"":)").size();
            add(value);
        });
        return bytes_;
    }

private:
    void add(const Value& v) { v.fraction ? add(*v.fraction) : add(v.number); }
    void add(const std::string& v) { bytes_ += 6 * v.size() + 2; }  // \u0000 for each byte, in quotes
    void add(const Fraction& v) { bytes_ += v.text.size() + 4; }    // in quotes, or null
    void add(PolygonPlace v) { bytes_ += names_[std::size_t(v.index)].size(); }
    void add(const Answer&) { add_all(0, 0); }  // two numbers at most
    void add(const Truth&) { add_all(0, 0); }
    template <Word T>
    void add(const T& v) {
        bytes_ += words_of(v)[std::size_t(v)].size() + 2;
    }
    template <Listed T>
    void add(const T& v) {
        with_items(v, [this](const auto&... items) { this->add_all(items...); });
    }
    template <class T>
    void add(const std::optional<T>& v) {
        if (v) add(*v);
    }
    template <class T>
    void add(const std::vector<T>& items) {
        for (const auto& item : items) add_all(item);
    }
    template <class T>
    void add(const T&) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_ += longest_number;
    }
    void add_all(const auto&... values) {
        bytes_ += 2 + sizeof...(values);  // brackets and commas
        (add(values), ...);
    }

    const PolygonNames& names_;
    std::size_t bytes_ = 0;
};

class EventText {
public:
    explicit EventText(PolygonNames names) : names_(std::move(names)) {}

    /// Appends the event as one line, newline included.
    template <class E>
    void line(Text& out, const E& event) {
        out.put(LineBound(names_)(event), [&](char* to) {
            Pen pen{to};
            pen += std::string_view(R"({"e":")");
            pen += E::kind.name;
            pen += std::string_view(R"(","at":")");
            pen += line_names[std::size_t(event.at)];
            pen += '"';
            E::fields(event, [&](std::string_view key, const auto& value, const Meaning& = any_number) {
                field(pen, key, value);
            });
            pen += std::string_view("}\n");
            return pen.at;
        });
    }

    void value(auto& out, const Value& v) {
        if (v.fraction) {
            append_string(out, *v.fraction);
        } else {
            append_number(out, v.number, shortest_);
        }
    }

private:
    void field(Pen& out, std::string_view key, const auto& v) {
        out += std::string_view(",\"");
        out += key;
        out += std::string_view("\":");
        value(out, v);
    }
    template <class T>
    void field(Pen& out, std::string_view key, const std::optional<T>& v) {
        if (v) field(out, key, *v);
    }

    void value(Pen& out, int v) { append_integer(out, v); }
    void value(Pen& out, bool v) { out += std::string_view(v ? "true" : "false"); }
    void value(Pen& out, double v) { append_number(out, v, shortest_); }
    void value(Pen& out, const std::string& v) { append_string(out, v); }
    void value(Pen& out, const Fraction& v) {
        if (v.text.empty()) {
            out += std::string_view("null");
        } else {
            name(out, v.text);
        }
    }
    void value(Pen& out, const Color& v) { append_color(out, v); }
    void value(Pen& out, PolygonPlace v) { out += std::string_view(names_[std::size_t(v.index)]); }
    void value(Pen& out, Sign v) { append_integer(out, int(v)); }
    void value(Pen& out, VisibilityFlag v) { append_integer(out, int(v)); }
    void value(Pen& out, Word auto v) { name(out, words_of(v)[std::size_t(v)]); }
    void value(Pen& out, const Answer& v) {
        std::visit([&](const auto& answer) { value(out, answer); }, v);
    }
    void value(Pen& out, const Truth& v) {
        if (v.answer) {
            value(out, *v.answer);
        } else {
            out += std::string_view("null");
        }
    }
    void value(Pen& out, const Listed auto& v) {
        with_items(v, [&](const auto&... items) { this->list(out, items...); });
    }
    template <class T>
    void value(Pen& out, const std::vector<T>& items) {
        out += '[';
        bool first = true;
        for (const auto& item : items) {
            if (!std::exchange(first, false)) out += ',';
            value(out, item);
        }
        out += ']';
    }

    static void name(Pen& out, std::string_view text) {
        out += '"';
        out += text;
        out += '"';
    }
    void list(Pen& out, const auto& first, const auto&... rest) {
        out += '[';
        value(out, first);
        ((out += ',', value(out, rest)), ...);
        out += ']';
    }

    PolygonNames names_;
    RememberedShortest shortest_;
};

}  // namespace vidno
