// Prints CLI11's errors like all other errors: typed text may contain control characters.
#include "app/shared/usage.h"

#include "app/shared/exits.h"
#include "core/base/file_address.h"
#include "core/base/instruction_set.h"
#include "core/base/result.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::cli {
namespace {

/// CLI11 takes many words and every number as a value of a switch. Here a switch of any command is on without a value, and takes true or
/// false; the last one counts.
void checkSwitches(CLI::App& app, const std::vector<std::string>& words) {
    const auto trueOrFalse = [](const std::string& value) {
        return value == "true" || value == "false" ? std::string() : "\"" + value + "\" is not true or false";
    };
    for (CLI::Option* option : app.get_options([](const CLI::Option* one) { return one->get_items_expected_max() == 0; })) {
        const bool answers = option == app.get_help_ptr() || option == app.get_version_ptr();
        for (const std::string& name : option->get_lnames()) {
            const std::string flag = "--" + name;
            if (answers && std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(flag + "="); }))
                throw CLI::ValidationError(flag, "takes no value");
            // CLI11 does not distinguish an empty value from none
            if (std::ranges::find(words, flag + "=") != words.end()) throw CLI::ValidationError(flag, "\"\" is not true or false");
        }
        if (!answers) option->check(trueOrFalse);
    }
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) checkSwitches(*command, words);
}

/// A name of version 0.1 and what to type now.
struct Renamed {
    std::string_view command; ///< empty: the name is that of a command, or a flag of a program without commands
    std::string_view old, now;
};
constexpr std::array kRenamed = std::to_array<Renamed>({
    {"", "change", "compare"},
    {"", "serve", "edgescan-lab emulate"},
    {"", "simulate", "edgescan-lab simulate"},
    {"", "emulate", "edgescan-lab emulate"},
    {"", "calibrate", "edgescan-lab calibrate"},
    {"", "evaluate", "edgescan-lab evaluate"},
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
    {"simulate", "--repeat", "--sweep-number"},
    {"simulate", "--rocks", "--rock-count"},
    {"simulate", "--hole", "--hole-shape"},
    {"simulate", "--holes", "--hole-count"},
});

/// The smallest number of letters to insert, delete or replace.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// The known name that was probably meant; empty if all differ much.
std::string nearest(const std::string& typed, const std::vector<std::string>& known) {
    constexpr std::size_t kLongestName = 40;
    if (typed.size() > kLongestName) return {};
    std::string best;
    std::size_t least = 1 + std::max<std::size_t>(1, typed.size() / 3);
    for (const std::string& name : known) {
        const std::size_t distance = name.starts_with(typed) ? 1 : editDistance(typed, name);
        if (distance >= least) continue;
        least = distance;
        best = name;
    }
    return best;
}

std::string hintFor(std::string_view command, const std::string& typed, const std::vector<std::string>& known, const std::string& list) {
    const auto renamed =
        std::ranges::find_if(kRenamed, [&](const Renamed& one) { return one.command == command && one.old == std::string_view(typed); });
    if (renamed != kRenamed.end()) return "use " + std::string(renamed->now);
    const std::string meant = nearest(typed, known);
    return (meant.empty() ? "" : "did you mean " + meant + "? ") + list;
}

using Apps = std::vector<const CLI::App*>;

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
    return Error{"there is no such command", words[1], hintFor("", words[1], names, list)};
}

bool isFlag(const std::string& word) { return word.size() > 1 && word.starts_with('-'); }

/// Of a command line with `words` that are not expected.
Error unexpected(const CLI::App& app, const std::vector<std::string>& words) {
    const auto parsed = app.get_subcommands();
    const CLI::App& command = parsed.empty() ? app : *parsed.front();
    const std::string name = parsed.empty() ? "" : command.get_name();
    const std::string list = (name.empty() ? "" : name + " ") + "--help lists all flags";
    const auto flag = std::ranges::find_if(words, isFlag);
    if (flag == words.end()) return Error{"this argument is one too many", words.empty() ? "" : words.front(), list};
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options([](const CLI::Option* one) { return !one->get_group().empty(); }))
        for (const std::string& one : option->get_lnames()) known.push_back("--" + one);
    const std::string typed = flag->substr(0, flag->find('='));
    return Error{"there is no such flag", typed, hintFor(name, typed, known, list)};
}

/// "--sensor: At least 3 required but received 2": another number of values than the option takes.
std::optional<Error> otherCount(const CLI::App& app, const std::string& sentence) {
    constexpr std::string_view kReceived = " required but received ";
    const std::size_t at = sentence.find(kReceived), colon = sentence.find(':');
    if (at == sentence.npos || colon == sentence.npos) return std::nullopt;
    const auto parsed = app.get_subcommands();
    const CLI::App& command = parsed.empty() ? app : *parsed.front();
    const CLI::Option* option = command.get_option_no_throw(sentence.substr(0, colon));
    if (option == nullptr) return std::nullopt;
    return Error{"takes " + std::to_string(option->get_items_expected_min()) + " values and got " + sentence.substr(at + kReceived.size()),
                 option->get_name(), "its values: " + option->get_description()};
}

std::string inOurWords(std::string sentence) {
    for (std::size_t at = sentence.find("ubcommand"); at != std::string::npos; at = sentence.find("ubcommand"))
        sentence.replace(at - 1, 10, sentence[at - 1] == 'S' ? "Command" : "command");
    return sentence;
}

} // namespace

std::optional<int> parsed(CLI::App& app, int argc, char** argv) {
    if (const auto set = wantedInstructionSet(); !set) {
        printError(set.error());
        return kWrongUsage;
    }
    std::vector<std::string> words;
    std::vector<const char*> typed;
    for (int n = 0; n < argc; ++n) {
        auto word = pathOfAddress(argv[n]); // the desktop gives files by their addresses
        if (!word) {
            printError(word.error());
            return kWrongUsage;
        }
        words.push_back(std::move(*word));
    }
    for (const std::string& word : words) typed.push_back(word.c_str());
    if (const auto unknown = unknownCommand(app, words)) {
        printError(*unknown);
        return kWrongUsage;
    }
    try {
        checkSwitches(app, words);
        app.parse(argc, typed.data());
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        const std::vector<std::string> left = app.remaining(true);
        // An unknown flag explains more than the arguments that are missing or too many because of it.
        const bool counted =
            dynamic_cast<const CLI::RequiredError*>(&error) != nullptr || dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
        if ((counted && std::ranges::any_of(left, isFlag)) || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
            printError(unexpected(app, left));
        else if (const auto count = otherCount(app, error.what()))
            printError(*count);
        else
            printError(inOurWords(error.what()) + " (see --help)");
    }
    return kWrongUsage;
}

} // namespace edgescan::cli
