/// Writes what your own program does, step by step, as a trace that the page of vidno replays. README.md beside this
/// file explains how to begin. Needs only C++14 and the standard library; a program that includes it does not need
/// vidno.
///
/// Make one call for each step. A call names the step's place in the listing and its result; trace/FORMAT.md describes
/// the events. A call that cannot be right is reported on standard error, and the program continues.
#ifndef VIDNO_STUDENT_H
#define VIDNO_STUDENT_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <string>
#include <vector>

namespace vidno {
namespace student {

struct Color {
    int red, green, blue;  // 0 to 255
};

struct Vertex {
    double x, y, z;  // y grows downward, the greater z is nearer, -1 <= z <= 1
};

/// Whole pixels; (x, y) is the upper left one. `window` of a scene file.
struct Area {
    int x, y, width, height;
};

/// Convex and planar.
struct Polygon {
    std::string id;  // unique; UTF-8
    Color color;
    std::vector<Vertex> vertices;
};

/// The contents of a scene file. Calls name a polygon by its index here, from 0.
struct Scene {
    std::string name;
    Area area;
    Color background;
    std::vector<Polygon> polygons;
};

/// A point of a curve, over a whole column. y grows downward. Where it is no number, the curve has a gap: nothing joins
/// it to its neighbours.
struct Sample {
    int x;
    double y;
};

/// The contents of a surface file: its curves from the nearest to the farthest, each from its left sample to its right
/// one. Calls name a curve by its index here, from 0.
struct Surface {
    std::string name;
    Area area;
    std::vector<std::vector<Sample>> curves;
};

/// A place on the screen, in pixels.
struct ScreenPoint {
    double x, y;
};

/// The loops of a region. With y downward, an outline runs clockwise on the screen and a hole counterclockwise.
using Region = std::vector<std::vector<ScreenPoint>>;

/// A part of a polygon in a list. It is ground if it is known to be behind all others of the list.
struct Piece {
    int polygon;
    Region region;
    bool ground;
};

/// An environment variable that `vidno grade` sets for the program that it runs; null if a person runs it.
inline std::string told_by_grade(const char* variable) {
    const char* const value = std::getenv(variable);
    return value ? value : "";
}

/// The scene that `vidno grade` wants drawn, or else your own. Its text: name; x, y, width and height of the area; the
/// background; the number of polygons; for each the id, the colour, the number of vertices, and the vertices. Names
/// have their own lines.
inline Scene scene_to_draw(const Scene& own) {
    const std::string file = told_by_grade("VIDNO_SCENE");
    if (file.empty()) return own;
    std::ifstream text(file, std::ios::binary);
    const auto name = [&text] {
        std::string line;
        std::getline(text >> std::ws, line);
        return line.substr(line.empty() ? 0 : 1);  // after a mark that keeps its spaces
    };
    const auto color = [&text] {
        Color read{};
        text >> read.red >> read.green >> read.blue;
        return read;
    };
    Scene scene{};
    scene.name = name();
    text >> scene.area.x >> scene.area.y >> scene.area.width >> scene.area.height;
    scene.background = color();
    std::size_t polygons = 0;
    text >> polygons;
    while (text && scene.polygons.size() < polygons) {
        Polygon polygon{name(), color(), {}};
        std::size_t vertices = 0;
        text >> vertices;
        for (Vertex v{}; polygon.vertices.size() < vertices && text >> v.x >> v.y >> v.z;)
            polygon.vertices.push_back(v);
        scene.polygons.push_back(polygon);
    }
    if (!text) std::cerr << "vidno: the scene " << file << " cannot be read\n";
    return scene;
}

/// The surface that `vidno grade` wants drawn, or else your own. Its text: the name on its own line; x, y, width and
/// height of the area; the number of curves; for each the number of samples, and the samples.
inline Surface surface_to_draw(const Surface& own) {
    const std::string file = told_by_grade("VIDNO_SURFACE");
    if (file.empty()) return own;
    std::ifstream text(file, std::ios::binary);
    Surface surface{};
    std::getline(text, surface.name);
    surface.name.erase(0, 1);  // a mark that keeps its spaces
    text >> surface.area.x >> surface.area.y >> surface.area.width >> surface.area.height;
    std::size_t curves = 0;
    text >> curves;
    while (text && surface.curves.size() < curves) {
        surface.curves.emplace_back();
        std::size_t samples = 0;
        text >> samples;
        std::string height;  // a stream does not read "nan"
        for (Sample s{}; surface.curves.back().size() < samples && text >> s.x >> height;) {
            s.y = std::strtod(height.c_str(), nullptr);
            surface.curves.back().push_back(s);
        }
    }
    if (!text) std::cerr << "vidno: the surface " << file << " cannot be read\n";
    return surface;
}

/// How much of what the program reports goes into the file; everything, if `vidno grade` reads it.
enum class Detail { windows, polygons, signs };

/// The type of the program's numbers: double or float.
enum class Precision { double_precision, single_precision };

/// The cases of a window in Warnock's algorithm.
enum class Case { empty, surrounded, pixel, single, split };

/// The corners of a window: (x, y), (x, y + height), (x + width, y), (x + width, y + height). Left bottom is the upper
/// left on the screen.
enum class Corner { left_bottom, left_top, right_bottom, right_top };

/// A row, a column, or another number that must be whole: C++ would cut y + 0.5 down to y in silence.
struct Whole {
    template <class Number>
    Whole(Number number)
        : value(is_near(double(number)) ? int(number) : 0), is(double(value) == double(number)), told(double(number)) {}

