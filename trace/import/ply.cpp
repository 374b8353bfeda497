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

/// How the numbers of an ASCII file are laid out: anywhere, or with an item in each line, as nearly all programs write
/// them.
enum class PlyLayout { free, item_in_line };

/// The part of a PLY file after its header, number by number. Every number fits a double.
class PlyBody {
public:
    /// The words are those of an ASCII file, after its header.
    PlyBody(PlyFormat format, std::string_view bytes, TextWords words, PlyLayout layout)
        : format_(format), layout_(layout), bytes_(bytes), words_(std::move(words)) {}

    std::size_t bytes_left() const { return is_text() ? words_.bytes_left() + 1 : bytes_.size(); }

    /// The fewest bytes that a number takes: a digit and a blank, or its binary size.
    std::size_t least_size(const PlyType& type) const { return is_text() ? 2 : type.size; }

    void begin_item(const PlyElement& element, std::uint64_t number) {
        element_ = &element;
        number_ = number;
        if (layout_ == PlyLayout::item_in_line && !words_.next_line_with_words()) refuse_end();
    }

    void end_item() {
        if (layout_ == PlyLayout::item_in_line && words_.has_word()) words_.refuse("more numbers than properties");
    }

    double number(const PlyType& type) {
        if (!is_text()) return binary(type);
        const std::string_view word = layout_ == PlyLayout::free ? words_.word_of_text() : words_.word();
        if (word.empty() && layout_ == PlyLayout::free) refuse_end();
        const double value = words_.any_number(word);
        if (type.kind != PlyType::real && value != std::floor(value)) words_.refuse("not a whole number");
        return value;
    }

    /// Whether the file ends here.
    bool at_end() {
        if (!is_text()) return bytes_.empty();
        TextWords rest = words_;
        return rest.word_of_text().empty();
    }

    /// 0 in a binary file.
    std::size_t line() const { return is_text() ? words_.line() : 0; }

    std::string place() const { return is_text() ? words_.place() : element_->name + " " + std::to_string(number_); }

    [[noreturn]] void refuse(const std::string& reason) const { throw Refused(place() + ": " + reason); }

private:
    bool is_text() const { return format_ == PlyFormat::ascii; }

    [[noreturn]] void refuse_end() const { refuse("the file ends before its last element"); }

    double binary(const PlyType& type) {
        if (bytes_.size() < type.size) refuse_end();
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
    PlyLayout layout_;
    std::string_view bytes_;
    TextWords words_;
    const PlyElement* element_ = nullptr;
    std::uint64_t number_ = 0;
};

const PlyType& ply_type(const TextWords& words, std::string_view name) {
    for (const PlyType& type : ply_types) {
        if (name == type.name || name == type.other_name) return type;
    }
    words.refuse("unknown type of a property: " + printable(name));
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
    std::string texture_place;  // empty: none
};

PlyFormat ply_format(const TextWords& words, std::string_view name) {
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::little_endian;
    if (name == "binary_big_endian") return PlyFormat::big_endian;
    words.refuse("unknown PLY format: " + printable(name));
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
        } else if (keyword == "comment") {
            if (words.word() == "TextureFile") header.texture_place = words.place();
        } else if (keyword != "obj_info" && !keyword.empty()) {
            words.refuse("unknown keyword: " + printable(keyword));
        }
    }
    throw Refused("the file ends in its header");
}

using PlyItem = std::vector<std::vector<double>>;  // the numbers of each property, which has one unless it is a list

/// Reads one item.
void ply_item(PlyBody& body, const PlyElement& element, std::uint64_t number, PlyItem& item) {
    item.resize(element.properties.size());
    body.begin_item(element, number);
    for (std::size_t i = 0; i < item.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        item[i].clear();
        double length = 1;
        if (property.size_type != nullptr) {
            length = body.number(*property.size_type);
            const auto most = body.bytes_left() / body.least_size(*property.type);
            if (!(length >= 0 && length <= double(most))) {
                body.refuse("a list that is longer than the file, or of negative length");
            }
        }
        for (double n = 0; n < length; ++n) item[i].push_back(body.number(*property.type));
    }
    body.end_item();
}

