/// KernelChoice: the kernels by name, and their capabilities.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "choice/algorithm.h"
#include "choice/edition.h"
#include "choice/language.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/kernels/grid.h"

namespace vidno {

enum class KernelKind : unsigned char { binary32, binary64, bits, depth, filtered, grid, exact };

struct KernelChoice {
    /// A whole number that follows the name: `bits:12`.
    struct Parameter {
        char letter;
        int least, most;
        std::array<int, 2> offered;  // on the page
        std::optional<int> if_not_said{};
    };

    KernelKind kind;
    std::string_view name;
    std::string_view rule;
    Bilingual says;  // on the page: what it computes with, and whether its decisions can be wrong
    /// Whether a wrong decision or pixel would be an error of the program; under `grid`, for the snapped scene.
    bool is_always_right = false;
    bool snaps = false;  // takes a scene that was snapped
    bool runs_printed = true;
    std::optional<Parameter> parameter{};
    bool runs_warnock = true;
    bool runs_mistakes = false;
    bool runs_family = true;        // the Warnock family
    bool constructs_points = true;  // for Weiler and Atherton's algorithm and the floating horizon

    /// Whether it runs the floating horizon, which takes samples unchanged and stores no depths.
    constexpr bool runs_floating_horizon(Edition edition) const {
        return constructs_points && has_text_of_curves(edition) && runs_text(edition);
    }

    bool runs(Method method, Edition edition) const {
        return runs(method) && has_text(edition, method) && runs_text(edition);
    }

private:
    constexpr bool runs(Method method) const {
        switch (algorithm_of(method)) {
            case Algorithm::warnock: return is_family(method) ? runs_family : runs_warnock;
            case Algorithm::z_buffer: return true;
            case Algorithm::weiler_atherton: return constructs_points;
        }
        std::abort();
    }
    constexpr bool runs_text(Edition edition) const {
        return edition == Edition::corrected || (is_mistake(edition) ? runs_mistakes : runs_printed);
    }
};

/// Indexed by KernelKind.
inline constexpr std::array kernel_choices{
    KernelChoice{
        .kind = KernelKind::binary32,
        .name = "float",
        .rule = "IEEE binary32; decisions follow from the rounded values",
        .says =
            {"Numbers of 24 significant bits (IEEE binary32). Results are rounded, so decisions can go wrong.",
             "Числа с 24 значащими битами (IEEE binary32). Результаты округляются, поэтому решения бывают неверными."}},
    KernelChoice{
        .kind = KernelKind::binary64,
        .name = "double",
        .rule = "IEEE binary64; decisions follow from the rounded values",
        .says =
            {"Numbers of 53 significant bits (IEEE binary64). Results are rounded, so decisions can go wrong.",
             "Числа с 53 значащими битами (IEEE binary64). Результаты округляются, поэтому решения бывают неверными."},
        .runs_mistakes = true},
    KernelChoice{
        .kind = KernelKind::bits,
        .name = "bits",
        .rule = "every result rounded to P bits; decisions follow from the rounded values",
        .says = {"Each result is rounded to that many significant bits, so that rounding is easy to see.",
                 "Каждый результат округляется до указанного числа значащих битов: погрешность легко увидеть."},
        .parameter = {{'P', fewest_bits, most_bits, {8, 12}}}},
    KernelChoice{.kind = KernelKind::depth,
                 .name = "depth",
                 .rule = "binary64, and a Z-buffer of B bits; zbuffer only",
                 .says = {"Ordinary numbers, but the Z-buffer keeps that many bits of each depth.",
                          "Обычные числа, но Z-буфер хранит указанное число битов каждой глубины."},
                 .parameter = {{'B', fewest_depth_bits, most_depth_bits, {8, 16}}},
                 .runs_warnock = false,
                 .runs_family = false,
                 .constructs_points = false},
    KernelChoice{.kind = KernelKind::filtered,
                 .name = "filtered",
                 .rule = "binary64 with an error bound, exact where that cannot decide: always right; corrected only",
                 .says = {"Ordinary numbers with an error bound, exact where that cannot decide: never wrong.",
                          "Обычные числа с границей погрешности, а где её мало — точные: неверных решений не бывает."},
                 .is_always_right = true,
                 .runs_printed = false},
    KernelChoice{
        .kind = KernelKind::grid,
        .name = "grid",
        .rule = "x and y snapped to 1/2^K pixel, whole numbers from there: right for the snapped scene; corrected only",
        .says = {"Vertices are moved to a fine grid, and whole numbers are used from there on.",
                 "Вершины сдвигаются в узлы мелкой сетки, дальше счёт идёт в целых числах."},
        .is_always_right = true,
        .snaps = true,
        .runs_printed = false,
        .parameter = {{'K', 1, finest_grid, {4, 8}, 8}},
        .constructs_points = false},
    KernelChoice{.kind = KernelKind::exact,
                 .name = "exact",
                 .rule = "exact rationals; every decision is right, the reference",
                 .says = {"Rational numbers of any length: nothing is rounded.",
                          "Рациональные числа любой длины: ничего не округляется."},
                 .is_always_right = true,
                 .runs_mistakes = true},
};

/// A kernel by its name: `double`, `bits:12`, `grid` for `grid:8`.
struct NamedKernel {
    const KernelChoice* choice;
    int parameter = 0;  // if the choice has one

    KernelKind kind() const { return choice->kind; }
    std::string name() const;
    bool snaps() const { return choice->snaps; }
    bool is_always_right() const { return choice->is_always_right; }
};

/// None if no kernel has this name, or its parameter is missing or out of range.
std::optional<NamedKernel> kernel_named(std::string_view name);

/// Whether it is the name of a kernel that is always right.
bool is_always_right(std::string_view kernel);

/// The kernel of a kind that is named without a parameter: `filtered`, `grid:8`. The kind must not be `bits` or
/// `depth`.
NamedKernel kernel_of(KernelKind kind);

/// All names: "float, double, bits:P (4 <= P <= 24), ...".
std::string kernel_names();

/// The names of the kernels that have a capability, or lack it: "double and exact".
std::string kernels_that(bool KernelChoice::*can, bool it = true);

}  // namespace vidno