    int value;
    bool is;
    double told;

private:
    static bool is_near(double number) { return number > -2e9 && number < 2e9; }
};

/// FIPS 180-4, in hexadecimal.
inline std::string sha256(std::vector<unsigned char> message) {
    static const std::uint32_t constants[64] = {
        0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
        0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
        0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
        0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
        0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
        0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
        0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
        0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
    std::uint32_t hash[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                             0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const auto rotated = [](std::uint32_t v, int by) { return v >> by | v << (32 - by); };

    const std::uint64_t bits = std::uint64_t(message.size()) * 8;
    message.push_back(0x80);
    while (message.size() % 64 != 56) message.push_back(0);
    for (int shift = 56; shift >= 0; shift -= 8) message.push_back(static_cast<unsigned char>(bits >> shift & 255));

    for (std::size_t block = 0; block < message.size(); block += 64) {
        std::uint32_t w[64];
        for (std::size_t i = 0; i < 16; ++i) {
            const unsigned char* byte = &message[block + 4 * i];
            w[i] = std::uint32_t(byte[0]) << 24 | std::uint32_t(byte[1]) << 16 | std::uint32_t(byte[2]) << 8 | byte[3];
        }
        for (int i = 16; i < 64; ++i) {
            const std::uint32_t s0 = rotated(w[i - 15], 7) ^ rotated(w[i - 15], 18) ^ w[i - 15] >> 3;
            const std::uint32_t s1 = rotated(w[i - 2], 17) ^ rotated(w[i - 2], 19) ^ w[i - 2] >> 10;
            w[i] = w[i - 16] + s0 + w[i - 7] + s1;
        }
        std::uint32_t v[8];
        std::copy(hash, hash + 8, v);
        for (int i = 0; i < 64; ++i) {
            const std::uint32_t s0 = rotated(v[0], 2) ^ rotated(v[0], 13) ^ rotated(v[0], 22);
            const std::uint32_t s1 = rotated(v[4], 6) ^ rotated(v[4], 11) ^ rotated(v[4], 25);
            const std::uint32_t choice = (v[4] & v[5]) ^ (~v[4] & v[6]);
            const std::uint32_t majority = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
            const std::uint32_t next = v[7] + s1 + choice + constants[i] + w[i];
            std::copy_backward(v, v + 7, v + 8);
            v[4] += next;
            v[0] = next + s0 + majority;
        }
        for (int i = 0; i < 8; ++i) hash[i] += v[i];
    }

    std::string digits;
    for (const std::uint32_t word : hash) {
        for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
    }
    return digits;
}

/// The common part of all traces: the file, and the procedure that runs.
class Trace {
public:
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;

protected:
    enum Procedure {
        method,
        process_window,
        point_color,
        surround_test,
        polygon_clip,
        fill_polygon,
        show_line,
        region_clip,
        remove_behind,
        side_edge_of_curve,
        visibility_of_point,
        horizon_of_segment,
        intersection_of_segment
    };

    struct Pixels {
        int left, top, right, bottom;
    };

    struct Window {
        double x, y, width, height;
    };

    /// Text that is JSON already.
    struct Json {
        std::string text;
    };

    Trace(const std::string& own_file, const Area& area, Detail detail)
        : area_(area),
          graded_file_(told_by_grade("VIDNO_TRACE")),
          detail_(graded_file_.empty() ? detail : Detail::signs) {
        const std::string file = graded_file_.empty() ? own_file : graded_file_;
        file_.open(file, std::ios::binary);
        begin("open");
        if (!file_) complain("the file " + file + " cannot be written");
        if (area.width < 1 || area.height < 1) complain("the area has no pixels");
    }

    /// The first line.
    void put_header(const char* name, Precision precision, const Json& scene) {
        const char* const details[] = {"windows", "polygons", "signs"};
        const char* const kernel = precision == Precision::double_precision ? "double" : "float";
        put(object("format", "vidno-trace/1", "method", name, "edition", "corrected", "kernel", kernel, "detail",
                   details[int(detail_)], "scene", scene));
    }
    /// The last line, with the hash of the result.
    void put_end(const char* result, const std::vector<unsigned char>& bytes) {
        begin("close");
        run(method);
        put(object("end", Json{object("events", events_, result, "sha256:" + sha256(bytes))}));
        if (!file_) complain("the file could not be written");
        closed_ = true;
    }
    bool is_closed() const { return closed_; }

    Detail detail() const { return detail_; }
    const Area& area() const { return area_; }
    Json window_json() const {
        return {object("x", area_.x, "y", area_.y, "width", area_.width, "height", area_.height)};
    }

    /// Notes a call of the program, for complaints.
    void begin(const char* call) {
        ++calls_;
        call_ = call;
        if (closed_) complain("the trace is closed");
    }
    void complain(const std::string& what) {
        const int most = 20;
        if (++complaints_ > most) return;
        std::cerr << "vidno: call " << calls_ << ", " << call_ << ", after step " << events_ << ": " << what << '\n';
        if (complaints_ == most) std::cerr << "vidno: more complaints are not shown\n";
    }

    /// Whether the rows and columns of a call are whole, with a complaint if they are not.
    bool are_whole(const char* call, std::initializer_list<Whole> numbers) {
        const auto is_whole = [](const Whole& each) { return each.is; };
        const Whole* const other = std::find_if_not(numbers.begin(), numbers.end(), is_whole);
        if (other == numbers.end()) return true;
        begin(call);
        complain(json(other->told) + " is not a whole number, as a row or a column is");
        return false;
    }

    /// Makes sure that a procedure runs: if it does not, it is called now, at that line. False, with a complaint, while
    /// a procedure that it called has not reported its result.
    bool run(Procedure procedure, const char* callers_line = "") {
        static const struct {
            const char *name, *result;
            Detail from;     // the level of its call
            bool is_nested;  // another procedure may call it
        } all[] = {{"", "", Detail::windows, false},
                   {"ProcessWindow", "summary", Detail::polygons, false},
                   {"PointColor", "color", Detail::polygons, false},
                   {"SurroundTest", "surround", Detail::signs, true},
                   {"PolygonClip", "clip_result", Detail::polygons, false},
                   {"FillPolygon", "draw", Detail::polygons, false},
                   {"ShowLine", "span", Detail::polygons, false},
                   {"RegionClip", "clipped", Detail::polygons, false},
                   {"RemoveBehind", "nearer_ones", Detail::polygons, false},
                   {"SideEdge", "side_edge", Detail::polygons, false},
                   {"Visibility", "visibility", Detail::signs, false},
                   {"Horizon", "horizon", Detail::signs, true},
                   {"Intersection", "intersection", Detail::signs, false}};
        const bool called = std::find(running_.begin(), running_.end(), procedure) != running_.end();
        if (called ? !runs(procedure) : !all[procedure].is_nested && running_.size() > 1) {
            complain(std::string(all[running_.back()].name) + " has not told its result, `" +
                     all[running_.back()].result + '`');
        }
        if (!called) {
            tell(all[procedure].from, "call", callers_line, "of", all[procedure].name);
            running_.push_back(procedure);
        }
        return runs(procedure);
    }
    bool runs(Procedure procedure) const { return running_.back() == procedure; }
    /// Like `run`, but the procedure also ends: its result is reported next.
    bool end(Procedure procedure, const char* callers_line) {
        const bool can_end = run(procedure, callers_line);
        if (can_end) running_.pop_back();
        return can_end;
    }

    /// An event of this level, with its fields as name, value, name, value.
    template <class... Fields>
    void tell(Detail from, const char* event, const char* at, const Fields&... fields) {
        if (closed_ || from > detail_) return;
        tell_line(object("e", event, "at", at, fields...));
    }
    /// An event that is a line already.
    void tell_line(const std::string& line) {
        put(line);
        ++events_;
    }

    template <class... Values>
    static Json list(const Values&... values) {
        return {json(std::vector<Json>{Json{json(values)}...})};
    }

    /// Keeps only the pixels in the area, with a complaint about others; false if none are left.
    bool cut(Pixels& pixels) {
        if (pixels.left >= pixels.right || pixels.top >= pixels.bottom) return false;
        const Pixels all = pixels;
        if (pixels.left < area().x) pixels.left = area().x;
        if (pixels.top < area().y) pixels.top = area().y;
        if (pixels.right > area().x + area().width) pixels.right = area().x + area().width;
        if (pixels.bottom > area().y + area().height) pixels.bottom = area().y + area().height;
        const bool whole = pixels.left == all.left && pixels.top == all.top && pixels.right == all.right &&
                           pixels.bottom == all.bottom;
        if (!whole) complain("pixels outside the area");
        return pixels.left < pixels.right && pixels.top < pixels.bottom;
    }
    /// Adds a row of pixels to those that will be painted, as far as it lies in the area.
    void add_row(std::vector<Pixels>& rows, int first, int y, int end) {
        Pixels pixels{first, y, end, y + 1};
        if (cut(pixels)) rows.push_back(pixels);
    }
    /// Adds a pixel, to the last row if it is the next one there.
    void add_pixel(std::vector<Pixels>& rows, int x, int y) {
        const bool goes_on = !rows.empty() && rows.back().top == y && rows.back().right == x;
        if (goes_on && x < area().x + area().width) {
            ++rows.back().right;
        } else {
            add_row(rows, x, y, x + 1);
        }
    }
    static std::string json(const Json& value) { return value.text; }
    static std::string json(bool value) { return value ? "true" : "false"; }
    static std::string json(int value) { return std::to_string(value); }
    static std::string json(const char* value) { return json(std::string(value)); }
    static std::string json(const std::string& value) {
        std::string text = "\"";
        for (const char c : value) {
            if (static_cast<unsigned char>(c) >= 32 && c != '"' && c != '\\') {
                text += c;
                continue;
            }
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", unsigned(c) & 127);
            text += code;
        }
        return text + '"';
    }
    /// A number with the fewest digits, from 15 up, that reads back the same.
    static std::string json(double value) {
        if (std::isnan(value)) return "\"nan\"";
        if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
        char text[32] = "0";  // -0 too
        for (int digits = 15; digits <= 17 && std::strtod(text, nullptr) != value; ++digits) {
            std::snprintf(text, sizeof text, "%.*g", digits, value);
        }
        for (char& c : text) c = c == ',' ? '.' : c;  // some locales have a comma
        return text;
    }
    static std::string json(const Color& color) {
        char text[8];
        std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red & 255, color.green & 255, color.blue & 255);
        return json(text);
    }
    static std::string json(const Vertex& v) { return list(v.x, v.y, v.z).text; }
    static std::string json(const ScreenPoint& c) { return list(c.x, c.y).text; }
    static std::string json(const Sample& s) {
        return std::isfinite(s.y) ? list(s.x, s.y).text : '[' + json(s.x) + ",null]";
    }
    static std::string json(const Window& w) { return list(w.x, w.y, w.width, w.height).text; }
    template <class T>
    static std::string json(const std::vector<T>& values) {
        std::string text;
        for (const T& value : values) text += (text.empty() ? "" : ",") + json(value);
        return '[' + text + ']';
    }

    template <class... Members>
    static std::string object(const Members&... all) {
        return '{' + members(all...) + '}';
    }

private:
    /// Flushes the line, so that everything reported before a crash is in the file.
    void put(const std::string& line) { file_ << line << '\n' << std::flush; }

    static std::string members() { return ""; }
    template <class Value, class... Rest>
    static std::string members(const char* name, const Value& value, const Rest&... rest) {
        return json(name) + ':' + json(value) + (sizeof...(rest) == 0 ? "" : ",") + members(rest...);
    }

    Area area_;
    std::string graded_file_;
    Detail detail_;
    std::ofstream file_;
    std::vector<Procedure> running_{method};
    const char* call_ = "";
    int calls_ = 0, events_ = 0, complaints_ = 0;
    bool closed_ = false;
};

/// The common part of the traces of polygons: the scene and the picture.
class PolygonTrace : public Trace {
public:
    ~PolygonTrace() { close(); }

    /// Ends the run with the last line. A file without it, from a program that crashed, is read as far as it goes.
    void close() {
        if (!is_closed()) put_end("picture", picture_bytes());
    }

    /// I1: the plane a x + b y + c z + d = 0.
    void plane(int polygon, double a, double b, double c, double d) {
        if (!begin("plane", polygon)) return;
        tell(Detail::polygons, "plane", "I1", "polygon", id(polygon), "plane", list(a, b, c, d));
    }

protected:
    PolygonTrace(const std::string& file, const char* name, const Scene& scene, Detail detail, Precision precision)
        : Trace(file, scene.area, detail), scene_(scene) {
        put_header(name, precision, scene_json());
        clear_picture();
    }

    const Color& background() const { return scene_.background; }
    const Polygon& polygon_at(int place) const { return scene_.polygons[std::size_t(place)]; }
    const std::string& id(int place) const { return polygon_at(place).id; }
    int polygon_count() const { return int(scene_.polygons.size()); }

    using Trace::begin;
    /// Begins a claim about a polygon; false if there is none.
    bool begin(const char* call, int polygon) {
        begin(call);
        return exists(polygon);
    }
    bool exists(int polygon) {
        const bool exists = polygon >= 0 && polygon < polygon_count();
        if (!exists) complain("the scene has no polygon " + json(polygon));
        return exists;
    }

    void clear_picture() {
        const bool has_pixels = area().width > 0 && area().height > 0;
        picture_.assign(has_pixels ? std::size_t(area().width) * std::size_t(area().height) : 0, background());
    }
    /// Pixels of the area take a colour.
    void paint(const Pixels& pixels, const Color& color) {
        for (int y = pixels.top; y < pixels.bottom; ++y) {
            const int first = (y - area().y) * area().width + (pixels.left - area().x);
            std::fill_n(picture_.begin() + first, pixels.right - pixels.left, color);
        }
    }

private:
    std::vector<unsigned char> picture_bytes() const {
        std::vector<unsigned char> bytes;
        for (const Color& c : picture_) {
            for (const int part : {c.red, c.green, c.blue}) bytes.push_back(static_cast<unsigned char>(part & 255));
        }
        return bytes;
    }

    Json scene_json() {
        std::vector<Json> polygons;
        std::vector<std::string> ids;
        for (const Polygon& each : scene_.polygons) {
            if (std::find(ids.begin(), ids.end(), each.id) != ids.end()) complain("two polygons " + json(each.id));
            ids.push_back(each.id);
            polygons.push_back({object("id", each.id, "color", each.color, "vertices", each.vertices)});
        }
        return {object("format", "vidno-scene/1", "name", scene_.name, "window", window_json(), "background",
                       background(), "polygons", polygons)};
    }

    Scene scene_;
    std::vector<Color> picture_;  // rows from the top
};

/// A run of Warnock's algorithm.
class WarnockTrace : public PolygonTrace {
public:
    WarnockTrace(const std::string& file, const Scene& scene, Detail detail = Detail::windows,
                 Precision precision = Precision::double_precision)
        : PolygonTrace(file, "warnock", scene, detail, precision) {}

    void push(double x, double y, double width, double height) {
        if (is_window("push", {x, y, width, height})) push_window({x, y, width, height});
    }
    void skip(double x, double y, double width, double height) {
        const Window window{x, y, width, height};
        if (is_window("skip", window)) tell(Detail::windows, "skip", "W13", "window", window);
    }
    void pop(double x, double y, double width, double height) {
        const Window window{x, y, width, height};
        if (!is_window("pop", window)) return;
        if (stack_.empty() || !same(stack_.back().window, window)) {
            // A program with a queue takes the window that has waited longest; the trace has a stack and pushes it
            // again.
            const auto is_it = [&](const ActiveWindow& each) { return same(each.window, window); };
            const bool waits = std::any_of(stack_.begin(), stack_.end(), is_it);
            if (!waits) complain("not the window on top of AW: the trace pushes it first");
            push_window(window);
        }
        current_ = stack_.back();
        stack_.pop_back();
        popped_ = true;
        decided_ = clipped_ = false;
        rows_.clear();
        tell(Detail::windows, "pop", "W5", "window", window);
    }
    void decide(Case which) {
        static const char* const names[] = {"empty", "surrounded", "pixel", "single", "split"};
        static const char* const lines[] = {"W7", "W8", "W9", "W10", "W13"};
        begin("decide");
        run(method);
        decided_ = true;
        if (which != Case::split) fill_line_ = lines[int(which)];
        tell(Detail::windows, "decide", lines[int(which)], "case", names[int(which)]);
    }
    void fill(Whole x, Whole y, Whole width, Whole height, const Color& color) {
        if (!are_whole("fill", {x, y, width, height})) return;
        begin("fill");
        run(method);
        Pixels pixels{x.value, y.value, x.value + width.value, y.value + height.value};
        if (!cut(pixels)) return;
        paint(pixels, color);
        const Json rect = list(pixels.left, pixels.top, pixels.right - pixels.left, pixels.bottom - pixels.top);
        tell(Detail::windows, "fill", fill_line_, "rect", rect, "color", color);
    }

    // ProcessWindow, from `pop` to `decide`

    void corners(double z) {
        begin("corners");
        run_inner();
        depths_ = 0;
        has_corners_ = true;
        tell(Detail::polygons, "corners", "PW1", "z", z);
    }
    void box(int polygon, double xmin, double ymin, double xmax, double ymax, bool outside) {
        look(Detail::signs, "box", "PW3", polygon, "box", list(xmin, ymin, xmax, ymax), "outside", outside);
    }
    void discard(int polygon) {
        if (!looks_at("discard", polygon) || !is_active(polygon)) return;
        current_.polygons.erase(entry(polygon));
        tell(Detail::polygons, "discard", "PW3", "polygon", id(polygon));
    }
    void count(int polygon, int so_far) {
        depths_ = 0;
        nearer_.clear();
        look(Detail::polygons, "count", "PW4", polygon, "count", so_far);
    }
    /// At the window's corners, in the order of Corner; also in PointColor.
    void depth(int polygon, double x, double y, double z) {
        ++depths_;
        look(Detail::polygons, "depth", decided_ ? "PC3" : "PW5", polygon, "point", list(x, y), "z", z);
    }
    void compare(int polygon, Corner corner, double z, double against, bool is_nearer) {
        static const char* const names[] = {"lb", "lt", "rb", "rt"};
        const char* const name = names[int(corner)];
        if (is_nearer) nearer_.push_back(name);
        look(Detail::signs, "compare", "PW6", polygon, "corner", name, "z", z, "against", against, "nearer", is_nearer);
    }
    /// After the four comparisons: the depths of the polygon stay at those corners where it is nearer.
    void nearer(int polygon) {
        if (!looks_at("nearer", polygon)) return;
        if (!has_corners_ || depths_ != 4) return complain("`corners` and four times `depth` come before");
        tell(Detail::polygons, "nearer", "PW6", "polygon", id(polygon), "corners", nearer_, "k", int(nearer_.size()));
    }
    void uncover(int polygon) { look(Detail::polygons, "uncover", "PW7", polygon); }
    void mark(int polygon) {
        if (!looks_at("mark", polygon) || !is_active(polygon)) return;
        entry(polygon)->surrounds = true;
        tell(Detail::polygons, "mark", "PW8", "polygon", id(polygon));
    }
    void cover(int polygon) {
        if (!looks_at("cover", polygon)) return;
        tell(Detail::polygons, "cover", "PW9", "polygon", id(polygon), "color", polygon_at(polygon).color);
    }
    void insider(int polygon, bool inside) { look(Detail::polygons, "insider", "PW10", polygon, "inside", inside); }
    /// Result of ProcessWindow; the colour counts if `has_surround`.
    void summary(int count, bool has_surround, const Color& color, bool insider) {
        begin("summary");
        if (!end(process_window, "W6")) return;
        if (has_surround) {
            tell(Detail::polygons, "summary", "W6", "count", count, "hasSurround", true, "color", color, "insider",
                 insider);
        } else {
            tell(Detail::polygons, "summary", "W6", "count", count, "hasSurround", false, "insider", insider);
        }
    }

    // PointColor, after `decide`

    void compare(int polygon, double z, double against, bool is_nearer) {
        look(Detail::signs, "compare", "PC4", polygon, "z", z, "against", against, "nearer", is_nearer);
    }
    void nearest(int polygon, double z) {
        if (!looks_at("nearest", polygon)) return;
        tell(Detail::polygons, "nearest", "PC4", "polygon", id(polygon), "z", z, "color", polygon_at(polygon).color);
    }
    /// Result of PointColor.
    void color(double x, double y, const Color& color) {
        begin("color");
        if (end(point_color, "W9")) tell(Detail::polygons, "color", "W9", "point", list(x, y), "color", color);
    }

    // SurroundTest, in either

    void orient(int polygon, int edge, double x, double y, double value, int sign) {
        if (!tests("orient", polygon)) return;
        tell(Detail::signs, "orient", has_sign_ ? "S3" : "S2", "polygon", id(polygon), "edge", edge, "point",
             list(x, y), "value", value, "sign", sign_of(sign));
        has_sign_ = has_sign_ || sign != 0;
    }
    /// Result of SurroundTest.
    void surround(int polygon, double x, double y, bool inside) {
        if (!tests("surround", polygon) || !end(surround_test, test_line())) return;
        has_sign_ = false;
        tell(Detail::polygons, "surround", test_line(), "polygon", id(polygon), "point", list(x, y), "inside", inside);
    }

    // PolygonClip

    void clip_begin(int polygon) {
        if (!begin("clip_begin", polygon)) return;
        run(polygon_clip, "W12");
        clipping_ = true;
        kept_ = 0;
        tell(Detail::polygons, "clip_begin", "PL1", "polygon", id(polygon), "window", current_.window);
    }
    /// Side 1 to 4 of the window, from f0 to F_i.
    void clip_side(int side, double from_x, double from_y, double to_x, double to_y) {
        if (!clips("clip_side")) return;
        if (side < 1 || side > 4) return complain("a window has the sides 1 to 4");
        kept_ = 0;
        has_first_ = false;
        tell(Detail::polygons, "clip_side", "PL2", "side", side, "from", list(from_x, from_y), "to", list(to_x, to_y));
    }
    /// The sign for the last vertex, then for each from the first on; positive lies outside.
    void clip_sign(const Vertex& vertex, double value, int sign) {
        clip(Detail::signs, "clip_sign", has_first_ ? "PL4" : "PL3", "vertex", vertex, "value", value, "sign",
             sign_of(sign));
        has_first_ = true;
    }
    void clip_cross(const Vertex& vertex) { kept_ += clip(Detail::polygons, "clip_cross", "PL5", "vertex", vertex); }
    void clip_keep(const Vertex& vertex) { kept_ += clip(Detail::polygons, "clip_keep", "PL6", "vertex", vertex); }
    void clip_drop(const Vertex& vertex) { clip(Detail::polygons, "clip_drop", "PL6", "vertex", vertex); }
    /// The vertices that joined at this side become the list for the next.
    void clip_list() {
        clip(Detail::polygons, "clip_list", "PL7", "count", kept_);
        kept_ = 0;
    }
    /// Result of PolygonClip.
    void clip_result(int polygon, const std::vector<Vertex>& vertices) {
        if (!begin("clip_result", polygon) || !end(polygon_clip, "W12")) return;
        clipping_ = false;
        clipped_ = true;
        tell(Detail::polygons, "clip_result", "W12", "polygon", id(polygon), "vertices", vertices);
    }

    // FillPolygon

    /// The pixels first <= x < end of row y will be drawn.
    void row(Whole y, double left, double right, Whole first, Whole end) {
        if (!are_whole("row", {y, first, end})) return;
        begin("row");
        run(fill_polygon, draw_line());
        tell(Detail::signs, "row", "F2", "row", y.value, "left", left, "right", right, "first", first.value, "end",
             end.value);
        add_row(rows_, first.value, y.value, end.value);
    }
    /// A pixel will be drawn, by a program that finds the pixels one by one and no rows.
    void pixel(Whole x, Whole y) {
        if (!are_whole("pixel", {x, y})) return;
        begin("pixel");
        run(fill_polygon, draw_line());
        add_pixel(rows_, x.value, y.value);
    }
    /// Result of FillPolygon: the rows take the polygon's colour.
    void draw(int polygon) {
        if (!begin("draw", polygon) || !end(fill_polygon, draw_line())) return;
        const Color& color = polygon_at(polygon).color;
        std::vector<Json> runs;
        for (const Pixels& each : rows_) {
            paint(each, color);
            runs.push_back(list(each.top, each.left, each.right));
        }
        rows_.clear();
        tell(Detail::windows, "draw", draw_line(), "polygon", id(polygon), "color", color, "runs", runs);
    }

private:
    struct Active {
        int polygon;
        bool surrounds;
    };
    struct ActiveWindow {
        Window window;
        std::vector<Active> polygons;  // APL
    };

    static bool same(const Window& a, const Window& b) {
        return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
    }
    bool is_window(const char* call, const Window& w) {
        begin(call);
        run(method);
        const bool finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.width + w.height);
        const bool is = finite && w.width > 0 && w.height > 0;
        if (!is) complain("not a window: a side is not positive, or a number not finite");
        return is;
    }
    /// A part has the polygons of the current window, the first window has all.
    void push_window(const Window& window) {
        if (popped_) {
            stack_.push_back({window, current_.polygons});
            return tell(Detail::windows, "push", "W13", "window", window);
        }
        std::vector<Active> all;
        std::vector<Json> entries;
        for (int i = 0; i < polygon_count(); ++i) {
            all.push_back({i, false});
            entries.push_back(list(id(i), false));
        }
        stack_.push_back({window, all});
        tell(Detail::windows, "push", "W3", "window", window, "apl", entries);
    }
    std::vector<Active>::iterator entry(int polygon) {
        const auto is_it = [polygon](const Active& each) { return each.polygon == polygon; };
        return std::find_if(current_.polygons.begin(), current_.polygons.end(), is_it);
    }
    bool is_active(int polygon) {
        const bool is = entry(polygon) != current_.polygons.end();
        if (!is) complain("the current APL has no polygon " + json(polygon));
        return is;
    }

    /// Before the decision ProcessWindow examines polygons, after it PointColor.
    bool run_inner() { return decided_ ? run(point_color, "W9") : run(process_window, "W6"); }
    bool looks_at(const char* call, int polygon) {
        const bool exists = begin(call, polygon);
        run_inner();
        return exists;
    }
    template <class... Fields>
    void look(Detail from, const char* call, const char* at, int polygon, const Fields&... fields) {
        if (looks_at(call, polygon)) tell(from, call, at, "polygon", id(polygon), fields...);
    }
    bool tests(const char* call, int polygon) {
        const bool exists = begin(call, polygon);
        if (!runs(surround_test) && run_inner()) run(surround_test, test_line());
        return exists;
    }
    bool clips(const char* call) {
        begin(call);
        if (!clipping_) complain("`clip_begin` comes before");
        return clipping_ && run(polygon_clip);
    }
    template <class... Fields>
    bool clip(Detail from, const char* call, const char* at, const Fields&... fields) {
        const bool can_clip = clips(call);
        if (can_clip) tell(from, call, at, fields...);
        return can_clip;
    }
    const char* test_line() const { return decided_ ? "PC2" : "PW8"; }
    const char* draw_line() const { return clipped_ ? "W12" : "W11"; }
    static int sign_of(int value) { return (value > 0) - (value < 0); }

    std::vector<ActiveWindow> stack_;  // AW
    ActiveWindow current_{};
    const char* fill_line_ = "W7";     // that of the last decision
    std::vector<std::string> nearer_;  // the corners where the current polygon is nearer
    std::vector<Pixels> rows_;         // of FillPolygon
    int depths_ = 0, kept_ = 0;        // since `count`; since `clip_side`
    bool popped_ = false, decided_ = false, clipped_ = false, clipping_ = false;
    bool has_corners_ = false, has_sign_ = false, has_first_ = false;
};

/// A run of the Z-buffer. Edge i of a polygon goes from vertex i to the next.
class ZBufferTrace : public PolygonTrace {
public:
    ZBufferTrace(const std::string& file, const Scene& scene, Detail detail = Detail::windows,
                 Precision precision = Precision::double_precision)
        : PolygonTrace(file, "zbuffer", scene, detail, precision) {}

