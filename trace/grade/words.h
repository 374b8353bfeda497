/// Words: the sentences of a report in one language. The arguments replace the places {} in turn, or the numbered
/// places {0}, {1} and so on if the order differs between the languages.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "choice/language.h"
#include "format/fault_reason.h"
#include "grade/scene_truth.h"
#include "say/words.h"
#include "vidno/picture.h"

namespace vidno {

class Words {
public:
    explicit Words(Language language = Language::english) : language_(language) {}

    std::string_view of(const Bilingual& text) const { return text.in(language_); }

    std::string operator()(const Bilingual& text, const auto&... arguments) const {
        return say::filled(of(text), {said(arguments)...});
    }

    /// The reason of a fault.
    std::string reason(std::string_view text) const { return std::string(reason_in(language_, text)); }

    std::string said(std::string_view text) const { return std::string(text); }
    std::string said(const Bilingual& text) const { return std::string(of(text)); }
    std::string said(const std::string& text) const { return text; }
    std::string said(const char* text) const { return text; }
    std::string said(int number) const { return std::to_string(number); }
    std::string said(std::size_t number) const { return std::to_string(number); }
    std::string said(double number) const {
        std::string text = in_words(number);
        std::replace(text.begin(), text.end(), '.', of({".", ","}).front());
        return text;
    }
    std::string said(const Color& color) const { return in_words(color); }
    /// The corner of least coordinates, and the size.
    std::string said(const Window& w) const { return rectangle(point(w.x, w.y), said(w.width), said(w.height)); }
    std::string said(const PixelRectangle& r) const {
        return rectangle(point(r.x, r.y), said(r.width), said(r.height));
    }

    /// "(1, 2)", in Russian "(1; 2)"; three numbers for a vertex.
    std::string point(const auto&... coordinates) const {
        std::string text;
        (text.append(text.empty() ? "" : separator()).append(said(coordinates)), ...);
        return "(" + text + ")";
    }

private:
    std::string_view separator() const { return of({", ", "; "}); }
    std::string rectangle(const std::string& place, const std::string& width, const std::string& height) const {
        return (*this)({"{} of {} x {}", "{} размером {} × {}"}, place, width, height);
    }

    Language language_;
};

}  // namespace vidno
