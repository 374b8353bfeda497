#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

namespace {

/// How numbers are laid out. The format is free: its numbers may be anywhere, but a face's colour reaches to the end of
/// its line. Many files have a vertex or a face in each line, some of them with numbers that the header does not
/// announce. Others have several faces in a line, and so no colours.
struct OffLayout {
    enum { free, item_in_line, without_colors } lines = free;
    bool has_edges = true;        // their number, which some files lack
    std::size_t color_parts = 4;  // of a vertex
};

class OffReader {
public:
    explicit OffReader(std::string_view bytes) : start_(bytes, '#') {
        read_keyword();
        check_count(points_, "vertices", 6, start_.bytes_left() + 1);  // "0 0 0" and a newline, which the last may lack
        check_count(faces_, "faces", 2, start_.bytes_left() + 1);
        check_face_count(faces_);
    }

    /// A layout that fits the whole text; otherwise the likeliest one, whose error is reported.
    MeshSoup soup() {
        OffLayout likely;
        likely.has_edges = states_edges();
        OffLayout by_lines = likely;
        by_lines.lines = OffLayout::item_in_line;
        const TextWords start = start_of_points(likely);
        const bool has_line_for_each = !start.has_word() && lines_from(start) == points_ + faces_;
        if (has_line_for_each && misfits(likely) <= 1) return read(by_lines);
        if (auto soup = fitting(likely)) return std::move(*soup);
        if (has_line_for_each) return read(by_lines);
        for (const bool has_edges : {true, false}) {
            for (const std::size_t color_parts : {4, 3}) {
                for (const auto lines : {OffLayout::free, OffLayout::without_colors}) {
                    if (auto soup = fitting({lines, has_edges, color_parts})) return std::move(*soup);
                }
            }
        }
        return read(likely);
    }

private:
    /// `[ST][C][N]OFF`, in any order, and the counts, of which the first may adjoin. The keyword may be missing.
    void read_keyword() {
        std::string_view first = start_.word_of_text();
        if (first.empty()) throw Refused("empty");
        const std::size_t keyword = first.find("OFF");
        if (keyword != std::string_view::npos) {
            read_prefix(first.substr(0, keyword));
            first.remove_prefix(keyword + 3);
            if (first.empty()) first = start_.word_of_text();
            if (first == "BINARY") start_.refuse("binary OFF is not supported");
        } else if (first.find_first_not_of("0123456789") != std::string_view::npos) {
            start_.refuse("does not start with OFF");
        }
        points_ = start_.count(first);
        faces_ = start_.count(start_.word_of_text());
    }

    void read_prefix(std::string_view prefix) {
        while (!prefix.empty()) {
            if (prefix == "4" || prefix == "n" || prefix == "4n") start_.refuse("not of three dimensions");
            const std::string_view part = prefix.substr(0, prefix.starts_with("ST") ? 2 : 1);
            if (part != "ST" && part != "C" && part != "N") start_.refuse("does not start with OFF");
            (part == "C" ? has_colors_ : part == "N" ? has_normals_ : has_texture_) = true;
            prefix.remove_prefix(part.size());
        }
    }

    /// Whether the number of edges seems to be there: in the line of the other counts, or alone in the next.
    bool states_edges() const {
        TextWords words = start_;
        if (words.has_word()) return true;
        words.word_of_text();
        return !words.has_word();
    }

    TextWords start_of_points(const OffLayout& layout) const {
        TextWords words = start_;
        if (layout.has_edges) words.whole_number(words.word_of_text());
        return words;
    }

    static std::uint64_t lines_from(TextWords words) {
        std::uint64_t lines = 0;
        while (words.next_line_with_words()) ++lines;
        return lines;
    }

    /// How many lines do not hold as many words as a vertex or a face. If it is just one, that line is wrong.
    std::size_t misfits(const OffLayout& layout) const {
        TextWords words = start_of_points(layout);
        const std::size_t least = 3 + (has_normals_ ? 3 : 0) + (has_texture_ ? 2 : 0);
        std::size_t found = 0;
        for (std::uint64_t i = 0; i < points_ + faces_; ++i) {
            words.next_line_with_words();
            const auto line = words.words_of_line();
            std::size_t more = line.size() - least;
            if (i >= points_) more = line.size() - 1 - std::size_t(std::atoi(std::string(line.front()).c_str()));
            const bool may_have_color = i >= points_ || has_colors_;
            found += !((more == 0 && (i >= points_ || !has_colors_)) || (more == 1 && i >= points_) ||
                       ((more == 3 || more == 4) && may_have_color));
        }
        return found;
    }

