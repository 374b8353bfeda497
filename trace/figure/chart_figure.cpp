#include "chart_figure.h"

#include <cmath>
#include <limits>

#include "say/numbers.h"
#include "wrap.h"

namespace vidno::figures {

namespace {

struct MarkWords {
    std::string_view wrong, right, cheapest, no_number;
};
const InEachLanguage<MarkWords> mark_words{
    {.wrong = "wrong", .right = "right", .cheapest = "the cheapest right one", .no_number = "no number"},
    {.wrong = "неверно", .right = "верно", .cheapest = "самый дешёвый верный", .no_number = "не число"}};

/// 0.01, 1, 10,000, and beyond as powers of ten.
std::string tick_text(int exponent, Language language) {
    constexpr int most = 5;
    if (std::abs(exponent) > most) return "1e" + std::to_string(exponent);
    if (exponent < 0) return say::in_format("0." + std::string(std::size_t(-exponent - 1), '0') + "1", language);
    std::string text = "1" + std::string(std::size_t(exponent), '0');
    if (exponent > 3) text.insert(text.size() - 3, language == Language::russian ? "\u00a0" : ",");
    return text;
}

/// A logarithmic scale from 0 to 1.
class ChartScale {
public:
    ChartScale(double least, double greatest) : least_(std::log10(least)), greatest_(std::log10(greatest)) {}
    double at(double value) const { return at_power(std::log10(value)); }
    /// Where ten to this power stands, which may be greater than any double.
    double at_power(double exponent) const { return (exponent - least_) / (greatest_ - least_); }
    /// The powers of ten on it, at most `most`.
    std::vector<int> ticks(int most) const {
        const int first = int(std::ceil(least_ - 1e-9)), last = int(std::floor(greatest_ + 1e-9));
        const int step = std::max(1, (last - first) / most + 1);
        std::vector<int> exponents;
        for (int exponent = first; exponent <= last; exponent += step) exponents.push_back(exponent);
        return exponents;
    }
    /// Goes on to the right, so that what took its whole length takes this share.
    ChartScale taking(double share) const {
        ChartScale longer = *this;
        longer.greatest_ = least_ + (greatest_ - least_) / share;
        return longer;
    }

private:
    double least_, greatest_;
};

class ChartDrawing {
public:
    ChartDrawing(const ChartPanel& panel, const Style& style, double width)
        : panel_(panel),
          style_(style),
          words_(mark_words.in(style.language)),
          costs_(cost_scale()),
          errors_(error_scale()) {
        drawing_.width = width;
        for (const int exponent : errors_.ticks(most_error_ticks))
            left_ = std::max(left_, text_width(tick_text(exponent, style.language), size));
        if (has_infinity_) left_ = std::max(left_, text_width(words_.no_number, size));
        left_ = std::max(left_, text_width(least_text(), size));
        left_ += 1.5;
        across_ = width - left_ - 0.5;
        name_marks();
        draw();
    }

    const Drawing& drawing() const { return drawing_; }

private:
    static constexpr double size = 7, small = 6.5;  // of letters, in points
    static constexpr double em = size / points_per_millimetre, line_height = 1.25 * em, radius = 0.75;
    static constexpr double least_height = 26, most_height = 120;  // of the part of the wrong marks
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr int most_cost_ticks = 6, most_error_ticks = 5;

    struct NameLine {
        std::string text;
        bool bold = false;
    };

    /// The name of a mark, or of several that cannot be told apart.
    struct Name {
        Point at;
        std::vector<NameLine> lines{};

        double height() const { return double(lines.size()) * line_height; }
        double width() const {
            double widest = 0;
            for (const auto& [text, bold] : lines) widest = std::max(widest, width_of(text, small, bold));
            return widest;
        }
    };

    /// A name where it is drawn, with the line that leads to it from its mark.
    struct PlacedName {
        const Name* name;
        Box box;
        Anchor anchor = Anchor::start;
        std::optional<Box> stem{};
    };

    static Box stem_at(double x, double from, double to) {
        return {x - 0.1, std::min(from, to), 0.2, std::abs(to - from)};
    }

    bool is_right(double error) const { return error <= panel_.least; }
    /// A picture may be right although its depths are not.
    bool is_marked(const ChartMark& mark) const { return mark.is_cheapest && is_right(mark.error); }
    /// To a hundredth.
    std::string least_text() const {
        return say::in_format(decimal(std::round(100 * panel_.least) / 100), style_.language);
    }
    double text_width(std::string_view text, double of_size, bool bold = false) const {
        return width_of(text, of_size, bold) * style_.letters;
    }

