#include <iostream>

#include "commands.h"

namespace vidno::cli {

int methods() {
    std::cout
        << "methods    (domain: convex planar polygons; rule: the nearest polygon at each pixel centre,\n"
           "            the first of equally near ones; edge-on polygons show nothing)\n"
           "  warnock    look at a window; paint it if it is plain, else split it\n"
           "  zbuffer    scan each polygon with an active edge list; keep the nearest depth at each pixel\n"
           "method of curves    (domain: curves with samples on whole columns, the nearest first; rule: a point is\n"
           "            visible unless it is strictly between the horizons of the curves before it)\n"
           "  floating-horizon    draw what is beyond both horizons; raise them to it\n"
           "kernels    (the arithmetic)\n";
    for (const auto& kernel : kernel_choices) {
        std::string name(kernel.name);
        if (kernel.parameter) (name += ':') += kernel.parameter->letter;
        std::cout << "  " << name << std::string(11 - name.size(), ' ') << kernel.rule << '\n';
    }
    std::cout << "editions    (from the third on with one usual mistake, under double and exact)\n";
    for (const auto& [name, rule, only] : edition_choices) {
        std::cout << "  " << name << std::string(21 - name.size(), ' ') << rule;
        if (only) std::cout << "; " << method_names[std::size_t(*only)] << " only";
        std::cout << '\n';
    }
    std::cout << "levels of detail (each adds events to the one before)\n"
                 "  windows    windows, cases and fills; polygons, scanlines and painted runs\n"
                 "  polygons   relations, corner depths and clips; the active edge list and stored depths\n"
                 "  signs      every orientation test and every depth comparison\n";
    return 0;
}

}  // namespace vidno::cli
