// Help texts, man pages and shell completion from CLI11's options. One source means that they cannot differ from the options.
#include "app/shared/pages.h"

#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <filesystem>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<const CLI::Option*> shownOptions(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// The allowed values of an option; empty if it takes any text.
std::vector<std::string> wordsOf(const CLI::Option& option) {
    std::vector<std::string> words;
    const std::string type = option.get_type_name();
    const std::size_t open = type.find('{');
    const std::size_t close = type.find('}');
    if (open != std::string::npos && close != std::string::npos) return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
    if (option.get_lnames().empty()) return words;
    const edges::Parameter* parameter = edges::findParameter(option.get_lnames().front());
    if (parameter == nullptr || option.get_group() != "Method") return words;
    for (const edges::Choice& choice : parameter->choices) words.emplace_back(choice.name);
    return words;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) { return CLI::detail::join(words, between); }

/// "-o,--output": all names of an option, with their hyphens.
std::vector<std::string> namesOf(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// What the help calls the value of an option: FILE, DIR, "NUMBER 0..20".
std::string valueName(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t brace = type.find_first_of("{:");
    const std::string name = type.substr(0, brace);
    return name.empty() ? "VALUE" : name;
}

/// The text of an option in the completion: the first sentence of its help, without limits.
std::string briefly(const std::string& help) {
    std::string text = help.substr(0, help.find(" ["));
    text = text.substr(0, text.find(". "));
    return text.substr(0, text.find("; "));
}

std::string replaced(const std::string& text, const std::vector<std::pair<char, std::string>>& with) {
    std::string out;
    for (const char c : text) {
        const auto found = std::ranges::find_if(with, [&](const auto& pair) { return pair.first == c; });
        out += found == with.end() ? std::string(1, c) : found->second;
    }
    return out;
}

// ---- man ----

/// Escapes text for roff: a line may begin with any character.
std::string roff(const std::string& text) {
    const std::string safe = replaced(text, {{'\\', "\\e"}, {'-', "\\-"}, {'\n', " "}, {'|', "|\\:"}});
    return !safe.empty() && (safe.front() == '.' || safe.front() == '\'') ? "\\&" + safe : safe;
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

// No justified text: long flags leave large gaps. groff 1.23 resets the adjustment to AD at each heading.
std::string heading(const std::string& page, const std::string& purpose) {
    return ".TH \"" + roff(upper(page)) + "\" \"1\" \"\" \"EdgeScan " + version() + "\" \"EdgeScan\"\n.ds AD l\n.ad l\n.nh\n.SH NAME\n" +
           roff(page) + " \\- " + roff(purpose) + "\n";
}

std::string synopsis(const CLI::App& app, const std::string& command) {
    std::string text = ".SH SYNOPSIS\n.B " + roff(command) + "\n";
    if (!commandsOf(app).empty()) return text + ".I COMMAND\n[\\fIOPTIONS\\fR]\n";
    for (const CLI::Option* option : shownOptions(app)) {
        if (!option->get_positional()) continue;
        const bool several = option->get_items_expected_max() > 1;
        const std::string name = "\\fI" + roff(option->get_name(true)) + "\\fR" + (several ? "..." : "");
        text += option->get_required() ? name + "\n" : "[" + name + "]\n";
    }
    return text + "[\\fIOPTIONS\\fR]\n";
}

std::string optionText(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : namesOf(option)) names.push_back("\\fB" + roff(name) + "\\fR");
    std::string text = ".TP\n" + (option.get_positional() ? "\\fI" + roff(option.get_name(true)) + "\\fR" : joined(names, ", "));
    const std::vector<std::string> words = wordsOf(option);
    if (takesValue(option) && !option.get_positional())
        text += words.empty() ? " \\fI" + roff(valueName(option)) + "\\fR" : " " + roff(joined(words, "|"));
    return text + "\n" + roff(option.get_description()) + "\n";
}

std::string optionsText(const CLI::App& app) {
    std::string text;
    for (const std::string& group : app.get_groups()) {
        std::string rows;
        for (const CLI::Option* option : shownOptions(app)) {
            if (option->get_group() == group) rows += optionText(*option);
        }
        if (!group.empty() && !rows.empty()) text += ".SH " + roff(upper(group)) + "\n" + rows;
    }
    return text;
}

std::string termsText(const std::string& heading, const std::vector<Term>& terms) {
    if (terms.empty()) return {};
    std::string text = ".SH " + heading + "\n";
    for (const Term& term : terms) text += ".TP\n\\fB" + roff(term.name) + "\\fR\n" + roff(term.meaning) + "\n";
    return text;
}

std::vector<Term> exitsOf(const CommandText& command) {
    std::vector<Term> exits{{"0", "everything was done"},
                            {"1", "an input was refused or unreadable, or an output could not be written"},
                            {"2", "the command line is wrong"}};
    exits.insert(exits.end(), command.exits.begin(), command.exits.end());
    return exits;
}

std::string endOf(const std::vector<std::string>& examples, const std::vector<Term>& files, const CommandText& command,
                  const std::vector<std::string>& others) {
    std::string text;
    if (!examples.empty()) {
        text += ".SH EXAMPLES\n.nf\n";
        for (const std::string& example : examples) text += roff(example) + "\n";
        text += ".fi\n";
    }
    text += termsText("EXIT STATUS", exitsOf(command)) + termsText("FILES", files);
    text += termsText("ENVIRONMENT",
                      {{"EDGESCAN_LOOPS", "For tests and benchmarks: the widest instruction set that loops use, plain, sse4.2, avx2 or "
                                          "avx512. Results do not depend on it. Without it, the widest that the processor has."}});
    if (others.empty()) return text;
    std::vector<std::string> links;
    for (const std::string& other : others) links.push_back("\\fB" + roff(other) + "\\fR(1)");
    return text + ".SH SEE ALSO\n" + joined(links, ",\n") + "\n";
}

std::string mainPage(const CLI::App& app, const PageText& page) {
    std::string text =
        heading(page.name, page.purpose) + synopsis(app, page.name) + ".SH DESCRIPTION\n" + roff(app.get_description()) + ".\n";
    std::vector<std::string> others;
    std::string group;
    if (!commandsOf(app).empty()) text += ".SH COMMANDS\n";
    for (const CLI::App* command : commandsOf(app)) {
        if (command->get_group() != group) text += ".SS " + roff(group = command->get_group()) + "\n";
        text += ".TP\n\\fB" + roff(command->get_name()) + "\\fR\n" + roff(command->get_description()) + ".\n";
        others.push_back(page.name + "-" + command->get_name());
    }
    return text + optionsText(app) + endOf(page.examples, page.files, {}, others);
}

const CommandText& textOf(const CLI::App& command, const PageText& page) {
    return *std::ranges::find(page.commands, command.get_name(), &CommandText::name);
}

std::string commandPage(const CLI::App& command, const PageText& page) {
    const std::string name = page.name + "-" + command.get_name();
    std::string purpose = command.get_description();
    purpose = purpose.substr(0, purpose.find(';'));
    const CommandText& text = textOf(command, page);
    return heading(name, purpose) + synopsis(command, page.name + " " + command.get_name()) + ".SH DESCRIPTION\n" +
           roff(command.get_description()) + ".\n" + optionsText(command) + endOf(text.examples, {}, text, {page.name});
}

// ---- help ----

/// What follows the flags in the help.
std::string footer(const std::vector<std::string>& examples, const std::vector<Term>& exits) {
    std::string text;
    if (!examples.empty()) text += "Examples:\n";
    for (const std::string& example : examples) text += "  " + example + "\n";
    if (!exits.empty()) text += std::string(text.empty() ? "" : "\n") + "Exit codes:\n";
    for (const Term& term : exits) text += "  " + term.name + "  " + term.meaning + "\n";
    if (!text.empty()) text.pop_back();
    return text;
}

/// CLI11 calls every text TEXT. The name of an argument says what it is; of a flag that has no better name it says VALUE.
void nameValues(CLI::App& command) {
    for (CLI::Option* option : command.get_options([](const CLI::Option* one) { return takesValue(*one); })) {
        if (option->get_positional())
            option->type_name("");
        else if (option->get_type_name() == "TEXT")
            option->type_name("VALUE");
    }
}

void completeHelp(CLI::App& app, const PageText& page) {
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("Positionals", "Arguments");
    app.footer(footer(page.examples, {}));
    nameValues(app);
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        const CommandText& text = textOf(*command, page);
        nameValues(*command);
        command->group(text.group);
        command->footer(footer(text.examples, exitsOf(text)));
    }
}