    ChartScale cost_scale() const {
        double least = infinity, greatest = 0;
        for (const ChartMark& mark : panel_.marks) {
            least = std::min(least, mark.cost);
            greatest = std::max(greatest, mark.cost);
        }
        if (least > greatest) return {1, 10};
        const double margin = std::max(std::pow(greatest / least, 0.05), 1.1);
        return {least / margin, greatest * margin};
    }

    ChartScale error_scale() {
        double least = infinity, greatest = 0;
        for (const ChartMark& mark : panel_.marks) {
            has_wrong_ = has_wrong_ || !is_right(mark.error);
            has_infinity_ = has_infinity_ || mark.error == infinity;
            if (is_right(mark.error) || mark.error == infinity) continue;
            least = std::min(least, mark.error);
            greatest = std::max(greatest, mark.error);
        }
        if (least > greatest) return {0.1, 1};
        const double lowest = std::floor(std::log10(least));
        return {std::pow(10, lowest), std::pow(10, std::max(std::ceil(std::log10(greatest)), lowest + 1))};
    }

    double x_of(const ChartMark& mark) const { return left_ + costs_.at(mark.cost) * across_; }
    double y_of(double error) const {
        if (is_right(error)) return right_line();
        if (error == infinity) return top_ + em;
        const double highest = top_ + (has_infinity_ ? 3 : 1) * em;
        return highest + (1 - errors_.at(error)) * (lowest_wrong() - highest);
    }
    double divide() const { return top_ + (has_wrong_ ? height_ : 0) + 1.6 * em; }
    double lowest_wrong() const { return divide() - 2 * em; }
    double right_line() const { return divide() + 2.2 * em; }

    /// One name for marks whose symbols nearly cover each other: the ways, each with its kernels.
    std::vector<Name> names_of(bool right) const {
        std::vector<const ChartMark*> marks;
        for (const ChartMark& mark : panel_.marks) {
            if (is_right(mark.error) == right) marks.push_back(&mark);
        }
        std::ranges::sort(marks, {}, [](const ChartMark* mark) { return std::pair(mark->cost, mark->error); });
        std::vector<Name> names;
        std::vector<std::vector<const ChartMark*>> groups;
        for (const ChartMark* mark : marks) {
            const Point at{x_of(*mark), y_of(mark->error)};
            const auto near = [&](const Name& name) {
                return std::hypot(name.at.x - at.x, name.at.y - at.y) < 1.6 * radius;
            };
            const auto group = std::ranges::find_if(names, near);
            if (group == names.end()) {
                names.push_back({at});
                groups.push_back({mark});
            } else {
                groups[std::size_t(group - names.begin())].push_back(mark);
            }
        }
        for (std::size_t i = 0; i < names.size(); ++i) names[i].lines = lines_of(groups[i]);
        return names;
    }

    std::vector<NameLine> lines_of(const std::vector<const ChartMark*>& marks) const {
        std::vector<NameLine> lines;
        std::vector<std::string_view> ways;
        for (const ChartMark* mark : marks) {
            const auto way = std::ranges::find(ways, mark->way);
            if (way == ways.end()) {
                ways.push_back(mark->way);
                lines.push_back({mark->way + " · " + mark->kernel});
            } else {
                lines[std::size_t(way - ways.begin())].text += ", " + mark->kernel;
            }
        }
        std::vector<NameLine> broken;
        for (const NameLine& line : lines) {
            // So that it fits on the left or on the right of any mark.
            const double most = 0.45 * across_ / style_.letters;
            for (const std::string& part : wrapped(line.text, small, most, most)) broken.push_back({part});
        }
        const auto is_cheapest = [&](const ChartMark* mark) { return is_marked(*mark); };
        if (std::ranges::any_of(marks, is_cheapest)) broken.push_back({std::string(words_.cheapest), true});
        return broken;
    }

    /// The names of right marks hang below their line, the rightmost at the top, each to the right of its stem: so no
    /// stem crosses a name. Returns how much room they take.
    double hang(const std::vector<Name>& names) {
        std::vector<const Name*> from_right;
        for (const Name& name : names) from_right.push_back(&name);
        std::ranges::stable_sort(from_right, {}, [](const Name* name) { return -name->at.x; });
        double deepest = 2 * radius;
        std::vector<Box> hung;
        for (const Name* name : from_right) {
            const double x = name->at.x, y = name->at.y;
            const double width = name->width() * style_.letters;
            double top = 2 * radius;
            for (const Box& other : hung) {
                if (other.x < x + 0.4 * em + width + 0.5 * em) top = std::max(top, other.bottom() - y);
            }
            const Box box{x + 0.4 * em, y + top, width, name->height() + 0.2 * em};
            placed_.push_back({name, box, Anchor::start, stem_at(x, y + radius, box.bottom() - 0.5 * em)});
            hung.push_back({x - 0.2 * em, y, 0, box.bottom() - y});
            deepest = std::max(deepest, box.bottom() - y);
        }
        return deepest;
    }

