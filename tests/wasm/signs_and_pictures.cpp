// Prints signs and pictures. The native program and the WebAssembly must print the same bytes.
#include <vidno/admission.h>
#include <vidno/kernels/exact.h>
#include <vidno/kernels/filtered.h>
#include <vidno/printed.h>
#include <vidno/vidno.h>
#include <array>
#include <cstdio>
#include <string>

namespace {

using namespace vidno;

// Kettner, Mehlhorn, Pion, Schirra and Yap, Classroom examples of robustness problems in geometric computations,
// figure 2a: the sides of the line through q and r on which points close to it lie.
template <Kernel K>
void print_signs(const K& kernel) {
    constexpr double u = 0x1p-53;
    const auto q = kernel.vertex({12, 12, 0});
    const auto r = kernel.vertex({24, 24, 0});
    std::printf("signs %s\n", std::string(K::name).c_str());
    for (int y = 0; y < 256; y += 4) {
        for (int x = 0; x < 256; x += 4) {
            const auto p = kernel.vertex({0.5 + x * u, 0.5 + y * u, 0});
            std::putchar("-0+"[int(kernel.sign(kernel.cross(p, q, r))) + 1]);
        }
        std::putchar('\n');
    }
}

AdmittedScene scene_of(std::string name, Area area, std::vector<std::vector<glm::dvec3>> outlines) {
    Scene scene{.name = std::move(name), .area = area, .background = {'.', 0, 0}, .polygons = {}};
    for (auto& outline : outlines) {
        const auto letter = char('A' + scene.polygons.size());
        scene.polygons.push_back(
            {.id = {letter}, .color = {std::uint8_t(letter), 0, 0}, .vertices = std::move(outline)});
    }
    return admit(std::move(scene));
}

std::vector<AdmittedScene> scenes() {
    return {
        scene_of("four relations", {0, 0, 16, 16},
                 {{{-1, -1, -0.5}, {17, -1, -0.5}, {17, 17, -0.5}, {-1, 17, -0.5}},
                  {{1, 1, 0.25}, {6.5, 1, 0.25}, {1, 6.5, 0.25}},
                  {{6, 4.5, 0}, {13, 2, 0}, {14, 5, 0}, {7, 7.5, 0}}}),
        scene_of("cyclic overlap", {-3, 5, 21, 13},
                 {{{-2, 6, 0.75}, {17, 9, -0.75}, {16.5, 11, -0.75}},
                  {{17, 7, 0.75}, {0, 17, -0.75}, {-2, 15.3, -0.75}},
                  {{2, 17.5, 0.75}, {6.1, 5.2, -0.75}, {8.3, 5.1, -0.75}}}),
        scene_of("one depth, thirds and tenths", {0, 0, 12, 9},
                 {{{0.1, 0.1, 0.3}, {11.9, 0.1, 0.1}, {5.95, 8.7, 0.2}},
                  {{0.5, 0.5, 0.3}, {11.5, 0.5, 0.1}, {6, 8.5, 0.2}},
                  {{3, 1. / 3, 0}, {9, 1. / 3, 1. / 3}, {9, 7, 1. / 3}, {3, 7, 0}}}),
    };
}

template <class Set, Kernel K>
void print_pictures(K kernel) {
    for (const AdmittedScene& scene : scenes()) {
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            std::printf("%s, %s, %s, %s\n", scene->name.c_str(), std::string(method_names[std::size_t(method)]).c_str(),
                        std::string(Set::name).c_str(), std::string(K::name).c_str());
            const Picture picture = render<Set>(method, scene, kernel);
            for (int y = scene->area.y; y < scene->area.bottom(); ++y) {
                for (int x = scene->area.x; x < scene->area.right(); ++x) std::putchar(picture.at(x, y).red);
                std::putchar('\n');
            }
        }
    }
}

template <Kernel K>
void print_all(K kernel) {
    print_signs(kernel);
    print_pictures<Corrected>(kernel);
    if constexpr (!std::same_as<K, Filtered>) print_pictures<Printed>(kernel);
}

}  // namespace

int main() {
    print_all(Float{});
    print_all(Double{});
    print_all(Filtered{});
    print_all(Exact{});
}
