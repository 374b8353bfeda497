// A program that never frees its memory.
#include <memory>

#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("endless_memory.jsonl", scene);
    for (std::vector<std::unique_ptr<std::vector<char>>> kept;;) kept.emplace_back(new std::vector<char>(1 << 20, 'x'));
}
