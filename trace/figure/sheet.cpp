#include "sheet.h"

#include "refused.h"
#include "scene/scene_names.h"
#include "table.h"

namespace vidno::figures {

namespace {

constexpr double title_size = 11;  // points

}  // namespace

void expect_at_most(std::size_t most, std::size_t count, const char* what, const std::string& file) {
    if (count <= most) return;
    throw Refused(file + ": " + std::to_string(count) + " " + what + ", but a worksheet takes at most " +
                  std::to_string(most));
}

Sheet::Sheet(const std::string& name, std::string method, Language language, bool answered,
             const std::optional<ChosenRows>& chosen)
    : name_(name),
      method_(std::move(method)),
      style_{language},
      words_(worksheet_words_of(language)),
      answered_(answered),
      chosen_(chosen) {}

void Sheet::add_page() {
    pages_.push_back({page_width, page_height});
    const double right = page_width - margin;
    double y = margin;
    const double room = text_width - width_of(method_, text_size) - part_gap;
    put(fitted(name_in(style_.language, name_), room, title_size, true), {margin, y}, title_size, Anchor::start, true);
    put(method_, {right, y}, text_size, Anchor::end);
    y += 2;
    rule(margin, right, y, 0.75);
    y += 8;
    if (answered_) {
        put(std::string(words_.key), {margin, y}, title_size, Anchor::start, true);
    } else {
        add_line_for(words_.name, margin, margin + 0.68 * text_width, y);
        add_line_for(words_.date, margin + 0.68 * text_width + part_gap, right, y);
    }
    const std::string number = std::string(words_.page) + " " + std::to_string(pages_.size());
    put(number, {right, page_height - margin / 2}, small_size, Anchor::end);
    y_ = y + 4;
}

void Sheet::add_line_for(std::string_view what, double from, double to, double y) {
    const std::string text(what);
    put(text, {from, y}, text_size);
    rule(from + width_of(text, text_size) + 1.5, to, y + 0.5, Stroke::hairline);
}

void Sheet::add_heading(std::string_view text, double x) {
    put(std::string(text), {x, y_ + heading_height - 2}, 9, Anchor::start, true);
}

void Sheet::add_note(std::string_view text) {
    y_ += line_height;
    put(fitted(std::string(text), text_width, small_size), {margin, y_}, small_size);
}

void Sheet::add_form(const Form& form, double width) {
    page().place(drawn(form, width, answered_), {margin, y_});
    y_ += form.height();
}

std::pair<std::size_t, std::size_t> Sheet::chosen_in(const std::vector<std::uint64_t>& steps) const {
    if (!chosen_) return {0, steps.size()};
    const auto is_chosen = [&](std::size_t place) {
        const std::uint64_t number = chosen_->are_steps ? steps[place] : place + 1;
        return chosen_->first <= number && number <= chosen_->last;
    };
    std::size_t first = 0;
    while (first < steps.size() && !is_chosen(first)) ++first;
    std::size_t end = first;
    while (end < steps.size() && is_chosen(end)) ++end;
    if (first == end)
        throw Refused("--" + std::string(chosen_->are_steps ? "steps" : "rows") + ": " + name_ +
                      " has no such row; rows in all: " + std::to_string(steps.size()));
    return {first, end};
}

void Sheet::add_rows(std::string_view title, const std::vector<Form::Column>& columns, std::vector<StepRow> answers,
                     const std::vector<std::string_view>& legend, const Numbering& numbering) {
    std::vector<std::uint64_t> steps;
    for (const auto& each : answers) steps.push_back(each.step);
    const auto [first, end] = chosen_in(steps);
    if (first > 0) {
        for (auto& cell : answers[first - 1].row) cell.is_given = true;
        for (std::size_t i = first; i < end; ++i) {
            for (std::size_t place = 0; place < numbering.places; ++place) answers[i].row[place].is_given = true;
        }
    }
    std::size_t done = first > 0 ? first - 1 : 0;
    for (std::size_t pages = 0; pages == 0 || (done < end && (chosen_ || pages < most_pages_of_rows)); ++pages) {
        if (pages > 0) add_page();
        add_heading(title);
        y_ += heading_height;
        Form form{columns, {}};
        const double room = text_bottom - y_ - Form::heading_height - double(legend.size() + 1) * line_height;
        for (auto left = std::size_t(room / form.row_height); left > 0 && (!chosen_ || done < end); --left, ++done) {
            Row row = done < end ? std::move(answers[done].row) : Row(columns.size() - numbering.are_numbered);
            if (numbering.are_numbered) row.insert(row.begin(), {std::to_string(done + 1), true});
            form.rows.push_back(std::move(row));
        }
        add_form(form, text_width);
        y_ += 0.6;
        for (const auto line : legend) add_note(line);
    }
    if (done < answers.size()) add_note(std::string(words_.rows_here) + " " + std::to_string(done) + ".");
}

}  // namespace vidno::figures
