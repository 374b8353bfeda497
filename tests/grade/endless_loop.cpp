// A program that loops forever and reports no step.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("endless_loop.jsonl", scene);
    volatile bool going = true;
    while (going) {
    }
}
