#include "say/pixel_history.h"

#include <array>
#include <charconv>
#include <type_traits>
#include <utility>

#include "format/paints.h"
#include "say/scene_facts.h"
#include "say/sentence.h"
#include "say/warnock_words.h"

namespace vidno::say {

namespace {

using Found = std::optional<Outcome>;

constexpr Outcome test(bool passed) { return passed ? Outcome::pass : Outcome::fail; }
constexpr Found noted(bool concerns) { return concerns ? Found(Outcome::note) : std::nullopt; }
constexpr Found painted(bool concerns) { return concerns ? Found(Outcome::paint) : std::nullopt; }
constexpr bool is_in(int x, int first, int end) { return first <= x && x < end; }

bool overlaps(const Window& window, Pixel pixel) {
    return window.x < pixel.x + 1 && window.right() > pixel.x && window.y < pixel.y + 1 && window.bottom() > pixel.y;
}

/// The windows that contain the pixel, and the findings about them.
struct WarnockJudge {
    Pixel pixel;
    const PixelWatch::Memory& memory;
    Detail detail;

    Found operator()(const event::Push& e) const { return noted(overlaps(e.window, pixel)); }
    Found operator()(const event::Fill& e) const { return painted(paints(e, pixel.x, pixel.y)); }
    Found operator()(const event::Draw& e) const {
        return paints(e, pixel.x, pixel.y) ? Found(Outcome::paint) : within(Outcome::fail);
    }
    Found operator()(const event::Fault& e) const {
        return e.x == pixel.x && e.y == pixel.y ? Found(Outcome::wrong) : std::nullopt;
    }

    Found operator()(const event::Pop&) const { return within(Outcome::note); }
    Found operator()(const event::Box& e) const { return within(test(!e.outside)); }
    Found operator()(const event::Discard&) const { return within(Outcome::fail); }
    Found operator()(const event::Count&) const { return within(Outcome::pass); }
    /// At the level of signs the following comparison includes the depth.
    Found operator()(const event::Depth&) const {
        return detail == Detail::signs ? std::nullopt : within(Outcome::note);
    }
    Found operator()(const event::Compare& e) const { return within(test(e.nearer)); }
    Found operator()(const event::Nearer& e) const { return within(test(e.k > 0)); }
    Found operator()(const event::Uncover&) const { return within(Outcome::note); }
    /// Orientations count only at the pixel's centre.
    Found operator()(const event::Orient&) const { return memory.is_at_centre ? within(Outcome::note) : std::nullopt; }
    Found operator()(const event::Surround& e) const { return within(test(e.inside)); }
    Found operator()(const event::Mark&) const { return within(Outcome::pass); }
    Found operator()(const event::Cover&) const { return within(Outcome::pass); }
    Found operator()(const event::Insider& e) const { return within(test(e.inside)); }
    Found operator()(const event::Summary&) const { return within(Outcome::note); }
    Found operator()(const event::Decide&) const { return within(Outcome::note); }
    Found operator()(const event::Nearest&) const { return within(Outcome::pass); }
    Found operator()(const event::PointColor&) const { return within(Outcome::note); }
    Found operator()(const event::BackFace& e) const { return within(test(!e.away)); }
    Found operator()(const event::Rejoin&) const { return within(Outcome::note); }
    Found operator()(const event::Join&) const { return within(Outcome::note); }
    Found operator()(const event::RelationFound& e) const { return within(test(e.relation != Relation::outside)); }
    Found operator()(const event::Meets&) const { return within(Outcome::note); }
    Found operator()(const event::Crossings&) const { return within(Outcome::note); }
    Found operator()(const event::Angle&) const { return within(Outcome::note); }
    Found operator()(const event::Hiding& e) const { return within(test(e.polygon.has_value())); }
    Found operator()(const event::SplitVertex& e) const { return e.splits ? within(Outcome::note) : std::nullopt; }
    Found operator()(const event::EdgeDepth&) const { return within(Outcome::note); }
    Found operator()(const event::ClipResult& e) const { return within(test(!e.vertices.empty())); }
    Found operator()(const event::Row& e) const {
        return e.row == pixel.y ? within(test(is_in(pixel.x, e.first, e.end))) : std::nullopt;
    }
    Found operator()(const event::Disagree&) const {
        return !memory.row || *memory.row == pixel.y ? within(Outcome::wrong) : std::nullopt;
    }

private:
    /// The outcome for the pixels of the current window.
    Found within(Outcome outcome) const {
        return memory.window && overlaps(*memory.window, pixel) ? Found(outcome) : std::nullopt;
    }
};

/// The lines on the pixel's row, and on these what is at its column.
struct ZBufferJudge {
    Pixel pixel;
    const PixelWatch::Memory& memory;

