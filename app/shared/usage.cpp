// Prints CLI11's errors like all other errors: typed text may contain control characters.
#include "app/shared/usage.h"

#include "app/shared/exits.h"
#include "core/base/file_address.h"
#include "core/base/instruction_set.h"
#include "core/base/nearest_name.h"
#include "core/base/replaced_files.h"
#include "core/base/result.h"
#include "core/edges/settings/parameters.h"
#include "core/rocks/selection/rock_settings.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::cli {
namespace {

/// CLI11 takes many words and every number as a value of a switch. Here a switch of any command is on without a value, and takes true or
/// false; the last one counts. Every other value has letters: an unset variable of a shell is not "no value".
void checkValues(CLI::App& app, const std::vector<std::string>& words) {
    const auto someValue = [](const std::string& value) {
        return value.empty() ? std::string("the value is empty; give one, or leave this out") : std::string();
    };
    const auto noFile = [](const std::string& value) {
        std::error_code ignored;
        return std::filesystem::is_regular_file(value, ignored) ? value + ": this is the name of one file; give the name of a folder"
                                                                : std::string();
    };
    for (CLI::Option* option : app.get_options([](const CLI::Option* one) { return one->get_items_expected_max() > 0; })) {
        option->check(someValue);
        if (option->get_type_name() == "DIR") option->check(noFile);
    }
    const auto trueOrFalse = [](const std::string& value) {
        return value == "true" || value == "false" ? std::string()
                                                   : "\"" + value + "\" is not true or false; write the flag alone, or with =false";
    };
    for (CLI::Option* option : app.get_options([](const CLI::Option* one) { return one->get_items_expected_max() == 0; })) {
        const bool answers = option == app.get_help_ptr() || option == app.get_version_ptr();
        for (const std::string& name : option->get_lnames()) {
            const std::string flag = "--" + name;
            if (answers && std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(flag + "="); }))
                throw CLI::ValidationError(flag, "takes no value; write the flag alone");
            // CLI11 does not distinguish an empty value from none
            if (std::ranges::find(words, flag + "=") != words.end()) throw CLI::ValidationError(flag, trueOrFalse(""));
        }
        if (!answers) option->check(trueOrFalse);
    }
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) checkValues(*command, words);
}

/// A name of version 0.1 or of another program, and what to type.
struct Renamed {
    std::string_view command; ///< empty: the name is that of a command, or a flag of a program without commands; "*": a flag of any command
    std::string_view old, now;
};
constexpr std::array kRenamed = std::to_array<Renamed>({
    {"", "change", "compare"},
    {"", "serve", "edgescan-lab emulate"},
    {"", "help", "COMMAND --help"},
    {"*", "--threshold", "--edge-strength, or --lower for gray levels"},
    {"*", "--strength", "--edge-strength"},
    {"*", "-j", "--jobs"},
    {"*", "-v", "--progress"},
    {"", "--standing", "--stop-and-go"},
    {"why", "--line", "--cell LINE,BEAM"},
    {"why", "--beam", "--cell LINE,BEAM"},
    {"detect", "--ndjson", "--json -, which prints one line for each of several scans"},
    {"record", "--first-line", "--line-start"},
    {"record", "--standing", "--stop-and-go"},
    {"compare", "--poses", "--poses-3dtk"},
    {"repeatability", "--poses", "--poses-3dtk"},
    {"evaluate", "--ranges", "--scan-of-mask"},
    {"batch", "--strict", "the exit code: it is 4 where a scan was refused or failed"},
    {"emulate", "--split", "--split-sends"},
    {"emulate", "--merge", "--merge-sends"},
    {"emulate", "--loss", "--lose-every N"},
    {"simulate", "--repeat", "--sweep-number"},
    {"simulate", "--rocks", "--rock-count"},
    {"simulate", "--hole", "--hole-shape"},
    {"simulate", "--holes", "--hole-count"},
});

/// The programs and their commands.
struct Program {
    std::string_view name, commands;
};
constexpr std::array kPrograms{
    Program{"edgescan-cli", " audit batch compare convert detect info record replay report rocks thumbnail verify why "},
    Program{"edgescan-lab", " benchmark calibrate clicks emulate evaluate families learn-borders learn-confidence learn-edges learn-rocks "
                            "repeatability simulate stones "}};

