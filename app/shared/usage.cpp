// CLI11's errors told like all others: what was typed may hold anything.
#include "app/shared/usage.h"

#include "app/shared/exits.h"

namespace edgescan::cli {

std::optional<int> parsed(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        complain(std::string(error.what()) + " (--help tells more)");
        return 2;
    }
}

} // namespace edgescan::cli
