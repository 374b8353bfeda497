// Two polygons, two methods, one picture.
#include <vidno/admission.h>
#include <vidno/vidno.h>
#include <cstdio>

int main() {
    vidno::Scene drawn{.name = "A triangle before a square", .area = {0, 0, 8, 4}, .background = {}, .polygons = {}};
    drawn.polygons.push_back(
        {.id = "S", .color = {'s', 0, 0}, .vertices = {{2, 1, 0}, {6, 1, 0}, {6, 4, 0}, {2, 4, 0}}});
    drawn.polygons.push_back({.id = "T", .color = {'t', 0, 0}, .vertices = {{0, 0, 0.5}, {4, 0, 0.5}, {0, 4, 0.5}}});
    drawn.background = {'.', 0, 0};
    const vidno::AdmittedScene scene = vidno::admit(drawn);

    for (const auto method : {vidno::Method::warnock, vidno::Method::zbuffer}) {
        const vidno::Picture picture = vidno::render(method, scene, vidno::Double{});
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 8; ++x) std::putchar(picture.at(x, y).red);
            std::putchar('\n');
        }
    }
}
