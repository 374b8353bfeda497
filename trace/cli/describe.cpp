/// What the program says about itself, for its packages: the manual and the completions, derived from the tables of
/// options.
#include <iomanip>
#include <iostream>
#include <sstream>

#include "cli/commands.h"

namespace vidno::cli {

namespace {

/// The commands and options, without those that the help hides.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands(
        [](const CLI::App* each) { return !each->get_name().empty() && !each->get_group().empty(); });
}
std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
    return app.get_options(
        [=](const CLI::Option* each) { return !each->get_group().empty() && each->get_positional() == positional; });
}

/// "-o" and "--kernel": the names of an option with their dashes.
std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const auto& name : option.get_snames()) names.push_back("-" + name);
    for (const auto& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// The words of which an option takes one. CLI11 names them in the option's type: "TEXT:{a,b}", or the kernels as
/// "TEXT:a, b:P (why), c". A word with a parameter is left out. Empty for a file or a number.
std::vector<std::string> choices_of(const CLI::Option& option) {
    std::string type = option.get_type_name();
    if (type.find(',') == type.npos) return {};
    type.erase(0, type.find(':') + 1);
    std::erase_if(type, [](char c) { return c == '{' || c == '}'; });
    std::vector<std::string> choices;
    std::istringstream words(type);
    for (std::string word; std::getline(words >> std::ws, word, ',');) {
        if (word.find_first_of(": ") == word.npos) choices.push_back(word);
    }
    return choices;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const auto& word : words) (text += text.empty() ? "" : between) += word;
    return text;
}

// The manual
// ------------------------------------------------------------

/// The character of more than one byte that begins here, as roff writes it, such as \[u2713]; passes it.
std::string roff_character(std::string_view text, std::size_t& at) {
    constexpr unsigned continued = 0x40, high = 0x80;  // values of the bytes' leading bits
    const auto byte = [&](std::size_t i) { return unsigned(static_cast<unsigned char>(text[i])); };
    unsigned bytes = 2;
    while (bytes < 4 && (byte(at) & (high >> bytes)) != 0) ++bytes;
    unsigned code = byte(at) & ((high >> bytes) - 1);
    for (unsigned i = 1; i < bytes && at + 1 < text.size(); ++i)
        code = code * continued + (byte(++at) & (continued - 1));
    std::ostringstream name;
    name << "\\[u" << std::uppercase << std::hex << std::setfill('0') << std::setw(4) << code << ']';
    return name.str();
}

/// Text as roff reads it unchanged.
std::string roff(const std::string& text) {
    std::string escaped;
    bool at_start = true;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (at_start && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\') {
            escaped += "\\e";
        } else if (c == '-') {
            escaped += "\\-";
        } else if (c == ',') {
            escaped += ",\\:";  // a long list of words may break here
        } else if ((static_cast<unsigned char>(c) & 0x80U) != 0) {
            escaped += roff_character(text, at);
        } else {
            escaped += c;
        }
        at_start = c == '\n';
    }
    return escaped;
}

void write_entry(std::ostream& out, const std::string& term, const std::string& text) {
    out << ".TP\n.B " << roff(term) << '\n' << roff(text.empty() ? "-" : text) << '\n';
}

void write_options(std::ostream& out, const CLI::App& app) {
    for (const CLI::Option* each : options_of(app, true))
        write_entry(out, each->get_name(true), each->get_description());
    for (const CLI::Option* each : options_of(app, false)) {
        const std::string type = each->get_type_name();
        write_entry(out, joined(names_of(*each), ", ") + (type.empty() ? "" : " " + type), each->get_description());
    }
}

void write_command(std::ostream& out, const CLI::App& app, const std::string& name) {
    out << ".SS " << roff(name) << '\n' << roff(app.get_description()) << ".\n";
    write_options(out, app);
    if (!app.get_footer().empty()) out << ".PP\n.nf\n" << roff(app.get_footer()) << "\n.fi\n";
    for (const CLI::App* each : commands_of(app)) write_command(out, *each, name + ' ' + each->get_name());
}

void write_manual(std::ostream& out, const CLI::App& program) {
    out << ".TH VIDNO 1 \"\" \"vidno " VIDNO_VERSION
           "\" \"User commands\"\n.ad l\n.SH NAME\nvidno \\- hidden-surface procedures, step by step\n"
        << ".SH SYNOPSIS\n.B vidno\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n"
        << roff(program.get_description()) << '\n'
        << roff(program.get_footer()) << "\n.SH OPTIONS\n";
    write_options(out, program);
    out << ".SH COMMANDS\n";
    for (const CLI::App* each : commands_of(program)) write_command(out, *each, each->get_name());
}

// Completions
// ------------------------------------------------------------

/// Calls `visit(path, app)` for the program and every command: the path is "", "trace", "lesson build".
void each_command(const CLI::App& app, const std::string& path, const auto& visit) {
    visit(path, app);
    for (const CLI::App* each : commands_of(app)) {
        each_command(*each, path + (path.empty() ? "" : " ") + each->get_name(), visit);
    }
}

std::string names_of_commands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each : commands_of(app)) names.push_back(each->get_name());
    return joined(names, " ");
}

void write_bash(std::ostream& out, const CLI::App& program) {
    out << R"(# Completion of vidno for bash
_vidno() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path='' i
    local commands options
    for ((i = 1; i <= COMP_CWORD; ++i)); do
        commands='' options=''
        case $path in
)";
    each_command(program, "", [&](const std::string& path, const CLI::App& app) {
        std::string options;
        for (const CLI::Option* each : options_of(app, false)) options += joined(names_of(*each), " ") + ' ';
        out << "            '" << path << "') commands='" << names_of_commands(app) << "' options='" << options
            << "' ;;\n";
    });
    out << R"(        esac
        ((i < COMP_CWORD)) || break
        [[ " $commands " != *" ${COMP_WORDS[i]} "* ]] || path="${path:+$path }${COMP_WORDS[i]}"
    done
    case $path:$before in
)";
    each_command(program, "", [&](const std::string& path, const CLI::App& app) {
        for (const CLI::Option* each : options_of(app, false)) {
            const auto choices = choices_of(*each);
            if (choices.empty()) continue;
            for (const auto& name : names_of(*each)) {
                out << "        '" << path << ':' << name << "') mapfile -t COMPREPLY < <(compgen -W '"
                    << joined(choices, " ") << "' -- \"$word\"); return ;;\n";
            }
        }
    });
    out << R"(    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    elif [[ $commands ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
    fi
}
complete -o default -F _vidno vidno
)";
}

/// Zsh reads the completion for bash.
void write_zsh(std::ostream& out, const CLI::App& program) {
    out << "#compdef vidno\nautoload -Uz bashcompinit && bashcompinit\n";
    write_bash(out, program);
}

}  // namespace

void add_describe(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("describe", "Write the manual, or the completions for bash or zsh");
    command.group("");  // not in the help: packages install these files
    const auto add = [&](const std::string& name, void (*write)(std::ostream&, const CLI::App&)) {
        command.add_subcommand(name)->callback([&program, &status, write] {
            write(std::cout, program);
            status = 0;
        });
    };
    command.require_subcommand(1);
    add("manual", write_manual);
    add("bash", write_bash);
    add("zsh", write_zsh);
}

}  // namespace vidno::cli
