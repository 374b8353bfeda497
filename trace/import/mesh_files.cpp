// What import needs from this machine's files. The page's library is compiled without it.
#include <filesystem>

#include "import/import.h"
#include "output.h"

namespace vidno {

Beside files_beside(const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    return [folder](const std::string& name) -> std::optional<std::string> {
        const auto path = folder / name;
        std::error_code error;
        if (name.empty() || !std::filesystem::is_regular_file(path, error)) return std::nullopt;
        return read_file(path.string());
    };
}

ImportedScene import_mesh_file(const std::string& file, const ImportOptions& options) {
    return import_mesh(read_file(file), file, options, files_beside(file));
}

}  // namespace vidno
