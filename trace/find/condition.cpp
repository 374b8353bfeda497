#include "find/condition.h"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "format/event.h"
#include "refused.h"

namespace vidno {

namespace {

template <class... Events>
LineSet lines_with_steps(EventTypes<Events...>) {
    LineSet lines{};
    const auto add = [&](const LineSet& of) {
        if (of == LineSet::all()) return;
        for (std::size_t line = 0; line < line_names.size(); ++line) {
            if (of.has(Line(line))) lines.add(Line(line));
        }
    };
    (add(Events::lines), ...);
    return lines;
}

/// "condition: at character 5: ..." The place is in bytes from 0.
Refused refused_at(const std::string& text, std::size_t place, const std::string& why) {
    place = std::min(place, text.size());
    const auto is_continued = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    const auto end = text.begin() + std::ptrdiff_t(place);
    const auto characters = std::ptrdiff_t(place) - std::count_if(text.begin(), end, is_continued);
    return Refused(text + ": at character " + std::to_string(characters + 1) + ": " + why);
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\n");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

/// A text in the alphabet of muParser, which is as long as what was written, so that places agree.
struct Spelled {
    std::string text;
    std::vector<Name> names;
    std::vector<std::string> variables;  // the names in this text
};

/// Reads the names, and spells `pixels(A)` and `wrong(bits:9)` as variables.
class Reader {
public:
    explicit Reader(const std::string& text) : given_(text), spelled_{text, {}, {}} {}

    Spelled read() {
        for (std::size_t at = 0; at < given_.size();) {
            const char c = given_[at];
            if (is_digit(c) || c == '.') {
                at = after_number(at);
            } else if (is_letter(c)) {
                at = after_name(at);
            } else {
                if (c == '=') at = after_equals(at);
                ++at;
            }
        }
        return std::move(spelled_);
    }

private:
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

    std::size_t end_of(std::size_t at, auto&& holds) const {
        while (at < given_.size() && holds(given_[at])) ++at;
        return at;
    }

    std::size_t after_number(std::size_t at) const {
        const auto in_number = [](char c) { return is_digit(c) || c == '.'; };
        at = end_of(at, in_number);
        if (at >= given_.size() || (given_[at] != 'e' && given_[at] != 'E')) return at;
        const bool has_sign = at + 1 < given_.size() && (given_[at + 1] == '-' || given_[at + 1] == '+');
        return end_of(at + (has_sign ? 2 : 1), is_digit);
    }

    /// In muParser a single = would set a variable.
    std::size_t after_equals(std::size_t at) const {
        if (at > 0 && std::string_view("<>!").find(given_[at - 1]) != std::string_view::npos) return at;
        if (at + 1 < given_.size() && given_[at + 1] == '=') return at + 1;
        throw refused_at(given_, at, "equality is written ==");
    }

    std::size_t after_name(std::size_t at) {
        const std::size_t end = end_of(at, [](char c) { return is_letter(c) || is_digit(c); });
        const std::string word = given_.substr(at, end - at);
        const std::size_t next = end_of(end, [](char c) { return c == ' '; });
        const bool is_call = next < given_.size() && given_[next] == '(';
        if (is_call && word != "pixels" && word != "wrong") return end;  // a function, which muParser knows or refuses
        const auto found = std::find_if(quantities.begin() + 1, quantities.end(),
                                        [&](const QuantityChoice& each) { return each.name == word; });
        if (found == quantities.end()) {
            const auto label = std::find(line_names.begin(), line_names.end(), word);
            if (label == line_names.end()) throw refused_at(given_, at, "no name " + word + " (vidno find --list)");
            const Line line = Line(label - line_names.begin());
            if (!is_counted(line)) throw refused_at(given_, at, "no step is reported at the line " + word);
            return spell(at, end, Name{Quantity::line, line, {}, {}});
        }
        Name name{Quantity(found - quantities.begin()), {}, {}, {}};
        if (found->argument.empty()) return spell(at, end, std::move(name));
        const std::string form = word + "(" + std::string(found->argument) + ")";
        if (!is_call) throw refused_at(given_, at, word + " is written " + form);
        const std::size_t close = given_.find(')', next);
        if (close == given_.npos) throw refused_at(given_, next, "no ) closes " + form);
        name.argument = trimmed(given_.substr(next + 1, close - next - 1));
        if (name.argument.empty()) throw refused_at(given_, close, word + " is written " + form);
        if (name.quantity == Quantity::wrong) {
            const auto kernel = kernel_named(name.argument);
            if (!kernel) throw refused_at(given_, next + 1, "no kernel " + name.argument + ": " + kernel_names());
            name.kernel = *kernel;
        }
        return spell(at, close + 1, std::move(name));
    }

    /// The variable of a name has its number, and is as long as what is written.
    std::size_t spell(std::size_t at, std::size_t end, Name name) {
        auto& [text, names, variables] = spelled_;
        const auto is_same = [&](const Name& each) { return each.text() == name.text(); };
        const auto found = std::find_if(names.begin(), names.end(), is_same);
        const auto number = found - names.begin();
        if (found == names.end()) names.push_back(std::move(name));
        std::string variable = names[std::size_t(number)].text();
        if (!names[std::size_t(number)].argument.empty()) {
            variable = std::string(1, '_') + std::to_string(number);  // GCC 12 warns of "_" +, wrongly
            variable.resize(end - at, '_');
        }
        if (std::find(variables.begin(), variables.end(), variable) == variables.end()) variables.push_back(variable);
        text.replace(at, end - at, variable);
        return end;
    }

    const std::string& given_;
    Spelled spelled_;
};

/// The number of a name by its variable.
std::size_t place_of(const std::string& variable, const std::vector<Name>& names) {
    if (variable.front() == '_') return std::stoul(variable.substr(1));
    const auto is_named = [&](const Name& each) { return each.text() == variable; };
    return std::size_t(std::find_if(names.begin(), names.end(), is_named) - names.begin());
}

/// What muParser says, in the words of this program where it would show the spelled text.
std::string reason_of(const mu::Parser::exception_type& error) {
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_EOF: return "something is missing at the end";
        case mu::ecMISSING_PARENS: return "a parenthesis is missing";
        case mu::ecUNEXPECTED_PARENS: return "unexpected parenthesis";
        case mu::ecUNEXPECTED_OPERATOR: return "unexpected operator " + error.GetToken();
        case mu::ecUNEXPECTED_VAL:
        case mu::ecUNEXPECTED_VAR: return "an operator is missing before it";
        case mu::ecUNEXPECTED_ARG:
        case mu::ecUNEXPECTED_ARG_SEP: return "unexpected comma";
        case mu::ecUNEXPECTED_FUN: return "unexpected function " + error.GetToken();
        case mu::ecTOO_MANY_PARAMS: return "too many arguments";
        case mu::ecTOO_FEW_PARAMS: return "too few arguments";
        case mu::ecUNASSIGNABLE_TOKEN: return "no meaning of " + error.GetToken();
        default: return error.GetMsg();
    }
}

double not_so(double value) { return value == 0 ? 1 : 0; }

/// How far apart two sides are, where they must not be. The logarithm lets small counts weigh as much as great ones.
double far_apart(double difference) {
    constexpr double farthest = 100;
    return std::isfinite(difference) ? std::min(std::log2(1 + std::abs(difference)), farthest) : farthest;
}

}  // namespace

bool is_counted(Line line) {
    static const LineSet lines = lines_with_steps(AllEvents{});
    return lines.has(line);
}

std::string Name::text() const {
    if (quantity == Quantity::line) return std::string(line_names[std::size_t(line)]);
    const std::string name(choice().name);
    return argument.empty() ? name : name + "(" + argument + ")";
}

/// The expression as a tree of what || and && join. A leaf is a comparison or something else.
class Condition::Expression {
public:
    explicit Expression(const std::string& text) : given_(text), spelled_(Reader(text).read()) {
        values_.resize(spelled_.names.size());
        expect_one_value();
        root_ = node_of(0, spelled_.text.size());
        const auto& joined = root_.kind == Node::Kind::all ? root_.children : std::vector{root_};
        for (const Node& node : joined) {
            parts_.push_back(node);
            texts_.push_back(trimmed(given_.substr(node.first, node.end - node.first)));
        }
    }