// ---- completion ----

/// A command with its flags: "detect", or an empty name for a program without commands.
struct Flags {
    std::string command;
    std::vector<const CLI::Option*> options;
};

std::vector<Flags> flagsOf(const CLI::App& app) {
    std::vector<Flags> all{{"", shownOptions(app)}};
    for (const CLI::App* command : commandsOf(app)) all.push_back({command->get_name(), shownOptions(*command)});
    for (Flags& flags : all) std::erase_if(flags.options, [](const CLI::Option* option) { return option->get_positional(); });
    return all;
}

std::string commandNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : commandsOf(app)) names.push_back(command->get_name());
    return joined(names, " ");
}

std::string bashText(const CLI::App& app, const std::string& program) {
    const std::string function = "_" + replaced(program, {{'-', "_"}});
    std::string text = "# bash completion for " + program + ", made by it\n" + function +
                       "() {\n    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} words=\n    COMPREPLY=()\n";
    std::string values, flags;
    for (const Flags& of : flagsOf(app)) {
        std::vector<std::string> names;
        for (const CLI::Option* option : of.options) {
            for (const std::string& name : namesOf(*option)) names.push_back(name);
            if (!takesValue(*option)) continue;
            for (const std::string& name : namesOf(*option))
                values += "        '" + of.command + " " + name + "') words='" + joined(wordsOf(*option), " ") + "'; value=1 ;;\n";
        }
        flags += "        '" + of.command + "') words='" + joined(names, " ") + "' ;;\n";
    }
    const std::string commands = commandNames(app);
    text += commands.empty() ? "    local command='' value=\n"
                             : "    local command=${COMP_WORDS[1]} value=\n    [ \"$COMP_CWORD\" -gt 1 ] || command=''\n";
    text += "    case \"$command $previous\" in\n" + values +
            "    esac\n    if [ -z \"$value\" ] && [[ $current == -* ]]; then\n        case $command in\n" + flags + "        esac\n";
    if (!commands.empty()) text += "    elif [ \"$COMP_CWORD\" -eq 1 ]; then\n        words='" + commands + "'\n";
    return text +
           "    fi\n    if [ -n \"$words\" ]; then mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"); fi\n}\ncomplete -o "
           "default -F " +
           function + " " + program + "\n";
}

