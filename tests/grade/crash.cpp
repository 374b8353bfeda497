// A program that reports its first steps and then writes through a null pointer.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("crash.jsonl", scene);
    trace.clear(farthest);
    if (!scene.polygons.empty()) trace.polygon(0);
    volatile int* nowhere = nullptr;
    *nowhere = 1;
}
