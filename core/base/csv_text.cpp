// Quotes cells and marks the beginnings of formulas.
#include "core/base/csv_text.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"

#include <cmath>

namespace edgescan {
namespace {

std::string withoutFormulas(const std::string& text) {
    std::string result;
    bool cellBegins = true;
    for (const char c : text) {
        if (cellBegins && std::string_view("=+-@").find(c) != std::string_view::npos) result += '\'';
        result += c;
        const bool separates = c == ';' || c == '|'; // a text with a comma is quoted
        const bool isSkipped = c == ' ' || c == '"'; // by some readers, at the beginning of a cell
        cellBegins = separates || (cellBegins && isSkipped);
    }
    return result;
}

} // namespace

std::string csvCell(std::string_view text) {
    if (const auto number = numberOf(text); number && std::isfinite(*number)) return std::string(text);
    const std::string shown = withoutFormulas(printable(escapedBytes(text), 4 * kMostShown));
    if (shown.find_first_of(",\"") == std::string::npos) return shown;
    std::string quoted = "\"";
    for (const char c : shown) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

} // namespace edgescan
