// Reading failures: refused files, with the reasons.

#include "scene/failure.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "output.h"

using namespace vidno;
using nlohmann::json;

namespace {

json entry(const std::string& name) { return json::parse(read_file(VIDNO_ROOT "/lessons/failures/" + name + ".json")); }

std::string refusal_of(const json& failure) {
    try {
        read_failure(failure.dump(), "f.json");
    } catch (const Refused& refusal) {
        return refusal.what();
    }
    return "read";
}

std::string with(const std::string& name, const json& changed) {
    json failure = entry(name);
    failure.update(changed);
    return refusal_of(failure);
}

bool says(const std::string& refusal, const std::string& reason) { return refusal.find(reason) != std::string::npos; }

}  // namespace

TEST_CASE("Failures: an invalid description of what can be seen is refused") {
    const auto shows = [](const json& form) { return with("clip-pixel", {{"shows", form}}); };
    CHECK(shows({{"pixel", {3, 4}}}) == "read");
    CHECK(says(shows(json::object()), "/shows: shows nothing"));
    CHECK(says(shows({{"wrong", "Painter"}}), "/shows/wrong: no procedure of this name"));
    CHECK(says(shows({{"fault", "Q1"}}), "/shows/fault: no line of this name"));
    CHECK(says(shows({{"missing", "PL99"}}), "/shows/missing: no line of this name"));
    CHECK(says(shows({{"more_windows", false}}), "/shows/more_windows: not true"));
    CHECK(says(shows({{"off", 0}}), "/shows/off: not positive"));
}

TEST_CASE("Failures: polygons show no columns, and curves no pixels") {
    CHECK(says(with("clip-pixel", {{"shows", {{"column", {0, 1}}}}}), "/shows/column: unknown key"));
    CHECK(says(with("missed-peak", {{"shows", {{"pixel", {0, 1}}}}}), "/shows/pixel: unknown key"));
}

TEST_CASE("Failures: a run must be one that the kernel makes of such a scene") {
    const auto fails = [](const std::string& name, const char* method, const char* kernel, const char* edition) {
        return with(name, {{"fails", {{"method", method}, {"kernel", kernel}, {"edition", edition}}}});
    };
    CHECK(fails("clip-pixel", "warnock", "float", "printed") == "read");
    CHECK(says(fails("clip-pixel", "painter", "float", "corrected"), "/fails/method: no method of this name"));
    CHECK(says(fails("clip-pixel", "warnock", "grid:8", "printed"), "/fails: the kernel does not run this"));
    CHECK(says(fails("clip-pixel", "floating-horizon", "float", "corrected"), "/fails/method: draws a surface"));
    CHECK(says(fails("missed-peak", "warnock", "float", "corrected"), "/fails/method: draws no surface"));
}