/// A name that can be meant, and what to do then.
struct Meaning {
    std::string name, hint;
};

/// The hint of the name that was typed, or of the nearest one; at last `list`.
std::string hintFor(const std::vector<Meaning>& meanings, const std::string& typed, const std::string& list) {
    if (const auto same = std::ranges::find(meanings, typed, &Meaning::name); same != meanings.end()) return same->hint;
    std::vector<std::string> names;
    for (const Meaning& one : meanings) {
        if (one.name.size() > 2) names.push_back(one.name); // every letter is near to every other
    }
    const auto near = std::ranges::find(meanings, nearestName(typed, names), &Meaning::name);
    return near == meanings.end() ? list : near->hint + (near->hint.ends_with('?') ? " " + list : "");
}

/// Old names first, then the names themselves.
std::vector<Meaning> meaningsOf(std::string_view command, const std::vector<std::string>& known) {
    std::vector<Meaning> all;
    for (const Renamed& one : kRenamed) {
        const auto isKnown = [&](const std::string& name) { return one.now.starts_with(name); };
        if (one.command == command || (one.command == "*" && !command.empty() && std::ranges::any_of(known, isKnown)))
            all.push_back({std::string(one.old), "use " + std::string(one.now)});
    }
    for (const std::string& name : known) all.push_back({name, "did you mean " + name + "?"});
    return all;
}

using Apps = std::vector<const CLI::App*>;

bool isThere(const std::string& path) {
    std::error_code ignored; // of a name that is too long, or below a folder that may not be read
    return std::filesystem::exists(path, ignored);
}

/// The first word, where it should be a command and is not.
std::optional<Error> unknownCommand(const CLI::App& app, const std::vector<std::string>& words) {
    const Apps commands = app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
    if (commands.empty()) return std::nullopt;
    const std::string list = "--help lists the commands";
    if (words.size() < 2) return Error{"no command was given", "", list};
    if (words[1].starts_with("-")) return std::nullopt;
    std::vector<std::string> names;
    for (const CLI::App* command : commands) names.push_back(command->get_name());
    if (std::ranges::find(names, words[1]) != names.end()) return std::nullopt;
    if (std::ranges::find(names, "detect") != names.end() && isThere(words[1]))
        return Error{"this is a file, not a command", words[1], "type " + programName() + " detect " + words[1]};
    std::vector<Meaning> meanings = meaningsOf("", names);
    if (app.get_option_no_throw("--" + words[1]) != nullptr) meanings.push_back({words[1], "use --" + words[1]});
    for (const Program& other : kPrograms) {
        if (other.commands.find(" " + words[1] + " ") != std::string_view::npos)
            meanings.push_back({words[1], "use " + std::string(other.name) + " " + words[1]});
    }
    return Error{"there is no such command", words[1], hintFor(meanings, words[1], list)};
}

bool isFlag(const std::string& word) { return word.size() > 1 && word.starts_with('-'); }

/// The command that was typed; without one, the program.
const CLI::App& commandOf(const CLI::App& app) {
    const auto typed = app.get_subcommands();
    return typed.empty() ? app : *typed.front();
}

/// "FILE", "NUMBER 0..1": the value of a flag; only a number with its limits.
std::string valueOf(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::string word = type.substr(0, type.find_first_of(type.starts_with("NUMBER") ? "{:" : " {:"));
    return word.empty() || word == "TEXT" ? "VALUE" : word;
}

/// "FILE", "-o DIR", "--cell LINE,BEAM LINE,BEAM": how an argument or a flag is written, with each value that it must have.
std::string valuesOf(const CLI::Option& option) {
    const std::string one = option.get_positional() ? option.get_name() : valueOf(option);
    std::string text = option.get_positional() ? "" : option.get_snames().empty() ? option.get_name() : "-" + option.get_snames().front();
    for (int n = 0; n < std::max(1, option.get_items_expected_min()); ++n) text += (text.empty() ? "" : " ") + one;
    return text;
}