    /// Places a name of a wrong mark beside it, or farther above or below on a stem, where it covers nothing.
    bool has_placed(const Name& name) {
        const auto [x, y] = name.at;
        const double width = name.width() * style_.letters, height = name.height();
        const Box inside{left_, top_, across_, divide() - top_};
        const auto is_free = [&](const Box& box, const std::vector<Box>& others) {
            return std::ranges::none_of(others, [&](const Box& other) { return box.overlaps(other); });
        };
        const auto try_at = [&](double text_x, double text_y, Anchor anchor, std::optional<Box> stem) {
            const Box box{anchor == Anchor::start ? text_x : text_x - width, text_y, width, height};
            if (!inside.holds(box) || !is_free(box, taken_) || !is_free(box, dots_)) return false;
            // A stem may pass a mark, since marks may lie close together.
            if (stem && !is_free(*stem, taken_)) return false;
            placed_.push_back({&name, box, anchor, stem});
            taken_.push_back(box);
            if (stem) taken_.push_back(*stem);
            return true;
        };
        for (const auto& [anchor, way] : {std::pair(Anchor::start, 1), std::pair(Anchor::end, -1)}) {
            if (try_at(x + way * (radius + 0.5), y - height / 2, anchor, std::nullopt)) return true;
        }
        for (double far = 1.5 * radius; far < height_; far += em / 2) {
            for (const auto& [anchor, way] : {std::pair(Anchor::start, 1), std::pair(Anchor::end, -1)}) {
                const double beside = x + way * 0.4 * em, above = y - far - height;
                if (try_at(beside, above, anchor, stem_at(x, y - radius, above + 0.4 * em))) return true;
                if (try_at(beside, y + far, anchor, stem_at(x, y + radius, y + far + height - 0.4 * em))) return true;
            }
        }
        return false;
    }

    /// A name that finds no place comes first in the next turn.
    bool has_placed_wrong_names() {
        wrong_names_ = names_of(false);
        dots_.clear();
        for (const ChartMark& mark : panel_.marks)
            dots_.push_back({x_of(mark) - radius, y_of(mark.error) - radius, 2 * radius, 2 * radius});
        for (std::size_t turn = 0; turn <= wrong_names_.size(); ++turn) {
            placed_.clear();
            taken_ = {{left_, divide() - 1.4 * em, text_width(words_.wrong, size, true) + em, 1.4 * em}};
            const auto lost =
                std::ranges::find_if_not(wrong_names_, [&](const Name& name) { return has_placed(name); });
            if (lost == wrong_names_.end()) return true;
            std::rotate(wrong_names_.begin(), lost, lost + 1);
        }
        return false;
    }

    void name_marks() {
        const double title_width = drawing_.width / style_.letters / 1.1;  // bold letters are wider
        for (const std::string& line : wrapped(panel_.title, size, title_width, title_width)) {
            drawing_.add(Label{line, {0, top_ + em}, size, Anchor::start, true, ink});
            top_ += line_height;
        }
        top_ += 0.4 * em;
        drawing_.add(Label{panel_.error, {0, top_ + em}, size, Anchor::start, false, ink});
        top_ += 1.6 * em;

        // The names of the right marks hang to the right of them, so the scale goes on until all of them fit.
        const auto sticks_out = [&](const Name& name) {
            return name.at.x + name.width() * style_.letters + em > left_ + across_;
        };
        for (int turn = 0; turn < 100 && std::ranges::any_of(names_of(true), sticks_out); ++turn)
            costs_ = costs_.taking(0.97);
        while (!has_placed_wrong_names() && height_ < most_height) height_ += line_height;
        right_names_ = names_of(true);
        below_ = hang(right_names_) + 0.4 * em;
    }

    void draw_line(double y, double width, const Color& color) {
        drawing_.add(Path{{{{left_, y}, {left_ + across_, y}}}, false, {}, Stroke{color, width}});
    }