    const std::vector<Name>& names() const { return spelled_.names; }
    const std::vector<std::string>& texts() const { return texts_; }
    void set(const std::vector<double>& values) { std::copy(values.begin(), values.end(), values_.begin()); }
    bool is_met() const { return is_met(root_); }
    bool is_met(std::size_t part) const { return is_met(parts_[part]); }
    double distance() const { return distance(root_); }

private:
    struct Node {
        enum class Kind : unsigned char { any, all, comparison, other };

        Kind kind = Kind::other;
        std::size_t first = 0, end = 0;  // in the text
        std::vector<Node> children{};    // of any and all
        std::string sign{};              // of a comparison: == != < <= > >=
        std::shared_ptr<mu::Parser> left{}, right{};
        std::shared_ptr<mu::Parser> whole{};
    };

    std::shared_ptr<mu::Parser> parser_of(std::size_t first, std::size_t end) {
        auto parser = std::make_shared<mu::Parser>();
        parser->DefineInfixOprt("!", not_so);
        for (const auto& variable : spelled_.variables) {
            parser->DefineVar(variable, &values_[place_of(variable, spelled_.names)]);
        }
        parser->SetExpr(spelled_.text.substr(first, end - first));
        return parser;
    }

    void expect_one_value() {
        if (trimmed(given_).empty()) throw Refused("the condition is empty");
        const auto whole = parser_of(0, spelled_.text.size());
        try {
            int results = 0;
            whole->Eval(results);
            if (results > 1) throw refused_at(given_, given_.find(','), "unexpected comma; write && or ||");
        } catch (const mu::Parser::exception_type& error) {
            throw refused_at(given_, error.GetPos() < 0 ? 0 : std::size_t(error.GetPos()), reason_of(error));
        }
    }