    void clear(double z) {
        clear_picture();
        step(Detail::windows, "clear", "Z1", "color", background(), "z", z);
    }
    /// The calls after this one are about this polygon.
    void polygon(int next) {
        if (!begin("polygon", next)) return;
        leave_line();
        polygon_ = next;
        edges_.clear();
        active_.clear();
        tell(Detail::windows, "polygon", "Z2", "polygon", id(next), "color", polygon_at(next).color);
    }
    /// Joins S.
    void edge(int edge, const Vertex& from, const Vertex& to) {
        if (!is_edge("edge", edge)) return;
        edges_.push_back(edge);
        tell(Detail::polygons, "edge", "Z3", "edge", edge, "from", from, "to", to);
    }
    void extent(double ymin, double ymax) { step(Detail::polygons, "extent", "Z4", "ymin", ymin, "ymax", ymax); }
    void scanline(double y, Whole row) {
        if (!are_whole("scanline", {row})) return;
        step(Detail::windows, "scanline", "Z6", "y", y, "row", row.value);
        row_ = row.value;
    }

    // The active edge list

    void ael_add(int edge, double x, double z, double until, double dx, double dz) {
        if (!is_edge("ael_add", edge)) return;
        if (holds(active_, edge)) return complain("edge " + json(edge) + " is in AEL already");
        active_.push_back(edge);
        tell(Detail::polygons, "ael_add", "Z8", "edge", edge, "x", x, "z", z, "until", until, "dx", dx, "dz", dz);
    }
    /// The next `line` is that of a level edge.
    void horizontal(int edge) {
        if (!is_edge("horizontal", edge)) return;
        is_level_ = true;
        tell(Detail::polygons, "horizontal", "Z9", "edge", edge);
    }
    void leave(const std::vector<int>& edges, double next) {
        begin("leave");
        leave_line();
        tell(Detail::polygons, "leave", "Z10", "edges", take(edges_, edges, "S"), "next", next);
    }
    void ael_sort(const std::vector<int>& edges, double next) {
        begin("ael_sort");
        leave_line();
        if (edges.size() != active_.size() || !std::is_permutation(edges.begin(), edges.end(), active_.begin())) {
            return complain("not an order of the edges in AEL");
        }
        tell(Detail::polygons, "ael_sort", "Z12", "edges", edges, "next", next);
    }
    void ael_drop(const std::vector<int>& edges, double next) {
        begin("ael_drop");
        leave_line();
        tell(Detail::polygons, "ael_drop", "Z16", "edges", take(active_, edges, "AEL"), "next", next);
    }
    void ael_step(int edge, double x, double z) {
        begin("ael_step");
        leave_line();
        if (!holds(active_, edge)) return complain("edge " + json(edge) + " is not in AEL");
        tell(Detail::polygons, "ael_step", "Z17", "edge", edge, "x", x, "z", z);
    }

