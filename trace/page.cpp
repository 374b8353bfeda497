#include "page.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "output.h"

namespace vidno {

namespace {

/// Beside the program's own folder, in the build as where it is installed.
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

/// JSON as a block of data in a page: nothing in it ends the block.
std::string as_block(std::string json) {
    for (auto at = json.find('<'); at != json.npos; at = json.find('<', at)) json.replace(at, 1, "\\u003c");
    return json;
}

constexpr std::string_view end_of_block = "</script>";
constexpr std::string_view index_block = R"(<script type="application/json" id="vidno-lessons">)";
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

/// Takes out every block that begins so, and says where the first one stood.
std::size_t take_blocks(std::string& page, std::string_view opening) {
    const auto first = page.find(opening);
    for (auto at = first; at != page.npos; at = page.find(opening, at)) {
        page.erase(at, page.find(end_of_block, at) + end_of_block.size() - at);
    }
    return first;
}

/// The lessons' index and files, in the form that `viewer_web/plugins/lessons.ts` gives them.
std::string blocks_of(const std::vector<PageFile>& files) {
    auto index = nlohmann::ordered_json::array();
    std::string blocks;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const PageFile& file = files[i];
        // The number keeps files of the same name in different folders apart; a name may be any bytes.
        const std::string name = std::to_string(i + 1) + (file.is_scene ? ".json" : ".jsonl.gz");
        index.push_back({{"id", name},
                         {"title", {{"en", file.title}, {"ru", file.title}}},
                         {"traces",
                          {{{"file", name},
                            {"method", file.method},
                            {"kernel", file.kernel},
                            {"edition", file.edition},
                            {"detail", file.detail}}}}});
        blocks += std::string(file_block) + name + "\">" + base64(file.bytes) + std::string(end_of_block);
    }
    const std::string json = index.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return std::string(index_block) + as_block(json) + std::string(end_of_block) + blocks;
}

/// Puts JSON into the block that the page of charts has for it.
void fill_block(std::string& page, std::string_view id, const std::string& json) {
    const std::string opening = "<script type=\"application/json\" id=\"" + std::string(id) + "\">";
    const auto block = page.find(opening);
    if (block == page.npos) throw Refused("chart.html: is not the page of charts");
    const auto begin = block + opening.size();
    page.replace(begin, page.find(end_of_block, begin) - begin, as_block(json));
}

/// The address of a built page as JSON, since what is written may lie anywhere; null if there is no such page.
std::string address_of(const std::string& name) {
    const auto page = place_of(name);
    if (!std::filesystem::exists(page)) return "null";
    constexpr std::string_view unreserved = "-._~/", digits = "0123456789ABCDEF";
    std::string address = "\"file://";
    for (const char c : std::filesystem::canonical(page).string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool stays = (byte < 0x80 && std::isalnum(byte) != 0) || unreserved.find(c) != unreserved.npos;
        address += stays ? std::string(1, c) : std::string{'%', digits[byte >> 4], digits[byte & 15]};
    }
    return address + '"';
}

}  // namespace

std::string trace_page(const std::vector<PageFile>& files) {
    std::string page = built_page("index.html");
    if (files.empty()) return page;
    const bool has_scene = std::any_of(files.begin(), files.end(), [](const PageFile& file) { return file.is_scene; });
    if (has_scene && page.find(R"(id="vidno-library">)") == page.npos) {
        throw Refused("index.html: was built without the library that runs a scene");
    }
    const auto lessons = take_blocks(page, index_block);
    take_blocks(page, file_block);
    const auto body = page.rfind("</body>");
    if (body == page.npos) throw Refused("index.html: is not the page of traces");
    return page.insert(std::min(lessons, body), blocks_of(files));
}

std::string chart_page(const std::string& json) {
    std::string page = built_page("chart.html");
    fill_block(page, "vidno-chart", json);
    fill_block(page, "vidno-replay", address_of("index.html"));
    return page;
}

std::string questions_script() { return built("vidno-questions.mjs"); }

}  // namespace vidno