    Found operator()(const event::Clear&) const { return Outcome::paint; }
    Found operator()(const event::ShownLine& e) const { return noted(e.row == pixel.y); }
    Found operator()(const event::Miss&) const { return memory.is_on_row ? Found(Outcome::fail) : std::nullopt; }
    Found operator()(const event::Columns& e) const {
        return memory.is_on_row ? Found(test(is_in(pixel.x, e.first, e.end))) : std::nullopt;
    }
    Found operator()(const event::Pixel& e) const {
        return e.x == pixel.x && e.y == pixel.y ? Found(test(e.shown)) : std::nullopt;
    }
    Found operator()(const event::Span& e) const {
        if (e.row != pixel.y) return std::nullopt;
        return paints(e, pixel.x, pixel.y) ? Outcome::paint : Outcome::fail;
    }
    Found operator()(const event::Fault& e) const {
        return e.x == pixel.x && e.y == pixel.y ? Found(Outcome::wrong) : std::nullopt;
    }
    Found operator()(const event::Disagree&) const {
        return memory.said_at == memory.step - 1 ? Found(Outcome::wrong) : std::nullopt;
    }
};

/// The pieces over the pixel's centre, what clips them, what is behind, and the visible region.
struct RegionJudge {
    Pixel pixel;
    const PixelWatch::Memory& memory;
    const WeilerAthertonState& after;

    Found operator()(const event::CutToArea& e) const { return noted(is_over(e.region)); }
    Found operator()(const event::Split& e) const { return noted(is_over(e.region) || is_over(e.other)); }
    Found operator()(const event::PopList&) const {
        const auto& pieces = list()->pieces;
        return noted(
            std::any_of(pieces.begin(), pieces.end(), [this](const auto& each) { return is_over(each->region); }));
    }
    Found operator()(const event::Beside&) const {
        return noted(is_over(list()->pieces[std::size_t(list()->seen) - 1]->region));
    }
    Found operator()(const event::Clipped& e) const {
        if (e.at == Line::SP1 || !(is_over(e.inside) || is_over(e.outside))) return std::nullopt;
        return test(is_over(e.inside));
    }
    Found operator()(const event::Behind& e) const {
        auto place = list()->behind.size();  // that of the part among those inside that are not ground, from 1
        for (const auto& part : list()->inside) {
            if (part->ground || --place > 0) continue;
            return is_over(part->region) ? Found(test(!e.behind)) : std::nullopt;
        }
        return std::nullopt;
    }
    Found operator()(const event::Show& e) const { return is_over(e.region) ? Found(Outcome::pass) : std::nullopt; }
    Found operator()(const event::Order& e) const {
        const bool is_here = number_of(e.point.x) == pixel.x + .5 && number_of(e.point.y) == pixel.y + .5;
        return is_here ? Found(test(e.order == Sign::positive)) : std::nullopt;
    }
    Found operator()(const event::Paint& e) const { return painted(paints(e, pixel.x, pixel.y)); }
    Found operator()(const event::Disagree&) const {
        return memory.said_at == memory.step - 1 ? Found(Outcome::wrong) : std::nullopt;
    }

private:
    const std::optional<WeilerAthertonState::CurrentList>& list() const { return after.current_list(); }

