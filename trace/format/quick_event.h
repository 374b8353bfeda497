/// QuickEvents: events out of lines as the program writes them: keys in the order of event.h, no spaces.
///
/// A line that is written otherwise, or wrong, is left to tree_event.h, which takes keys in any order and says what is wrong. What both
/// read is the same.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "format/tree_event.h"

namespace vidno {

class QuickEvents {
public:
    /// The context must outlive it.
    explicit QuickEvents(const EventContext& context) : context_(&context) {}

    /// The event lies here until the next line is read. None for a line that is written otherwise.
    std::optional<EventView> read(std::string_view line);

private:
    class Scanner;

    template <class E>
    std::optional<EventView> read_as(Scanner& scanner);
    template <class... Events>
    std::optional<EventView> read_one_of(EventTypes<Events...>, std::size_t place, Scanner& scanner);

    const EventContext* context_;
    std::array<std::shared_ptr<void>, AllEvents::count> events_;  // the last one of each type
};

}  // namespace vidno
