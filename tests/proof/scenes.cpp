// Prints random scenes, one a line: of every family, moved by ulps or not, and the recorded ones.
//
//     vidno_proof_scenes FIRST COUNT

#include <cstdlib>
#include <iostream>

#include "../recorded/random_scenes.h"
#include "scene/families.h"
#include "scene/scene_json.h"

int main(int, char** arguments) {
    using namespace vidno;
    const unsigned first = unsigned(std::atoi(arguments[1])), count = unsigned(std::atoi(arguments[2]));
    for (unsigned i = first; i < first + count; ++i) {
        if (i % 3 == 0) {
            std::cout << scene_json(read_scene(recorded::random_scene(i), "").scene) << '\n';
            continue;
        }
        RandomPolygons random(std::mt19937{i});
        const AdmittedScene scene = random_scene(families[i % families.size()], random);
        std::cout << scene_json(i % 2 == 0 ? moved_by_ulps(*scene, 2, random) : scene) << '\n';
    }
}