    /// Whether the region contains the pixel's centre; one on the outline may count as either. Doubles are accurate
    /// enough to show.
    bool is_over(const RegionLoops& region) const {
        bool inside = false;
        for (const auto& loop : region) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                if (crosses(loop[i], loop[(i + 1) % loop.size()])) inside = !inside;
            }
        }
        return inside;
    }
    /// Whether the edge crosses the horizontal ray from the centre to the right.
    bool crosses(const ValuePoint& from, const ValuePoint& to) const {
        const double x = pixel.x + .5, y = pixel.y + .5;
        const double x1 = number_of(from.x), y1 = number_of(from.y), x2 = number_of(to.x), y2 = number_of(to.y);
        return (y1 > y) != (y2 > y) && x < x1 + (y - y1) * (x2 - x1) / (y2 - y1);
    }
};

/// Every curve's height and flag over a column, the lines, and the changes of the horizons.
struct ColumnJudge {
    int x;
    const PixelWatch::Memory& memory;
    const FloatingHorizonHeader& header;

    Found operator()(const event::Height& e) const { return noted(e.x == x); }
    Found operator()(const event::Visibility& e) const {
        if (e.x != x) return std::nullopt;
        // The printed text finds such a point below, but does not draw it.
        const bool is_lost = e.flag == VisibilityFlag::below && header.edition.has(Deviation::x_h1);
        return is_lost ? Outcome::note : test(e.flag != VisibilityFlag::hidden);
    }
    Found operator()(const event::DrawLine& e) const {
        return painted(e.from_columns.second <= x && x <= e.to_columns.first);
    }
    Found operator()(const event::Intersection& e) const {
        return noted(e.columns.first <= x && x <= e.columns.second);
    }
    /// At the level of signs each change of a horizon has an event of its own.
    Found operator()(const event::Horizon& e) const {
        return noted(header.detail == Detail::polygons && (is_among(e.upper) || is_among(e.lower)));
    }
    Found operator()(const event::Raise& e) const { return noted(e.x == x); }
    Found operator()(const event::Lower& e) const { return noted(e.x == x); }
    Found operator()(const event::Step& e) const { return noted(e.x == x); }
    Found operator()(const event::Disagree&) const {
        return memory.said_at == memory.step - 1 ? Found(Outcome::wrong) : std::nullopt;
    }

private:
    bool is_among(const std::vector<ColumnHeight>& changes) const {
        return std::any_of(changes.begin(), changes.end(),
                           [this](const ColumnHeight& each) { return each.first == x; });
    }
};

/// What a judge finds; it judges no events without a function of its own.
template <class Judge>
Found found_by(const Judge& judge, const EventView& event) {
    return event.visit([&]<class E>(const E& e) -> Found {
        if constexpr (std::is_invocable_v<const Judge&, const E&>) return judge(e);
        return std::nullopt;
    });
}

using NameSet = std::array<bool, AllEvents::count>;

template <class Judge, class... Events>
constexpr NameSet judged_in(EventTypes<Events...>) {
    return {std::is_invocable_v<const Judge&, const Events&>...};
}
/// The events that a judge judges, and others that the watch follows.
template <class Judge, class... Followed>
constexpr NameSet names_for() {
    NameSet names = judged_in<Judge>(AllEvents{});
    ((names[event_place<Followed>] = true), ...);
    return names;
}
template <class... Events>
constexpr NameSet only() {
    NameSet names{};
    ((names[event_place<Events>] = true), ...);
    return names;
}

/// Whether a line clearly has another number under a key, which is given with its quotes and its colon.
bool has_other(std::string_view line, std::string_view key, int number) {
    const auto at = line.find(key);
    if (at == line.npos || line.find('\\') != line.npos) return false;
    int found = 0;
    const char* const last = line.data() + line.size();
    const auto [end, error] = std::from_chars(line.data() + at + key.size(), last, found);
    return error == std::errc{} && end != last && (*end == ',' || *end == '}') && found != number;
}

