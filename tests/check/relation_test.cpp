// FORMAT.md: which relation a comparison asks for whose answers are true and false, redone from the operands that a
// checked trace has.

#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "check/checked_trace.h"
#include "choice/method.h"
#include "support/scenes.h"
#include "vidno/kernels/exact.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// The relations that FORMAT.md has for a line.
const std::map<std::string, std::string> relations{{"TF3", "<= >="}, {"OA3", "<= >="}, {"OA4", "<= >="}, {"CR3", "< >"},
                                                   {"RE4", "< >"},   {"CR4", "< >"},   {"I1", "<"}};

bool holds(const std::string& relation, const Rational& a, const Rational& b) {
    if (relation == "<") return a < b;
    if (relation == ">") return a > b;
    return relation == "<=" ? a <= b : a >= b;
}

}  // namespace

TEST_CASE("A comparison with the answers true and false can be redone by the relation of its line") {
    std::map<std::string, int> seen;
    RandomPolygons random(std::mt19937(11));
    for (int trial = 0; trial < 24 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        for (const Method method : {Method::warnock_full, Method::warnock_angles, Method::warnock_edges}) {
            if (refusal_of(method, scene)) continue;
            std::ostringstream text;
            TraceWriter writer(TraceHeader{method, Edition::corrected, "bits:4", Detail::signs, scene},
                               [&](std::string_view part) { text << part; });
            write_checked_trace({method, *kernel_named("bits:4"), Edition::corrected, scene, Detail::signs}, writer);
            std::istringstream lines(text.str());
            for (std::string line; std::getline(lines, line);) {
                if (line.find("\"e\":\"disagree\"") == std::string::npos) continue;
                const auto event = nlohmann::json::parse(line);
                const auto asked = relations.find(event.at("at"));
                if (event.at("of") != "comparison" || !event.at("taken").is_boolean() || asked == relations.end())
                    continue;
                const auto number = [&](int operand, int which) {
                    return Rational(event.at("operands").at(operand).at(which).get<std::string>());
                };
                std::istringstream names(asked->second);
                bool is_redone = false;
                for (std::string relation; names >> relation;) {
                    is_redone =
                        is_redone || (holds(relation, number(0, 1), number(1, 1)) == event.at("taken").get<bool>() &&
                                      holds(relation, number(0, 2), number(1, 2)) == event.at("exact").get<bool>());
                }
                CHECK_MESSAGE(is_redone, line);
                ++seen[asked->first];
            }
        }
    }
    CHECK(seen["TF3"] > 0);
    CHECK(seen["OA3"] > 0);
    CHECK(seen["CR3"] > 0);
}
