#include "page.h"

#include <filesystem>

#include "output.h"

namespace vidno {

namespace {

/// Beside the program's own folder, in the build as where it is installed.
std::string built_page(const std::string& name) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto page = program.parent_path().parent_path() / "share" / "vidno" / name;
    if (!std::filesystem::exists(page)) throw Refused(page.string() + ": not there; ./dev demo builds the page");
    return read_file(page.string());
}

/// JSON as a block of data in a page: nothing in it ends the block.
std::string as_block(std::string json) {
    for (auto at = json.find('<'); at != json.npos; at = json.find('<', at)) json.replace(at, 1, "\\u003c");
    return json;
}

}  // namespace

std::string chart_page(const std::string& json) {
    static constexpr std::string_view opening = R"(<script type="application/json" id="vidno-chart">)";
    std::string page = built_page("chart.html");
    const auto block = page.find(opening);
    if (block == page.npos) throw Refused("chart.html: is not the page of charts");
    const auto begin = block + opening.size();
    return page.replace(begin, page.find("</script>", begin) - begin, as_block(json));
}

}  // namespace vidno
