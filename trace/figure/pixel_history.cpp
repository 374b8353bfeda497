#include "pixel_history.h"

#include "format/paints.h"
#include "notation.h"
#include "table.h"

namespace vidno::figures {

namespace {

/// The meaning of an event for the pixel.
struct Meaning {
    std::optional<bool> answer{};
    bool painted = false;
};
constexpr Meaning fact{}, yes{true}, no{false}, paint{true, true};
constexpr Meaning test(bool passed) { return passed ? yes : no; }

/// Interprets an event by the pixel's place. In a window or row that does not contain the pixel, only painting concerns
/// it.
class Judge {
public:
    Judge(Pixel pixel, bool& inside) : pixel_(pixel), inside_(inside) {}

    using Found = std::optional<Meaning>;

    Found operator()(const event::Pop& e) {
        const auto& [x, y, width, height] = e.window;
        inside_ = x < pixel_.x + 1 && x + width > pixel_.x && y < pixel_.y + 1 && y + height > pixel_.y;
        return within(fact);
    }
    Found operator()(const event::Discard&) { return within(no); }
    Found operator()(const event::Nearer& e) { return within(test(e.k > 0)); }
    Found operator()(const event::Mark&) { return within(yes); }
    Found operator()(const event::Cover&) { return within(yes); }
    Found operator()(const event::Uncover&) { return within(fact); }
    Found operator()(const event::Nearest&) { return within(yes); }
    Found operator()(const event::Decide&) { return within(fact); }
    Found operator()(const event::Draw& e) { return covers(e) ? Found(paint) : within(no); }
    Found operator()(const event::Clear&) { return paint; }
    Found operator()(const event::ShownLine& e) {
        inside_ = e.row == pixel_.y;
        return std::nullopt;
    }
    Found operator()(const event::Columns& e) { return within(test(e.first <= pixel_.x && pixel_.x < e.end)); }
    Found operator()(const event::Pixel& e) {
        return e.x == pixel_.x && e.y == pixel_.y ? Found(test(e.shown)) : std::nullopt;
    }
    Found operator()(const event::Span& e) {
        if (e.row != pixel_.y) return std::nullopt;
        return covers(e) ? paint : no;
    }
    Found operator()(const event::Fault& e) { return e.x == pixel_.x && e.y == pixel_.y ? Found(no) : std::nullopt; }
    Found operator()(const auto& e) { return covers(e) ? Found(paint) : std::nullopt; }

private:
    bool covers(const auto& e) const { return paints(e, pixel_.x, pixel_.y); }
    Found within(Meaning meaning) const { return inside_ ? Found(meaning) : std::nullopt; }

    Pixel pixel_;
    bool& inside_;
};

}  // namespace

void PixelHistory::take(const Moment& moment) {
    const EventView& event = *moment.event();
    const auto found = event.visit(Judge(pixel_, inside_));
    if (!found) return;
    const Line at = event.visit([](const auto& e) { return e.at; });
    std::string note = note_of(event, moment.scene(), language_);
    const auto polygon = moment.state().z_buffer().polygon();
    const bool of_line = event.get_if<event::Span>() || event.get_if<event::Pixel>() || event.get_if<event::Columns>();
    if (of_line && polygon) note = moment.scene().polygons[std::size_t(polygon->index)].id + ": " + note;
    entries_.push_back({moment.state().step(), at, std::move(note), found->answer, found->painted});
}

Drawing PixelHistory::part(const Style& style, double width) const {
    constexpr std::size_t most = 30;
    const auto& words = words_of(style.language);
    Table table{.title = std::string(words.pixel) + " " +
                         pair_of(std::to_string(pixel_.x), std::to_string(pixel_.y), style.language),
                .columns = {{std::string(words.step), 0.13, Anchor::end},
                            {std::string(words.line), 0.17},
                            {std::string(words.what), 0.46},
                            {std::string(words.answer), 0.24}}};
    const std::size_t first = entries_.size() > most ? entries_.size() - most : 0;
    if (first > 0) table.note = std::string(words.earlier) + " " + std::to_string(first);
    for (std::size_t i = first; i < entries_.size(); ++i) {
        const auto& [step, at, note, answer, painted] = entries_[i];
        const std::string_view meaning = painted ? words.painted : !answer ? "" : *answer ? words.yes : words.no;
        if (painted) table.current = table.rows.size();  // the last one counts
        table.rows.push_back(
            {{std::to_string(step)}, {std::string(line_names[std::size_t(at)])}, {note}, {std::string(meaning)}});
    }
    if (entries_.empty()) table.below.emplace_back(words.empty);
    return drawn(table, width, style.letters);
}

}  // namespace vidno::figures
