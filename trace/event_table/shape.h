/// Shape: the JSON form of a value of an event in a trace, derived from its C++ type.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "format/event_fields.h"

namespace vidno {

struct Shape {
    enum class Kind : unsigned char { named, integer, words, numbers, tuple, list };
    Kind kind = Kind::named;
    std::string_view name{};                // its name in the first table of FORMAT.md, in the schema and in the page
    std::vector<std::string_view> words{};  // the texts that the value may be
    std::vector<int> numbers{};             // the numbers that the value may be
    std::vector<Shape> items{};             // the items of a tuple; a list has one
};

/// The names of basic values. The other values are built from these.
template <class T>
inline constexpr std::string_view shape_name{};
template <>
inline constexpr std::string_view shape_name<bool> = "bool";
template <>
inline constexpr std::string_view shape_name<double> = "finite";
template <>
inline constexpr std::string_view shape_name<std::string> = "text";
template <>
inline constexpr std::string_view shape_name<Value> = "number";
template <>
inline constexpr std::string_view shape_name<Color> = "color";
template <>
inline constexpr std::string_view shape_name<PolygonPlace> = "polygon";
template <>
inline constexpr std::string_view shape_name<ValuePoint> = "point";
template <>
inline constexpr std::string_view shape_name<ValueVertex> = "vertex";
template <>
inline constexpr std::string_view shape_name<Window> = "window";
template <>
inline constexpr std::string_view shape_name<PixelRectangle> = "rect";
template <>
inline constexpr std::string_view shape_name<std::vector<PixelRun>> = "runs";
template <>
inline constexpr std::string_view shape_name<std::vector<ColumnRun>> = "rowRuns";
template <>
inline constexpr std::string_view shape_name<RegionLoops> = "region";
template <>
inline constexpr std::string_view shape_name<PolygonPart> = "piece";
template <>
inline constexpr std::string_view shape_name<ReportedSample> = "sample";
template <>
inline constexpr std::string_view shape_name<std::vector<ColumnHeight>> = "heights";
template <>
inline constexpr std::string_view shape_name<Fraction> = "fraction";
template <>
inline constexpr std::string_view shape_name<Operands> = "operands";
template <>
inline constexpr std::string_view shape_name<Answer> = "answer";
template <>
inline constexpr std::string_view shape_name<Truth> = "truth";
template <>
inline constexpr std::string_view shape_name<Corner> = "corner";
template <>
inline constexpr std::string_view shape_name<Procedure> = "procedure";
template <>
inline constexpr std::string_view shape_name<Decision> = "decision";
template <>
inline constexpr std::string_view shape_name<FilterStage> = "stage";

template <class T>
struct ShapeOf {
    static Shape shape() {
        if constexpr (Word<T>) {
            const auto& words = words_of(T{});
            return {.kind = Shape::Kind::words, .name = shape_name<T>, .words = {words.begin(), words.end()}};
        } else if constexpr (!shape_name<T>.empty()) {
            return {.name = shape_name<T>};
        } else if constexpr (std::same_as<T, int>) {
            return {.kind = Shape::Kind::integer};
        } else if constexpr (std::same_as<T, Sign>) {
            return {.kind = Shape::Kind::numbers, .numbers = {-1, 0, 1}};
        } else if constexpr (std::same_as<T, VisibilityFlag>) {
            return {.kind = Shape::Kind::numbers, .numbers = {1, -1, 0, 2}};
        } else {
            static_assert(Listed<T>, "a value without a shape");
            T value{};
            return with_items(value, [](auto&... items) {
                return Shape{.kind = Shape::Kind::tuple,
                             .items = {ShapeOf<std::remove_reference_t<decltype(items)>>::shape()...}};
            });
        }
    }
};
template <class T>
struct ShapeOf<std::vector<T>> {
    static Shape shape() {
        if constexpr (!shape_name<std::vector<T>>.empty()) return {.name = shape_name<std::vector<T>>};
        return {.kind = Shape::Kind::list, .items = {ShapeOf<T>::shape()}};
    }
};

}  // namespace vidno