/// Where an element's items have a colour: the places of its properties; none if it has no colour.
class PlyColor {
public:
    explicit PlyColor(const PlyElement& element) : element_(element) {
        for (const std::string prefix : {"", "diffuse_"}) {
            for (std::size_t part = 0; part < names.size(); ++part) {
                if (!places_[part]) places_[part] = place(prefix + std::string(names[part]));
            }
        }
    }

    std::optional<WrittenColor> in(const PlyItem& item, const PlyBody& body, LeftOut& left_out) const {
        if (!places_[0] || !places_[1] || !places_[2]) return std::nullopt;
        if (places_[3] && value(item, 3) < most(3).value_or(1)) left_out.add("transparency", body.place());
        const glm::dvec3 parts{value(item, 0), value(item, 1), value(item, 2)};
        if (std::isfinite(parts.x + parts.y + parts.z)) return WrittenColor{parts, most(0)};
        left_out.add("colours that are not finite", body.place());
        return std::nullopt;
    }

private:
    static constexpr std::array<std::string_view, 4> names{"red", "green", "blue", "alpha"};

    std::optional<std::size_t> place(const std::string& name) const {
        for (std::size_t i = 0; i < element_.properties.size(); ++i) {
            if (element_.properties[i].name == name && element_.properties[i].size_type == nullptr) return i;
        }
        return std::nullopt;
    }

    double value(const PlyItem& item, std::size_t part) const { return item[*places_[part]].front(); }

    std::optional<double> most(std::size_t part) const {
        const PlyType& type = *element_.properties[*places_[part]].type;
        if (type.kind == PlyType::real) return std::nullopt;
        return type.size == 2 ? 65535 : 255;
    }

    const PlyElement& element_;
    std::array<std::optional<std::size_t>, 4> places_;
};

class PlyReader {
public:
    explicit PlyReader(std::string_view bytes) : bytes_(bytes), words_(bytes), header_(ply_header(words_)) {}

    MeshSoup soup() {
        read(has_item_in_each_line() ? PlyLayout::item_in_line : PlyLayout::free);
        return std::move(soup_);
    }

private:
    /// Whether there are as many lines as items, and at most one of them has not as many words as its item. That line
    /// is then wrong.
    bool has_item_in_each_line() const {
        if (header_.format != PlyFormat::ascii) return false;
        TextWords words = words_;
        std::size_t misfits = 0;
        for (const PlyElement& element : header_.elements) {
            for (std::uint64_t i = 0; i < element.count; ++i) {
                if (!words.next_line_with_words()) return false;
                misfits += !fits(words.words_of_line(), element);
                if (misfits > 1) return false;
            }
        }
        return !words.next_line_with_words();
    }

    static bool fits(const std::vector<std::string_view>& line, const PlyElement& element) {
        std::size_t at = 0;
        for (const PlyProperty& property : element.properties) {
            if (property.size_type != nullptr && at < line.size()) {
                const int length = std::atoi(std::string(line[at]).c_str());
                if (length < 0) return false;
                at += std::size_t(length);
            }
            ++at;
        }
        return at == line.size();
    }

    /// The bytes after the header. After a header of lines that end in CR alone, an LF belongs to the data.
    std::string_view data() const {
        const std::size_t first_end = bytes_.find_first_of("\r\n");
        const bool is_cr_alone = bytes_.substr(first_end, 1) == "\r" && bytes_.substr(first_end, 2) != "\r\n";
        const std::size_t at = bytes_.size() - words_.rest().size();
        return bytes_.substr(is_cr_alone && bytes_[at - 1] == '\n' ? at - 1 : at);
    }

