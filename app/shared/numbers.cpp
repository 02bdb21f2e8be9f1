// Parses numbers of the command line.
#include "app/shared/numbers.h"

namespace edgescan::cli {

Result<TypedCell> typedCell(const std::string& text, const char* flag) {
    const std::size_t comma = text.find(',');
    const double line = numberOf(text.substr(0, comma)).value_or(-1.0);
    const double beam = comma == std::string::npos ? -1.0 : numberOf(text.substr(comma + 1)).value_or(-1.0);
    const auto isIndex = [](double n) { return n >= 0 && n < 1e9 && n == static_cast<int>(n); };
    if (!isIndex(line) || !isIndex(beam)) return Error{"\"" + text + "\" is not a cell", flag, "give LINE,BEAM such as 525,593"};
    return TypedCell{static_cast<int>(line), static_cast<int>(beam)};
}

CLI::Validator cellText() {
    const auto check = [](const std::string& text) {
        const auto cell = typedCell(text, "");
        return cell ? std::string() : cell.error().what + "; " + cell.error().hint;
    };
    return {check, ""};
}

Result<std::uint32_t> cellIn(const Scan& scan, const std::string& text, const char* flag) {
    const Result<TypedCell> cell = typedCell(text, flag);
    if (!cell) return cell.error();
    const bool noLine = cell->line >= scan.lines();
    if (noLine || cell->beam >= scan.beams())
        return Error{"the scan has no " + (noLine ? "line " + std::to_string(cell->line) : "beam " + std::to_string(cell->beam)), flag,
                     "lines run from 0 to " + std::to_string(scan.lines() - 1) + ", beams from 0 to " + std::to_string(scan.beams() - 1)};
    return static_cast<std::uint32_t>(scan.rangeMm.index(cell->line, cell->beam));
}

std::string limitsText(NumberLimits limits, bool whole) {
    return std::string(whole ? "a whole number" : "a number") + " from " + shortestText(limits.least) + " to " + shortestText(limits.most);
}

std::string rangeName(NumberLimits limits) { return "NUMBER " + shortestText(limits.least) + ".." + shortestText(limits.most); }

std::string unitIn(const std::string& help) {
    const std::size_t from = help.find('['), to = help.find(']');
    return from < to && to != help.npos ? help.substr(from + 1, to - from - 1) : std::string();
}

double numberTyped(const std::string& flag, const std::string& text, NumberLimits limits, bool whole, const std::string& unit) {
    const std::optional<double> value = numberOf(text);
    if (value && limits.hold(*value) && (!whole || *value == std::floor(*value))) return *value;
    const bool isOutside = value && !limits.hold(*value);
    const std::string what = isOutside ? " is outside " + shortestText(limits.least) + " to " + shortestText(limits.most)
                             : value   ? " is not a whole number"
                                       : " is not a number";
    const std::string hint =
        isOutside ? std::string(whole ? "a whole number" : "a number") + " within these limits" : limitsText(limits, whole);
    throw CLI::ValidationError(flag, "\"" + text + "\"" + what + "; give " + hint + (unit.empty() ? "" : ", in " + unit));
}

} // namespace edgescan::cli
