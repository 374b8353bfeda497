// Runs every procedure with the visitor that ignores all events. The test compiles this program against lib/ and
// against a copy of lib/ without trace calls, and compares the counts of instructions.
#include <vidno/printed.h>
#include <vidno/vidno.h>
#include <cstdio>

#include "cost_scene.h"

namespace {

using namespace vidno;

template <class Set, Kernel K>
void run(const AdmittedScene& scene, K kernel) {
    for (const auto method : {Method::warnock, Method::zbuffer}) {
        const Picture picture = render<Set>(method, scene, kernel);
        unsigned sum = 0;
        for (const Color& color : picture.pixels()) sum = sum * 31 + color.red * 7u + color.green * 3u + color.blue;
        std::printf("%08x\n", sum);
    }
}

}  // namespace

int main() {
    const AdmittedScene scene = cost_scene();
    run<Corrected>(scene, Double{});
    run<Corrected>(scene, Float{});
    run<Printed>(scene, Double{});
}
