#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

namespace {

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

    /// The fewest bytes that a number takes: a digit and a blank, or its binary size.
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
    TextWords words_;
};

const PlyType& ply_type(const TextWords& words, std::string_view name) {
    for (const PlyType& type : ply_types) {
        if (name == type.name || name == type.other_name) return type;
    }
    words.refuse("unknown type of a property");
}

PlyProperty ply_property(TextWords& words) {
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

PlyFormat ply_format(const TextWords& words, std::string_view name) {
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::little_endian;
    if (name == "binary_big_endian") return PlyFormat::big_endian;
    words.refuse("unknown PLY format");
}

/// Leaves the words at the first byte after the header.
PlyHeader ply_header(TextWords& words) {
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

/// The index of an element's property; refused if it is missing or has the wrong type.
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

/// Reads one item: the numbers of each property, which has one unless it is a list.
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

class PlyReader {
public:
    explicit PlyReader(std::string_view bytes) : words_(bytes), header_(ply_header(words_)) {
        PlyBody body(header_.format, words_.rest());
        for (const PlyElement& element : header_.elements) read(body, element);
        if (soup_.points.empty()) throw Refused("no vertices");
        if (greatest_index_ >= double(soup_.points.size())) throw Refused("a face has a vertex that does not exist");
    }

    MeshSoup soup() { return std::move(soup_); }

private:
    void read(PlyBody& body, const PlyElement& element) {
        std::size_t least_size = 0;
        for (const PlyProperty& property : element.properties) {
            least_size += body.least_size(property.size_type != nullptr ? *property.size_type : *property.type);
        }
        if (least_size == 0 && element.count > 0) throw Refused("element " + element.name + " has no properties");
        if (element.count > 0)
            check_count(element.count, "items of element " + element.name, least_size, body.bytes_left());
        if (element.name == "vertex" || element.name == "vertices") {
            read_points(body, element);
        } else if (element.name == "face" || element.name == "faces") {
            read_faces(body, element);
        } else {
            for (std::uint64_t i = 0; i < element.count; ++i) ply_item(body, element, item_);
        }
    }

    void read_points(PlyBody& body, const PlyElement& element) {
        if (!soup_.points.empty()) throw Refused("the vertices occur twice");
        const std::array<std::size_t, 3> places{ply_find(element, "x", "x", false), ply_find(element, "y", "y", false),
                                                ply_find(element, "z", "z", false)};
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, item_);
            glm::dvec3 point;
            for (int axis = 0; axis < 3; ++axis) {
                point[axis] = item_[places[std::size_t(axis)]].front();
                if (!std::isfinite(point[axis])) {
                    throw Refused("vertex " + std::to_string(i) + ": a coordinate that is not finite");
                }
            }
            soup_.points.push_back(point);
        }
    }

    void read_faces(PlyBody& body, const PlyElement& element) {
        check_face_count(soup_.faces.size() + element.count);
        const std::size_t place = ply_find(element, "vertex_indices", "vertex_index", true);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, item_);
            auto& face = soup_.faces.emplace_back();
            for (const double index : item_[place]) {
                if (!(index >= 0 && index <= std::numeric_limits<std::int32_t>::max())) {
                    throw Refused("a face has a vertex that does not exist");
                }
                greatest_index_ = std::max(greatest_index_, index);
                face.push_back(std::size_t(index));
            }
        }
    }

    TextWords words_;
    PlyHeader header_;
    MeshSoup soup_;
    double greatest_index_ = -1;
    std::vector<std::vector<double>> item_;
};

}  // namespace

MeshSoup read_ply(std::string_view bytes) { return PlyReader(bytes).soup(); }

}  // namespace vidno
