#include "scene/height_function.h"

#include <muParser.h>

#include <memory>
#include <numbers>

#include "refused.h"
#include "scene/elementary.h"

namespace vidno {

namespace {

/// The parser reads its variables from these members.
struct Parsed {
    mu::Parser parser;
    double x = 0, z = 0;
};

/// Replaces what muParser computes by the system's library, or by shortcuts that round differently: x^3 as x * x * x.
void define_same_everywhere(mu::Parser& parser) {
#define VIDNO_NAMED(name) parser.DefineFun(#name, elementary::name);
    VIDNO_ELEMENTARY(VIDNO_NAMED)
#undef VIDNO_NAMED
    parser.DefineFun("ln", elementary::log);
    parser.DefineFun("atan2", elementary::atan2);
    parser.EnableBuiltInOprt(false);
    parser.DefineOprt(
        "||", [](double a, double b) { return double(a != 0 || b != 0); }, mu::prLOR);
    parser.DefineOprt(
        "&&", [](double a, double b) { return double(a != 0 && b != 0); }, mu::prLAND);
    parser.DefineOprt(
        "<", [](double a, double b) { return double(a < b); }, mu::prCMP);
    parser.DefineOprt(
        ">", [](double a, double b) { return double(a > b); }, mu::prCMP);
    parser.DefineOprt(
        "<=", [](double a, double b) { return double(a <= b); }, mu::prCMP);
    parser.DefineOprt(
        ">=", [](double a, double b) { return double(a >= b); }, mu::prCMP);
    parser.DefineOprt(
        "==", [](double a, double b) { return double(a == b); }, mu::prCMP);
    parser.DefineOprt(
        "!=", [](double a, double b) { return double(a != b); }, mu::prCMP);
    parser.DefineOprt(
        "+", [](double a, double b) { return a + b; }, mu::prADD_SUB);
    parser.DefineOprt(
        "-", [](double a, double b) { return a - b; }, mu::prADD_SUB);
    parser.DefineOprt(
        "*", [](double a, double b) { return a * b; }, mu::prMUL_DIV);
    parser.DefineOprt(
        "/", [](double a, double b) { return a / b; }, mu::prMUL_DIV);
    parser.DefineOprt("^", elementary::pow, mu::prPOW, mu::oaRIGHT);
}

}  // namespace

HeightFunction height_function(const std::string& text) {
    const auto parsed = std::make_shared<Parsed>();
    try {
        define_same_everywhere(parsed->parser);
        parsed->parser.DefineConst("pi", std::numbers::pi);
        parsed->parser.DefineVar("x", &parsed->x);
        parsed->parser.DefineVar("z", &parsed->z);
        parsed->parser.SetExpr(text);
        parsed->parser.Eval();  // the first call parses the text
    } catch (const mu::ParserError& error) {
        throw Refused(error.GetMsg());
    }
    return [parsed](double x, double z) {
        parsed->x = x;
        parsed->z = z;
        return parsed->parser.Eval();
    };
}

}  // namespace vidno
