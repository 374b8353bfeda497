#include "mesh_soup.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>

#include "json_text.h"
#include "refused.h"
#include "vidno/scene.h"

namespace vidno {
namespace {

std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = char(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

void check_face_count(std::uint64_t count) {
    if (count > most_polygons) throw Refused("more than " + std::to_string(most_polygons) + " faces");
}

/// A promise in a header against what is there.
void check_count(std::uint64_t count, std::string_view what, std::uint64_t least_size, std::size_t bytes_left) {
    if (count <= bytes_left / least_size) return;
    throw Refused("the header says " + std::to_string(count) + " " + std::string(what) +
                  ", more than the file can hold");
}

// ------------------------------------------------------------------------------------------------ text

/// The words of a text, line by line.
class Words {
public:
    explicit Words(std::string_view text) : rest_(text) {}

    /// Goes to the next line; false at the end of the text. Comments start with the mark, if there is one.
    bool next_line(char comment_mark = '\0') {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++line_number_;
        if (comment_mark != '\0') line_ = line_.substr(0, line_.find(comment_mark));
        return true;
    }

    /// Goes to the next line that has a word.
    bool next_line_with_words(char comment_mark) {
        while (next_line(comment_mark)) {
            if (line_.find_first_not_of(blanks) != std::string_view::npos) return true;
        }
        return false;
    }

    /// The next word of the line; empty at its end.
    std::string_view word() {
        line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size()));
        const std::string_view found = line_.substr(0, line_.find_first_of(blanks));
        line_.remove_prefix(found.size());
        return found;
    }

    /// The next word of the text.
    std::string_view word_of_text() {
        std::string_view found = word();
        while (found.empty() && next_line()) found = word();
        return found;
    }

    void skip_line() { line_ = {}; }
    std::size_t bytes_left() const { return line_.size() + rest_.size(); }
    std::string_view rest() const { return rest_; }

    [[noreturn]] void refuse(std::string_view reason) const {
        throw Refused("line " + std::to_string(line_number_) + ": " + std::string(reason));
    }

    /// A word as a number; what is not finite is refused.
    double number(std::string_view word) const {
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc::result_out_of_range) refuse("a number beyond the range of doubles");
        if (error != std::errc() || end != word.data() + word.size()) refuse("not a number");
        if (!std::isfinite(value)) refuse("a coordinate that is not finite");
        return value;
    }

    std::int64_t whole_number(std::string_view word) const {
        if (word.starts_with('+')) word.remove_prefix(1);
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) refuse("not a whole number");
        return value;
    }

    std::uint64_t count(std::string_view word) const {
        const std::int64_t value = whole_number(word);
        if (value < 0) refuse("a negative count");
        return std::uint64_t(value);
    }

private:
    static constexpr std::string_view blanks = " \t\r\v\f";
    std::string_view rest_, line_;
    std::size_t line_number_ = 0;
};

void copy_coordinates(Text& out, Words& words) {
    for (int axis = 0; axis < 3; ++axis) {
        out += ' ';
        append_number(out, words.number(words.word()));
    }
    out += '\n';
}

// ------------------------------------------------------------------------------------------------ OBJ

/// The lines v and f, faces with the points' positions only and counted from 1. All else is passed over.
std::string plain_obj(std::string_view bytes) {
    std::string unfolded(bytes);  // a backslash at its end continues a line
    for (const std::string_view fold : {"\\\n", "\\\r\n"}) {
        for (std::size_t at = unfolded.find(fold); at != std::string::npos; at = unfolded.find(fold, at)) {
            std::fill_n(unfolded.begin() + std::ptrdiff_t(at), fold.size(), ' ');
        }
    }
    Text out;
    std::int64_t points = 0, greatest_index = 0;
    std::uint64_t faces = 0;
    Words words(unfolded);
    while (words.next_line_with_words('#')) {
        const std::string_view keyword = words.word();
        if (keyword == "v") {
            out += 'v';
            copy_coordinates(out, words);
            ++points;
        } else if (keyword == "f") {
            check_face_count(++faces);
            out += 'f';
            for (std::string_view corner = words.word(); !corner.empty(); corner = words.word()) {
                std::int64_t index = words.whole_number(corner.substr(0, corner.find('/')));
                if (index < 0) index = index < -points ? 0 : points + index + 1;  // counted back from the latest
                if (index == 0) words.refuse("a face of a vertex that is not there");
                greatest_index = std::max(greatest_index, index);
                out += ' ';
                append_integer(out, index);
            }
            out += '\n';
        }
    }
    if (greatest_index > points) {
        throw Refused("a face of vertex " + std::to_string(greatest_index) + ", of " + std::to_string(points));
    }
    return out.string();
}

