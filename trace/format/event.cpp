#include "format/event.h"

namespace vidno {

Event EventView::copy() const {
    return visit([](const auto& event) { return Event(event); });
}

}  // namespace vidno
