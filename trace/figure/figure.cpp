#include "figure.h"

#include <cmath>

#include "floating_horizon_parts.h"
#include "refused.h"
#include "say/sentence.h"
#include "table.h"
#include "weiler_atherton_parts.h"
#include "wrap.h"

namespace vidno::figures {

namespace {

constexpr double panel_gap = 4;     // millimetres between panels and parts
constexpr double wide_panel = 110;  // a panel has text beside its plane, not below
constexpr double least_plane = 38, least_text = 76;

/// The number of columns of a strip, so that the last row is as full as possible.
std::size_t columns_for(const Options& options) {
    if (options.is_film) return 1;
    const double least = options.shows_text() ? least_text : least_plane;
    const auto fitting = std::size_t(std::max(1., std::floor((options.width + panel_gap) / (least + panel_gap))));
    const std::size_t rows = (options.moments + fitting - 1) / fitting;
    return (options.moments + rows - 1) / rows;
}

std::string said_of(const auto& moment, Language language) {
    if (!moment.event()) return std::string(words_of(language).start);
    return say::sentence(*moment.event(), moment.state(), language).whole();
}

void append(auto& parts, Drawing drawing) {
    parts.height = std::max(parts.height, drawing.height);
    parts.drawings.push_back(std::move(drawing));
}

}  // namespace

std::string caption_of(const Moment& moment, Language language) { return said_of(moment, language); }
std::string caption_of(const FloatingHorizonMoment& moment, Language language) { return said_of(moment, language); }

std::string letter_of(std::size_t place) {
    constexpr std::size_t letters = 26;
    std::string text(1, char('a' + place % letters));
    if (place >= letters) text.insert(0, 1, char('a' + place / letters - 1));
    return "(" + text + ")";
}

Figure::Figure(const Options& options) : options_(options), columns_(columns_for(options)) {
    panel_width_ = (options.width - panel_gap * double(columns_ - 1)) / double(columns_);
    plane_width_ = is_beside() ? 0.46 * panel_width_ : panel_width_;
    text_width_ = is_beside() ? panel_width_ - plane_width_ - panel_gap : panel_width_;
}

bool Figure::is_beside() const { return options_.shows_plane() && options_.shows_text() && panel_width_ >= wide_panel; }

Drawing Figure::plane(const Moment& moment, const std::optional<PixelHistory>& history) const {
    const Style& style = options_.style;
    const Plane plane = plane_in(moment.scene().area, plane_width_, most_plane_height());
    Drawing drawing{plane_width_, height_of(plane)};
    // Outlines of very many polygons would hide the picture, so they show only where nothing is painted yet.
    const bool crowded = moment.scene().polygons.size() > most_outlines;
    if (crowded) draw_outlines(drawing, moment, plane, style);
    if (options_.shows(Part::picture)) {
        draw_picture(drawing, moment, plane, style);
        if (!moment.is_painted()) draw_visible(drawing, moment, plane, style);
    }
    draw_frame(drawing, plane);
    if (!crowded) draw_outlines(drawing, moment, plane, style);
    if (options_.shows(Part::windows)) {
        draw_windows(drawing, moment, plane, style);
        draw_marks(drawing, moment, plane, style);
    }
    if (history) draw_chosen(drawing, history->pixel(), plane);
    draw_names(drawing, moment.scene(), plane, style);
    return drawing;
}

Drawing Figure::plane(const FloatingHorizonMoment& moment) const {
    const Style& style = options_.style;
    const bool has_legend = options_.shows(Part::windows);
    const double below = has_legend ? legend_height : 0;
    const Plane plane = plane_in(moment.scene().area, plane_width_, most_plane_height() - below);
    Drawing drawing{plane_width_, height_of(plane) + below};
    draw_frame(drawing, plane);
    if (options_.shows(Part::picture)) draw_lines(drawing, moment, plane);
    if (has_legend) {
        draw_horizons(drawing, moment, plane, style);
        draw_curve_at_hand(drawing, moment, plane, style);
        drawing.place(curve_legend(moment, style, plane_width_), {0, height_of(plane)});
    }
    return drawing;
}

void Figure::add(std::string caption, std::optional<Drawing> plane, std::vector<Drawing> texts) {
    const double width = (options_.shows_plane() ? plane_width_ : panel_width_) / options_.style.letters;
    if (!options_.is_film) caption = letter_of(captions_.size()) + " " + caption;
    captions_.push_back(wrapped(caption, text_size, width, width));
    caption_lines_ = std::max(caption_lines_, captions_.back().size());
    if (plane) append(planes_, std::move(*plane));
    texts_.resize(texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) append(texts_[i], std::move(texts[i]));
}

void Figure::add(const Moment& moment, const std::optional<PixelHistory>& history) {
    const Style& style = options_.style;
    std::optional<Drawing> drawn_plane;
    if (options_.shows_plane()) drawn_plane = plane(moment, history);
    std::vector<Drawing> texts;
    if (options_.shows(Part::list)) texts.push_back(list_part(moment, style, text_width_));
    if (options_.shows(Part::listing)) texts.push_back(listing_part(moment, style, text_width_));
    if (options_.shows(Part::history)) texts.push_back(history->part(style, text_width_));
    add(caption_of(moment, options_.style.language), std::move(drawn_plane), std::move(texts));
}

void Figure::add(const FloatingHorizonMoment& moment) {
    if (options_.shows(Part::list) || options_.shows(Part::history)) {
        throw Refused("a run of curves has no list and no history of pixels; use --show picture,windows,listing");
    }
    std::optional<Drawing> drawn_plane;
    if (options_.shows_plane()) drawn_plane = plane(moment);
    std::vector<Drawing> texts;
    if (options_.shows(Part::listing)) texts.push_back(listing_part(moment, options_.style, text_width_));
    add(caption_of(moment, options_.style.language), std::move(drawn_plane), std::move(texts));
}

Drawing Figure::panel(std::size_t moment) const {
    Drawing drawing{panel_width_, 0};
    double y = 0;
    if (options_.shows_plane()) {
        drawing.place(planes_.drawings[moment], {0, 0});
        y = planes_.height;
    }
    double text_y = is_beside() ? 0 : y;
    for (const auto& [drawings, height] : texts_) {
        if (text_y > 0) text_y += panel_gap / 2;
        drawing.place(drawings[moment], {panel_width_ - text_width_, text_y});
        text_y += height;
    }
    drawing.height = std::max(y, text_y);
    if (options_.moments > 1) {
        const double x = (options_.shows_plane() ? plane_width_ : panel_width_) / 2, top = drawing.height;
        drawing.height += line_height * double(caption_lines_);
        for (std::size_t i = 0; i < captions_[moment].size(); ++i) {
            const Point middle{x, top + line_height * double(i + 1) - 0.8};
            drawing.add(Label{captions_[moment][i], middle, text_size, Anchor::middle, false, ink});
        }
    }
    return drawing;
}

std::vector<Drawing> Figure::panels() const {
    std::vector<Drawing> panels;
    for (std::size_t i = 0; i < captions_.size(); ++i) panels.push_back(panel(i));
    return panels;
}

Drawing Figure::strip() const {
    const auto all = panels();
    const std::size_t rows = (all.size() + columns_ - 1) / columns_;
    const double height = all.front().height;
    Drawing strip{options_.width, double(rows) * height + panel_gap / 2 * double(rows - 1)};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t row = i / columns_, column = i % columns_;
        strip.place(all[i], {double(column) * (panel_width_ + panel_gap), double(row) * (height + panel_gap / 2)});
    }
    return strip;
}

}  // namespace vidno::figures
