// Running another program.

#include "page/program.h"

#include <doctest/doctest.h>

#include "refused.h"

using namespace vidno;

TEST_CASE("A program's output, with a long input") {
    const std::string much(1 << 20, 'x');
    CHECK(output_of({"cat"}, much) == much);
    CHECK(output_of({"printf", "%s|", "a b", "$c"}, "") == "a b|$c|");
}

TEST_CASE("A program that does not exist or fails is refused") {
    CHECK_THROWS_AS(output_of({"no-program-has-this-name"}, ""), Refused);
    CHECK_THROWS_AS(output_of({"false"}, ""), Refused);
}

TEST_CASE("The last line on a program's standard error is the reason of the refusal") {
    CHECK_THROWS_WITH_AS(output_of({"sh", "-c", "echo first >&2; echo 'why not' >&2; exit 3"}, ""), "sh: why not",
                         Refused);
    CHECK_THROWS_WITH_AS(output_of({"false"}, ""), "false failed", Refused);
}