/// Windows without the pixel are passed over, except for what leads out of them.
bool needs_in_warnock(std::size_t name, Pixel pixel, const PixelWatch::Memory& memory, Detail detail) {
    static constexpr NameSet inside = names_for<WarnockJudge, event::Call>();
    static constexpr NameSet outside =
        only<event::Push, event::Pop, event::Fill, event::Draw, event::Fault, event::Call>();
    if (!memory.window || !overlaps(*memory.window, pixel)) return outside[name];
    if (name == event_place<event::Orient>) return memory.is_at_centre;
    if (name == event_place<event::Depth>) return detail != Detail::signs;
    return inside[name];
}

bool needs_in_z_buffer(std::size_t name, const PixelWatch::Memory& memory) {
    static constexpr NameSet on_row = names_for<ZBufferJudge, event::Polygon>();
    static constexpr NameSet off_row =
        only<event::Clear, event::Polygon, event::ShownLine, event::Span, event::Fault, event::Disagree>();
    return (memory.is_on_row ? on_row : off_row)[name];
}

/// Keeps what later events refer to.
struct Remember {
    PixelWatch::Memory& memory;

    void operator()(const event::Pop& e) const { memory.window = e.window; }
    void operator()(const event::Call& e) const { memory.is_at_centre = e.at == Line::PC2; }
    void operator()(const event::Row& e) const { memory.row = e.row; }
    void operator()(const event::Polygon& e) const { memory.polygon = e.polygon; }
    void operator()(const event::Curve& e) const { memory.curve = e.curve; }
    void operator()(const auto&) const {}
};

}  // namespace

PixelWatch::PixelWatch(Pixel pixel, const TraceHeader& header) : pixel_(pixel), header_(&header) {
    if (algorithm_of(header.method) == Algorithm::weiler_atherton) regions_.emplace(header);
}

bool PixelWatch::needs(std::size_t name) const {
    static constexpr NameSet in_column = names_for<ColumnJudge, event::Curve>();
    if (header_.index() == 1) return in_column[name];
    switch (algorithm_of(header().method)) {
        case Algorithm::warnock: return needs_in_warnock(name, pixel_, memory_, header().detail);
        case Algorithm::z_buffer: return needs_in_z_buffer(name, memory_);
        case Algorithm::weiler_atherton: return true;
    }
    return true;
}

/// Most lines are on other rows, most pixels of a row in other columns, and so are most heights of curves.
bool PixelWatch::is_elsewhere(std::size_t name, std::string_view line) const {
    static constexpr NameSet of_row = only<event::ShownLine, event::Span>();
    static constexpr NameSet of_column =
        only<event::Pixel, event::Height, event::Visibility, event::Raise, event::Lower, event::Step>();
    if (of_column[name]) return has_other(line, R"("x":)", pixel_.x);
    return of_row[name] && !memory_.is_on_row && has_other(line, R"("row":)", pixel_.y);
}

Found PixelWatch::judged(const EventView& event) const {
    if (const auto* of_curves = std::get_if<const FloatingHorizonHeader*>(&header_)) {
        return found_by(ColumnJudge{pixel_.x, memory_, **of_curves}, event);
    }
    switch (algorithm_of(header().method)) {
        case Algorithm::warnock: return found_by(WarnockJudge{pixel_, memory_, header().detail}, event);
        case Algorithm::z_buffer: return found_by(ZBufferJudge{pixel_, memory_}, event);
        case Algorithm::weiler_atherton:
            return found_by(RegionJudge{pixel_, memory_, regions_->weiler_atherton()}, event);
    }
    return std::nullopt;
}

