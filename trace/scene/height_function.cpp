#include "scene/height_function.h"

#include <muParser.h>

#include <memory>
#include <numbers>

#include "refused.h"

namespace vidno {

namespace {

/// The parser reads its variables from these members.
struct Parsed {
    mu::Parser parser;
    double x = 0, z = 0;
};

}  // namespace

HeightFunction height_function(const std::string& text) {
    const auto parsed = std::make_shared<Parsed>();
    try {
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
