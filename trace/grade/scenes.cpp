#include "grade/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "grade/words.h"
#include "scene/exact_scene.h"
#include "scene/families.h"

namespace vidno {

namespace {

constexpr std::array colors{Color{31, 119, 180},  Color{255, 127, 14}, Color{44, 160, 44},   Color{214, 39, 40},
                            Color{148, 103, 189}, Color{140, 86, 75},  Color{227, 119, 194}, Color{23, 190, 207}};

using Vertices = std::vector<glm::dvec3>;

Vertices level(double left, double top, double right, double bottom, double z) {
    return {{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}};
}

/// A rectangle whose depth goes from z_left at its left side to z_right at its right side.
Vertices sloping(double left, double top, double right, double bottom, double z_left, double z_right) {
    return {{left, top, z_left}, {right, top, z_right}, {right, bottom, z_right}, {left, bottom, z_left}};
}

/// The depth of each vertex is `at` + `by_x` x + `by_y` y.
Vertices tilted(const std::vector<std::pair<double, double>>& outline, double at, double by_x, double by_y) {
    Vertices vertices;
    for (const auto& [x, y] : outline) vertices.push_back({x, y, at + by_x * x + by_y * y});
    return vertices;
}

AdmittedScene scene(std::string name, const Area& area, const std::vector<Vertices>& polygons) {
    Scene made{std::move(name), area, {255, 255, 255}, {}};
    for (const auto& vertices : polygons) {
        const std::size_t i = made.polygons.size();
        made.polygons.push_back({std::string(1, char('A' + i)), colors[i % colors.size()], vertices});
    }
    return exact_scene::admit(std::move(made));
}

/// About two millionths: a millionth of the range from -1 to 1. At these coordinates `float` cannot resolve it.
constexpr double gap = 0x1p-19;

/// Between depths, and between heights of curves.
constexpr std::array powers{23, 20, 17, 13, 10, 7, 3};  // 2^-23 is about 1e-7, 2^-3 about 1e-1

AdmittedScene on(Color background, Scene scene) {
    scene.background = background;
    return exact_scene::admit(std::move(scene));
}

/// Three to seven polygons of three to eight vertices on ellipses, on planes of their own, in an area of any size.
Scene convex_polygons(RandomPolygons& random) {
    Scene scene{"convex polygons",
                {random.whole(-9, 9), random.whole(-9, 9), random.whole(3, 16), random.whole(3, 16)},
                {255, 255, 255},
                {}};
    const Area& area = scene.area;
    const auto eighths = [&](double low, double high) { return random.whole(int(8 * low), int(8 * high)) / 8.0; };
    for (int polygons = random.whole(3, 7); polygons > 0; --polygons) {
        const double x = area.x + eighths(0, area.width), y = area.y + eighths(0, area.height);
        const double width = eighths(1, area.width), height = eighths(1, area.height);
        const double z = random.whole(-40, 40) / 64.0, by_x = random.whole(-8, 8) / 512.0,
                     by_y = random.whole(-8, 8) / 512.0;
        std::vector<double> angles;
        for (int vertices = random.whole(3, 8); vertices > 0; --vertices) angles.push_back(random.whole(0, 359));
        std::sort(angles.begin(), angles.end());
        if (random.whole(0, 1) == 1) std::reverse(angles.begin(), angles.end());
        Vertices vertices;
        for (const double degrees : angles) {
            // Rounded to 1/1024, so that the sines of all machines give the same scene.
            const auto stepped = [](double value) { return std::round(value * 1024) / 1024; };
            const double u = stepped(width * std::cos(degrees / 57.296)),
                         v = stepped(height * std::sin(degrees / 57.296));
            vertices.push_back({x + u, y + v, z + by_x * u + by_y * v});
        }
        const std::size_t i = scene.polygons.size();
        scene.polygons.push_back({std::string(1, char('A' + i)), colors[i % colors.size()], vertices, false});
    }
    return admitted(scene);
}

Surface surface(std::string name, const Area& area, const std::vector<std::vector<Sample>>& curves) {
    CurveScene made{area, {}};
    for (const auto& samples : curves) made.curves.push_back({samples});
    return {std::move(name), admit(std::move(made))};
}

/// Two to six curves, some of which leave out columns at the sides. With few heights they touch, and meet on columns.
CurveScene random_curves(RandomPolygons& random, bool few_heights) {
    CurveScene scene{{random.whole(-9, 9), random.whole(-9, 9), random.whole(3, 14), random.whole(4, 14)}, {}};
    const Area& area = scene.area;
    const auto height = [&] {
        return few_heights ? area.y + double(random.whole(0, 4))
                           : area.y + random.whole(-64, 64 * (area.height + 1)) / 64.0;
    };
    for (int curves = random.whole(2, 6); curves > 0; --curves) {
        const bool is_short = random.whole(0, 2) == 0;
        const int first = is_short ? random.whole(area.x, area.right() - 2) : area.x;
        const int last = is_short ? random.whole(first + 1, area.right() - 1) : area.right() - 1;
        Curve curve;
        for (int x = first; x < last; x += random.whole(1, 5)) curve.samples.push_back({x, height()});
        curve.samples.push_back({last, height()});
        scene.curves.push_back(std::move(curve));
    }
    return scene;
}

}  // namespace

std::vector<AdmittedScene> scenes_to_grade(Language language) {
    constexpr Area square{0, 0, 16, 16};
    const Words say(language);
    std::vector<AdmittedScene> scenes{
        scene(say({"Two triangles apart", "Два отдельных треугольника"}), square,
              {{{1.25, 1.25, .25}, {6.25, 2.125, .25}, {2.25, 5.75, .25}},
               {{9.25, 7.125, .5}, {14.75, 7.875, .5}, {10.75, 11.25, .5}}}),
        scene(say({"A near square before a far one", "Ближний квадрат перед дальним"}), square,
              {level(-1, -1, 17, 17, .125), level(4.25, 2.25, 10.25, 7.75, .5)}),
        scene(say({"The near one comes first", "Ближний стоит первым"}), square,
              {level(4.25, 2.25, 10.25, 7.75, .5), level(-1, -1, 17, 17, .125)}),
        scene(say({"Behind depth 0", "За глубиной 0"}), square,
              {level(-1, -1, 17, 17, -.75), level(3.25, 1.25, 9.25, 12.75, -.25)}),
        scene(say({"Larger than the area", "Больше области"}), square,
              {{{-4.25, 5.75, .25}, {21.25, -3.25, .25}, {12.75, 22.25, .25}}}),
        scene(say({"Two walls through each other", "Две стены проходят друг сквозь друга"}), square,
              {sloping(1.25, 2.25, 15.25, 9.75, -.5, .5), sloping(1.25, 4.25, 15.25, 13.75, .4375, -.4375)}),
        scene(say({"Each behind the next", "Каждый за следующим"}), square,
              {sloping(1.25, 2.25, 14.25, 5.25, -.5, .5),
               {{10.25, 1.25, 0}, {14.25, 1.25, 0}, {14.25, 14.25, .25}, {10.25, 14.25, .25}},
               {{1.25, 1.25, 0}, {14.75, 12.25, .5}, {11.25, 14.75, .5}}}),
        scene(say({"Eight pieces", "Восемь фигур"}), square,
              {{{1.125, 1.25, .125}, {7.25, 2.125, .375}, {3.25, 9.125, .3125}},
               {{5.125, .25, -.25}, {15.25, 3.125, .5}, {8.125, 6.25, .125}},
               {{.25, 8.125, .5}, {9.125, 7.25, -.25}, {6.25, 15.125, .25}},
               {{8.25, 4.125, .75}, {14.125, 6.25, -.5}, {10.25, 13.125, .0625}},
               {{2.125, 3.25, -.125}, {13.25, 9.125, .1875}, {4.125, 13.25, .5}},
               level(6.25, 6.25, 9.75, 8.75, .328125),
               {{11.25, 8.125, 0}, {16.125, 10.25, .25}, {12.25, 16.125, .5}},
               level(.25, 12.25, 15.75, 14.75, -.390625)}),
        scene(say({"An area of 13 x 7", "Область 13 × 7"}), {0, 0, 13, 7},
              {level(-1, -1, 14, 8, -.5), level(6.25, 1.25, 12.75, 4.25, .25)}),
        scene(say({"An area of 3 x 1", "Область 3 × 1"}), {0, 0, 3, 1},
              {level(-1, -1, 1.75, 2, .25), level(1.25, -1, 4, 2, .125)}),
        scene(say({"An area off the origin", "Область не в начале координат"}), {-5, 3, 8, 8},
              {level(-6, 2, 4, 12, -.25), level(-3.75, 4.25, .25, 6.25, .5)}),
        scene(say({"Nothing", "Пустая сцена"}), {0, 0, 4, 4}, {}),
        scene(say({"Off the area", "Вне области"}), {0, 0, 8, 8},
              {level(9, 1, 12, 4, .5), level(1.25, 2.25, 6.25, 4.25, .25)}),
        scene(say({"Seen edge-on", "Виден с ребра"}), {0, 0, 8, 8},
              {level(1.25, 1.25, 6.75, 4.25, .25), {{2, 1, .5}, {5, 5, .5}, {5, 5, -.5}, {2, 1, -.5}}}),
        scene(say({"An edge that two share, on the centres of pixels", "Общее ребро двух по центрам пикселей"}),
              {0, 0, 8, 8}, {level(1.25, 1.25, 4.5, 6.75, .25), level(4.5, 1.25, 6.75, 6.75, .25)}),
        scene(say({"A vertex that four share, on the centre of a pixel", "Общая вершина четырёх в центре пикселя"}),
              {0, 0, 8, 8},
              {{{4.5, 4.5, .25}, {1.25, 4.5, .25}, {4.5, 1.25, .25}},
               {{4.5, 4.5, .25}, {4.5, 1.25, .25}, {7.75, 4.5, .25}},
               {{4.5, 4.5, .25}, {7.75, 4.5, .25}, {4.5, 7.75, .25}},
               {{4.5, 4.5, .25}, {4.5, 7.75, .25}, {1.25, 4.5, .25}}}),
        scene(say({"Vertices on centres and corners of pixels", "Вершины в центрах и углах пикселей"}), {0, 0, 8, 8},
              {level(.5, .5, 3.5, 3.5, .25), level(4, 4, 8, 8, .5), {{0.5, 7.5, 0}, {3.5, 4.5, 0}, {3.5, 7.5, 0}}}),
        scene(say({"Two in one plane", "Два в одной плоскости"}), {0, 0, 8, 8},
              {sloping(1.25, 1.25, 5.25, 5.25, .125, .375), sloping(1.25, 3.25, 7.25, 6.75, .125, .5)}),
        scene(say({"Five vertices, six and nine", "Пять вершин, шесть и девять"}), square,
              {tilted({{2.25, 1.25}, {8.25, .75}, {13.25, 4.25}, {9.75, 7.25}, {3.25, 6.25}}, .25, 0, .03125),
               tilted({{6.25, 5.25}, {10.25, 5.75}, {14.75, 9.25}, {13.25, 14.75}, {9.25, 13.75}, {5.25, 9.75}}, .75,
                      -.0625, 0),
               tilted({{1.25, 9.25},
                       {2.25, 7.75},
                       {4.25, 7.25},
                       {6.25, 8.25},
                       {7.25, 10.25},
                       {6.75, 12.75},
                       {5.25, 14.25},
                       {3.25, 14.75},
                       {1.75, 12.75}},
                      -.25, .0625, .03125)}),
        scene(say({"The first three vertices on a line", "Первые три вершины на одной прямой"}), square,
              {tilted({{1.25, 1.25}, {6.25, 1.25}, {12.25, 1.25}, {12.25, 9.25}, {1.25, 9.25}}, -.25, 0, .0625),
               tilted({{8.25, 6.25}, {8.25, 9.25}, {8.25, 14.25}, {14.75, 11.25}}, .75, -.0625, 0),
               level(3.25, 3.25, 9.75, 12.75, .125)}),
        scene(say({"The first vertex twice", "Первая вершина дважды"}), square,
              {tilted({{2.25, 2.25}, {2.25, 2.25}, {13.25, 3.25}, {11.25, 12.75}}, .5, -.03125, .015625),
               level(5.25, 1.25, 14.75, 8.25, .25)}),
        scene(
            say({"Vertices on the lines of windows", "Вершины на линиях окон"}), square,
            {level(13.75, 13.25, 15.25, 15.75, .5), tilted({{8, 1.25}, {13.25, 8}, {8, 12.75}, {2.75, 8}}, .25, 0, 0)}),
        scene(say({"Vertices and edges on the lines of windows", "Вершины и рёбра на линиях окон"}), square,
              {level(14.25, .25, 15.75, 1.75, .5),
               tilted({{4, 4}, {12, 4}, {14, 8}, {12, 12}, {4, 12}, {2, 8}}, .125, .03125, 0)}),
        scene(say({"Vertices on the corners of windows", "Вершины в углах окон"}), square,
              {tilted({{1.25, 1.75}, {2.75, 1.25}, {2.25, 2.75}}, .5, 0, 0),
               tilted({{4, 8}, {8, 4}, {12, 8}, {8, 12}}, .25, .015625, .015625),
               level(13.25, 12.25, 15.25, 14.75, .375)}),
        scene(say({"Corners of windows, cut off", "Срезанные углы окон"}), square,
              {level(12.75, 1.25, 14.75, 2.75, .25), tilted({{-3, 6}, {6, -3}, {7.5, 7.5}}, .125, .015625, -.015625),
               tilted({{1.25, 19.25}, {12.25, 6.25}, {18.75, 17.25}}, .0625, 0, .03125)}),
        scene(say({"Nearer by a millionth of the range", "Ближе на миллионную долю диапазона"}), square,
              {level(-1, -1, 17, 17, .25), level(2.25, 2.25, 12.25, 9.75, .25 + gap),
               level(5.25, 5.25, 14.75, 14.25, .25)}),
        scene(say({"Farther by a millionth of the range", "Дальше на миллионную долю диапазона"}), square,
              {level(2.25, 2.25, 12.25, 9.75, .25), level(5.25, 5.25, 14.75, 14.25, .25 - gap),
               sloping(1.25, 8.25, 13.25, 15.25, .25 - 2 * gap, .25 + 2 * gap)}),
        scene(say({"Tilted, a millionth of the range apart", "Наклонные, разделены миллионной долей диапазона"}),
              square,
              {tilted({{1.25, 1.25}, {12.25, 2.25}, {11.25, 11.25}}, -.75, .03125, .0625),
               tilted({{-2, -2}, {18, -2}, {18, 18}, {-2, 18}}, -.75 - gap, .03125, .0625),
               tilted({{3.25, 5.25}, {14.25, 3.25}, {9.25, 13.75}}, -.75 + gap, .03125, .0625)}),
        scene(say({"At both ends of the range", "На обоих концах диапазона"}), square,
              {level(-1, -1, 17, 17, -1), level(3.25, 2.25, 9.75, 12.25, 1), sloping(6.25, 5.25, 14.25, 10.75, -1, 1)}),
        scene(say({"Nothing but the farthest depth", "Только самая дальняя глубина"}), {0, 0, 8, 8},
              {level(1.25, 1.25, 6.75, 6.75, -1)}),
        scene(say({"Four bars, each before the next", "Четыре полосы, каждая перед следующей"}), square,
              {sloping(.75, 2.25, 14.75, 4.75, .25, -.25),
               tilted({{11.25, .75}, {13.75, .75}, {13.75, 14.75}, {11.25, 14.75}}, .25, 0, -.03125),
               sloping(1.25, 11.25, 15.25, 13.75, -.25, .25),
               tilted({{2.25, 1.25}, {4.75, 1.25}, {4.75, 15.25}, {2.25, 15.25}}, -.25, 0, .03125)}),
        scene(say({"Thinner than a pixel", "Тоньше пикселя"}), square,
              {{{.25, .25, .5}, {15.75, 14.75, .5}, {15.25, 15.75, .5}},
               {{1.25, 14.75, .25}, {14.25, 1.25, .375}, {14.5, 1.5, .375}},
               level(2.25, 6.125, 13.75, 6.75, .125)}),
        scene(say({"Between the centres of pixels", "Между центрами пикселей"}), square,
              {level(-1, -1, 17, 17, .125), level(3.625, 1.25, 4.375, 14.75, .5),
               level(8.5625, 9.5625, 9.4375, 10.4375, .75)}),
        scene(say({"Less than a pixel, alone", "Меньше пикселя, отдельно"}), square,
              {level(2.625, 2.625, 3.375, 3.25, .5), level(9.25, 10.125, 9.75, 10.875, .25)}),
        scene(say({"Over each side of the area", "Через каждую сторону области"}), square,
              {level(-3.25, 3.25, 2.75, 6.25, .25), level(12.25, 8.25, 19.75, 11.75, .375),
               level(7.25, -2.25, 10.25, 2.75, .125), level(4.25, 13.25, 8.75, 20.25, .5),
               level(6.25, 6.25, 9.75, 9.75, .25)}),
        scene(say({"From near to far", "От ближних к дальним"}), square,
              {level(6.25, 6.25, 9.75, 9.75, .75), level(4.25, 4.25, 11.75, 11.75, .5),
               level(2.25, 2.25, 13.75, 13.75, .25), level(.25, .25, 15.75, 15.75, 0)}),
        scene(say({"From far to near", "От дальних к ближним"}), square,
              {level(.25, .25, 15.75, 15.75, 0), level(2.25, 2.25, 13.75, 13.75, .25),
               level(4.25, 4.25, 11.75, 11.75, .5), level(6.25, 6.25, 9.75, 9.75, .75)}),
        scene(say({"Two that surround, and one before each", "Два охватывающих и по одному перед каждым"}), square,
              {level(-1, -1, 17, 17, .25), level(2.25, 9.25, 6.25, 13.25, .5), level(-2, -2, 18, 18, .375),
               level(9.25, 2.25, 13.25, 6.25, .3125)}),
        scene(say({"Through the one that surrounds", "Сквозь охватывающий"}), square,
              {level(-1, -1, 17, 17, .125), tilted({{-1, -1}, {17, -1}, {17, 17}, {-1, 17}}, -.625, .0625, .03125),
               sloping(2.25, 3.25, 13.75, 12.25, .375, -.125)}),
        scene(say({"The other direction", "В другом направлении"}), square,
              {{{2.25, 2.25, .25}, {2.25, 9.75, .25}, {11.25, 9.75, .25}, {11.25, 2.25, .25}},
               {{6.25, 14.25, .5}, {14.25, 12.25, .5}, {13.25, 5.25, 0}, {5.25, 7.25, 0}}}),
        scene(say({"Edges on the centres of rows", "Рёбра по центрам строк"}), {0, 0, 8, 8},
              {level(1.25, 1.5, 5.75, 4.5, .25), tilted({{2.5, 5.5}, {6.5, 5.5}, {4.5, 7.5}}, .25, 0, 0),
               tilted({{4.5, .5}, {7.5, 2.5}, {6.5, 6.5}}, .375, 0, 0)}),
        // Two edges begin at one point and lead to the left, so only their dx says which is the left one.
        scene(say({"A tip on the centre of a row", "Остриё в центре строки"}), square,
              {{{13.25, 2.5, 0}, {9.25, 13.25, -.25}, {1.25, 9.25, .25}}}),
        scene(say({"An area of 5 x 12", "Область 5 × 12"}), {2, -3, 5, 12},
              {level(1, -4, 8, 10, -.25), tilted({{3.25, -2.25}, {6.75, 2.25}, {2.25, 8.25}}, .25, .03125, 0),
               level(2.25, 3.25, 5.75, 7.25, .125)}),
        scene(say({"An area of 16 x 3", "Область 16 × 3"}), {-9, 4, 16, 3},
              {level(-8.25, 4.25, 6.25, 5.75, .25), sloping(-4.25, 3.25, 5.25, 8.25, -.5, 1)}),
        // The product of the two distances from the side x = 0 is less than every double but 0 (X-W7).
        scene(say({"Across a side by the least number", "За сторону на наименьшее число"}), {0, 0, 2, 2},
              {{{-std::numeric_limits<double>::denorm_min(), 1, 0}, {.125, .25, 0}, {1.75, 1, 0}, {.125, 1.75, 0}}}),
        scene(say({"A single pixel", "Единственный пиксель"}), {3, 3, 1, 1},
              {level(2.25, 2.25, 5.25, 5.25, .25), level(3.25, 3.25, 3.75, 3.75, .5)}),
        on(Color{16, 16, 32}, scene(say({"A dark background", "Тёмный фон"}), {0, 0, 12, 12},
                                    {level(1.25, 1.25, 7.75, 5.25, .25),
                                     tilted({{5.25, 3.25}, {10.25, 4.25}, {7.25, 10.75}}, .375, 0, 0)})),
    };
    // The second polygon is hidden and the third is not, by the gap alone. The fourth passes through the first. A
    // program in float must tell apart depths 2^-13 and more apart, which is more than twice its tolerance; below that
    // they are left open.
    for (const int power : powers) {
        const double difference = std::ldexp(1, -power);
        scenes.push_back(scene(say({"Depths 2^-{} apart", "Глубины на расстоянии 2^-{}"}, power), {0, 0, 12, 12},
                               {level(-1, -1, 13, 13, .25), level(1.25, 1.25, 6.75, 6.75, .25 - difference),
                                level(5.25, 3.25, 10.75, 8.75, .25 + difference),
                                sloping(1.25, 7.25, 10.75, 10.75, .25 - 2 * difference, .25 + 2 * difference)}));
    }
    return scenes;
}

std::vector<AdmittedScene> random_scenes_to_grade(unsigned seed, int count, Language language) {
    const Words say(language);
    RandomPolygons random{std::mt19937(seed)};
    std::vector<AdmittedScene> scenes;
    for (int i = 0; i < count; ++i) {
        Scene scene =
            i % 2 == 0 ? convex_polygons(random) : random_scene(families[std::size_t(i / 2) % families.size()], random);
        scene.name = say({"Random, {}", "Случайная, {}"}, i + 1);
        scenes.push_back(exact_scene::admit(std::move(scene)));
    }
    return scenes;
}

std::vector<Surface> surfaces_to_grade(Language language) {
    constexpr Area area{0, 0, 12, 12};
    const Words say(language);
    std::vector<Surface> surfaces{
        surface(say({"One curve", "Одна кривая"}), area, {{{0, 8}, {4, 3.25}, {11, 7.5}}}),
        surface(say({"A farther curve above", "Дальняя кривая выше"}), area, {{{0, 9}, {11, 8}}, {{0, 5}, {11, 3}}}),
        surface(say({"A farther curve below", "Дальняя кривая ниже"}), area,
                {{{0, 3}, {11, 4}}, {{0, 8}, {5, 9.5}, {11, 7}}}),
        surface(say({"A curve between two others", "Кривая между двумя другими"}), area,
                {{{0, 2}, {11, 3}}, {{0, 10}, {11, 9}}, {{0, 5}, {6, 7}, {11, 4}}}),
        surface(say({"Behind a hill", "За холмом"}), area,
                {{{0, 10}, {11, 10}}, {{0, 9}, {5, 2.5}, {11, 9}}, {{0, 6}, {11, 6.5}}}),
        surface(say({"Through both horizons", "Сквозь оба горизонта"}), area,
                {{{0, 8}, {11, 8}}, {{0, 4}, {11, 4}}, {{0, 1}, {11, 11}}}),
        surface(say({"Out of the lower horizon and back", "За нижний горизонт и обратно"}), area,
                {{{0, 7}, {11, 7}}, {{0, 2}, {11, 3}}, {{0, 5}, {4, 9.5}, {9, 10}, {11, 5}}}),
        surface(say({"A peak between two samples", "Пик между двумя отсчётами"}), area,
                {{{0, 11}, {11, 11}}, {{0, 9}, {5, 9}, {6, 2}, {7, 9}, {11, 9}}, {{0, 6}, {11, 6.25}}}),
        surface(say({"Steep curves", "Крутые кривые"}), area,
                {{{0, 11}, {1, 1}, {2, 10}, {11, 2}}, {{0, 3}, {3, 9}, {4, 0.5}, {11, 8}}}),
        surface(say({"Curves of different columns", "Кривые над разными столбцами"}), area,
                {{{3, 8}, {8, 7}}, {{1, 6}, {11, 5}}, {{0, 4}, {6, 9}, {10, 4.5}}}),
        surface(say({"Behind the side edges", "За боковыми рёбрами"}), area,
                {{{4, 10}, {8, 10}}, {{1, 3}, {11, 2}}, {{0, 6}, {11, 7}}}),
        surface(say({"Side edges over each other", "Боковые рёбра друг над другом"}), area,
                {{{5, 4}, {7, 4}}, {{0, 9}, {3, 9}}, {{6, 2}, {11, 9}}, {{2, 6}, {8, 6}}}),
        surface(say({"Apart from each other", "Отдельно друг от друга"}), area,
                {{{0, 6}, {3, 5}}, {{8, 7}, {11, 6}}, {{2, 4}, {9, 8}}}),
        surface(say({"Beyond the upper side of the area", "За верхней стороной области"}), area,
                {{{0, -6}, {11, -5}}, {{0, -3}, {11, -8}}}),
        surface(say({"Beyond the lower side of the area", "За нижней стороной области"}), area,
                {{{0, 18}, {11, 17}}, {{0, 15}, {5, 20}, {11, 14}}}),
        surface(say({"The same curve twice", "Одна и та же кривая дважды"}), area,
                {{{0, 8}, {5, 3}, {11, 7}}, {{0, 8}, {5, 3}, {11, 7}}, {{0, 6}, {11, 5}}}),
        surface(say({"A curve that touches a horizon", "Кривая касается горизонта"}), area,
                {{{0, 8}, {11, 8}}, {{0, 4}, {11, 4}}, {{0, 6}, {5, 4}, {11, 6}}, {{0, 2}, {4, 4}, {7, 4}, {11, 1}}}),
        surface(say({"Where the horizons meet", "Где горизонты сходятся"}), area,
                {{{0, 5}, {11, 5}}, {{0, 5}, {4, 8}, {8, 5}, {11, 2}}}),
        surface(say({"Crossings on columns", "Пересечения над столбцами"}), area,
                {{{0, 6}, {11, 6}}, {{0, 2}, {8, 10}, {11, 7}}, {{0, 4}, {4, 8}, {11, 1}}}),
        surface(say({"A curve that rises over itself", "Кривая поднимается над собой"}), {0, 0, 6, 8},
                {{{0, 6}, {5, 6}}, {{0, 2}, {5, 2}}, {{0, 1}, {2, 0.5}, {5, 5}}}),
        surface(say({"Two columns", "Два столбца"}), {0, 0, 2, 6},
                {{{0, 4}, {1, 2}}, {{0, 2}, {1, 4}}, {{0, 1}, {1, 5}}}),
        surface(say({"Left of zero", "Левее нуля"}), {-7, -4, 9, 8},
                {{{-7, 2}, {1, 1}}, {{-5, -2}, {0, 3}}, {{-6, 1.5}, {1, -3}}}),
        surface(say({"A millionth apart", "На расстоянии миллионной доли"}), area,
                {{{0, 6}, {11, 6}}, {{0, 6 - gap}, {11, 6 + gap}}, {{0, 6 + gap}, {11, 6 - 2 * gap}}}),
        surface(say({"Six waves", "Шесть волн"}), area,
                {{{0, 9}, {2, 7.75}, {5, 9.5}, {8, 8}, {11, 9}},
                 {{0, 8}, {3, 9.25}, {6, 6.5}, {9, 8.75}, {11, 7}},
                 {{0, 7.5}, {2, 6}, {4, 8}, {7, 6.25}, {11, 8}},
                 {{0, 6}, {3, 7.25}, {5, 5}, {8, 7}, {11, 5.5}},
                 {{0, 6.5}, {4, 4.25}, {7, 6.75}, {11, 4}},
                 {{0, 4}, {2, 6.25}, {6, 3.5}, {9, 5.75}, {11, 3}}}),
    };
    for (const int power : powers) {
        const double apart = std::ldexp(1, -power);
        surfaces.push_back(
            surface(say({"Heights 2^-{} apart", "Высоты на расстоянии 2^-{}"}, power), area,
                    {{{0, 6}, {11, 6}}, {{0, 6 - apart}, {11, 6 + apart}}, {{0, 6 + apart}, {11, 6 - 2 * apart}}}));
    }
    return surfaces;
}

std::vector<Surface> random_surfaces_to_grade(unsigned seed, int count, Language language) {
    const Words say(language);
    RandomPolygons random{std::mt19937(seed)};
    std::vector<Surface> surfaces;
    for (int i = 0; i < count; ++i) {
        const bool ties = i % 2 == 1;
        surfaces.push_back({say({"Random, {}", "Случайная, {}"}, i + 1), admit(random_curves(random, ties))});
    }
    return surfaces;
}

}  // namespace vidno