    // ShowLine

    void line(Whole row, double from_x, double from_z, double to_x, double to_z) {
        if (!are_whole("line", {row})) return;
        show(Detail::polygons, "line", "L1", "row", row.value, "from", list(from_x, from_z), "to", list(to_x, to_z));
        row_ = row.value;
    }
    void miss() { show(Detail::polygons, "miss", "L2"); }
    void slope(double dz) { show(Detail::signs, "slope", "L3", "dz", dz); }
    void columns(Whole first, Whole end, double z) {
        if (!are_whole("columns", {first, end})) return;
        show(Detail::signs, "columns", "L4", "first", first.value, "end", end.value, "z", z);
    }
    /// Compares its depth z with the stored one; shown if z replaces it.
    void pixel(Whole x, Whole y, double z, double stored, bool shown) {
        if (!are_whole("pixel", {x, y}) || !shows("pixel")) return;
        Pixels pixels{x.value, y.value, x.value + 1, y.value + 1};
        if (!cut(pixels)) return;
        if (!depths_.empty() && y.value != row_) return complain("`span` comes before another row");
        row_ = y.value;
        tell(Detail::signs, "pixel", "L6", "x", x.value, "y", y.value, "z", z, "stored", stored, "shown", shown);
        if (!shown) return;
        depths_.push_back(z);
        if (!runs_.empty() && runs_.back().right == x.value) {
            ++runs_.back().right;
        } else {
            runs_.push_back(pixels);
        }
    }
    /// Result of ShowLine: the pixels that were shown take the polygon's colour.
    void span() {
        if (shows("span")) show_span();
    }

private:
    template <class... Fields>
    void step(Detail from, const char* call, const char* at, const Fields&... fields) {
        begin(call);
        leave_line();
        tell(from, call, at, fields...);
    }
    template <class... Fields>
    void show(Detail from, const char* call, const char* at, const Fields&... fields) {
        if (shows(call)) tell(from, call, at, fields...);
    }
    bool shows(const char* call) {
        begin(call);
        if (polygon_ < 0) complain("`polygon` comes before");
        return polygon_ >= 0 && run(show_line, shown_at());
    }
    /// Returns to ZBuffer; a line without `span` gets one.
    void leave_line() {
        if (!run(method)) show_span();
    }
    void show_span() {
        end(show_line, shown_at());
        std::vector<Json> runs;
        for (const Pixels& each : runs_) {
            paint(each, polygon_at(polygon_).color);
            runs.push_back(list(each.left, each.right));
        }
        if (detail() == Detail::windows) {
            tell(Detail::windows, "span", shown_at(), "row", row_, "runs", runs);
        } else {
            tell(Detail::polygons, "span", shown_at(), "row", row_, "runs", runs, "depths", depths_);
        }
        runs_.clear();
        depths_.clear();
        is_level_ = false;
    }
    const char* shown_at() const { return is_level_ ? "Z9" : "Z14"; }