Found PixelWatch::see(const EventView& event, std::uint64_t step) {
    // The row is that of the event before, or of the one before events Disagree.
    const bool follows = event.get_if<event::Disagree>() != nullptr && memory_.step == step - 1;
    if (!follows) memory_.row.reset();
    memory_.step = step;
    event.visit(Remember{memory_});
    if (regions_) regions_->apply(event);
    const Found outcome = judged(event);
    if (outcome) memory_.said_at = step;
    // ShowLine begins with its row and ends with the span.
    if (const auto* line = event.get_if<event::ShownLine>()) memory_.is_on_row = line->row == pixel_.y;
    if (event.get_if<event::Span>()) memory_.is_on_row = false;
    return outcome;
}

Heading PixelWatch::heading(const EventView& event) const {
    if (memory_.window) return *memory_.window;
    if (memory_.polygon) return *memory_.polygon;
    if (memory_.curve) return *memory_.curve;
    if (!regions_) return {};
    // Once regions are painted no list is current.
    if (const auto* paint = event.get_if<event::Paint>()) return paint->polygon;
    if (const auto* order = event.get_if<event::Order>()) return order->polygon;
    const auto& list = regions_->weiler_atherton().current_list();
    return list ? Heading(list->pieces[0]->polygon) : Heading();
}

Statement sentence_for_pixel(const EventView& event, Outcome outcome, const State& after, Language language) {
    const PolygonWords words(after, language);
    const auto* draw = event.get_if<event::Draw>();
    if (draw && outcome == Outcome::fail) {
        return stated(words.say("{} does not cover the centre of this pixel, which stays as it is.",
                                "{} не покрывает центра этого пикселя: пиксель остаётся прежним.", draw->polygon),
                      exactly(event, words), words);
    }
    const auto polygon = after.z_buffer().polygon();
    if (event.get_if<event::Span>() && outcome == Outcome::fail && polygon) {
        return {
            words.say("On this row {} leaves the pixel as it is.", "В этой строке {} не меняет пикселя.", *polygon)};
    }
    return sentence(event, after, language);
}

Statement sentence_for_pixel(const EventView& event, Outcome, const FloatingHorizonState& after, Language language) {
    return sentence(event, after, language);
}

namespace {

/// A reason, and whether the pixel has the colour of the background.
struct Reason {
    std::string text;
    bool is_background = false;
};

/// The polygon with the colour, or all with that colour if the trace does not say which.
std::string owner_of(const event::Fill& e, const WarnockWords& words) {
    constexpr std::size_t most = 3;
    auto owners = words.owners(e).polygons;
    if (owners.size() > most) {
        owners.resize(most);
        owners.emplace_back("…");
    }
    return joined(owners, " / ");
}

struct ReasonOf {
    const State& after;
    const WarnockWords words;
    using enum Line;

