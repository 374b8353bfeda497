/// FieldWriter: the values of events and states as JSON.
#pragma once

#include <cassert>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "format/event_fields.h"
#include "format/event_text.h"

namespace vidno {

/// A structure that is written as an object.
template <class T>
concept Fielded = requires(const T& value) {
    T::fields(value, [](std::string_view, const auto&, const auto&...) {});
};

/// Out is `Text&`; or Pen, for a place with room for everything. `Events` are the types of the events that values
/// contain.
template <class Out, class Events = EventTypes<>>
class FieldWriter {
public:
    FieldWriter(Out out, const PolygonNames& names, RememberedShortest& shortest)
        : out_(out), names_(names), shortest_(shortest) {}

    const std::remove_reference_t<Out>& out() const { return out_; }

    template <EventType E>
    void value(const E& event) {
        out_ += std::string_view(R"({"e":")");
        out_ += E::kind.name;
        out_ += std::string_view(R"(","at":")");
        out_ += line_names[std::size_t(event.at)];
        out_ += '"';
        E::fields(event,
                  [&](std::string_view key, const auto& v, const Meaning& = any_number) { this->field(key, v); });
        out_ += '}';
    }
    void value(const Event& event) {
        event.visit([this]<class E>(const E& e) {
            assert(Events::template has<E>());
            if constexpr (Events::template has<E>()) this->value(e);
        });
    }
    template <Fielded T>
    void value(const T& v) requires(!EventType<T>) {
        char before = '{';
        T::fields(v, [&](std::string_view key, const auto& field) {
            out_ += std::exchange(before, ',');
            this->key(key);
            this->value(field);
        });
        out_ += '}';
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
    void value(Line v) { name(line_names[std::size_t(v)]); }
    void value(Word auto v) { name(words_of(v)[std::size_t(v)]); }
    void value(const Answer& v) {
        std::visit([&](const auto& answer) { value(answer); }, v);
    }
    void value(const Truth& v) { value(v.answer); }
    void value(const Listed auto& v) {
        with_items(v, [&](const auto& first, const auto&... rest) {
            out_ += '[';
            this->value(first);
            ((out_ += ',', this->value(rest)), ...);
            out_ += ']';
        });
    }
    template <class T>
    void value(const std::optional<T>& v) {
        v ? value(*v) : null();
    }
    template <class T>
    void value(const std::shared_ptr<const T>& v) {
        value(*v);
    }
    template <class T>
    void value(const std::vector<T>& items) {
        list(items.begin(), items.end(), std::identity{});
    }
    void value(const std::vector<bool>& items) {
        list(items.begin(), items.end(), [](bool item) { return item; });
    }
    /// What `as` makes of the items.
    void list(auto first, auto end, auto&& as) {
        out_ += '[';
        for (auto item = first; item != end; ++item) {
            if (item != first) out_ += ',';
            value(as(*item));
        }
        out_ += ']';
    }

    void key(std::string_view key) {
        name(key);
        out_ += ':';
    }
    void null() { out_ += std::string_view("null"); }

private:
    void field(std::string_view key, const auto& v) {
        out_ += std::string_view(",\"");
        out_ += key;
        out_ += std::string_view("\":");
        value(v);
    }
    /// An event leaves out what it does not have.
    template <class T>
    void field(std::string_view key, const std::optional<T>& v) {
        if (v) field(key, *v);
    }
    void name(std::string_view text) {
        out_ += '"';
        out_ += text;
        out_ += '"';
    }

    Out out_;
    const PolygonNames& names_;
    RememberedShortest& shortest_;
};

}  // namespace vidno
