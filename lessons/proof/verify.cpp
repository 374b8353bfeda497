// Checks a proof that a picture shows a scene, as trace/PROOF.md explains: verify SCENE.json PICTURE.ppm PROOF.jsonl
#include <boost/multiprecision/cpp_int.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
using namespace std;
using Json = nlohmann::json;
using Numbers = vector<boost::multiprecision::cpp_rational>;
using Pairs = vector<array<int, 2>>;
void check(bool is_true, const string& reason) { if (!is_true) throw runtime_error(reason); }
auto value(const Numbers& f, const Numbers& at) { return Numbers{f.at(0) * at[0] + f[1] * at[1] + f[2]}.front(); }
struct Polygon {
    vector<Numbers> v, edges;
    Numbers n = Numbers(3), depth;  // its normal; an edge-on polygon has no depth
    explicit Polygon(const Json& given) {
        for (const vector<double> vertex : given["vertices"]) v.emplace_back(vertex.begin(), vertex.end());
        for (size_t k = 0; k < v.size(); ++k) {
            const Numbers &p = v[k], &q = v[(k + 1) % v.size()];
            edges.push_back({p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]});
            for (int i : {0, 1, 2}) n[i] += p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];  // Newell's sum
        }
        for (auto& edge : edges) for (auto& factor : edge) if (n[2] < 0) factor = -factor;  // so that none is negative inside
        for (auto& edge : edges) for (auto& vertex : v) check(value(edge, vertex) >= 0, "scene: a polygon is not convex");
        if (n[2] != 0) depth = {-n[0] / n[2], -n[1] / n[2], v[0][2] + (n[0] * v[0][0] + n[1] * v[0][1]) / n[2]};
    }
};
int main(int, char** file) try {
    ifstream scene_file(file[1]), picture(file[2]), proof(file[3]);
    const Json scene = Json::parse(scene_file), window = scene["window"];
    const int left = window["x"], top = window["y"], columns = window["width"], rows = window["height"];
    const string header = "P6\n" + to_string(columns) + " " + to_string(rows) + "\n255\n", ppm(istreambuf_iterator<char>(picture), {});
    check(ppm.starts_with(header) && ppm.size() == header.size() + 3 * columns * rows, "no PPM of the size of the window");
    check(!scene.contains("camera"), "the scene has a camera");
    const vector<Polygon> polygons(scene["polygons"].begin(), scene["polygons"].end());
    vector<pair<array<int, 4>, set<int>>> around{{{left, top, columns, rows}, {}}};  // rectangles, and who is left out there
    vector<string> proved(columns * rows);  // the colours of each pixel
    string text;
    check(getline(proof, text) && Json::parse(text) == Json{{"format", "vidno-proof/1"}}, "line 1: not a proof");
    for (int number = 2; getline(proof, text); ++number) {
        const Json line = Json::parse(text);
        const auto [x, y, w, h] = line["rectangle"].get<array<int, 4>>();
        const Pairs beside = line.value("beside", Pairs()), behind = line.value("behind", Pairs());
        const auto expect = [&](bool is_true, int p, string is_not) { check(is_true, "line " + to_string(number) + ": " + to_string(p) + is_not); };
        const auto leaves = [x = x, y = y, w = w, h = h](const array<int, 4>& a) { return x < a[0] || y < a[1] || x + w > a[0] + a[2] || y + h > a[1] + a[3]; };
        for (; leaves(around.back().first); around.pop_back()) expect(around.size() > 1, x, " begins a rectangle that is not in the window");
        vector<Numbers> corners;
        for (double i : {x + 0.5, x + w - 0.5}) for (double j : {y + 0.5, y + h - 0.5}) corners.push_back(Numbers{i, j});
        set<int> left_out = around.back().second, holding;
        for (int p : line.value("edge_on", vector<int>())) expect(polygons.at(p).depth.empty(), p, " is not edge-on"), left_out.insert(p);
        for (auto [p, e] : beside) for (auto& at : corners) expect(value(polygons.at(p).edges.at(e), at) < 0, p, " is not beside");
        for (auto [p, q] : behind) for (auto& at : corners)
            expect(pair(value(polygons.at(p).depth, at), q) < pair(value(polygons.at(q).depth, at), p), p, " is not behind");
        for (auto [p, e] : beside) left_out.insert(p);
        for (auto [p, q] : behind) left_out.insert(p), holding.insert(q);
        around.push_back({{x, y, w, h}, left_out});
        if (line.value("owner", Json()).is_number()) holding.insert(int(line["owner"]));
        for (int p : holding) for (auto& edge : polygons.at(p).edges) for (auto& at : corners)
            expect(value(edge, at) >= 0 && !polygons[p].depth.empty(), p, " does not hold the rectangle");
        if (!line.contains("owner")) continue;
        const Json color = line["owner"].is_null() ? scene["background"] : scene["polygons"][int(line["owner"])]["color"];
        for (int p = 0; p < int(polygons.size()); ++p) expect(left_out.count(p) || line["owner"] == p, p, " has no reason");
        for (int k = 0; k < w * h; ++k) proved[(y - top + k / w) * columns + x - left + k % w] += color;
    }
    for (int k = 0; k < columns * rows; ++k) {
        char rgb[8] = "";
        const auto* byte = (const unsigned char*)ppm.data() + ppm.size() - 3 * (columns * rows - k);
        snprintf(rgb, 8, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
        check(proved[k] == rgb, "pixel " + to_string(k) + ": not proved once, or not in this colour");
    }
    cout << "proved: the picture shows the scene at each of its " << columns * rows << " pixels\n";
} catch (const exception& failed) { cerr << failed.what() << '\n'; return 1; }
