#include "scene/scene_names.h"

#include <nlohmann/json.hpp>

#include "event_table/event_table.h"

namespace vidno {

std::string scene_names_json() {
    using Json = nlohmann::ordered_json;
    Json names = Json::array();
    for (const Bilingual& name : scene_names) names.push_back(object_of<Json>(name));
    return names.dump() + "\n";
}

}  // namespace vidno
