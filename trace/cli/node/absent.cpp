/// What `npx vidno` lacks, since it needs libraries or programs outside Node. Each refusal says so.
#include "chart/chart_input.h"
#include "figure/writers.h"
#include "find/until.h"
#include "import/import.h"
#include "lesson/story.h"
#include "page/program.h"
#include "picture/image.h"
#include "refused.h"

/// Emscripten takes every stream for a terminal, where the program shows progress.
extern "C" int isatty(int) { return 0; }

namespace vidno {

namespace {

Refused only_native(const std::string& what) {
    return Refused(what + ": not available in vidno for Node; use the program for Debian");
}

}  // namespace

namespace figures {

std::string pdf_of(const std::vector<std::string>&, const About&) { throw only_native("PDF"); }
std::string png_of(const std::string&, int) { throw only_native("PNG"); }

}  // namespace figures

std::string output_of(const std::vector<std::string>& command, std::string_view) { throw only_native(command.front()); }

std::string encode_png(const Picture&, const std::string& name) { throw only_native(name); }

std::optional<std::uint64_t> events_until(const std::string&, RunRequest) { throw only_native("--until"); }
AnyChart read_chart(std::string_view, const std::string& file) { throw only_native(file); }
ImportedScene import_mesh_file(const std::string& file, const ImportOptions&) { throw only_native(file); }
Story read_story(std::string_view, Language, const std::string& file, Problems&) { throw only_native(file); }
void compare_structure(const Story&, const Story&, Problems&) {}
void omit_answers(nlohmann::ordered_json&) {}

}  // namespace vidno
