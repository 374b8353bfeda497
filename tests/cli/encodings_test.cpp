/// Each kind of text that the program reads, as other programs save it: with a byte order mark, with lines that end in
/// CR LF or CR, and in UTF-16, which is refused by that name.
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "support/workplace.h"

namespace {

std::string with_line_ends(const std::string& text, const std::string& end) {
    std::string out;
    for (const char c : text) out += c == '\n' ? end : std::string(1, c);
    return out;
}

/// In UTF-16, as far as the text is ASCII.
std::string in_utf_16(const std::string& text, bool big_endian, bool has_mark) {
    std::string out = !has_mark ? "" : big_endian ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x80) out += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    }
    return out;
}

struct Read {
    std::string name, text, command;  // the command reads IN and writes OUT
};

std::vector<Read> every_kind(const Workplace& work) {
    const auto lesson = [](const std::string& file) { return text_of(VIDNO_ROOT "/lessons/" + file); };
    const std::string trace = work.file("made.jsonl");
    REQUIRE(program("trace " VIDNO_ROOT "/lessons/05-polygon-clip/scene.json -o " + trace).status == 0);
    return {{"in.json", lesson("05-polygon-clip/scene.json"), "render IN -o OUT.ppm"},
            {"in.json", lesson("surfaces/waves-and-pit.json"), "render IN -o OUT.ppm"},
            {"in.json", lesson("failures/cyclic-overlap.json"), "render IN -o OUT.ppm"},
            {"in.jsonl", text_of(trace), "replay IN -o OUT.ppm"},
            {"in.jsonl", text_of(trace), "figure IN --step 7 -o OUT.svg"},
            {"in.jsonl", text_of(trace), "check IN --list OUT.csv"},
            {"in.obj", lesson("00-world-to-screen/ramp.obj"), "import IN -o OUT.json"}};
}

}  // namespace

TEST_CASE("a mark and the ends of lines change nothing that is read") {
    const Workplace work;
    for (const auto& [name, text, command] : every_kind(work)) {
        std::string expected;
        std::optional<int> status;
        for (const std::string& way : {text, "\xef\xbb\xbf" + text, with_line_ends(text, "\r\n"),
                                       with_line_ends(text, "\r"), "\xef\xbb\xbf" + with_line_ends(text, "\r")}) {
            CAPTURE(command);
            work.write(name, way);
            std::string words = command;
            words.replace(words.find("IN"), 2, work.file(name));
            const auto out = words.find("OUT"), end = words.size();
            const std::string file = work.file("out") + words.substr(out + 3, end);
            const Outcome outcome = program(words.replace(out, end, file));
            CAPTURE(outcome.text);
            if (!status) status = outcome.status;
            CHECK(outcome.status == *status);
            if (expected.empty()) expected = text_of(file);
            CHECK(text_of(file) == expected);
        }
        CHECK(!expected.empty());
    }
}

TEST_CASE("UTF-16 is refused by that name") {
    const Workplace work;
    for (const auto& [name, text, command] : every_kind(work)) {
        for (const bool big_endian : {false, true}) {
            for (const bool has_mark : {false, true}) {
                CAPTURE(command);
                const std::string file = work.write(name, in_utf_16(text, big_endian, has_mark));
                std::string words = command;
                words.replace(words.find("IN"), 2, file).replace(words.find("OUT"), 3, work.file("out"));
                const Outcome outcome = program(words);
                CHECK(outcome.status == 2);
                CHECK(outcome.text == "vidno: " + file + ": text in UTF-16; save it as UTF-8\n");
            }
        }
    }
}

TEST_CASE("an error in a scene names its line, however lines end") {
    const Workplace work;
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const std::string file = work.write("bad.json", with_line_ends("{\n\"polygons\": [\n{\"vertices\": 7}]}", end));
        CHECK(program("render " + file + " -o " + work.file("out.ppm"))
                  .text.starts_with("vidno: " + file + ": line 3, column 14: "));
    }
}