// ------------------------------------------------------------------------------------------------ OFF

/// OFF with colours, normals and texture coordinates left out.
std::string plain_off(std::string_view bytes) {
    Words words(bytes);
    if (!words.next_line_with_words('#')) throw Refused("empty");
    std::string_view keyword = words.word();
    for (const std::string_view prefix : {"ST", "C", "N"}) {
        if (keyword.starts_with(prefix)) keyword.remove_prefix(prefix.size());
    }
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF") words.refuse("not of three dimensions");
    if (keyword != "OFF") words.refuse("does not start with OFF");
    std::string_view first = words.word();
    if (first == "BINARY") words.refuse("binary OFF is not read");
    if (first.empty() && words.next_line_with_words('#')) first = words.word();
    const std::uint64_t points = words.count(first);
    const std::uint64_t faces = words.count(words.word());
    check_count(points, "vertices", 6, words.bytes_left() + 1);  // "0 0 0" and a line end, which the last may lack
    check_count(faces, "faces", 2, words.bytes_left() + 1);
    check_face_count(faces);

    Text out;
    out += "OFF\n" + std::to_string(points) + " " + std::to_string(faces) + " 0\n";
    for (std::uint64_t i = 0; i < points; ++i) {
        if (!words.next_line_with_words('#')) words.refuse("the file ends before its last vertex");
        copy_coordinates(out, words);
    }
    for (std::uint64_t i = 0; i < faces; ++i) {
        if (!words.next_line_with_words('#')) words.refuse("the file ends before its last face");
        const std::uint64_t corners = words.count(words.word());
        check_count(corners, "corners of a face", 2, words.bytes_left() + 1);
        append_integer(out, corners);
        for (std::uint64_t corner = 0; corner < corners; ++corner) {
            const std::uint64_t index = words.count(words.word());
            if (index >= points) words.refuse("a face of a vertex that is not there");
            out += ' ';
            append_integer(out, index);
        }
        out += '\n';
    }
    return out.string();
}

// ------------------------------------------------------------------------------------------------ PLY

struct PlyType {
    std::string_view name, other_name;
    std::size_t size;
    enum { natural, integer, real } kind;
};

constexpr std::array<PlyType, 8> ply_types{{{"char", "int8", 1, PlyType::integer},
                                            {"uchar", "uint8", 1, PlyType::natural},
                                            {"short", "int16", 2, PlyType::integer},
                                            {"ushort", "uint16", 2, PlyType::natural},
                                            {"int", "int32", 4, PlyType::integer},
                                            {"uint", "uint32", 4, PlyType::natural},
                                            {"float", "float32", 4, PlyType::real},
                                            {"double", "float64", 8, PlyType::real}}};

struct PlyProperty {
    std::string name;
    const PlyType* type;
    const PlyType* size_type = nullptr;  // of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, little_endian, big_endian };

/// The part of a PLY file after its header, number by number. Every number fits a double.
class PlyBody {
public:
    PlyBody(PlyFormat format, std::string_view bytes) : format_(format), bytes_(bytes), words_(bytes) {}

    std::size_t bytes_left() const { return format_ == PlyFormat::ascii ? words_.bytes_left() + 1 : bytes_.size(); }

    /// What a number takes at least: a digit and a blank, or its bytes.
    std::size_t least_size(const PlyType& type) const { return format_ == PlyFormat::ascii ? 2 : type.size; }

