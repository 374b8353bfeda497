#include "pixel_history.h"

#include "notation.h"
#include "table.h"
#include "wrap.h"

namespace vidno::figures {

void PixelHistory::take(const Moment& moment) {
    const EventView& event = *moment.event();
    const auto entry = story_.take(event, moment.state());
    if (!entry) return;
    const Line at = event.visit([](const auto& e) { return e.at; });
    entries_.push_back({moment.state().step(), at, entry->said.whole(), entry->outcome});
}

Drawing PixelHistory::part(const Style& style, double width) const {
    constexpr std::size_t most = 30;  // lines
    constexpr double share = 0.58;    // of the width for what was found
    const auto& words = words_of(style.language);
    const std::string_view meanings[]{words.yes, words.no, words.painted, words.wrong, ""};
    Table table{.title = std::string(words.pixel) + " " +
                         pair_of(std::to_string(pixel_.x), std::to_string(pixel_.y), style.language),
                .columns = {{std::string(words.step), 0.09, Anchor::end},
                            {std::string(words.line), 0.12},
                            {std::string(words.what), share},
                            {std::string(words.answer), 0.21}}};
    const double room = (share * width - 4) / style.letters;
    std::size_t first = entries_.size();
    for (; first > 0; --first) {
        const auto& [step, at, text, outcome] = entries_[first - 1];
        const auto lines = wrapped(text, text_size, room, room);
        if (table.rows.size() + lines.size() > most && !table.rows.empty()) break;
        std::vector<std::vector<Table::Cell>> rows;
        for (const auto& line : lines) rows.push_back({{}, {}, {line}, {}});
        rows[0][0].text = std::to_string(step);
        rows[0][1].text = line_names[std::size_t(at)];
        rows[0][3].text = meanings[std::size_t(outcome)];
        if (table.current) *table.current += rows.size();
        // The last one that painted it counts.
        if (outcome == say::Outcome::paint && !table.current) table.current = 0;
        table.rows.insert(table.rows.begin(), rows.begin(), rows.end());
    }
    if (first > 0) table.note = std::string(words.earlier) + " " + std::to_string(first);
    if (entries_.empty()) table.below.emplace_back(words.empty);
    if (!story_.why().empty()) table.below.push_back(story_.why());
    return drawn(table, width, style.letters);
}

}  // namespace vidno::figures
