// Flags of `benchmark` and `repeatability`.
#include "app/lab/commands/compared_methods.h"

#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <limits>

#include <unistd.h>

namespace edgescan::cli {

void addComparedFlags(CLI::App& command, ComparedFlags& flags) {
    addJsonFlag(command, flags.json, "All figures");
    CLI::Option& radius =
        addNumber(command, "--radius", flags.settings.pclLimits.radiusM, {0.001, 10}, "Radius of PCL's BoundaryEstimation [m]");
    CLI::Option& seconds = addNumber(command, "--peer-seconds", flags.settings.pclLimits.seconds, {0, 1e6},
                                     "A PCL peer that works point by point stops after this time [s]");
    CLI::Option* slow = command.add_flag("--slow", flags.slow, "Let every PCL peer end, however long it takes");
    CLI::Option* only = command.add_option("--only", flags.settings.only, "Only these of our methods, and no peers: thesis,edgescan+")
                            ->delimiter(',')
                            ->type_name("NAME,...");
    CLI::Option* none = command.add_flag("--no-peers", flags.noPeers, "Leave the PCL peers out");
    for (CLI::Option* ofPeers : {&radius, &seconds, slow}) ofPeers->excludes(only)->excludes(none);
    addReadFlags(command, flags.read);
}

std::optional<Error> unknownKey(const ComparedFlags& flags) {
    const std::vector<std::string> known = lab::comparedKeys();
    for (const std::string& key : flags.settings.only) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string names;
        for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
        return Error{"no method is called \"" + key + "\"", "--only", "use " + names};
    }
    return std::nullopt;
}

lab::ComparisonSettings comparisonSettings(const ComparedFlags& flags) {
    lab::ComparisonSettings settings = flags.settings;
    settings.withPcl = !flags.noPeers && flags.settings.only.empty();
    if (flags.slow) settings.pclLimits.seconds = std::numeric_limits<double>::infinity();
    return settings;
}

bool showsProgress(const ComparedFlags& flags) { return flags.read.progress || isatty(STDERR_FILENO) != 0; }

lab::ComparisonProgress shownProgress(const ComparedFlags& flags) {
    return [shown = showsProgress(flags)](const char* name, double fraction) {
        if (shown) showProgress(rightAligned(fixedText(100 * fraction, 0), 3) + " % " + name, fraction >= 1.0);
        return true;
    };
}

} // namespace edgescan::cli
