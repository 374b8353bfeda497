#include "page/page.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "output.h"

namespace vidno {

namespace {

/// A file beside the program's own folder, in the build as in an installation.
std::filesystem::path place_of(const std::string& name) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    return program.parent_path().parent_path() / "share" / "vidno" / name;
}

std::string built(const std::string& name) {
    const auto page = place_of(name);
    if (!std::filesystem::exists(page)) throw Refused(page.string() + ": not there; ./dev demo builds the page");
    return page.string();
}

std::string built_page(const std::string& name) { return read_file(built(name)); }

/// JSON for a data block in a page, escaped so that nothing in it ends the block.
std::string as_block(std::string json) {
    for (auto at = json.find('<'); at != json.npos; at = json.find('<', at)) json.replace(at, 1, "\\u003c");
    return json;
}

constexpr std::string_view end_of_block = "</script>";
constexpr std::string_view index_block = R"(<script type="application/json" id="vidno-lessons">)";
constexpr std::string_view address_block = R"(<script type="application/json" id="vidno-address">)";
constexpr std::string_view file_block = R"(<script type="application/octet-stream" data-vidno-file=")";

std::string base64(std::string_view bytes) {
    constexpr std::size_t most = 3 << 20;  // whole groups of three bytes, in steps that an int counts
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 8);
    std::string part(most / 3 * 4 + 1, '\0');
    for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size()))) {
        const int length =
            EVP_EncodeBlock(reinterpret_cast<unsigned char*>(part.data()),
                            reinterpret_cast<const unsigned char*>(bytes.data()), int(std::min(most, bytes.size())));
        text.append(part, 0, std::size_t(length));
    }
    return text;
}

/// Removes every block that begins like this, and returns the place of the first.
std::size_t take_blocks(std::string& page, std::string_view opening) {
    const auto first = page.find(opening);
    for (auto at = first; at != page.npos; at = page.find(opening, at)) {
        page.erase(at, page.find(end_of_block, at) + end_of_block.size() - at);
    }
    return first;
}

/// In the form of `viewer_web/plugins/lessons.ts`.
std::string blocks_of(const PageContent& content) {
    const auto bad_text = nlohmann::ordered_json::error_handler_t::replace;  // a name may be any bytes
    std::string blocks =
        std::string(index_block) + as_block(content.index.dump(-1, ' ', false, bad_text)) + std::string(end_of_block);
    for (const auto& [name, bytes] : content.files) {
        blocks += std::string(file_block) + name + "\">" + base64(bytes) + std::string(end_of_block);
    }
    return blocks;
}

/// Puts JSON into the data block of the page of charts.
void fill_block(std::string& page, std::string_view id, const std::string& json) {
    const std::string opening = "<script type=\"application/json\" id=\"" + std::string(id) + "\">";
    const auto block = page.find(opening);
    if (block == page.npos) throw Refused("chart.html: not the page of charts");
    const auto begin = block + opening.size();
    page.replace(begin, page.find(end_of_block, begin) - begin, as_block(json));
}

/// The address of a built page as JSON, since the output may lie anywhere; null if there is no such page.
std::string address_of(const std::string& name) {
    const auto page = place_of(name);
    if (!std::filesystem::exists(page)) return "null";
    return '"' + file_address(std::filesystem::canonical(page)) + '"';
}

}  // namespace

std::string file_address(const std::filesystem::path& path) {
    constexpr std::string_view unreserved = "-._~/", digits = "0123456789ABCDEF";
    std::string address = "file://";
    for (const char c : path.string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool stays = (byte < 0x80 && std::isalnum(byte) != 0) || unreserved.find(c) != unreserved.npos;
        address += stays ? std::string(1, c) : std::string{'%', digits[byte >> 4], digits[byte & 15]};
    }
    return address;
}

void PageContent::add(const PageFile& file) {
    // The number distinguishes files with the same name in different folders.
    const std::string name = std::to_string(files.size() + 1) + (file.is_scene ? ".json" : ".jsonl.gz");
    index.push_back(
        {{"id", name},
         {"title", object_of<nlohmann::ordered_json>(in_each_language([&](Language) { return file.title; }))},
         {"traces",
          {{{"file", name},
            {"method", file.method},
            {"kernel", file.kernel},
            {"edition", file.edition},
            {"detail", file.detail}}}}});
    files.emplace_back(name, file.bytes);
    has_scene = has_scene || file.is_scene;
}

std::string PageContent::title(Language language) const {
    if (index.empty()) return "vidno";
    const auto title_of = [&](const nlohmann::ordered_json& entry) {
        return entry["title"][std::string(code_of(language))].get<std::string>();
    };
    return title_of(index.front()) + (index.size() > 1 ? " \u2013 " + title_of(index.back()) : "");
}

std::string trace_page(const PageContent& content, std::optional<Language> language) {
    std::string page = built_page("index.html");
    const auto body = [&] {
        const auto place = page.rfind("</body>");
        if (place == page.npos) throw Refused("index.html: is not the page of traces");
        return place;
    };
    if (language) {
        const std::string address = R"("#lang=)" + std::string(code_of(*language)) + '"';
        page.insert(body(), std::string(address_block) + address + std::string(end_of_block));
    }
    if (content.files.empty()) return page;
    if (content.has_scene && page.find(R"(id="vidno-library">)") == page.npos) {
        throw Refused("index.html: was built without the library that runs a scene");
    }
    const auto lessons = take_blocks(page, index_block);
    take_blocks(page, file_block);
    return page.insert(std::min(lessons, body()), blocks_of(content));
}

std::string chart_page(const std::string& json) {
    std::string page = built_page("chart.html");
    fill_block(page, "vidno-chart", json);
    fill_block(page, "vidno-replay", address_of("index.html"));
    return page;
}

std::string questions_script() { return built("vidno-questions.mjs"); }

}  // namespace vidno
