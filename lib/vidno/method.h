/// Method: the algorithms, by name.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

/// The two methods of the course, the Warnock family (family/family.h), and Weiler and Atherton's algorithm, which
/// gives more than a picture (weiler_atherton.h).
enum class Method : unsigned char {
    warnock,
    zbuffer,
    warnock_simplest,
    warnock_full,
    warnock_angles,
    warnock_vertex,
    warnock_edges,
    warnock_bodies,
    weiler_atherton
};
inline constexpr auto method_names =
    std::to_array<std::string_view>({"warnock", "zbuffer", "warnock-simplest", "warnock-full", "warnock-angles",
                                     "warnock-vertex", "warnock-edges", "warnock-bodies", "weiler-atherton"});

constexpr bool is_family(Method method) { return Method::zbuffer < method && method < Method::weiler_atherton; }

/// The methods that examine windows.
constexpr bool is_warnock(Method method) { return method == Method::warnock || is_family(method); }

}  // namespace vidno
