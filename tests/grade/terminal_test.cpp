/// Text of strangers, as a terminal may show it.
#include <doctest/doctest.h>

#include <string>

#include "characters.h"

using namespace vidno;

TEST_CASE("what could control a terminal is shown as an escape") {
    struct Example {
        std::string text, shown;
    };
    const Example examples[] = {
        {"plain text, äöü, Привет, 𝛼", "plain text, äöü, Привет, 𝛼"},
        {"", ""},
        {"\x1b[2J", "\\x1b[2J"},                // clears the screen
        {"a\nright: b", "a\\nright: b"},        // a line of its own
        {"a\rb\tc\x07", "a\\x0db\\x09c\\x07"},  // C0
        {std::string("a\0b", 3), "a\\x00b"},    // ends a C string
        {"\x7f", "\\x7f"},                      // DEL
        {"\xc2\x9b"
         "2J",
         "\\u009b2J"},  // U+009B, CSI in one character
        {"\xe2\x80\xae"
         "cba",
         "\\u202ecba"},                                // U+202E, right to left
        {"\xe2\x81\xa6", "\\u2066"},                   // U+2066, an isolate
        {"\xef\xbb\xbf", "\\ufeff"},                   // no width
        {"\xff", "\\xff"},                             // no beginning of a character
        {"\x80\xbf", "\\x80\\xbf"},                    // no beginning either
        {"\xc3", "\\xc3"},                             // cut short
        {"\xc3(", "\\xc3("},                           // broken off
        {"\xc0\x8a", "\\xc0\\x8a"},                    // a newline in two bytes
        {"\xed\xa0\x80", "\\xed\\xa0\\x80"},           // half of a pair, U+D800
        {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},  // U+110000, beyond Unicode
        {"\xf0\x9d\x9b", "\\xf0\\x9d\\x9b"},           // three bytes of four
    };
    for (const auto& [text, shown] : examples) CHECK(escaped_for_terminal(text) == shown);
}

TEST_CASE("a text of several lines keeps its lines") {
    CHECK(escaped_for_terminal("one\n\ttwo\x1b\n", "\n\t") == "one\n\ttwo\\x1b\n");
}