/// A command with the arguments and flags that it needs; of an argument or a flag with several values as many.
std::string usageOf(const CLI::App& app, const CLI::App& command) {
    std::string line = programName() + (&command == &app ? "" : " " + command.get_name());
    for (const bool arguments : {true, false}) {
        for (const CLI::Option* one : command.get_options([&](const CLI::Option* o) { return o->get_required(); })) {
            if (one->get_positional() == arguments) line += " " + valuesOf(*one);
        }
    }
    return line;
}

/// The flags with their names, "--jump", that the help shows.
std::vector<std::string> longFlagsOf(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options([](const CLI::Option* one) { return !one->get_group().empty(); }))
        for (const std::string& one : option->get_lnames()) names.push_back("--" + one);
    return names;
}

/// "Crease angle" of the window is --crease-angle.
template <class Rows>
void addLabels(std::vector<Meaning>& meanings, const Rows& rows, const std::vector<std::string>& known) {
    for (const auto& row : rows) {
        std::string label = std::string("--") + row.label;
        std::ranges::transform(label, label.begin(), [](char c) {
            return c == ' ' ? '-' : c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
        });
        const std::string flag = std::string("--") + row.key;
        if (std::ranges::find(known, flag) != known.end()) meanings.push_back({label, "use " + flag});
    }
}

/// What an unknown flag can mean: an old name, the name in the window, or a flag of other commands.
std::vector<Meaning> flagMeanings(const CLI::App& app, const CLI::App& command, const std::string& typed) {
    const std::string name = &command == &app ? "" : command.get_name();
    const std::vector<std::string> known = longFlagsOf(command);
    std::vector<Meaning> meanings = meaningsOf(name, known);
    addLabels(meanings, edges::parameters(), known);
    addLabels(meanings, rocks::rockParameters(), known);
    std::string others;
    for (const CLI::App* other : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
        if ("--" + other->get_name() == typed && name.empty())
            meanings.push_back({typed, "this is a command: type " + usageOf(app, *other)});
        const std::vector<std::string> flags = longFlagsOf(*other);
        if (std::ranges::find(flags, typed) != flags.end()) others += (others.empty() ? "" : ", ") + other->get_name();
    }
    if (!others.empty()) meanings.push_back({typed, "it is a flag of " + others});
    return meanings;
}

/// Of a command line with `left` that are not expected.
Error unexpected(const CLI::App& app, const std::vector<std::string>& words, const std::vector<std::string>& left) {
    const CLI::App& command = commandOf(app);
    const std::string name = &command == &app ? "" : command.get_name();
    const std::string list = (name.empty() ? "" : name + " ") + "--help lists all flags";
    const auto flag = std::ranges::find_if(left, isFlag);
    if (flag == left.end()) {
        const std::string extra = left.empty() ? "" : left.front();
        const auto at = std::ranges::find(words, extra);
        // "--cell 1 2": the values of one flag, with a blank between them
        const CLI::Option* option = at - words.begin() < 3 || at == words.end() ? nullptr : command.get_option_no_throw(*(at - 2));
        const bool pair = option != nullptr && option->get_type_name().find(',') != std::string::npos;
        return Error{"this argument is one too many", extra,
                     pair ? "write " + *(at - 2) + " " + option->get_type_name()
                          : "type " + usageOf(app, command) + (isThere(extra) ? ", once for each" : "")};
    }
    if (isThere(*flag)) return Error{"this file is read as a flag", *flag, "write ./" + *flag};
    const std::string typed = flag->substr(0, flag->find('='));
    if (words.size() > 1 && isFlag(words[1]) && !name.empty() && *flag == words[1])
        return Error{"this flag belongs behind the command", typed, "type " + programName() + " " + name + " " + typed};
    return Error{"there is no such flag", typed, hintFor(flagMeanings(app, command, typed), typed, list)};
}

/// An argument that must be there and is not.
Error missing(const CLI::App& app, const CLI::App& command, const CLI::Option& option) {
    if (!option.get_positional()) return {option.get_name() + " is missing", "", "give " + option.get_name() + " " + valueOf(option)};
    return {option.get_name() + " is missing", "", "type " + usageOf(app, command)};
}

Error noValue(const CLI::Option& option) {
    return {"a value is missing", option.get_name(), "give " + option.get_name() + " " + valueOf(option)};
}