    void draw_axes() {
        const double bottom = right_line() + below_;
        const Color pale{0xe3, 0xe6, 0xea};
        drawing_.add(rectangle({left_, divide(), across_, bottom - divide()},
                               printed(Color{0xee, 0xf5, 0xf0}, style_.greyscale)));
        double end_of_tick = 0;
        for (const int exponent : costs_.ticks(most_cost_ticks)) {
            const double x = left_ + costs_.at_power(exponent) * across_;
            drawing_.add(Path{{{{x, top_}, {x, bottom}}}, false, {}, Stroke{pale, Stroke::hairline}});
            const std::string text = tick_text(exponent, style_.language);
            const double half = text_width(text, size) / 2;
            // It would be cut off, or cover the one before.
            if (x + half > drawing_.width || x - half < end_of_tick) continue;
            end_of_tick = x + half + em / 2;
            drawing_.add(Label{text, {x, bottom + 1.2 * em}, size, Anchor::middle, false, ink});
        }
        const auto tick = [&](double y, const std::string& text) {
            drawing_.add(Label{text, {left_ - 1, y + 0.35 * em}, size, Anchor::end, false, ink});
        };
        if (has_wrong_) {
            for (const int exponent : errors_.ticks(most_error_ticks)) {
                const double y = y_of(std::pow(10, exponent));
                if (std::pow(10, exponent) <= panel_.least) continue;
                draw_line(y, Stroke::hairline, pale);
                tick(y, tick_text(exponent, style_.language));
            }
        }
        if (has_infinity_) tick(top_ + em, std::string(words_.no_number));
        tick(right_line(), least_text());
        draw_line(right_line(), 0.4, faint);
        draw_line(divide(), 0.8, ink);
        drawing_.add(
            Label{std::string(words_.wrong), {left_ + 0.5, divide() - 0.5 * em}, size, Anchor::start, true, ink});
        drawing_.add(
            Label{std::string(words_.right), {left_ + 0.5, divide() + 1.1 * em}, size, Anchor::start, true, ink});
        drawing_.add(Label{panel_.cost, {left_ + across_, bottom + 2.7 * em}, size, Anchor::end, false, ink});
        drawing_.height = bottom + 3.2 * em;
    }

    void draw_mark(const ChartMark& mark) {
        const Point at{x_of(mark), y_of(mark.error)};
        const auto color = [&](Color usual) { return style_.greyscale ? ink : usual; };
        // From Okabe and Ito's palette for colour-blind readers.
        const Color of_circle = color({0x00, 0x72, 0xb2}), of_square = color({0xd5, 0x5e, 0x00}),
                    of_triangle = color({0x00, 0x9e, 0x73});
        const double r = radius;
        const auto filled = [&](Polyline outline, const Color& own) {
            drawing_.add(Path{{std::move(outline)}, true, own, Stroke{paper, 0.3}});
        };
        switch (mark.shape) {
            case ChartMark::Shape::circle: filled(circle(at, r), of_circle); break;
            case ChartMark::Shape::square:
                filled(Box{at.x - .9 * r, at.y - .9 * r, 1.8 * r, 1.8 * r}.corners(), of_square);
                break;
            case ChartMark::Shape::triangle:
                filled({{at.x, at.y - 1.2 * r}, {at.x + 1.1 * r, at.y + .8 * r}, {at.x - 1.1 * r, at.y + .8 * r}},
                       of_triangle);
        }
        if (is_marked(mark)) drawing_.add(Path{{circle(at, 1.9 * r)}, true, {}, Stroke{ink, 0.8}});
    }

    void draw() {
        draw_axes();
        for (const auto& [name, box, anchor, stem] : placed_) {
            if (stem)
                drawing_.add(
                    Path{{{{name->at.x, stem->y}, {name->at.x, stem->bottom()}}}, false, {}, Stroke{faint, 0.4}});
            double y = box.y;
            for (const auto& [text, bold] : name->lines) {
                drawing_.add(Label{
                    text, {anchor == Anchor::start ? box.x : box.right(), y + 0.95 * em}, small, anchor, bold, ink});
                y += line_height;
            }
        }
        for (const ChartMark& mark : panel_.marks) draw_mark(mark);
    }

    const ChartPanel& panel_;
    const Style& style_;
    const MarkWords& words_;
    bool has_wrong_ = false, has_infinity_ = false;
    ChartScale costs_, errors_;
    double left_ = 0, across_ = 0, top_ = 0, below_ = 0, height_ = least_height;  // of the plot, in millimetres
    std::vector<Name> right_names_, wrong_names_;
    std::vector<PlacedName> placed_;
    std::vector<Box> taken_, dots_;  // by names, by marks
    Drawing drawing_;
};

}  // namespace

Drawing chart_figure(const std::vector<ChartPanel>& panels, const Style& style, double width) {
    constexpr double panel_width = 80, gap = 10;
    const auto columns =
        std::max<std::size_t>(1, std::min(panels.size(), std::size_t((width + gap) / (panel_width + gap) + 0.05)));
    const double own = (width - double(columns - 1) * gap) / double(columns);
    Drawing figure{width, 0};
    for (std::size_t first = 0; first < panels.size(); first += columns) {
        double highest = 0;
        if (first > 0) figure.height += gap / 2;
        for (std::size_t i = first; i < std::min(first + columns, panels.size()); ++i) {
            const Drawing panel = ChartDrawing(panels[i], style, own).drawing();
            figure.place(panel, {double(i - first) * (own + gap), figure.height});
            highest = std::max(highest, panel.height);
        }
        figure.height += highest;
    }
    return figure;
}

}  // namespace vidno::figures