    double number(const PlyType& type) {
        if (format_ != PlyFormat::ascii) return binary(type);
        const std::string_view word = words_.word_of_text();
        if (word.empty()) throw Refused("the file ends before its last element");
        const double value = words_.number(word);
        if (type.kind != PlyType::real && value != std::floor(value)) words_.refuse("not a whole number");
        return value;
    }

private:
    double binary(const PlyType& type) {
        if (bytes_.size() < type.size) throw Refused("the file ends before its last element");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.size; ++i) {
            const std::size_t at = format_ == PlyFormat::little_endian ? type.size - 1 - i : i;
            bits = bits << 8 | static_cast<unsigned char>(bytes_[at]);
        }
        bytes_.remove_prefix(type.size);
        if (type.kind == PlyType::natural) return double(bits);
        if (type.kind == PlyType::real) {
            return type.size == 4 ? double(std::bit_cast<float>(std::uint32_t(bits))) : std::bit_cast<double>(bits);
        }
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
        return double(std::int64_t(bits ^ sign) - std::int64_t(sign));
    }

    PlyFormat format_;
    std::string_view bytes_;
    Words words_;
};

const PlyType& ply_type(const Words& words, std::string_view name) {
    for (const PlyType& type : ply_types) {
        if (name == type.name || name == type.other_name) return type;
    }
    words.refuse("unknown type of a property");
}

PlyProperty ply_property(Words& words) {
    const std::string_view first = words.word();
    if (first != "list") {
        const PlyType& type = ply_type(words, first);
        return {std::string(words.word()), &type};
    }
    const PlyType& size_type = ply_type(words, words.word());
    if (size_type.kind == PlyType::real) words.refuse("a list whose length is not a whole number");
    const PlyType& type = ply_type(words, words.word());
    return {std::string(words.word()), &type, &size_type};
}

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
};

PlyFormat ply_format(const Words& words, std::string_view name) {
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::little_endian;
    if (name == "binary_big_endian") return PlyFormat::big_endian;
    words.refuse("unknown PLY format");
}

/// Leaves the words at the first byte after the header.
PlyHeader ply_header(Words& words) {
    PlyHeader header;
    if (!words.next_line() || words.word() != "ply") throw Refused("does not start with ply");
    bool has_format = false;
    while (words.next_line()) {
        const std::string_view keyword = words.word();
        if (keyword == "end_header") {
            if (!has_format) words.refuse("no format");
            return header;
        }
        if (keyword == "format") {
            header.format = ply_format(words, words.word());
            has_format = true;
        } else if (keyword == "element") {
            const std::string name(words.word());
            header.elements.push_back({name, words.count(words.word()), {}});
        } else if (keyword == "property") {
            if (header.elements.empty()) words.refuse("a property before the first element");
            header.elements.back().properties.push_back(ply_property(words));
        } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
            words.refuse("unknown keyword");
        }
    }
    throw Refused("the file ends in its header");
}

/// Where the element has a property; refused if it has none, or one of the wrong kind.
std::size_t ply_find(const PlyElement& element, std::string_view name, std::string_view other_name, bool list) {
    const auto& properties = element.properties;
    const auto found = std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& property) {
        return property.name == name || property.name == other_name;
    });
    const bool fits = found != properties.end() && (found->size_type != nullptr) == list;
    if (!fits || (list && found->type->kind == PlyType::real)) {
        throw Refused("element " + element.name + " has no " + (list ? "list " : "number ") + std::string(name));
    }
    return std::size_t(found - properties.begin());
}

/// Reads one item: the numbers of each property, one unless it is a list.
void ply_item(PlyBody& body, const PlyElement& element, std::vector<std::vector<double>>& item) {
    item.resize(element.properties.size());
    for (std::size_t i = 0; i < item.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        item[i].clear();
        double length = 1;
        if (property.size_type != nullptr) {
            length = body.number(*property.size_type);
            const auto most = body.bytes_left() / body.least_size(*property.type);
            if (!(length >= 0 && length <= double(most))) {
                throw Refused("a list that is longer than the file, or of negative length");
            }
        }
        for (double n = 0; n < length; ++n) item[i].push_back(body.number(*property.type));
    }
}