    void read(PlyLayout layout) {
        soup_ = {};
        if (!header_.texture_place.empty()) soup_.left_out.add("textures", header_.texture_place);
        PlyBody body(header_.format, data(), words_, layout);
        for (const PlyElement& element : header_.elements) read(body, element);
        if (soup_.points.empty()) throw Refused("no vertices");
        if (!body.at_end()) soup_.left_out.add("data after the last element", body.place());
    }

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
        } else if (element.name == "tristrips") {
            read_strips(body, element);
        } else {
            for (std::uint64_t i = 0; i < element.count; ++i) {
                ply_item(body, element, i, item_);
                if (element.name != "camera") soup_.left_out.add("element " + element.name, body.place());
            }
        }
    }

    void read_points(PlyBody& body, const PlyElement& element) {
        if (!soup_.points.empty()) throw Refused("the vertices occur twice");
        std::array<std::size_t, 3> places{};
        for (std::size_t axis = 0; axis < 3; ++axis) places[axis] = coordinate(element, std::string(1, "xyz"[axis]));
        const PlyColor color(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, i, item_);
            glm::dvec3 point;
            for (int axis = 0; axis < 3; ++axis) {
                point[axis] = item_[places[std::size_t(axis)]].front();
                if (!std::isfinite(point[axis])) body.refuse("a coordinate that is not finite");
            }
            soup_.points.push_back(point);
            soup_.point_colors.push_back(color.in(item_, body, soup_.left_out));
        }
    }

    static std::size_t coordinate(const PlyElement& element, const std::string& name) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (element.properties[i].name == name && element.properties[i].size_type == nullptr) return i;
        }
        throw Refused("element " + element.name + " has no number " + name);
    }

    /// The list with the usual name or, if none has it, the only list of whole numbers.
    static std::size_t list_of_corners(const PlyElement& element) {
        std::vector<std::size_t> lists;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (property.size_type == nullptr || property.type->kind == PlyType::real) continue;
            if (property.name == "vertex_indices" || property.name == "vertex_index") return i;
            lists.push_back(i);
        }
        if (lists.size() == 1) return lists.front();
        throw Refused("element " + element.name + " has no list vertex_indices");
    }

    std::size_t corner(const PlyBody& body, double index) const {
        if (index >= 0 && index <= std::numeric_limits<std::int32_t>::max()) return std::size_t(index);
        body.refuse("a face has a vertex that does not exist");
    }

    void read_faces(PlyBody& body, const PlyElement& element) {
        check_face_count(soup_.faces.size() + element.count);
        const std::size_t place = list_of_corners(element);
        const PlyColor color(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, i, item_);
            MeshFace face{{}, body.line(), color.in(item_, body, soup_.left_out)};
            for (const double index : item_[place]) face.corners.push_back(corner(body, index));
            soup_.faces.push_back(std::move(face));
        }
    }

    /// Each further corner of a strip makes a triangle with the two before it; every second one has the opposite
    /// direction. -1 begins a new strip. A corner that is repeated joins two strips and makes no triangle.
    void read_strips(PlyBody& body, const PlyElement& element) {
        const std::size_t place = list_of_corners(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            ply_item(body, element, i, item_);
            std::vector<std::size_t> strip;
            for (const double index : item_[place]) {
                if (index == -1) {
                    strip.clear();
                    continue;
                }
                strip.push_back(corner(body, index));
                if (strip.size() < 3) continue;
                const std::size_t first = strip[strip.size() - 3], second = strip[strip.size() - 2];
                if (first == second || second == strip.back() || first == strip.back()) continue;
                check_face_count(soup_.faces.size() + 1);
                const bool turned = strip.size() % 2 == 0;
                soup_.faces.push_back({{turned ? second : first, turned ? first : second, strip.back()}, body.line()});
            }
        }
    }

    std::string_view bytes_;
    TextWords words_;
    PlyHeader header_;
    MeshSoup soup_;
    PlyItem item_;
};

}  // namespace

MeshSoup read_ply(std::string_view bytes, const Beside&) { return PlyReader(bytes).soup(); }

}  // namespace vidno