    bool is_edge(const char* call, int edge) {
        begin(call);
        leave_line();
        const bool is = polygon_ >= 0 && edge >= 0 && std::size_t(edge) < polygon_at(polygon_).vertices.size();
        if (!is) complain("the polygon has no edge " + json(edge));
        return is;
    }
    static bool holds(const std::vector<int>& edges, int edge) {
        return std::find(edges.begin(), edges.end(), edge) != edges.end();
    }
    /// Removes edges from the list and returns them, with a complaint about edges that are not on it.
    std::vector<int> take(std::vector<int>& list, const std::vector<int>& edges, const char* name) {
        std::vector<int> taken;
        for (const int edge : edges) {
            if (!holds(list, edge)) {
                complain("edge " + json(edge) + " is not in " + name);
                continue;
            }
            list.erase(std::find(list.begin(), list.end(), edge));
            taken.push_back(edge);
        }
        return taken;
    }

    int polygon_ = -1;
    std::vector<int> edges_, active_;  // S, AEL
    int row_ = 0;                      // of ShowLine, as are these
    std::vector<Pixels> runs_;
    std::vector<double> depths_;
    bool is_level_ = false;
};

/// A run of Weiler and Atherton's algorithm.
class WeilerAthertonTrace : public PolygonTrace {
public:
    WeilerAthertonTrace(const std::string& file, const Scene& scene, Detail detail = Detail::windows,
                        Precision precision = Precision::double_precision)
        : PolygonTrace(file, "weiler-atherton", scene, detail, precision) {}

