// Parses numbers of the command line.
#include "app/shared/numbers.h"

namespace edgescan::cli {

std::string limitsText(NumberLimits limits, bool whole) {
    return std::string(whole ? "a whole number" : "a number") + " from " + shortestText(limits.least) + " to " + shortestText(limits.most);
}

std::string rangeName(NumberLimits limits) { return "NUMBER " + shortestText(limits.least) + ".." + shortestText(limits.most); }

double numberTyped(const std::string& flag, const std::string& text, NumberLimits limits, bool whole) {
    const std::optional<double> value = numberOf(text);
    if (value && limits.hold(*value) && (!whole || *value == std::floor(*value))) return *value;
    const bool isOutside = value && !limits.hold(*value);
    const std::string what = isOutside ? " is outside " + shortestText(limits.least) + " to " + shortestText(limits.most)
                             : value   ? " is not a whole number"
                                       : " is not a number";
    const std::string hint =
        isOutside ? std::string(whole ? "a whole number" : "a number") + " within these limits" : limitsText(limits, whole);
    throw CLI::ValidationError(flag, "\"" + text + "\"" + what + "; give " + hint);
}

} // namespace edgescan::cli
