#include "format/event_text.h"

#include <string_view>
#include <utility>

#include "format/event_fields.h"

// Header-only programs, which link no library, define this as `inline`.
#ifndef VIDNO_INLINE
#define VIDNO_INLINE
#endif

namespace vidno {

namespace {

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

/// Writes one event, to a place with room for it.
class LineWriter {
public:
    LineWriter(char* to, const PolygonNames& names, RememberedShortest& shortest)
        : out_{to}, names_(names), shortest_(shortest) {}

    /// Gives the end of the line.
    template <class E>
    char* line(const E& event) {
        out_ += std::string_view(R"({"e":")");
        out_ += E::kind.name;
        out_ += std::string_view(R"(","at":")");
        out_ += line_names[std::size_t(event.at)];
        out_ += '"';
        E::fields(event,
                  [&](std::string_view key, const auto& v, const Meaning& = any_number) { this->field(key, v); });
        out_ += std::string_view("}\n");
        return out_.at;
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
    void value(double v) { shortest_.append(out_, v); }
    void value(const std::string& v) { append_string(out_, v); }
    void value(const Value& v) { v.fraction ? value(*v.fraction) : value(v.number); }
    void value(const Fraction& v) { v.text.empty() ? null() : name(v.text); }
    void value(const Color& v) { append_color(out_, v); }
    void value(PolygonPlace v) { out_ += std::string_view(names_[std::size_t(v.index)]); }
    void value(Sign v) { value(int(v)); }
    void value(VisibilityFlag v) { value(int(v)); }
    void value(Word auto v) { name(words_of(v)[std::size_t(v)]); }
    void value(const Answer& v) {
        std::visit([&](const auto& answer) { value(answer); }, v);
    }
    void value(const Truth& v) { v.answer ? value(*v.answer) : null(); }
    void value(const Listed auto& v) {
        with_items(v, [&](const auto& first, const auto&... rest) {
            out_ += '[';
            this->value(first);
            ((out_ += ',', this->value(rest)), ...);
            out_ += ']';
        });
    }
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

    void null() { out_ += std::string_view("null"); }
    void name(std::string_view text) {
        out_ += '"';
        out_ += text;
        out_ += '"';
    }

    Pen out_;
    const PolygonNames& names_;
    RememberedShortest& shortest_;
};

}  // namespace

VIDNO_INLINE PolygonNames polygon_names(const Scene& scene) {
    PolygonNames names;
    for (const auto& polygon : scene.polygons) {
        Text name;
        append_string(name, polygon.id);
        names.push_back(name.string());
    }
    return names;
}

VIDNO_INLINE void EventText::line(Text& out, const EventView& event) {
    event.visit([&](const auto& e) {
        out.put(LineBound(names_)(e), [&](char* to) { return LineWriter(to, names_, shortest_).line(e); });
    });
}

VIDNO_INLINE void EventText::value(Text& out, const Value& v) {
    v.fraction ? append_string(out, *v.fraction) : shortest_.append(out, v.number);
}

}  // namespace vidno
