// A program that does not end, and says nothing more.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("endless_loop.jsonl", scene);
    volatile bool going = true;
    while (going) {
    }
}