    /// A window gets one colour, for the reason of its line.
    Reason operator()(const event::Fill& e) const {
        if (words.is_at(e, {W7, WS4, WF5})) {
            return {words.say("no polygon is left in this window.", "в этом окне не осталось многоугольников."), true};
        }
        if (words.is_at(e, {W10, WF6})) {
            return {
                words.say("as this run computes it, the only polygon in this window does not cover the centre of the "
                          "pixel.",
                          "по вычислениям этого прогона единственный многоугольник в окне не покрывает центр "
                          "пикселя."),
                true};
        }
        const std::string owner = owner_of(e, words);
        if (words.is_at(e, {W8, WF9, WF10})) {
            return {words.say("{} surrounds this window and hides everything else in it.",
                              "{} охватывает это окно и закрывает в нём всё остальное.", owner),
                    owner.empty()};
        }
        if (owner.empty()) {
            return {words.say("no polygon covers its centre.", "его центр не покрыт ни одним многоугольником."), true};
        }
        return {words.say("{} is the nearest of all that cover its centre.",
                          "из всех, что покрывают его центр, {} ближе всех.", owner)};
    }
    Reason operator()(const event::Draw& e) const {
        return {words.say("{} is alone in this window and covers the centre of the pixel.",
                          "в этом окне только {}, и он покрывает центр пикселя.", e.polygon)};
    }
    Reason operator()(const event::Span&) const {
        const auto polygon = after.z_buffer().polygon();
        if (!polygon) return (*this)(0);
        if (after.header().edition.has(Deviation::x_z7)) {
            return {words.say(
                "{} is here at least as near as everything drawn before, and nothing drawn later replaced it.",
                "{} здесь не дальше любого из нарисованных до него, и потом его ничто не заменило.", *polygon)};
        }
        return {words.say("{} is nearer here than everything drawn before, and nothing drawn later replaced it.",
                          "{} здесь ближе, чем всё нарисованное раньше, а нарисованное позже пикселя не изменило.",
                          *polygon)};
    }
    Reason operator()(const event::Paint& e) const {
        return {words.say("its centre lies in a visible region, where {} is the nearest.",
                          "его центр лежит в видимой области, где ближе всех {}.", e.polygon)};
    }
    Reason operator()(const auto&) const {
        return {words.say("no polygon was drawn at this pixel.", "ни один многоугольник его не закрасил."), true};
    }
};

/// A number of a step, its thousands apart.
std::string step_in(const Words& words, std::uint64_t step) {
    std::string text = std::to_string(step);
    for (auto at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), words.say(",", "\u00a0"));
    return text;
}

}  // namespace

GoesWrong::GoesWrong(Pixel pixel, const TraceHeader& header) {
    if (!can_be_wrong(header)) return;
    const auto shown = SceneFacts(header).shown(pixel.x, pixel.y);
    if (shown) owner_ = shown->polygon;
}

bool GoesWrong::needs(const EventView& event) const {
    const auto* discard = event.get_if<event::Discard>();
    return discard && owner_ == discard->polygon.index;
}

void GoesWrong::see(const EventView& event, const State& after) {
    const auto& window = after.warnock().current();
    if (window && needs(event)) left_list_[window->list] = after.step();
}

void GoesWrong::hear(std::uint64_t step, const Statement& said) {
    if (said.exactly.empty()) {
        is_wrong_ = false;
    } else if (!std::exchange(is_wrong_, true)) {
        wrong_since_ = step;
    }
}

std::optional<std::uint64_t> GoesWrong::step(const State& after) const {
    const auto& window = after.warnock().current();
    const auto left = window ? left_list_.find(window->list) : left_list_.end();
    return left == left_list_.end() ? wrong_since_ : std::optional(left->second);
}

Statement why(const EventView& event, const State& after, Pixel pixel, std::optional<std::uint64_t> wrong_at,
              Language language, bool is_later) {
    const WarnockWords words{PolygonWords(after, language)};
    const auto [reason, is_background] = event.visit(ReasonOf{after, words});
    auto so = exactly_at(pixel.x, pixel.y, words);
    if (so) {
        so->text += wrong_at ? words.say(" The run goes wrong at step {}.", " Прогон ошибается на шаге {}.",
                                         step_in(words, *wrong_at))
                             : words.say(" The steps of this trace do not tell where the run goes wrong.",
                                         " По шагам этой трассы не видно, где прогон ошибается.");
    } else {
        so = exactly(event, words);
    }
    Statement said = stated(reason, so, words);
    const std::string step = step_in(words, after.step());
    if (is_background) {
        said.text = is_later ? words.say("Why it becomes background at step {}: {}",
                                         "Почему на шаге {} здесь будет фон: {}", step, said.text)
                             : words.say("Why it is background: {}", "Почему здесь фон: {}", said.text);
    } else {
        said.text = is_later ? words.say("Why it gets this colour at step {}: {}",
                                         "Почему на шаге {} он получит этот цвет: {}", step, said.text)
                             : words.say("Why it has this colour: {}", "Почему у него такой цвет: {}", said.text);
    }
    return said;
}

}  // namespace vidno::say
