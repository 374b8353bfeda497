#include "story.h"

#include <cmark-gfm-core-extensions.h>

#include <algorithm>
#include <memory>
#include <regex>
#include <sstream>

#include "choice/edition.h"
#include "listings_text.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

std::vector<cmark_node*> children(cmark_node* parent) {
    std::vector<cmark_node*> nodes;
    for (auto* node = cmark_node_first_child(parent); node; node = cmark_node_next(node)) nodes.push_back(node);
    return nodes;
}

std::string literal(cmark_node* node) {
    const char* text = cmark_node_get_literal(node);
    return text ? text : "";
}

std::string without_newline(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

/// The words of inline content, without markup.
std::string plain(const Json& content) {
    std::string words;
    for (const auto& each : content) {
        if (each.is_string()) {
            words += each.get<std::string>();
        } else if (each.contains("tex")) {
            words += each["tex"].get<std::string>();
        } else if (each["text"].is_string()) {
            words += each["text"].get<std::string>();
        } else {
            words += plain(each["text"]);
        }
    }
    return words;
}

/// The output of a command: the word after -o.
std::string output_of_command(const std::string& command) {
    std::istringstream words(command);
    std::string word, file;
    while (words >> word) {
        if (word == "-o") words >> file;
    }
    return file;
}

/// Whether it is the name of a procedure or the label of one of its lines.
bool is_in_listings(const std::string& word) {
    static const auto listings = nlohmann::json::parse(figures::listings_text);
    return std::ranges::any_of(listings.at("procedures"), [&](const auto& procedure) {
        const auto has_label = [&](const auto& line) { return line.at("at") == word; };
        return procedure.at("name") == word || std::ranges::any_of(procedure.at("lines"), has_label);
    });
}

/// A Russian formula as English writes it: Russian has a decimal comma, a space between thousands, and a semicolon
/// between coordinates.
std::string in_english(std::string tex) {
    static const std::regex comma(R"((\d)\{,\}(?=\d))"), space(R"((\d)\\,(?=\d))"), semicolon(R"(([^\\]);)");
    tex = std::regex_replace(tex, comma, "$1.");
    tex = std::regex_replace(tex, space, "$1{,}");
    return std::regex_replace(tex, semicolon, "$1,");
}

class StoryReader {
public:
    StoryReader(Language language, const std::string& file, Problems& problems)
        : language_(language),
          summary_(summary_heading.in(language)),
          exercises_(exercises_heading.in(language)),
          problems_(problems) {
        story_.file = file;
    }

    Story read(cmark_node* document) {
        auto nodes = children(document);
        if (!nodes.empty() && is_title(nodes[0])) {
            story_.title = inlines(nodes[0]);
            story_.plain_title = plain(story_.title);
            nodes.erase(nodes.begin());
        } else {
            problem(1, "a story begins with its title: # Title");
        }
        if (!nodes.empty() && is_list(nodes[0], CMARK_BULLET_LIST)) {
            story_.goals = goals(nodes[0]);
            nodes.erase(nodes.begin());
        } else {
            problem(1, "the learning goals are missing: a list below the title");
        }
        story_.blocks = blocks(nodes);
        const int end = last_line(document);
        if (story_.questions < 2) problem(end, "at least two questions to think about are required");
        if (!story_.has_summary) problem(end, "the summary is missing: ## " + summary_);
        if (story_.exercises < 2) problem(end, "at least two exercises with answers are required: ## " + exercises_);
        return std::move(story_);
    }

private:
    static bool is_title(cmark_node* node) {
        return cmark_node_get_type(node) == CMARK_NODE_HEADING && cmark_node_get_heading_level(node) == 1;
    }
    static bool is_list(cmark_node* node, cmark_list_type type) {
        return cmark_node_get_type(node) == CMARK_NODE_LIST && cmark_node_get_list_type(node) == type;
    }
    static int last_line(cmark_node* document) { return std::max(1, cmark_node_get_end_line(document)); }

    void problem(int line, std::string what) { problems_.push_back({story_.file, line, std::move(what)}); }

    void mark(cmark_node* node, std::string what) { story_.marks.push_back({line_of(node), std::move(what)}); }

    void mark_formula(cmark_node* node, const std::string& tex) {
        mark(node, "formula " + (language_ == Language::russian ? in_english(tex) : tex));
    }

    /// CommonMark's tree gives no line for inline content or for the cells of a table.
    static int line_of(cmark_node* node) {
        while (cmark_node_get_start_line(node) == 0 && cmark_node_parent(node)) node = cmark_node_parent(node);
        return cmark_node_get_start_line(node);
    }

    Json blocks(const std::vector<cmark_node*>& nodes) {
        Json made = Json::array();
        for (auto* node : nodes) {
            if (is_questions(node)) {
                for (auto* item : children(node)) made.push_back(question(item));
            } else {
                made.push_back(block(node));
            }
        }
        return made;
    }

    Json goals(cmark_node* list) {
        const auto items = children(list);
        mark(list, "list of " + std::to_string(items.size()) + " goals");
        Json made = Json::array();
        for (auto* item : items) {
            auto* text = cmark_node_first_child(item);
            const bool is_text = text && cmark_node_get_type(text) == CMARK_NODE_PARAGRAPH && !cmark_node_next(text);
            if (is_text) {
                made.push_back(inlines(text));
            } else {
                problem(line_of(item), "a goal is one paragraph");
            }
        }
        return made;
    }

    Json block(cmark_node* node) {
        const auto type = cmark_node_get_type(node);
        if (type == CMARK_NODE_HEADING) return heading(node);
        if (type == CMARK_NODE_PARAGRAPH) return paragraph(node);
        if (type == CMARK_NODE_LIST) return list(node);
        if (type == CMARK_NODE_CODE_BLOCK) return fence(node);
        if (cmark_node_get_type_string(node) == std::string_view("table")) return table(node);
        if (type == CMARK_NODE_BLOCK_QUOTE) {
            mark(node, "quote");
            return {{"is", "quote"}, {"blocks", blocks(children(node))}};
        }
        problem(line_of(node), type == CMARK_NODE_HTML_BLOCK ? "HTML is not shown" : "a page cannot show such a block");
        return {{"is", "paragraph"}, {"text", Json::array()}};
    }

    Json heading(cmark_node* node) {
        const int level = cmark_node_get_heading_level(node);
        if (level != 2 && level != 3) problem(line_of(node), "a heading within a story is of level 2 or 3: ## or ###");
        mark(node, "heading " + std::to_string(level));
        Json text = inlines(node);
        if (level == 2) {
            const std::string words = plain(text);
            story_.has_summary = story_.has_summary || words == summary_;
            are_exercises_ = words == exercises_;
        }
        return {{"is", "heading"}, {"level", level}, {"text", std::move(text)}};
    }

    Json paragraph(cmark_node* node) {
        mark(node, "paragraph");
        return {{"is", "paragraph"}, {"text", inlines(node)}};
    }

    Json list(cmark_node* node) {
        const bool ordered = cmark_node_get_list_type(node) == CMARK_ORDERED_LIST;
        const auto items = children(node);
        mark(node, (ordered ? "numbered list of " : "list of ") + std::to_string(items.size()));
        Json made = Json::array();
        for (auto* item : items) made.push_back(blocks(children(item)));
        return {{"is", "list"}, {"ordered", ordered}, {"items", std::move(made)}};
    }

    static bool ends_with_quote(cmark_node* item) {
        auto* last = cmark_node_last_child(item);
        return last && cmark_node_get_type(last) == CMARK_NODE_BLOCK_QUOTE && cmark_node_previous(last);
    }

    /// A numbered list whose every item ends in its answer, as a quote.
    static bool is_questions(cmark_node* node) {
        if (!is_list(node, CMARK_ORDERED_LIST)) return false;
        const auto items = children(node);
        return std::all_of(items.begin(), items.end(), ends_with_quote);
    }

    Json question(cmark_node* item) {
        auto asked = children(item);
        auto* answer = asked.back();
        asked.pop_back();
        const char* kind = are_exercises_ ? "exercise" : "question";
        int& count = are_exercises_ ? story_.exercises : story_.questions;
        mark(item, kind);
        Json made{{"is", kind}, {"number", ++count}, {"blocks", blocks(asked)}};
        made["answer"] = blocks(children(answer));
        return made;
    }

    Json fence(cmark_node* node) {
        const std::string info = cmark_node_get_fence_info(node);
        const std::string text = without_newline(literal(node));
        if (info == "math") {
            mark_formula(node, text);
            return {{"is", "formula"}, {"tex", text}};
        }
        constexpr std::string_view figure_word = "figure ";
        if (info.starts_with(figure_word)) return figure(node, info.substr(figure_word.size()), text);
        if (info == "listing" || info.starts_with("listing ")) return listing(node, info, text);
        mark(node, "code " + (info == "sh" ? text : info));
        return {{"is", "code"}, {"language", info}, {"text", text}};
    }

    Json figure(cmark_node* node, const std::string& caption, const std::string& command) {
        const std::string file = output_of_command(command);
        if (!command.starts_with("vidno figure ") || file.empty() || command.find('\n') != command.npos) {
            problem(line_of(node), "a figure contains one line: vidno figure ... -o NAME.svg");
        }
        mark(node, "figure");
        story_.figures.push_back({line_of(node), command, file});
        return {{"is", "figure"}, {"caption", Json::array({caption})}, {"command", command}, {"file", file}};
    }

    /// Procedures and lines of procedures by their names, in the edition after the word `listing`.
    Json listing(cmark_node* node, const std::string& info, const std::string& text) {
        const std::size_t space = info.find(' ');
        const std::string edition = space == info.npos ? "corrected" : info.substr(space + 1);
        if (!edition_named(edition)) problem(line_of(node), edition + ": no such edition");
        mark(node, info + ' ' + text);
        Json names = Json::array();
        std::istringstream words(text);
        for (std::string word; words >> word;) {
            if (!is_in_listings(word)) problem(line_of(node), word + ": neither a procedure nor one of its lines");
            names.push_back(word);
        }
        return {{"is", "listing"}, {"edition", edition}, {"names", std::move(names)}};
    }

    Json table(cmark_node* node) {
        Json align = Json::array();
        const auto columns = cmark_gfm_extensions_get_table_columns(node);
        const auto* alignments = cmark_gfm_extensions_get_table_alignments(node);
        for (int i = 0; i < columns; ++i) {
            const char letter = char(alignments[i]);
            align.push_back(letter == 'l' ? "left" : letter == 'r' ? "right" : letter == 'c' ? "center" : "");
        }
        const auto rows = children(node);
        mark(node, "table of " + std::to_string(rows.size()) + " x " + std::to_string(columns));
        Json made{{"is", "table"}, {"head", cells(rows.front())}, {"align", std::move(align)}, {"rows", Json::array()}};
        for (std::size_t i = 1; i < rows.size(); ++i) made["rows"].push_back(cells(rows[i]));
        return made;
    }

    Json cells(cmark_node* row) {
        Json made = Json::array();
        for (auto* cell : children(row)) made.push_back(inlines(cell));
        return made;
    }

    /// The content of a block. The order of its parts may differ between languages, so its marks are compared sorted.
    Json inlines(cmark_node* parent) {
        const std::size_t first = story_.marks.size();
        Json content = content_of(parent);
        std::sort(story_.marks.begin() + std::ptrdiff_t(first), story_.marks.end(),
                  [](const auto& a, const auto& b) { return a.what < b.what; });
        return content;
    }

    Json content_of(cmark_node* parent) {
        Json content = Json::array();
        const auto nodes = children(parent);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (is_formula(nodes, i, content)) {
                content.back() = shortened(content.back());
                const std::string tex = literal(nodes[i]);
                mark_formula(nodes[i], tex);
                content.push_back({{"is", "formula"}, {"tex", tex}});
                append_text(content, literal(nodes[++i]).substr(1));
            } else {
                append(content, nodes[i]);
            }
        }
        return without_empty(content);
    }

    /// Code between dollars: $`x`$.
    static bool is_formula(const std::vector<cmark_node*>& nodes, std::size_t i, const Json& content) {
        return cmark_node_get_type(nodes[i]) == CMARK_NODE_CODE && i + 1 < nodes.size() && !content.empty() &&
               content.back().is_string() && content.back().get<std::string>().ends_with('$') &&
               cmark_node_get_type(nodes[i + 1]) == CMARK_NODE_TEXT && literal(nodes[i + 1]).starts_with('$');
    }

    static Json shortened(const Json& text) {
        std::string words = text.get<std::string>();
        words.pop_back();
        return words;
    }

    static void append_text(Json& content, const std::string& words) {
        if (!content.empty() && content.back().is_string()) {
            content.back() = content.back().get<std::string>() + words;
        } else {
            content.push_back(words);
        }
    }

    static Json without_empty(const Json& content) {
        Json kept = Json::array();
        for (const auto& each : content) {
            const bool is_empty = each.is_string() && each.get_ref<const std::string&>().empty();
            if (!is_empty) kept.push_back(each);
        }
        return kept;
    }

    void append(Json& content, cmark_node* node) {
        switch (cmark_node_get_type(node)) {
            case CMARK_NODE_TEXT: return append_text(content, literal(node));
            case CMARK_NODE_SOFTBREAK:
            case CMARK_NODE_LINEBREAK: return append_text(content, " ");
            case CMARK_NODE_CODE: return content.push_back({{"is", "code"}, {"text", literal(node)}});
            case CMARK_NODE_EMPH: return content.push_back({{"is", "emphasis"}, {"text", content_of(node)}});
            case CMARK_NODE_STRONG: return content.push_back({{"is", "strong"}, {"text", content_of(node)}});
            case CMARK_NODE_LINK: return content.push_back(link(node));
            case CMARK_NODE_HTML_INLINE: return problem(line_of(node), "HTML is not shown: " + literal(node));
            default: problem(line_of(node), "a page cannot show this within a line; a figure has its own fence");
        }
    }

    Json link(cmark_node* node) {
        const std::string url = cmark_node_get_url(node);
        const int line = line_of(node);
        Json text = content_of(node);
        if (url.starts_with('#')) {
            const std::string pin = url.substr(1);
            mark(node, "pin " + pin);
            story_.pins.push_back({line, pin, plain(text)});
            return {{"is", "pin"}, {"pin", pin}, {"text", std::move(text)}};
        }
        if (url.starts_with("../")) {
            const std::string id = url.substr(3, url.find('/', 3) - 3);
            mark(node, "lesson " + id);
            story_.lessons.push_back({line, id});
            return {{"is", "lesson"}, {"id", id}, {"text", std::move(text)}};
        }
        if (!url.starts_with("https://")) problem(line, url + ": neither #PIN, ../LESSON/ nor https://");
        mark(node, "link");
        return {{"is", "link"}, {"url", url}, {"text", std::move(text)}};
    }

    const Language language_;
    const std::string summary_, exercises_;
    bool are_exercises_ = false;  // in the current section
    Story story_;
    Problems& problems_;
};