std::string zshText(const CLI::App& app, const std::string& program) {
    const auto quoted = [](const std::string& text) { return replaced(text, {{'\'', "'\\''"}, {'[', "\\["}, {']', "\\]"}, {':', "\\:"}}); };
    std::string text = "#compdef " + program + "\n# zsh completion, made by " + program + "\n";
    std::string cases;
    for (const Flags& of : flagsOf(app)) {
        std::string rows;
        for (const CLI::Option* option : of.options) {
            const std::vector<std::string> words = wordsOf(*option);
            for (const std::string& name : namesOf(*option)) {
                rows += " \\\n        '" + name + "[" + quoted(briefly(option->get_description())) + "]";
                if (takesValue(*option)) rows += words.empty() ? ":value:_files" : ":value:(" + joined(words, " ") + ")";
                rows += "'";
            }
        }
        cases +=
            "    " + (of.command.empty() ? std::string("''") : of.command) + ") _arguments" + rows + " \\\n        '*:file:_files' ;;\n";
    }
    std::string rows;
    for (const CLI::App* command : commandsOf(app))
        rows += "    '" + command->get_name() + ":" + quoted(briefly(command->get_description())) + "'\n";
    if (rows.empty()) return text + "local command=''\ncase $command in\n" + cases + "esac\n";
    return text + "local -a commands=(\n" + rows +
           ")\nlocal command=''\nif (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n    _describe command commands\n    return\nfi\n"
           "if (( CURRENT > 2 )); then\n    command=$words[2]\n    shift words\n    (( CURRENT-- ))\nfi\ncase $command in\n" +
           cases + "esac\n";
}

std::string fishText(const CLI::App& app, const std::string& program) {
    const auto quoted = [](const std::string& text) { return "'" + replaced(text, {{'\\', "\\\\"}, {'\'', "\\'"}}) + "'"; };
    std::string text = "# fish completion for " + program + ", made by it\n";
    for (const CLI::App* command : commandsOf(app))
        text += "complete -c " + program + " -n __fish_use_subcommand -f -a " + command->get_name() + " -d " +
                quoted(briefly(command->get_description())) + "\n";
    for (const Flags& of : flagsOf(app)) {
        for (const CLI::Option* option : of.options) {
            text += "complete -c " + program;
            if (!of.command.empty())
                text += " -n '__fish_seen_subcommand_from " + of.command + "'";
            else if (!commandsOf(app).empty())
                text += " -n __fish_use_subcommand";
            for (const std::string& name : option->get_snames()) text += " -s " + name;
            for (const std::string& name : option->get_lnames()) text += " -l " + name;
            const std::vector<std::string> words = wordsOf(*option);
            if (takesValue(*option)) text += words.empty() ? " -r" : " -x -a " + quoted(joined(words, " "));
            text += " -d " + quoted(briefly(option->get_description())) + "\n";
        }
    }
    return text;
}

void write(const fs::path& path, const std::string& text) {
    if (const auto made = makeFolder(path.parent_path()); !made) throw CLI::ValidationError("--pages", made.error().sentence());
    if (const auto written = writeWholeFile(path, text); !written) throw CLI::ValidationError("--pages", written.error().sentence());
}

void writePages(const CLI::App& app, const PageText& page, const fs::path& folder) {
    write(folder / "man1" / (page.name + ".1"), mainPage(app, page));
    for (const CLI::App* command : commandsOf(app))
        write(folder / "man1" / (page.name + "-" + command->get_name() + ".1"), commandPage(*command, page));
    write(folder / "bash" / page.name, bashText(app, page.name));
    write(folder / "zsh" / ("_" + page.name), zshText(app, page.name));
    write(folder / "fish" / (page.name + ".fish"), fishText(app, page.name));
}

} // namespace

void addPages(CLI::App& app, const PageText& text) {
    completeHelp(app, text);
    app.add_option_function<std::string>(
           "--pages",
           [&app, text](const std::string& folder) {
               writePages(app, text, folder);
               throw CLI::Success();
           },
           "Writes man pages and completion")
        ->group("");
}

} // namespace edgescan::cli
