// A program that reports the same window again and again.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("endless_output.jsonl", scene);
    for (;;) trace.push(scene.area.x, scene.area.y, 64, 64);
}
