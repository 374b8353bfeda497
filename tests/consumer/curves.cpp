// Three level lines. The third lies between the first two and is hidden. Curves need no CGAL.
#include <vidno/floating_horizon.h>
#include <cstdio>

int main() {
    const vidno::AdmittedCurves curves =
        vidno::admit(vidno::CurveScene{{0, 0, 4, 8}, {{{{0, 1}, {3, 1}}}, {{{0, 5}, {3, 5}}}, {{{0, 3}, {3, 3}}}}});
    for (const auto& [segment, from, to] : vidno::visible_lines(curves, vidno::Double{}).lines) {
        std::printf("%d: %g to %g at %g\n", segment.curve, from.point.x, to.point.x, to.point.y);
    }
}