template <class Value>
void append_bytes(std::string& out, Value value) {
    out.append(std::bit_cast<std::array<char, sizeof value>>(value).data(), sizeof value);
}

/// Binary PLY with positions as doubles and faces as lists of 32-bit indices, and nothing else.
class PlainPly {
public:
    explicit PlainPly(std::string_view bytes) : words_(bytes), header_(ply_header(words_)) {
        PlyBody body(header_.format, words_.rest());
        for (const PlyElement& element : header_.elements) copy(body, element);
        if (points_ == 0) throw Refused("no vertices");
        if (greatest_index_ >= double(points_)) throw Refused("a face of a vertex that is not there");
    }

    std::string bytes() const {
        return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points_) +
               "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(faces_) +
               "\nproperty list uint uint vertex_indices\nend_header\n" + point_bytes_ + face_bytes_;
    }

private:
    void copy(PlyBody& body, const PlyElement& element) {
        std::size_t least_size = 0;
        for (const PlyProperty& property : element.properties) {
            least_size += body.least_size(property.size_type != nullptr ? *property.size_type : *property.type);
        }
        if (least_size == 0 && element.count > 0) throw Refused("element " + element.name + " has no properties");
        if (element.count > 0)
            check_count(element.count, "items of element " + element.name, least_size, body.bytes_left());
        if (element.name == "vertex" || element.name == "vertices") {
            copy_points(body, element);
        } else if (element.name == "face" || element.name == "faces") {
            copy_faces(body, element);
        } else {
            for (std::uint64_t i = 0; i < element.count; ++i) ply_item(body, element, item_);
        }
    }

    void copy_points(PlyBody& body, const PlyElement& element) {
        if (points_ > 0) throw Refused("the vertices are there twice");
        const std::array<std::size_t, 3> places{ply_find(element, "x", "x", false), ply_find(element, "y", "y", false),
                                                ply_find(element, "z", "z", false)};
        points_ = element.count;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, item_);
            for (const std::size_t place : places) {
                const double coordinate = item_[place].front();
                if (!std::isfinite(coordinate)) {
                    throw Refused("vertex " + std::to_string(i) + ": a coordinate that is not finite");
                }
                append_bytes(point_bytes_, coordinate);
            }
        }
    }

    void copy_faces(PlyBody& body, const PlyElement& element) {
        faces_ += element.count;
        check_face_count(faces_);
        const std::size_t place = ply_find(element, "vertex_indices", "vertex_index", true);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, item_);
            append_bytes(face_bytes_, std::uint32_t(item_[place].size()));
            for (const double index : item_[place]) {
                if (!(index >= 0 && index <= std::numeric_limits<std::int32_t>::max())) {
                    throw Refused("a face of a vertex that is not there");
                }
                greatest_index_ = std::max(greatest_index_, index);
                append_bytes(face_bytes_, std::uint32_t(index));
            }
        }
    }

    Words words_;
    PlyHeader header_;
    std::string point_bytes_, face_bytes_;
    std::uint64_t points_ = 0, faces_ = 0;
    double greatest_index_ = -1;
    std::vector<std::vector<double>> item_;
};

// ------------------------------------------------------------------------------------------------ STL

constexpr std::size_t stl_header_size = 80, stl_triangle_size = 50;

/// The number of triangles that a binary STL file promises; none if the file is too short to say.
std::optional<std::uint32_t> stl_count(std::string_view bytes) {
    if (bytes.size() < stl_header_size + 4) return std::nullopt;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + stl_header_size, sizeof count);
    return count;
}

/// The header cleared: it may begin with "solid", which is how text begins.
std::string plain_binary_stl(std::string_view bytes) {
    const std::optional<std::uint32_t> count = stl_count(bytes);
    if (!count) throw Refused("neither text that begins with solid nor long enough for a binary header");
    check_face_count(*count);
    check_count(*count, "triangles", stl_triangle_size, bytes.size() - stl_header_size - 4);
    const std::string_view body = bytes.substr(stl_header_size, 4 + stl_triangle_size * *count);
    for (std::uint32_t i = 0; i < *count; ++i) {
        std::array<float, 9> corners;
        std::memcpy(corners.data(), body.data() + 4 + i * stl_triangle_size + 12, sizeof corners);
        if (!std::all_of(corners.begin(), corners.end(), [](float coordinate) { return std::isfinite(coordinate); })) {
            throw Refused("triangle " + std::to_string(i) + ": a coordinate that is not finite");
        }
    }
    return std::string(stl_header_size, '\0') + std::string(body);
}

