// A program that tells three steps and reaches for what is not there.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("crash.jsonl", scene);
    trace.clear(farthest);
    if (!scene.polygons.empty()) trace.polygon(0);
    volatile int* nowhere = nullptr;
    *nowhere = 1;
}
