// Checks a proof that a picture shows a scene, as trace/PROOF.md explains: verify SCENE.json PICTURE.ppm PROOF.jsonl
#include <boost/multiprecision/cpp_int.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
using namespace std;
using Json = nlohmann::json;
using Numbers = vector<boost::multiprecision::cpp_rational>;
using Pairs = vector<array<int, 2>>;
using Rectangle = array<int, 4>;
struct Polygon { vector<Numbers> edges; Numbers depth; };  // an edge-on polygon has no depth
void check(bool is_true, const string& reason) { if (!is_true) throw runtime_error(reason); }
auto value(const Numbers& linear, const Numbers& at) { return Numbers{linear.at(0) * at[0] + linear[1] * at[1] + linear[2]}[0]; }
bool contains(Rectangle a, Rectangle b) { return a[0] <= b[0] && a[1] <= b[1] && b[0] + b[2] <= a[0] + a[2] && b[1] + b[3] <= a[1] + a[3]; }
Polygon polygon(const Json& given) {
    vector<Numbers> v, edges;
    Numbers n(3);  // by Newell's sum
    for (const vector<double> vertex : given["vertices"]) v.emplace_back(vertex.begin(), vertex.end());
    for (size_t k = 0; k < v.size(); ++k) {
        const Numbers &p = v[k], &q = v[(k + 1) % v.size()];
        edges.push_back({p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]});
        for (int i : {0, 1, 2}) n[i] += p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }
    for (auto& edge : edges) for (auto& factor : edge) if (n[2] < 0) factor = -factor;  // so that no edge is negative inside
    for (auto& edge : edges) for (auto& vertex : v) check(value(edge, vertex) >= 0, "scene: a polygon is not convex");
    if (n[2] == 0) return {edges, {}};
    return {edges, {-n[0] / n[2], -n[1] / n[2], v[0][2] + (n[0] * v[0][0] + n[1] * v[0][1]) / n[2]}};
}
int main(int, char** file) try {
    ifstream scene_file(file[1]), picture(file[2]), proof(file[3]);
    const Json scene = Json::parse(scene_file), window = scene["window"];
    const int left = window["x"], top = window["y"], columns = window["width"], rows = window["height"];
    const string header = "P6\n" + to_string(columns) + " " + to_string(rows) + "\n255\n", ppm(istreambuf_iterator<char>(picture), {});
    string text, is_proof = R"({"format":"vidno-proof/1"})";
    check(!scene.contains("camera") && ppm.starts_with(header) && ppm.size() == header.size() + 3 * columns * rows &&
          getline(proof, text) && Json::parse(text) == Json::parse(is_proof), "not a scene on the screen, its PPM and a proof");
    vector<Polygon> polygons;
    for (const Json& given : scene["polygons"]) polygons.push_back(polygon(given));
    vector<pair<Rectangle, set<int>>> around{{{left, top, columns, rows}, {}}};  // rectangles, and who is left out in them
    vector<int> proved(columns * rows);                                          // how often, pixel by pixel
    for (int number = 2; getline(proof, text); ++number) {
        const Json line = Json::parse(text);
        const auto expect = [&](bool is_true, int p, string is_not) { check(is_true, "line " + to_string(number) + ": " + to_string(p) + is_not); };
        const auto r = line["rectangle"].get<Rectangle>();
        vector<Numbers> corners;
        for (int x : {r[0], r[0] + r[2] - 1}) for (int y : {r[1], r[1] + r[3] - 1}) corners.push_back(Numbers{x + 0.5, y + 0.5});
        for (; !contains(around.back().first, r); around.pop_back()) expect(around.size() > 1, r[0], ": it is not in the window");
        set<int> left_out = around.back().second, holding;
        for (int p : line.value("edge_on", vector<int>())) {
            expect(polygons.at(p).depth.empty(), p, " is not edge-on");
            left_out.insert(p);
        }
        for (auto [p, edge] : line.value("beside", Pairs())) {
            for (auto& at : corners) expect(value(polygons.at(p).edges.at(edge), at) < 0, p, " is not beside");
            left_out.insert(p);
        }
        for (auto [p, q] : line.value("behind", Pairs())) {
            const Numbers &far = polygons.at(p).depth, &near = polygons.at(q).depth;
            for (auto& at : corners) expect(pair(value(far, at), q) < pair(value(near, at), p), p, " is not behind");
            left_out.insert(p);
            holding.insert(q);
        }
        around.push_back({r, left_out});
        const bool is_whole = line.contains("owner");
        optional<int> owner;  // none: the background
        if (is_whole && !line["owner"].is_null()) holding.insert(*(owner = int(line["owner"])));
        for (int p : holding) for (auto& edge : polygons.at(p).edges) for (auto& at : corners)
            expect(value(edge, at) >= 0 && !polygons[p].depth.empty(), p, " does not hold the rectangle");
        for (int p = 0; is_whole && p < int(polygons.size()); ++p) expect(p == owner || left_out.count(p), p, " has no reason");
        const string color = !owner ? scene["background"] : scene["polygons"][*owner]["color"];
        for (int k = 0; is_whole && k < r[2] * r[3]; ++k) {
            const int pixel = (r[1] - top + k / r[2]) * columns + r[0] - left + k % r[2];
            const auto* rgb = (const unsigned char*)ppm.data() + header.size() + 3 * pixel;
            expect((rgb[0] << 16 | rgb[1] << 8 | rgb[2]) == stoi(color.substr(1), nullptr, 16), pixel, ": this pixel has another colour");
            proved[pixel] += 1;
        }
    }
    check(ranges::count(proved, 1) == columns * rows, "not each pixel is proved once");
    cout << "proved: the picture shows the scene at each of its " << columns * rows << " pixels\n";
} catch (const exception& failed) {
    cerr << failed.what() << '\n';
    return 1;
}