/// The corners of the triangles, without the solids' names, which may be anything.
std::string plain_text_stl(std::string_view bytes) {
    Text out;
    out += "solid\n";
    Words words(bytes);
    const auto expect = [&](std::string_view wanted) {
        if (lower_case(words.word_of_text()) != wanted) words.refuse("\"" + std::string(wanted) + "\" is missing");
    };
    bool in_solid = false;
    std::uint64_t faces = 0;
    for (std::string word = lower_case(words.word_of_text()); !word.empty(); word = lower_case(words.word_of_text())) {
        if (word == (in_solid ? "endsolid" : "solid")) {
            in_solid = !in_solid;
            words.skip_line();
            continue;
        }
        if (!in_solid || word != "facet") words.refuse(in_solid ? "\"facet\" is missing" : "\"solid\" is missing");
        check_face_count(++faces);
        expect("normal");
        for (int axis = 0; axis < 3; ++axis) words.word_of_text();  // may be anything, even nan
        expect("outer");
        expect("loop");
        out += "facet\n";
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            out += "vertex";
            copy_coordinates(out, words);
        }
        expect("endloop");
        expect("endfacet");
        out += "endfacet\n";
    }
    if (in_solid) words.refuse("the file ends before endsolid");
    out += "endsolid\n";
    return out.string();
}

std::string plain_stl(std::string_view bytes) {
    const std::optional<std::uint32_t> count = stl_count(bytes);
    const bool exactly_binary = count && bytes.size() == stl_header_size + 4 + stl_triangle_size * std::size_t{*count};
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const bool text = !exactly_binary && lower_case(bytes.substr(start, 5)) == "solid";
    return text ? plain_text_stl(bytes) : plain_binary_stl(bytes);
}

// ------------------------------------------------------------------------------------------------ CGAL

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Points = std::vector<Point>;
using Faces = std::vector<std::vector<std::size_t>>;

bool read_by_format(const std::string& format, std::string_view bytes, Points& points, Faces& faces) {
    const auto quiet = CGAL::parameters::verbose(false);
    if (format == "obj") {
        std::istringstream stream(plain_obj(bytes));
        return CGAL::IO::read_OBJ(stream, points, faces, quiet);
    }
    if (format == "off") {
        std::istringstream stream(plain_off(bytes));
        return CGAL::IO::read_OFF(stream, points, faces, quiet);
    }
    if (format == "ply") {
        std::istringstream stream(PlainPly(bytes).bytes());
        return CGAL::IO::read_PLY(stream, points, faces, quiet);
    }
    if (format == "stl") {
        std::istringstream stream(plain_stl(bytes));
        return CGAL::IO::read_STL(stream, points, faces, quiet);
    }
    throw Refused("not a mesh by its name: .obj, .off, .ply or .stl");
}

}  // namespace

MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file) {
    try {
        Points points;
        MeshSoup soup;
        const std::size_t dot = file.rfind('.');
        const std::string format = dot == std::string::npos ? "" : lower_case(file.substr(dot + 1));
        const bool read = read_by_format(format, bytes, points, soup.faces);
        if (points.empty() || soup.faces.empty()) throw Refused("no faces");
        if (!read) throw Refused("cannot be read");
        soup.points.reserve(points.size());
        for (const Point& point : points) soup.points.push_back({point.x(), point.y(), point.z()});
        for (const auto& face : soup.faces) {
            for (const std::size_t index : face) {
                if (index >= soup.points.size()) throw Refused("a face of a vertex that is not there");
            }
        }
        return soup;
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    } catch (const std::exception&) {
        throw Refused(file + ": cannot be read");
    }
}

}  // namespace vidno
