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

void add_triangle(MeshSoup& soup, const std::array<glm::dvec3, 3>& corners) {
    const std::size_t first = soup.points.size();
    soup.points.insert(soup.points.end(), corners.begin(), corners.end());
    soup.faces.push_back({first, first + 1, first + 2});
}

MeshSoup read_binary_stl(std::string_view bytes) {
    const std::optional<std::uint32_t> count = stl_count(bytes);
    if (!count) throw Refused("neither text that begins with solid nor long enough for a binary header");
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
                throw Refused("triangle " + std::to_string(i) + ": a coordinate that is not finite");
            }
            corners[n / 3][int(n % 3)] = double(numbers[n]);
        }
        add_triangle(soup, corners);
    }
    return soup;
}

/// The solids' names may be anything.
MeshSoup read_text_stl(std::string_view bytes) {
    MeshSoup soup;
    TextWords words(bytes);
    const auto expect = [&](std::string_view wanted) {
        if (lower_case(words.word_of_text()) != wanted) words.refuse("\"" + std::string(wanted) + "\" is missing");
    };
    bool in_solid = false;
    for (std::string word = lower_case(words.word_of_text()); !word.empty(); word = lower_case(words.word_of_text())) {
        if (word == (in_solid ? "endsolid" : "solid")) {
            in_solid = !in_solid;
            words.skip_line();
            continue;
        }
        if (!in_solid || word != "facet") words.refuse(in_solid ? "\"facet\" is missing" : "\"solid\" is missing");
        check_face_count(soup.faces.size() + 1);
        expect("normal");
        for (int axis = 0; axis < 3; ++axis) words.word_of_text();  // may be anything, even nan
        expect("outer");
        expect("loop");
        std::array<glm::dvec3, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            expect("vertex");
            corners[corner] = words.coordinates();
        }
        expect("endloop");
        expect("endfacet");
        add_triangle(soup, corners);
    }
    if (in_solid) words.refuse("the file ends before endsolid");
    return soup;
}

}  // namespace

/// A binary file may begin with "solid", like a text file.
MeshSoup read_stl(std::string_view bytes) {
    const std::optional<std::uint32_t> count = stl_count(bytes);
    const bool exactly_binary = count && bytes.size() == stl_header_size + 4 + stl_triangle_size * std::size_t{*count};
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const bool text = !exactly_binary && lower_case(bytes.substr(start, 5)) == "solid";
    return text ? read_text_stl(bytes) : read_binary_stl(bytes);
}

}  // namespace vidno