    /// Result of RegionClip: the polygon's part in the area, perhaps empty.
    void cut_to_area(int polygon, const Region& region) {
        if (!begin("cut_to_area", polygon) || !end(region_clip, "WA1")) return;
        tell(Detail::polygons, "cut_to_area", "WA1", "polygon", id(polygon), "region", region);
    }

    // The stack of lists

    void push_list(const std::vector<Piece>& pieces) {
        begin("push_list");
        run(method);
        bool any_ground = false;
        std::vector<Json> told;
        for (const Piece& piece : pieces) {
            if (!exists(piece.polygon)) return;
            any_ground = any_ground || piece.ground;
            told.push_back(list(id(piece.polygon), piece.region, piece.ground));
        }
        if (pieces.empty()) return complain("an empty list");
        tell(Detail::windows, "push_list", !has_popped_ ? "WA3" : any_ground ? "WA9" : "WA6", "pieces", told);
        lists_.push_back(pieces);
    }
    /// The list on top becomes the current one. Its first piece clips the others.
    void pop_list() {
        begin("pop_list");
        run(method);
        if (lists_.empty()) return complain("the stack of lists is empty");
        current_ = lists_.back();
        lists_.pop_back();
        has_popped_ = true;
        next_ = 1;
        inside_ = hidden_ = 0;
        tell(Detail::windows, "pop_list", "WA4", "clip", id(current_[0].polygon), "count", int(current_.size()));
    }