/// Another number of values than the option takes: none, too few, or too many.
Error otherCount(const CLI::App& app, const CLI::Option& option, const std::string& sentence, const std::vector<std::string>& words) {
    constexpr std::string_view kReceived = "received ";
    const std::size_t at = sentence.find(kReceived);
    const int least = option.get_items_expected_min();
    if (at == sentence.npos) return noValue(option);
    std::string names; // of the flag, as typed
    std::string typed; // its last value
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (!isFlag(word) || !option.check_name(name)) continue;
        if ((names + " ").find(name + " ") == names.npos) names += (names.empty() ? "" : " and ") + name;
        typed = name != word ? word.substr(name.size() + 1) : &word == &words.back() ? "" : *(&word + 1);
    }
    if (least < 2 && names.find(' ') != names.npos) return {names + " are one flag", "", "give one of them, once"};
    if (least < 2) return {option.get_name() + " is given more than once", "", "give it once"};
    const std::string count = std::to_string(least);
    const std::string hint = option.get_delimiter() == ','
                                 ? "write \"" + typed + "\" as " + count + " numbers with commas between them: " + option.get_description()
                             : option.get_positional() ? "type " + usageOf(app, commandOf(app))
                                                       : "give " + valuesOf(option);
    return {"takes " + count + " values and got " + sentence.substr(at + kReceived.size()), option.get_name(), hint};
}

/// "\"inch\" is not one of its values; use mm, cm or m" of CLI11's "inch not in {mm,cm,m}"; our own sentences stay.
std::string refusedValue(const std::string& sentence) {
    constexpr std::string_view kNotIn = " not in {", kValue = "Value ", kNotInRange = " not in range ";
    if (const std::size_t range = sentence.find(kNotInRange); range != sentence.npos && sentence.starts_with(kValue))
        return sentence.substr(kValue.size(), range - kValue.size()) + " is outside " + sentence.substr(range + kNotInRange.size()) +
               "; give a number within these limits";
    const std::size_t at = sentence.find(kNotIn);
    if (at == sentence.npos) return sentence;
    const std::vector<std::string> words =
        CLI::detail::split(sentence.substr(at + kNotIn.size(), sentence.rfind('}') - at - kNotIn.size()), ',');
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : &word == &words.back() ? " or " : ", ") + word;
    return "\"" + sentence.substr(0, at) + "\" is not one of its values; use " + list;
}

/// CLI11's error as what, where and what to do.
Error inOurWords(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error) {
    const std::string sentence = error.what();
    const CLI::App& command = commandOf(app);
    const std::string name = sentence.substr(0, sentence.find_first_of(": "));
    const CLI::Option* option = command.get_option_no_throw(name);
    const std::string list = (&command == &app ? "" : command.get_name() + " ") + "--help lists all flags";
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && option != nullptr) return missing(app, command, *option);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && option != nullptr)
        return otherCount(app, *option, sentence, words);
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) return {sentence, "", "give one of them"};
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) return {sentence, "", "give both"};
    if (dynamic_cast<const CLI::ValidationError*>(&error) == nullptr) return {sentence, "", list};
    const std::size_t colon = sentence.find(": ");
    const std::string value = refusedValue(colon == sentence.npos ? sentence : sentence.substr(colon + 2));
    const std::size_t hint = value.find("; ");
    return {value.substr(0, hint), colon == sentence.npos ? "" : sentence.substr(0, colon),
            hint == value.npos ? list : value.substr(hint + 2)};
}

/// The desktop gives files by their addresses: "file:///a.pcd" is "/a.pcd", also as the value of a flag, "--pose=file:///a.json".
Result<std::string> withoutAddress(const std::string& word) {
    const std::size_t equals = isFlag(word) ? word.find('=') : word.npos;
    if (equals == word.npos) return pathOfAddress(word);
    auto value = pathOfAddress(word.substr(equals + 1));
    return value ? word.substr(0, equals + 1) + *value : value;
}

/// "--jump" of "\u2014jump", as a word processor writes it; empty: the word begins with no long dash.
std::string withTwoDashes(std::string_view word) {
    constexpr std::array<std::string_view, 4> kDashes{"-", "\u2013", "\u2014", "\u2212"};
    bool isLong = false;
    const auto next = [&] { return std::ranges::find_if(kDashes, [&](std::string_view dash) { return word.starts_with(dash); }); };
    for (auto dash = next(); dash != kDashes.end(); dash = next()) {
        isLong = isLong || dash->size() > 1;
        word.remove_prefix(dash->size());
    }
    return isLong ? "--" + std::string(word) : std::string();
}

