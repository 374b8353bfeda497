// Checks a proof that a picture shows a scene, as trace/PROOF.md explains: verify SCENE.json PICTURE.png PROOF.jsonl
#include <iostream>
#include "polygon.h"
#include "read_picture.h"
using Pairs = vector<array<size_t, 2>>;
int main(int, char** file) try {
    ifstream scene_file(file[1]), proof(file[3]);
    const json scene = json::parse(scene_file), window = scene.at("window");
    const Rectangle whole{window.at("x"), window.at("y"), window.at("width"), window.at("height")};
    const vector<Polygon> polygons(scene.at("polygons").begin(), scene.at("polygons").end());
    check(!scene.contains("camera"), "not a scene on the screen");
    string line;
    check(getline(proof, line) && json::parse(line) == json{{"format", "vidno-proof/1"}}, "not a proof");
    set<array<long, 3>> unproved = read_picture(file[2], whole);
    vector<pair<Rectangle, set<size_t>>> around{{whole, {}}};  // rectangles, and the polygons that do not show in them
    while (getline(proof, line)) {
        const json told = json::parse(line), place = told.at("rectangle");
        const Rectangle rectangle{place.at(0), place.at(1), place.at(2), place.at(3)};
        for (; !around.back().first.contains(rectangle); around.pop_back()) check(around.size() > 1, line);
        set<size_t>& gone = around.emplace_back(rectangle, around.back().second).second;
        const vector<Place> at = rectangle.corners();
        const auto drop = [&](size_t p, bool is_so) { check(is_so, to_string(p) + ": " + line), gone.insert(p); };
        for (const size_t p : told.value("edge_on", vector<size_t>())) drop(p, !polygons.at(p).depth);
        for (const auto& [p, k] : told.value("beside", Pairs())) drop(p, least(-polygons.at(p).edges.at(k), at) > 0);
        for (const auto& [p, q] : told.value("behind", Pairs())) {
            const Number gap = least(polygons.at(q).depth.value() - polygons.at(p).depth.value(), at);
            drop(p, polygons[q].holds(at) && (gap > 0 || (gap == 0 && q < p)));
        }
        if (!told.contains("owner")) continue;
        const bool is_ground = told["owner"].is_null();
        if (!is_ground) drop(told["owner"], polygons.at(told["owner"]).holds(at));
        check(gone.size() == polygons.size(), "another polygon has no reason: " + line);
        const json color = is_ground ? scene.at("background") : scene["polygons"][size_t(told["owner"])].at("color");
        for (const auto& [x, y] : rectangle.pixels()) check(unproved.erase({x, y, number_of(color)}), "pixel: " + line);
    }
    check(unproved.empty(), "not each pixel is proved");
    cout << "proved: the picture shows the scene at each of its " << whole.pixels().size() << " pixels\n";
} catch (const exception& failed) {
    return cerr << failed.what() << '\n', 1;
}