    /// The next piece of the current list is known to lie outside the clip piece.
    void beside(int polygon) {
        if (!begin("beside", polygon) || !run(method) || !is_next(polygon)) return;
        ++next_;
        tell(Detail::polygons, "beside", "WA5", "polygon", id(polygon));
    }
    /// Result of RegionClip: the parts of the next piece of the current list, perhaps empty.
    void clipped(int polygon, const Region& inside, const Region& outside) {
        if (!begin("clipped", polygon) || !is_next(polygon) || !end(region_clip, "WA5")) return;
        inside_ += int(!inside.empty() && !current_[next_].ground);
        ++next_;
        tell(Detail::polygons, "clipped", "WA5", "polygon", id(polygon), "clip", id(current_[0].polygon), "inside",
             inside, "outside", outside);
    }
    /// In RemoveBehind: the depths of a part inside and of the clip piece at a point, and whether the part is hidden.
    void behind(int polygon, double x, double y, double z, double clip_z, bool is_behind) {
        if (!begin("behind", polygon)) return;
        if (hidden_ == inside_) return complain("no part inside is left");
        if (!run(remove_behind, "WA7")) return;
        ++hidden_;
        tell(Detail::polygons, "behind", "RB3", "polygon", id(polygon), "clip", id(current_[0].polygon), "point",
             list(x, y), "z", z, "clipZ", clip_z, "order", (z > clip_z) - (z < clip_z), "behind", is_behind);
    }
    /// Result of RemoveBehind: the polygons of the parts inside that are nearer.
    void nearer_ones(const std::vector<int>& polygons) {
        begin("nearer_ones");
        std::vector<std::string> ids;
        for (const int polygon : polygons) {
            if (!exists(polygon)) return;
            ids.push_back(id(polygon));
        }
        if (hidden_ != inside_) return complain("`behind` comes before, for each part inside that is not ground");
        if (end(remove_behind, "WA7")) tell(Detail::polygons, "nearer_ones", "WA7", "polygons", ids);
    }
    /// A part of the polygon is visible.
    void show(int polygon, const Region& region) {
        if (!begin("show", polygon) || !run(method)) return;
        tell(Detail::windows, "show", "WA8", "polygon", id(polygon), "region", region);
    }

    // PaintRegions

    /// Row y meets a visible region from left to right; its pixels first <= x < end will be painted.
    void row(Whole y, double left, double right, Whole first, Whole end) {
        if (!are_whole("row", {y, first, end})) return;
        begin("row");
        if (!run(method)) return;
        tell(Detail::signs, "row", "PR1", "row", y.value, "left", left, "right", right, "first", first.value, "end",
             end.value);
        add_row(rows_, first.value, y.value, end.value);
    }
    /// A pixel will be painted, by a program that finds the pixels one by one and no rows.
    void pixel(Whole x, Whole y) {
        if (!are_whole("pixel", {x, y})) return;
        begin("pixel");
        if (run(method)) add_pixel(rows_, x.value, y.value);
    }
    /// The rows take the polygon's colour.
    void paint(int polygon) {
        if (!begin("paint", polygon) || !run(method)) return;
        const Color& color = polygon_at(polygon).color;
        std::vector<Json> runs;
        for (const Pixels& each : rows_) {
            PolygonTrace::paint(each, color);
            runs.push_back(list(each.top, each.left, each.right));
        }
        rows_.clear();
        tell(Detail::windows, "paint", "PR3", "polygon", id(polygon), "color", color, "runs", runs);
    }

private:
    bool is_next(int polygon) {
        const bool is = next_ < current_.size() && current_[next_].polygon == polygon;
        if (!is) complain("not the next piece of the current list");
        return is;
    }

    std::vector<std::vector<Piece>> lists_;
    std::vector<Piece> current_;
    std::size_t next_ = 1;         // the piece of the current list that is clipped next
    int inside_ = 0, hidden_ = 0;  // parts inside that are not ground, and those of them with a `behind`
    bool has_popped_ = false;
    std::vector<Pixels> rows_;  // of `paint`
};

/// A run of the floating horizon.
class FloatingHorizonTrace : public Trace {
public:
    FloatingHorizonTrace(const std::string& file, const Surface& surface, Detail detail = Detail::windows,
                         Precision precision = Precision::double_precision)
        : Trace(file, surface.area, detail), curves_(surface.curves) {
        put_header("floating-horizon", precision,
                   {object("format", "vidno-surface/1", "name", surface.name, "window", window_json(), "curves",
                           surface.curves)});
    }
    ~FloatingHorizonTrace() { close(); }

    /// Ends the run with the last line. A file without it, from a program that crashed, is read as far as it goes.
    void close() {
        if (is_closed()) return;
        std::string text;
        for (const Line& line : lines_)
            text += list(line.curve, list(line.from.x, line.from.y), list(line.to.x, line.to.y)).text + '\n';
        put_end("lines", {text.begin(), text.end()});
    }

    /// There are no horizons over any column.
    void horizons() {
        begin("horizons");
        run(method);
        tell(Detail::polygons, "horizons", "FH1");
    }
    /// The horizons start at these heights over every column.
    void horizons(double upper, double lower) {
        begin("horizons");
        run(method);
        tell(Detail::polygons, "horizons", "FH1", "upper", upper, "lower", lower);
    }
    /// The calls after this one are about this curve.
    void curve(int next) {
        begin("curve");
        run(method);
        if (next < 0 || std::size_t(next) >= curves_.size()) return complain("the surface has no curve " + json(next));
        const bool returns = next == curve_;  // a program may call it before each part of the curve
        curve_ = next;
        if (returns) return tell(Detail::windows, "curve", "FH2", "curve", next);
        has_left_edge_ = has_looked_ = has_drawn_ = has_met_ = false;
        was_ = is_ = 0;
        tell(Detail::windows, "curve", "FH2", "curve", next);
    }

    /// Result of SideEdge: the edge on that side has come to this end of the curve.
    void side_edge(Whole column, double y) {
        if (!are_whole("side_edge", {column}) || !has_curve("side_edge")) return;
        const int x = column.value;
        const bool is_left = x == left_end();
        const char* const at = is_left ? "FH3" : "FH10";
        if (!end(side_edge_of_curve, at)) return;
        has_left_edge_ = has_left_edge_ || is_left;
        tell(Detail::polygons, "side_edge", at, "sample", list(x, y));
    }

    // Visibility

