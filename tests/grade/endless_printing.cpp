// A program that prints forever.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("endless_printing.jsonl", scene);
    for (;;) std::cout << "Here I am.\n";
}