using Document = std::unique_ptr<cmark_node, void (*)(cmark_node*)>;

Document parsed(std::string_view markdown) {
    cmark_gfm_core_extensions_ensure_registered();
    const std::unique_ptr<cmark_parser, void (*)(cmark_parser*)> parser(cmark_parser_new(CMARK_OPT_DEFAULT),
                                                                        cmark_parser_free);
    cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
    cmark_parser_feed(parser.get(), markdown.data(), markdown.size());
    Document document(cmark_parser_finish(parser.get()), cmark_node_free);
    cmark_consolidate_text_nodes(document.get());
    return document;
}

}  // namespace

Story read_story(std::string_view markdown, Language language, const std::string& file, Problems& problems) {
    return StoryReader(language, file, problems).read(parsed(markdown).get());
}

void omit_answers(Json& blocks) {
    for (Json& block : blocks) {
        const auto& kind = block["is"];
        if (kind == "question" || kind == "exercise") block.erase("answer");
        if (block.contains("blocks")) omit_answers(block["blocks"]);
        if (!block.contains("items")) continue;
        for (Json& item : block["items"]) omit_answers(item);
    }
}

void compare_structure(const Story& first, const Story& second, Problems& problems) {
    const auto same = [](const Story::Mark& a, const Story::Mark& b) { return a.what == b.what; };
    const auto [a, b] =
        std::mismatch(first.marks.begin(), first.marks.end(), second.marks.begin(), second.marks.end(), same);
    if (a == first.marks.end() && b == second.marks.end()) return;
    const auto name = [](const Story& story, auto mark) { return mark == story.marks.end() ? "the end" : mark->what; };
    const auto line = [](const Story& story, auto mark) {
        if (mark != story.marks.end()) return mark->line;
        return story.marks.empty() ? 1 : story.marks.back().line;
    };
    problems.push_back(
        {second.file, line(second, b),
         name(second, b) + ", where " + first.file + ":" + std::to_string(line(first, a)) + " has " + name(first, a)});
}

}  // namespace vidno