    std::optional<MeshSoup> fitting(const OffLayout& layout) {
        try {
            MeshSoup soup = read(layout);
            if (is_whole_ && has_plausible_faces(soup)) return soup;
        } catch (const Refused&) {
        }
        return std::nullopt;
    }

    MeshSoup read(const OffLayout& layout) {
        layout_ = layout;
        words_ = start_of_points(layout);
        soup_ = {};
        has_odd_numbers_ = false;
        for (std::uint64_t i = 0; i < points_; ++i) read_point();
        for (std::uint64_t i = 0; i < faces_; ++i) read_face();
        const bool at_end = words_.word_of_text().empty();
        is_whole_ = at_end && !has_odd_numbers_;
        if (!at_end) soup_.left_out.add("text after the last face", words_.place());
        return std::move(soup_);
    }

    bool by_lines() const { return layout_.lines == OffLayout::item_in_line; }

    std::string_view word(const char* item) {
        const std::string_view found = by_lines() ? words_.word() : words_.word_of_text();
        if (!found.empty()) return found;
        words_.refuse(by_lines() ? "a number is missing" : "the file ends before its last " + std::string(item));
    }

    /// Where the first number of an item is, when it is read by lines.
    void begin(const char* item) {
        if (!by_lines() || words_.next_line_with_words()) return;
        words_.refuse("the file ends before its last " + std::string(item));
    }

    void read_point() {
        begin("vertex");
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = words_.number(word("vertex"));
        soup_.points.push_back(point);
        for (int axis = 0; has_normals_ && axis < 3; ++axis) words_.any_number(word("vertex"));
        std::vector<std::string_view> rest;
        if (by_lines()) {
            rest = words_.words_of_line();
        } else {
            const std::size_t more = (has_colors_ ? layout_.color_parts : 0) + (has_texture_ ? 2 : 0);
            for (std::size_t i = 0; i < more; ++i) rest.push_back(word("vertex"));
        }
        if (has_texture_) rest.resize(rest.size() - std::min<std::size_t>(2, rest.size()));
        if (has_colors_) {
            soup_.point_colors.push_back(color_of(rest));
        } else if (!rest.empty()) {
            soup_.left_out.add("numbers of vertices that the header does not announce", words_.place());
        }
    }

    void read_face() {
        begin("face");
        const std::uint64_t corners = words_.count(word("face"));
        MeshFace face{{}, words_.line()};
        check_count(corners, "corners of a face", 2, words_.bytes_left() + 1);
        for (std::uint64_t corner = 0; corner < corners; ++corner) {
            face.corners.push_back(words_.count(word("face")));
        }
        if (layout_.lines != OffLayout::without_colors) face.color = color_of(words_.words_of_line());
        soup_.faces.push_back(std::move(face));
    }

    /// Three parts, or four with the opacity. Written with a point, they are from 0 to 1.
    std::optional<WrittenColor> color_of(const std::vector<std::string_view>& written) {
        std::vector<double> parts;
        bool has_point = false;
        for (const std::string_view word : written) {
            parts.push_back(words_.any_number(word));
            has_point = has_point || word.find_first_of(".eE") != std::string_view::npos;
        }
        if (parts.size() == 4 && parts[3] != 1 && parts[3] != 255) {
            soup_.left_out.add("transparency", words_.place());
        }
        if (parts.size() == 3 || parts.size() == 4) return written_color(parts[0], parts[1], parts[2], has_point);
        if (parts.size() == 1) soup_.left_out.add("a colour that is a place in a table of colours", words_.place());
        if (parts.size() > 1) {
            soup_.left_out.add("numbers that are no colour", words_.place());
            has_odd_numbers_ = true;
        }
        return std::nullopt;
    }

    static WrittenColor written_color(double red, double green, double blue, bool has_point) {
        const bool is_small = std::max({red, green, blue}) <= 1;
        return {{red, green, blue}, has_point && is_small ? std::optional(1.0) : std::nullopt};
    }

    TextWords start_;  // after the counts of points and faces
    std::uint64_t points_ = 0, faces_ = 0;
    bool has_texture_ = false, has_colors_ = false, has_normals_ = false;

    OffLayout layout_;
    TextWords words_{""};
    MeshSoup soup_;
    bool is_whole_ = false;         // whether the layout explains each number
    bool has_odd_numbers_ = false;  // after a face
};

}  // namespace

MeshSoup read_off(std::string_view bytes, const Beside&) { return OffReader(bytes).soup(); }

}  // namespace vidno
