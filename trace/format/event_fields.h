/// How the values of events are written in a line: enumerations as words, and small structures as lists.
#pragma once

#include <algorithm>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "format/event.h"

namespace vidno {

/// The words of an enumeration, each at the index of its value.
constexpr auto& words_of(Corner) { return corner_names; }
constexpr auto& words_of(Case) { return case_names; }
constexpr auto& words_of(Lies) { return lies_names; }
constexpr auto& words_of(Relation) { return relation_names; }
constexpr auto& words_of(OtherList) { return other_list_names; }
constexpr auto& words_of(Procedure) { return procedure_names; }
constexpr auto& words_of(Decision) { return decision_names; }
constexpr auto& words_of(FilterStage) { return filter_stage_names; }
constexpr auto& words_of(Cause) { return cause_names; }

template <class T>
concept Word = requires(T value) {
    words_of(value);
};

/// The number of items of a structure as a list; 0 if it is not written as one.
template <class T>
inline constexpr int list_size = 0;
template <>
inline constexpr int list_size<ValuePoint> = 2;
template <>
inline constexpr int list_size<ColumnRun> = 2;
template <class A, class B>
inline constexpr int list_size<std::pair<A, B>> = 2;
template <class... Items>
inline constexpr int list_size<std::tuple<Items...>> = int(sizeof...(Items));
template <>
inline constexpr int list_size<ValueVertex> = 3;
template <>
inline constexpr int list_size<PixelRun> = 3;
template <>
inline constexpr int list_size<Operand> = 3;
template <>
inline constexpr int list_size<PolygonPart> = 3;
template <>
inline constexpr int list_size<Window> = 4;
template <>
inline constexpr int list_size<PixelRectangle> = 4;
template <>
inline constexpr int list_size<std::array<Value, 4>> = 4;

template <class T>
concept Listed = (list_size<std::remove_const_t<T>> > 0);

/// Calls `use` with all items of the list.
template <Listed T>
constexpr decltype(auto) with_items(T& value, auto&& use) {
    constexpr int size = list_size<std::remove_const_t<T>>;
    if constexpr (size == 2) {
        auto& [a, b] = value;
        return use(a, b);
    } else if constexpr (size == 3) {
        auto& [a, b, c] = value;
        return use(a, b, c);
    } else {
        auto& [a, b, c, d] = value;
        return use(a, b, c, d);
    }
}

/// "p/q" with whole numbers p and q, p perhaps negative.
constexpr bool is_fraction(std::string_view text) {
    const auto is_digits = [](std::string_view part) {
        return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (text.starts_with('-')) text.remove_prefix(1);
    const auto slash = text.find('/');
    return slash != std::string_view::npos && is_digits(text.substr(0, slash)) && is_digits(text.substr(slash + 1));
}

/// Numbers of the machine that are not fractions.
inline constexpr std::array<std::string_view, 3> not_fractions{"inf", "-inf", "nan"};

constexpr bool is_fraction_or_none(std::string_view text) {
    return is_fraction(text) || std::find(not_fractions.begin(), not_fractions.end(), text) != not_fractions.end();
}

}  // namespace vidno