/// What the parser would take for something else: a flag as a value or as a file. After -- every word is a file: `words` gets "./-x" for
/// "-x". "-.ply" is standard output, and the parser gets it last.
Result<Done> checkFlags(const CLI::App& app, std::vector<std::string>& words) {
    const Apps commands = app.get_subcommands([&](const CLI::App* one) { return words.size() > 1 && one->get_name() == words[1]; });
    const CLI::App& command = commands.empty() ? app : *commands.front();
    const auto optionOf = [&](const std::string& word) {
        return isFlag(word) ? command.get_option_no_throw(word.substr(0, word.find('='))) : nullptr;
    };
    std::vector<std::string> streams;
    const auto addStreams = [&] {
        if (!streams.empty()) words.emplace_back("--");
        words.insert(words.end(), streams.begin(), streams.end());
    };
    std::size_t n = 1;
    for (; n < words.size() && words[n] != "--"; ++n) {
        if (words[n].starts_with("-.") && !isThere(words[n])) {
            streams.push_back(words[n]);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(n--));
            continue;
        }
        std::string flag = withTwoDashes(words[n]);
        if (flag.size() == 3 && optionOf(flag) == nullptr) flag.erase(0, 1); // of one letter
        if (optionOf(flag) != nullptr) return Error{"this begins with a long dash", words[n], "write " + flag};
        const CLI::Option* option = optionOf(words[n]);
        const std::size_t equals = words[n].find('=');
        if (!isFlag(words[n]) && equals != std::string::npos && !isThere(words[n]) && optionOf("--" + words[n]) != nullptr)
            return Error{"this is neither a file nor a flag", words[n], "write --" + words[n]};
        if (option == nullptr || equals != std::string::npos) continue;
        const int values = option->get_delimiter() == '\0' ? option->get_items_expected_min() : 1;
        for (int value = 0; value < values && n + 1 < words.size(); ++value) {
            ++n;
            if (words[n] == "--" || optionOf(words[n]) != nullptr) return noValue(*option);
        }
    }
    if (n >= words.size()) return addStreams(), Done{};
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(n));
    for (; n < words.size(); ++n) {
        if (optionOf(words[n]) != nullptr) return Error{"after -- every word is a file", words[n], "write flags before --"};
        if (isFlag(words[n])) words[n].insert(0, "./");
    }
    addStreams();
    return Done{};
}

} // namespace

std::optional<int> parsed(CLI::App& app, int argc, char** argv, const std::function<void()>& addOthers) {
    if (const auto set = wantedInstructionSet(); !set) return failWith(set.error(), kWrongUsage);
    std::vector<std::string> words;
    std::vector<const char*> typed;
    for (int n = 0; n < argc; ++n) {
        auto word = withoutAddress(argv[n]);
        if (!word) return failWith(word.error(), kWrongUsage);
        words.push_back(std::move(*word));
    }
    if (const auto unknown = unknownCommand(app, words)) return failWith(*unknown, kWrongUsage);
    if (const auto right = checkFlags(app, words); !right) return failWith(right.error(), kWrongUsage);
    for (const std::string& word : words) typed.push_back(word.c_str());
    try {
        checkValues(app, words);
        app.parse(static_cast<int>(typed.size()), typed.data());
        for (const std::string& word : words) { // what no command has said yet
            const std::string path = isFlag(word) ? word.substr(word.find('=') + 1) : word;
            if (popReplaced(path)) printError(path + ": replaced.");
        }
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        const std::vector<std::string> left = app.remaining(true);
        // An unknown flag explains more than the arguments that are missing or too many because of it.
        const bool counted =
            dynamic_cast<const CLI::RequiredError*>(&error) != nullptr || dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
        if ((counted && std::ranges::any_of(left, isFlag)) || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
            addOthers(), printError(unexpected(app, words, left));
        else
            printError(inOurWords(app, words, error));
    }
    return kWrongUsage;
}

} // namespace edgescan::cli
