/// QuickEvents: reads events from lines in the form that the program writes: keys in the order of event.h, no spaces.
///
/// Lines in another form, or with errors, are left to tree_event.h, which takes keys in any order and reports errors.
/// Both readers agree on the lines that both read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "format/tree_event.h"

namespace vidno {

class QuickEvents {
public:
    /// The context must outlive this object.
    explicit QuickEvents(const EventContext& context) : context_(&context) {}

    /// The event is valid until the next line is read. None for a line in another form.
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
