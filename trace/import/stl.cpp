#include <array>
#include <cstring>
#include <optional>

#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

namespace {

constexpr std::size_t stl_header_size = 80, stl_triangle_size = 50;

/// The number of triangles that a binary STL file promises; none if the file is too short.
std::optional<std::uint32_t> stl_count(std::string_view bytes) {
    if (bytes.size() < stl_header_size + 4) return std::nullopt;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + stl_header_size, sizeof count);
    return count;
}

/// `line` is 0 in a binary file.
void add_triangle(MeshSoup& soup, const std::array<glm::dvec3, 3>& corners, std::size_t line = 0) {
    const std::size_t first = soup.points.size();
    soup.points.insert(soup.points.end(), corners.begin(), corners.end());
    soup.faces.push_back({{first, first + 1, first + 2}, line});
}

MeshSoup read_binary_stl(std::string_view bytes) {
    const std::optional<std::uint32_t> count = stl_count(bytes);
    if (!count) throw Refused("neither text that begins with solid nor long enough for a binary header");
    if (*count == 0) throw Refused("contains no faces: the header says 0 triangles");
    check_face_count(*count);
    check_count(*count, "triangles", stl_triangle_size, bytes.size() - stl_header_size - 4);
    MeshSoup soup;
    const char* triangle = bytes.data() + stl_header_size + 4;
    for (std::uint32_t i = 0; i < *count; ++i, triangle += stl_triangle_size) {
        std::array<float, 9> numbers;
        std::memcpy(numbers.data(), triangle + 12, sizeof numbers);  // after the normal
        std::array<glm::dvec3, 3> corners;
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            if (!std::isfinite(numbers[n])) {
                throw Refused("face " + std::to_string(i) + ": a coordinate that is not finite");
            }
            corners[n / 3][int(n % 3)] = double(numbers[n]);
        }
        if (triangle[48] != 0 || triangle[49] != 0) {
            soup.left_out.add("attributes of triangles, which may be colours", "face " + std::to_string(i));
        }
        add_triangle(soup, corners);
    }
    return soup;
}

/// The solids' names may be anything.
class TextStlReader {
public:
    explicit TextStlReader(std::string_view bytes) : words_(bytes) {
        bool in_solid = false;
        for (std::string found = word(); !found.empty(); found = word()) {
            if (found == (in_solid ? "endsolid" : "solid")) {
                in_solid = !in_solid;
                words_.skip_line();
            } else if (in_solid && found == "facet") {
                read_facet();
            } else {
                words_.refuse(in_solid ? "\"facet\" is missing" : "\"solid\" is missing");
            }
        }
        if (in_solid) words_.refuse("the file ends before endsolid");
        if (soup_.faces.empty()) words_.refuse("contains no faces, for no solid has a facet");
    }

    MeshSoup soup() { return std::move(soup_); }

private:
    /// The next word in small letters; "end solid" is one, like "endsolid".
    std::string word() {
        const std::string found = lower_case(words_.word_of_text());
        return found == "end" ? found + lower_case(words_.word_of_text()) : found;
    }

    void expect(std::string_view wanted) {
        if (word() != wanted) words_.refuse("\"" + std::string(wanted) + "\" is missing");
    }

    void read_facet() {
        check_face_count(soup_.faces.size() + 1);
        const std::size_t line = words_.line();
        expect("normal");
        for (int axis = 0; axis < 3; ++axis) words_.any_number(words_.word_of_text());
        expect("outer");
        expect("loop");
        std::array<glm::dvec3, 3> corners;
        for (glm::dvec3& corner : corners) {
            expect("vertex");
            for (int axis = 0; axis < 3; ++axis) corner[axis] = words_.number(words_.word_of_text());
        }
        expect("endloop");
        expect("endfacet");
        add_triangle(soup_, corners, line);
    }

    TextWords words_;
    MeshSoup soup_;
};

}  // namespace

/// A binary file may begin with "solid", like a text file. The last byte of its count of triangles is then 0, which no
/// text contains: a greater count exceeds most_polygons.
MeshSoup read_stl(std::string_view bytes, const Beside&) {
    constexpr std::size_t end_of_count = stl_header_size + 3;
    const bool has_count = bytes.size() > end_of_count && bytes[end_of_count] == 0;
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const bool is_text = !has_count && lower_case(bytes.substr(start, 5)) == "solid";
    return is_text ? TextStlReader(bytes).soup() : read_binary_stl(bytes);
}

}  // namespace vidno
