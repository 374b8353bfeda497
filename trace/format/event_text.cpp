#include "format/event_text.h"

#include <string_view>
#include <utility>

#include "format/field_writer.h"

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
        out.put(LineBound(names_)(e), [&](char* to) {
            FieldWriter<Pen> writer(Pen{to}, names_, shortest_);
            writer.value(e);
            *writer.out().at = '\n';
            return writer.out().at + 1;
        });
    });
}

}  // namespace vidno
