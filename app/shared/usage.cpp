// Prints CLI11's errors like all other errors: typed text may contain control characters.
#include "app/shared/usage.h"

#include "app/shared/exits.h"
#include "core/base/instruction_set.h"

#include <algorithm>
#include <string_view>

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

} // namespace

std::optional<int> parsed(CLI::App& app, int argc, char** argv) {
    if (const auto set = wantedInstructionSet(); !set) {
        printError(set.error());
        return kWrongUsage;
    }
    try {
        checkSwitches(app, {argv, argv + argc});
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        printError(std::string(error.what()) + " (see --help)");
        return kWrongUsage;
    }
}

} // namespace edgescan::cli
