// A convex polygon on the screen, in exact numbers. For verify.cpp.
#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <valarray>
using namespace std;
using nlohmann::json;
using Number = boost::multiprecision::cpp_rational;
using Vector = valarray<Number>;  // also a linear function of places
using Place = array<double, 3>;   // (x, y, 1), or a vertex

inline void check(bool is_true, const string& reason) { is_true ? void() : throw runtime_error(reason); }
inline Vector exact(const Place& place) { return {place[0], place[1], place[2]}; }
inline Vector cross(const Place& a, const Place& b) {
    const Vector p = exact(a), q = exact(b);
    return p.cshift(1) * q.cshift(2) - p.cshift(2) * q.cshift(1);
}
inline Number least(const Vector& linear, const vector<Place>& places) {  // its least value at these places
    Vector values(places.size());
    for (size_t i = 0; i < places.size(); ++i) values[i] = (linear * exact(places[i])).sum();
    return values.min();
}
struct Polygon {
    vector<Vector> edges;    // the polygon lies where none of these functions is negative
    optional<Vector> depth;  // none if it is edge-on
    explicit Polygon(const json& given) {
        const vector<Place> v = given.at("vertices");
        vector<Place> places;
        for (const Place& vertex : v) places.push_back({vertex[0], vertex[1], 1});
        Vector n(3);  // Newell's sum
        for (size_t k = 0; k < v.size(); ++k) n += cross(v[k], v[(k + 1) % v.size()]);
        const Number way = n[2] < 0 ? -1 : 1;
        for (size_t k = 0; k < v.size(); ++k) edges.push_back(way * cross(places[k], places[(k + 1) % v.size()]));
        for (const Vector& edge : edges) check(least(edge, places) >= 0, "scene: a polygon is not convex");
        if (n[2] != 0) depth = Vector{-n[0] / n[2], -n[1] / n[2], least(n, {v[0]}) / n[2]};
    }
    bool holds(const vector<Place>& places) const {
        return depth && ranges::all_of(edges, [&](const Vector& edge) { return least(edge, places) >= 0; });
    }
};
