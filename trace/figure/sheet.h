/// Sheet: the pages of a worksheet on A4, blank or answered: their heads, headings, notes and long tables.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "form.h"
#include "parts.h"
#include "worksheet.h"
#include "worksheet_words.h"

namespace vidno::figures {

/// Refuses a file that has more of something than a worksheet takes.
void expect_at_most(std::size_t most, std::size_t count, const char* what, const std::string& file);

class Sheet {
protected:
    static constexpr double page_width = 210, page_height = 297, margin = 18;
    static constexpr double text_width = page_width - 2 * margin, text_bottom = page_height - margin;
    static constexpr double part_gap = 5, heading_height = 7;
    static constexpr std::size_t most_pages_of_rows = 2;

    using Row = std::vector<Form::Cell>;
    struct StepRow {
        std::uint64_t step;
        Row row;
    };
    struct Numbering {
        bool are_numbered;
        std::size_t places;  // how many of the first columns say where a row is
    };

    Sheet(const std::string& name, std::string method, Language language, bool answered,
          const std::optional<ChosenRows>& chosen);

    const Style& style() const { return style_; }
    Language language() const { return style_.language; }
    const WorksheetWords& words() const { return words_; }
    bool is_answered() const { return answered_; }
    bool has_chosen() const { return chosen_.has_value(); }
    std::vector<Drawing> taken_pages() { return std::move(pages_); }

    void add_page();
    Drawing& page() { return pages_.back(); }

    void put(std::string text, Point at, double size, Anchor anchor = Anchor::start, bool bold = false) {
        page().add(Label{std::move(text), at, size, anchor, bold, ink});
    }
    void add_heading(std::string_view text, double x = margin);
    void add_note(std::string_view text);
    /// Adds a form with its rows at the left margin.
    void add_form(const Form& form, double width);

    /// The rows that are answered, as a range of places in all of them, which begin at these steps. Throws Refused if
    /// there are none.
    std::pair<std::size_t, std::size_t> chosen_in(const std::vector<std::uint64_t>& steps) const;

    /// Adds rows to the end of the page, whether they have answers or not, so that their number gives no hint, unless
    /// rows are chosen.
    void add_rows(std::string_view title, const std::vector<Form::Column>& columns, std::vector<StepRow> answers,
                  const std::vector<std::string_view>& legend, const Numbering& numbering);

    double y_ = 0;  // where the next part of the page begins, in millimetres from its top

private:
    void rule(double from, double to, double y, double width) {
        page().add(Path{{{{from, y}, {to, y}}}, false, {}, Stroke{ink, width}});
    }
    void add_line_for(std::string_view what, double from, double to, double y);

    std::string name_, method_;
    Style style_;
    const WorksheetWords& words_;
    bool answered_;
    std::optional<ChosenRows> chosen_;
    std::vector<Drawing> pages_;
};

}  // namespace vidno::figures
