/// Fuzz target: any bytes make a small scene, with coordinates from the whole range of doubles, their neighbours, and
/// subnormal ones. Every method and kernel draws the admitted polygons. Nothing may stop the program, and `filtered`
/// must paint what `exact` paints.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "choice/method.h"
#include "refused.h"
#include "run/run.h"
#include "scene/exact_scene.h"
#include "scene/families.h"
#include "scene/snapped_scene.h"

namespace {

using namespace vidno;

/// Reads the bytes in order, and zeros after their end.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    bool any() const { return size_ > 0; }
    unsigned one() {
        if (size_ == 0) return 0;
        --size_;
        return *data_++;
    }
    template <class T>
    T value() {
        std::array<std::uint8_t, sizeof(T)> bytes{};
        for (auto& byte : bytes) byte = std::uint8_t(one());
        return std::bit_cast<T>(bytes);
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

class Coordinates {
public:
    explicit Coordinates(Bytes& bytes) : bytes_(bytes) {}

    /// Next to the last one, in half pixels, a power of two, or any double.
    double next() {
        switch (bytes_.one() % 5) {
            case 0: break;  // the same
            case 1: last_ = std::nextafter(last_, bytes_.one() % 2 == 0 ? -INFINITY : INFINITY); break;
            case 2: last_ = double(int(bytes_.one() % 48) - 16) / 2; break;
            case 3: {
                const double sign = bytes_.one() % 2 == 0 ? -1 : 1;
                last_ = std::ldexp(sign, int(bytes_.value<std::uint16_t>() % 2100) - 1076);
                break;
            }
            default: last_ = bytes_.value<double>();
        }
        return last_;
    }
    double depth() { return double(int(bytes_.one() % 17) - 8) / 8; }

private:
    Bytes& bytes_;
    double last_ = 0;
};

AdmittedScene scene_of(Bytes bytes) {
    Scene scene;
    scene.area = {int(bytes.one() % 5) - 2, int(bytes.one() % 5) - 2, 1 + int(bytes.one() % 8),
                  1 + int(bytes.one() % 8)};
    Coordinates coordinates(bytes);
    while (bytes.any() && scene.polygons.size() < 4) {
        const std::size_t place = scene.polygons.size();
        ScenePolygon polygon{std::string(1, char('A' + place)), color_of(place), {}, false};
        const unsigned vertices = 3 + bytes.one() % 4;
        const bool is_level = vertices > 3 || bytes.one() % 2 == 0;
        const double level = coordinates.depth();
        for (unsigned i = 0; i < vertices; ++i) {
            const double x = coordinates.next();
            const double y = coordinates.next();
            polygon.vertices.emplace_back(x, y, is_level ? level : coordinates.depth());
        }
        if (exact_scene::admit_polygon(polygon).admission == Admission::admitted) scene.polygons.push_back(polygon);
    }
    return exact_scene::admit(std::move(scene));
}

Picture drawn(Method method, std::string_view kernel, const AdmittedScene& scene) {
    return run({.method = method, .kernel = *kernel_named(kernel), .edition = Edition::corrected, .scene = scene});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const AdmittedScene scene = scene_of(Bytes(data, size));
    const bool are_bodies = !refuses_bodies(scene);
    for (std::size_t i = 0; i < method_choices.size(); ++i) {
        const auto method = Method(i);
        if (method_choices[i].takes_closed_bodies && !are_bodies) continue;
        if (!(drawn(method, "filtered", scene) == drawn(method, "exact", scene))) std::abort();
        for (const auto* kernel : {"float", "double", "bits:7", "depth:9"}) {
            if (kernel_named(kernel)->choice->runs(method, Edition::corrected)) drawn(method, kernel, scene);
        }
    }
    try {
        const AdmittedScene snapped = snapped_scene(scene, 4).scene;
        const Picture by_windows = drawn(Method::warnock, "grid:4", snapped);
        if (!(by_windows == drawn(Method::zbuffer, "grid:4", snapped))) std::abort();
        if (!(by_windows == drawn(Method::zbuffer, "exact", snapped))) std::abort();
    } catch (const Refused&) {
        // Numbers on the grid cannot hold such coordinates.
    }
    return 0;
}
