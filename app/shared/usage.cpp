// Prints CLI11's errors like all other errors: typed text may contain control characters.
#include "app/shared/usage.h"

#include "app/shared/exits.h"
#include "core/base/instruction_set.h"

namespace edgescan::cli {

std::optional<int> parsed(CLI::App& app, int argc, char** argv) {
    if (const auto set = wantedInstructionSet(); !set) {
        printError(set.error());
        return kWrongUsage;
    }
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        printError(std::string(error.what()) + " (--help tells more)");
        return kWrongUsage;
    }
}

} // namespace edgescan::cli
