#include <map>
#include <utility>

#include "characters.h"
#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

namespace {

/// The materials of a library: of each its colour, Kd, if that is given as red, green and blue; and what else it has.
struct Material {
    std::optional<WrittenColor> color;
    bool is_textured = false, is_transparent = false;
};

/// Statements of numbers that show nothing by themselves. Like those that are read, they continue after a backslash.
constexpr std::array<std::string_view, 15> without_look{"vn",   "vt",   "vp",   "cstype", "deg", "bmat", "step", "con",
                                                        "parm", "trim", "hole", "scrv",   "sp",  "end",  "ctech"};
/// Statements of one line that show nothing by themselves.
constexpr std::array<std::string_view, 9> without_look_in_line{
    "s", "mg", "stech", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

bool is_among(std::string_view word, const auto& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
public:
    ObjReader(std::string_view bytes, const Beside& beside) : words_(bytes, '#'), beside_(beside) {
        while (words_.next_line()) {
            line_ = words_.line();
            continues_ = false;
            if (const std::string_view keyword = words_.word(); !keyword.empty()) read(keyword);
        }
    }

    MeshSoup soup() { return std::move(soup_); }

private:
    void read(std::string_view keyword) {
        if (keyword == "v") {
            read_point();
        } else if (keyword == "f" || keyword == "fo") {  // "fo" in files of old programs
            read_face();
        } else if (keyword == "g" || keyword == "o") {
            soup_.groups.push_back(words_.name());
        } else if (keyword == "mtllib") {
            read_materials(words_.name());
        } else if (keyword == "usemtl") {
            use_material(words_.name());
        } else if (keyword == "l" || keyword == "p") {
            leave_out("lines and points", true);
        } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
            leave_out("curves and curved surfaces", true);
        } else if (keyword == "usemap" || keyword == "maplib") {
            leave_out("textures", false);
        } else if (is_among(keyword, without_look)) {
            skip_words();
        } else if (!is_among(keyword, without_look_in_line)) {
            leave_out("statements that are not of OBJ, \"" + printable(keyword) + "\"", false);
        }
    }

    /// The next word of a statement of numbers; a backslash at the end of a line continues it.
    std::string_view word() {
        if (std::exchange(continues_, false) && !words_.next_line()) return {};
        std::string_view found = words_.word();
        if (!found.ends_with('\\') || words_.has_word()) return found;
        found.remove_suffix(1);
        continues_ = true;
        return found.empty() ? word() : found;
    }

    void skip_words() {
        while (!word().empty()) {
        }
    }

    void leave_out(const std::string& kind, bool continues) {
        soup_.left_out.add(kind, words_.place());
        if (continues) skip_words();
    }

    /// Three coordinates; then nothing, a weight, or a colour.
    void read_point() {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = words_.number(word());
        soup_.points.push_back(point);
        std::vector<double> more;
        for (std::string_view found = word(); !found.empty(); found = word()) more.push_back(words_.any_number(found));
        if (more.size() == 3 || more.size() == 4) {
            soup_.point_colors.resize(soup_.points.size() - 1);
            soup_.point_colors.push_back(WrittenColor{{more[0], more[1], more[2]}});
        } else if (!soup_.point_colors.empty()) {
            soup_.point_colors.emplace_back();
        }
        if (more.size() == 1 && more[0] != 1) soup_.left_out.add("weights of vertices", words_.place());
        if (more.size() == 4) soup_.left_out.add("transparency", words_.place());
        if (more.size() == 2 || more.size() > 4) {
            soup_.left_out.add("numbers after a vertex that are no colour", words_.place());
        }
    }

    void read_face() {
        check_face_count(soup_.faces.size() + 1);
        MeshFace face{{}, line_, color_};
        if (!soup_.groups.empty() && !soup_.groups.back().empty()) face.group = soup_.groups.size() - 1;
        const auto points = std::int64_t(soup_.points.size());
        for (std::string_view corner = word(); !corner.empty(); corner = word()) {
            std::int64_t index = words_.whole_number(corner.substr(0, corner.find('/')));
            if (index < 0) index = index < -points ? 0 : points + index + 1;  // counts back from the last
            if (index == 0) words_.refuse("a face has a vertex that does not exist");
            face.corners.push_back(std::size_t(index - 1));
        }
        soup_.faces.push_back(std::move(face));
    }

    /// Several libraries may follow one keyword, and the name of one may contain blanks.
    void read_materials(const std::string& names) {
        if (read_library(names)) return;
        TextWords parts(names);
        parts.next_line();
        bool all = !names.empty();
        for (auto name = parts.word(); !name.empty(); name = parts.word()) {
            all = name.size() < names.size() && read_library(std::string(name)) && all;
        }
        if (all) return;
        misses_library_ = true;
        soup_.left_out.add("colours: the library of materials \"" + printable(names) + "\" cannot be read",
                           words_.place());
    }

    bool read_library(const std::string& name) {
        if (!beside_) return false;
        std::optional<std::string> bytes = beside_(name);
        if (!bytes) bytes = beside_(without_folders(name));
        if (!bytes) return false;
        TextWords words(without_mark(*bytes), '#');
        Material* material = nullptr;
        while (words.next_line()) {
            const std::string keyword = lower_case(words.word());
            if (keyword == "newmtl") {
                material = &(materials_[words.name()] = {});
            } else if (material == nullptr) {
                continue;
            } else if (keyword == "kd") {
                material->color = color_in(words, name);
            } else if (keyword == "d" || keyword == "tr") {
                std::string_view word = words.word();
                if (word == "-halo") word = words.word();
                material->is_transparent = words.any_number(word) != (keyword == "d" ? 1 : 0);
            } else if (keyword == "map_kd") {
                material->is_textured = true;
            }
        }
        return true;
    }

    /// One number stands for all three. Not read: `Kd spectral FILE` and `Kd xyz X Y Z`.
    static std::optional<WrittenColor> color_in(TextWords& words, const std::string& library) {
        const std::string_view first = words.word();
        if (first == "spectral" || first == "xyz") return std::nullopt;
        try {
            WrittenColor color{glm::dvec3(words.number(first)), 1.0};
            if (words.has_word()) {
                color.parts.y = words.number(words.word());
                color.parts.z = words.number(words.word());
            }
            return color;
        } catch (const Refused& refused) {
            throw Refused(library + ": " + refused.what());
        }
    }

    void use_material(const std::string& name) {
        color_.reset();
        const auto found = materials_.find(name);
        if (found == materials_.end()) {
            if (!misses_library_) {
                soup_.left_out.add("colours: no library has the material \"" + printable(name) + "\"", words_.place());
            }
            return;
        }
        const Material& material = found->second;
        color_ = material.color;
        if (!material.color) {
            soup_.left_out.add("colours: the material \"" + printable(name) + "\" has no Kd of red, green and blue",
                               words_.place());
        }
        if (material.is_textured) soup_.left_out.add("textures", words_.place());
        if (material.is_transparent) soup_.left_out.add("transparency", words_.place());
    }

    TextWords words_;
    const Beside& beside_;
    std::size_t line_ = 0;  // of the statement's keyword
    bool continues_ = false;
    MeshSoup soup_;
    std::map<std::string, Material> materials_;
    std::optional<WrittenColor> color_;
    bool misses_library_ = false;
};

}  // namespace

MeshSoup read_obj(std::string_view bytes, const Beside& beside) { return ObjReader(bytes, beside).soup(); }

}  // namespace vidno
