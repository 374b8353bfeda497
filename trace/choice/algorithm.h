/// Algorithm: what a method belongs to. The methods of one algorithm hold the same state and share their parts of a figure.
#pragma once

#include <cstdlib>

#include "vidno/method.h"

namespace vidno {

enum class Algorithm : unsigned char { warnock, z_buffer, weiler_atherton };

/// The compiler names a method that is missing here, and each place that lacks an algorithm.
constexpr Algorithm algorithm_of(Method method) {
    switch (method) {
        case Method::warnock:
        case Method::warnock_simplest:
        case Method::warnock_full:
        case Method::warnock_angles:
        case Method::warnock_vertex:
        case Method::warnock_edges:
        case Method::warnock_bodies: return Algorithm::warnock;
        case Method::zbuffer: return Algorithm::z_buffer;
        case Method::weiler_atherton: return Algorithm::weiler_atherton;
    }
    std::abort();
}

}  // namespace vidno