    /// The places of these signs that are in no parentheses. Longer signs come first in the list.
    std::vector<std::pair<std::size_t, std::string>> signs_in(std::size_t first, std::size_t end,
                                                              const std::vector<std::string>& signs) const {
        std::vector<std::pair<std::size_t, std::string>> found;
        int depth = 0;
        for (std::size_t at = first; at < end; ++at) {
            const char c = spelled_.text[at];
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (depth > 0) continue;
            const auto is_here = [&](const std::string& sign) {
                return spelled_.text.compare(at, sign.size(), sign) == 0;
            };
            const auto sign = std::find_if(signs.begin(), signs.end(), is_here);
            if (sign == signs.end()) continue;
            found.emplace_back(at, *sign);
            at += sign->size() - 1;
        }
        return found;
    }

    /// Narrows the range to what surrounding spaces and parentheses leave.
    void unwrap(std::size_t& first, std::size_t& end) const {
        const auto& text = spelled_.text;
        for (;;) {
            while (first < end && std::isspace(static_cast<unsigned char>(text[first]))) ++first;
            while (end > first && std::isspace(static_cast<unsigned char>(text[end - 1]))) --end;
            if (text[first] != '(' || text[end - 1] != ')') return;
            int depth = 0;
            for (std::size_t at = first; at + 1 < end; ++at) {
                depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
                if (depth == 0) return;
            }
            ++first;
            --end;
        }
    }

    Node joined(Node::Kind kind, const std::vector<std::pair<std::size_t, std::string>>& signs, std::size_t first,
                std::size_t end) {
        Node node{.kind = kind, .first = first, .end = end};
        for (const auto& [at, sign] : signs) {
            node.children.push_back(node_of(first, at));
            first = at + sign.size();
        }
        node.children.push_back(node_of(first, end));
        return node;
    }

    Node node_of(std::size_t first, std::size_t end) {
        unwrap(first, end);
        Node node{.kind = Node::Kind::other, .first = first, .end = end, .whole = parser_of(first, end)};
        if (!signs_in(first, end, {"?"}).empty()) return node;
        if (const auto any = signs_in(first, end, {"||"}); !any.empty()) {
            return joined(Node::Kind::any, any, first, end);
        }
        if (const auto all = signs_in(first, end, {"&&"}); !all.empty()) {
            return joined(Node::Kind::all, all, first, end);
        }
        const auto signs = signs_in(first, end, {"==", "!=", "<=", ">=", "<", ">"});
        if (signs.empty()) return node;
        node.kind = Node::Kind::comparison;
        node.sign = signs.back().second;
        node.left = parser_of(first, signs.back().first);
        node.right = parser_of(signs.back().first + node.sign.size(), end);
        return node;
    }

    static bool is_met(const Node& node) {
        const auto holds = [](const Node& each) { return is_met(each); };
        if (node.kind == Node::Kind::any) return std::any_of(node.children.begin(), node.children.end(), holds);
        if (node.kind == Node::Kind::all) return std::all_of(node.children.begin(), node.children.end(), holds);
        const double value = node.whole->Eval();
        return value != 0 && !std::isnan(value);
    }

    static double distance(const Node& node) {
        if (node.kind == Node::Kind::any || node.kind == Node::Kind::all) {
            double least = INFINITY, sum = 0;
            for (const Node& child : node.children) {
                const double each = distance(child);
                least = std::min(least, each);
                sum += each;
            }
            return node.kind == Node::Kind::any ? least : sum;
        }
        if (is_met(node)) return 0;
        if (node.kind == Node::Kind::other || node.sign == "!=") return 1;
        return std::max(far_apart(node.left->Eval() - node.right->Eval()), 0.5);
    }

    std::string given_;
    Spelled spelled_;
    std::vector<double> values_;  // of the variables
    Node root_;
    std::vector<Node> parts_;
    std::vector<std::string> texts_;
};

Condition::Condition(const std::string& text) : expression_(std::make_unique<Expression>(text)) {}
Condition::~Condition() = default;
Condition::Condition(Condition&&) noexcept = default;
Condition& Condition::operator=(Condition&&) noexcept = default;

const std::vector<Name>& Condition::names() const { return expression_->names(); }
const std::vector<std::string>& Condition::parts() const { return expression_->texts(); }

bool Condition::is_met(const std::vector<double>& values) const {
    expression_->set(values);
    return expression_->is_met();
}

bool Condition::is_met(const std::vector<double>& values, std::size_t part) const {
    expression_->set(values);
    return expression_->is_met(part);
}

double Condition::distance(const std::vector<double>& values) const {
    expression_->set(values);
    return expression_->distance();
}

}  // namespace vidno
