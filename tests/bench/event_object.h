/// An event as a tree of JSON values, as a trace would be written without EventText.
#pragma once

#include <nlohmann/json.hpp>

#include "format/event_fields.h"

namespace vidno {

class EventObject {
public:
    explicit EventObject(const Scene& scene) : scene_(scene) {}

    template <class E>
    nlohmann::json operator()(const E& event) const {
        nlohmann::json object{{"e", E::kind.name}, {"at", line_names[std::size_t(event.at)]}};
        E::fields(event, [&](std::string_view key, const auto& v, const auto&...) { field(object, key, v); });
        return object;
    }

private:
    using json = nlohmann::json;

    void field(json& object, std::string_view key, const auto& v) const { object[std::string(key)] = value(v); }
    template <class T>
    void field(json& object, std::string_view key, const std::optional<T>& v) const {
        if (v) field(object, key, *v);
    }

    json value(int v) const { return v; }
    json value(bool v) const { return v; }
    json value(double v) const { return v; }
    json value(const std::string& v) const { return v; }
    json value(const Value& v) const { return v.fraction ? json(*v.fraction) : json(v.number); }
    json value(const Color& v) const {
        Text text;
        append_hex(text, v);
        return text.string();
    }
    json value(PolygonPlace v) const { return scene_.polygons[std::size_t(v.index)].id; }
    json value(Sign v) const { return int(v); }
    json value(VisibilityFlag v) const { return int(v); }
    json value(Word auto v) const { return words_of(v)[std::size_t(v)]; }
    json value(const Answer& v) const {
        return std::visit([&](const auto& answer) { return value(answer); }, v);
    }
    json value(const Operand& v) const { return list(v.name, v.used.text, v.exact.text); }
    json value(const Truth& v) const { return v.answer ? value(*v.answer) : json(); }
    json value(const ValuePoint& v) const { return list(v.x, v.y); }
    json value(const ValueVertex& v) const { return list(v.x, v.y, v.z); }
    json value(const PolygonPart& v) const { return list(v.polygon, v.region, v.ground); }
    json value(const Window& v) const { return list(v.x, v.y, v.width, v.height); }
    json value(const PixelRectangle& v) const { return list(v.x, v.y, v.width, v.height); }
    json value(const PixelRun& v) const { return list(v.row, v.first, v.end); }
    json value(const ColumnRun& v) const { return list(v.first, v.end); }
    template <class A, class B>
    json value(const std::pair<A, B>& v) const {
        return list(v.first, v.second);
    }
    json value(const std::array<Value, 4>& v) const { return list(v[0], v[1], v[2], v[3]); }
    template <class T>
    json value(const std::vector<T>& items) const {
        json array = json::array();
        for (const auto& item : items) array.push_back(value(item));
        return array;
    }

    json list(const auto&... items) const {
        json array = json::array();
        (array.push_back(value(items)), ...);
        return array;
    }

    const Scene& scene_;
};

}  // namespace vidno
