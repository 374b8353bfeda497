/// Algorithm: what a method belongs to. The methods of one algorithm hold the same state and share their parts of a
/// figure.
#pragma once

#include <cstddef>
#include <cstdlib>

#include "vidno/method.h"

namespace vidno {

enum class Algorithm : unsigned char { warnock, z_buffer, weiler_atherton };

constexpr Algorithm algorithm_of(Method method) {
    if (is_warnock(method)) return Algorithm::warnock;
    switch (method) {
        case Method::zbuffer: return Algorithm::z_buffer;
        case Method::weiler_atherton: return Algorithm::weiler_atherton;
        default: std::abort();
    }
}

constexpr bool each_method_has_an_algorithm() {
    for (std::size_t i = 0; i < method_names.size(); ++i) algorithm_of(Method(i));
    return true;
}
static_assert(each_method_has_an_algorithm());

}  // namespace vidno
