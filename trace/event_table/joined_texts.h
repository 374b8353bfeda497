/// Joins texts, with a separator between them.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

/// `text` gives the text of an item.
std::string joined_texts(const auto& items, std::string_view between, auto&& text) {
    std::string all;
    for (const auto& item : items) all += std::string(all.empty() ? "" : between) + text(item);
    return all;
}

}  // namespace vidno
