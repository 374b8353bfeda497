/// Language: the languages of the program's texts, and what there is once for each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

namespace vidno {

enum class Language : unsigned char { english, russian };
inline constexpr std::array<std::string_view, 2> language_codes{"en", "ru"};

constexpr std::string_view code_of(Language language) { return language_codes[std::size_t(language)]; }

inline constexpr auto languages = [] {
    std::array<Language, language_codes.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = Language(i);
    return all;
}();

/// One T for each language. Where one is missing, the compiler warns.
template <class T>
struct InEachLanguage {
    T english, russian;

    constexpr const T& in(Language language) const {
        switch (language) {
            case Language::english: return english;
            case Language::russian: return russian;
        }
        std::abort();
    }
    constexpr T& in(Language language) { return const_cast<T&>(std::as_const(*this).in(language)); }
};

/// `make(language)` for each language.
auto in_each_language(auto&& make) {
    InEachLanguage<decltype(make(Language{}))> made{};
    for (const Language language : languages) made.in(language) = make(language);
    return made;
}

/// The object of JSON with a member for each language, by its code.
template <class Json, class T>
Json object_of(const InEachLanguage<T>& texts) {
    Json object = Json::object();
    for (const Language language : languages) object[std::string(code_of(language))] = texts.in(language);
    return object;
}

using Bilingual = InEachLanguage<std::string_view>;

}  // namespace vidno