    /// The curve's height over a column where there are no horizons.
    void height(Whole x, double y) {
        if (looks("height", x)) tell(Detail::signs, "height", "V1", "x", x.value, "y", y);
    }
    /// The height of the curve, and those of the horizons.
    void height(Whole x, double y, double upper, double lower) {
        if (looks("height", x))
            tell(Detail::signs, "height", "V1", "x", x.value, "y", y, "upper", upper, "lower", lower);
    }
    /// Result of Visibility: 1 above the upper horizon or on it, -1 below the lower one or on it, 0 hidden, 2 both of
    /// the first two.
    void visibility(Whole column, int flag) {
        const int x = column.value;
        if (!is_on_column("visibility", column)) return;
        if (flag < -1 || flag > 2) return complain("a flag is -1, 0, 1 or 2");
        if (!end(visibility_of_point, looked_at())) return;
        was_ = is_;
        is_ = flag;
        has_met_ = false;
        tell(Detail::polygons, "visibility", looked_at(), "segment", segment_of(x, x), "x", x, "flag", flag);
        has_looked_ = true;
    }

    // Intersection, and the lines

    /// Is the curve over this column on the other side of the horizon than over the first one?
    void step(Whole x, bool changes) {
        if (!is_on_column("step", x) || !run(intersection_of_segment, met_at())) return;
        tell(Detail::signs, "step", "IN2", "x", x.value, "changes", changes);
    }
    /// Result of Intersection.
    void intersection(double x, double y) {
        if (!is_on_curve("intersection", x, x) || !end(intersection_of_segment, met_at())) return;
        tell(Detail::polygons, "intersection", met_at(), "segment", segment_of(x, x), "point", list(x, y), "columns",
             columns_of(x));
        line_at_ = met_at();
        has_met_ = true;
    }
    /// A part of the curve is visible, from left to right, within two neighbouring samples.
    void draw_line(double from_x, double from_y, double to_x, double to_y) {
        if (!is_on_curve("draw_line", from_x, to_x) || !run(method)) return;
        const bool is_whole = from_x == std::floor(from_x) && to_x == std::floor(to_x);
        if (line_at_.empty()) line_at_ = is_whole ? "FH6" : to_x == std::floor(to_x) ? "FH8" : "FH7";
        const Json segment = segment_of(from_x, to_x);
        tell(Detail::windows, "draw_line", line_at_.c_str(), "segment", segment, "from", list(from_x, from_y),
             "fromColumns", columns_of(from_x), "to", list(to_x, to_y), "toColumns", columns_of(to_x));
        add_line({curve_, segment.text, {from_x, from_y}, {to_x, to_y}});
        drawn_at_ = line_at_;
        line_at_.clear();
        has_drawn_ = true;
    }

    // Horizon, after `draw_line` or before an edge

    /// The upper horizon over the column becomes y.
    void raise(Whole x, double y) { move("raise", "H2", upper_, x, y); }
    /// The lower horizon over the column becomes y.
    void lower(Whole x, double y) { move("lower", "H3", lower_, x, y); }
    /// Result of Horizon: the columns first <= x <= last were examined.
    void horizon(Whole first, Whole last) {
        if (!are_whole("horizon", {first, last})) return;
        begin("horizon");
        if (!moves() || !end(horizon_of_segment, horizon_at())) return;
        tell(Detail::polygons, "horizon", horizon_at(), "first", first.value, "last", last.value, "upper", upper_,
             "lower", lower_);
        upper_.clear();
        lower_.clear();
        has_drawn_ = false;
    }

private:
    struct Line {
        int curve;
        std::string segment;
        ScreenPoint from, to;

        bool is_point() const { return from.x == to.x && is_whole(from.x); }
    };

    static bool is_whole(double x) { return x == std::floor(x); }
    static Json columns_of(double x) { return list(int(std::floor(x)), int(std::ceil(x))); }

    /// Two lines of one curve that meet on a column become one: as the page joins them.
    void add_line(const Line& line) {
        const bool goes_on = !lines_.empty() && lines_.back().curve == line.curve && is_whole(line.from.x) &&
                             lines_.back().to.x == line.from.x;
        if (goes_on && lines_.back().is_point()) {
            lines_.back() = line;
        } else if (goes_on && lines_.back().segment == line.segment) {
            lines_.back().to = line.to;
        } else if (!goes_on || !line.is_point()) {
            lines_.push_back(line);
        }
    }

    bool has_curve(const char* call) {
        begin(call);
        if (curve_ < 0) complain("`curve` comes before");
        return curve_ >= 0;
    }
    const std::vector<Sample>& samples() const { return curves_[std::size_t(curve_)]; }

    static bool are_joined(const Sample& a, const Sample& b) { return std::isfinite(a.y) && std::isfinite(b.y); }
    int left_end() const {
        std::size_t i = 1;
        while (i + 1 < samples().size() && !are_joined(samples()[i - 1], samples()[i])) ++i;
        return samples()[i - 1].x;
    }

    /// The columns of the samples that these places lie between; empty if there are none.
    Json segment_of(double from, double to) const {
        for (std::size_t i = 1; i < samples().size(); ++i) {
            const Sample &a = samples()[i - 1], &b = samples()[i];
            if (are_joined(a, b) && a.x <= from && to <= b.x) return list(a.x, b.x);
        }
        return {""};
    }
    bool is_on_curve(const char* call, double from, double to) {
        if (!has_curve(call)) return false;
        const bool is = from <= to && !segment_of(from, to).text.empty();
        if (!is) complain("not between two neighbouring samples of the curve, from left to right");
        return is;
    }

    bool is_on_column(const char* call, Whole x) { return are_whole(call, {x}) && is_on_curve(call, x.value, x.value); }
    bool looks(const char* call, Whole x) { return is_on_column(call, x) && run(visibility_of_point, looked_at()); }
    const char* looked_at() const { return has_looked_ ? "FH5" : "FH4"; }
    /// A line that was visible ends at the first intersection; at the next one the curve becomes visible.
    const char* met_at() const { return was_ != 0 && !has_met_ ? "FH7" : "FH8"; }

    /// A horizon that moves without a line before it belongs to a side edge.
    bool moves() {
        if (curve_ < 0) complain("`curve` comes before");
        if (curve_ < 0) return false;
        if (!has_drawn_ && !runs(horizon_of_segment)) run(side_edge_of_curve, has_left_edge_ ? "FH10" : "FH3");
        return run(horizon_of_segment, horizon_at());
    }
    const char* horizon_at() const { return has_drawn_ ? drawn_at_.c_str() : "SE2"; }
    void move(const char* call, const char* at, std::vector<Json>& moved, Whole column, double y) {
        if (!are_whole(call, {column})) return;
        begin(call);
        const int x = column.value;
        if (x < area().x || x >= area().x + area().width) return complain("a column outside the area");
        if (!moves()) return;
        moved.push_back(list(x, y));
        tell(Detail::signs, call, at, "x", x, "y", y);
    }

    std::vector<std::vector<Sample>> curves_;
    std::vector<Line> lines_;
    int curve_ = -1;
    bool has_left_edge_ = false, has_looked_ = false;
    bool has_drawn_ = false, has_met_ = false;  // since the last `horizon`; since the last `visibility`
    int was_ = 0, is_ = 0;                      // the last two flags
    std::string line_at_, drawn_at_;            // the labels of the next line and of the last one
    std::vector<Json> upper_, lower_;           // moved since the last `horizon`
};

}  // namespace student
}  // namespace vidno

#endif
