// Looks for a zone in the words of a pose.
#include "core/scan/georef/utm_zone.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

namespace edgescan {
namespace {

/// Letters and digits only, in capitals.
std::string bareText(const std::string& grid) {
    std::string bare;
    for (const char c : grid.substr(0, 100)) {
        if (c >= 'a' && c <= 'z') bare += static_cast<char>(c - 'a' + 'A');
        if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) bare += c;
    }
    return bare;
}

/// The whole number at `at`, and how many digits it has.
std::pair<int, std::size_t> numberAt(const std::string& text, std::size_t at) {
    int number = 0;
    const char* first = text.data() + std::min(at, text.size());
    const auto end = std::from_chars(first, text.data() + text.size(), number).ptr;
    return {number, static_cast<std::size_t>(end - first)};
}

/// "17N" at the beginning of a bare text, alone or before the name of the datum: no "17South Street".
std::optional<UtmZone> zoneIn(std::string_view text) {
    const auto [number, digits] = numberAt(std::string(text), 0);
    if (digits == 0 || digits > 2 || text.size() <= digits) return std::nullopt;
    const char side = text[digits];
    const std::string_view rest = text.substr(digits + 1);
    if ((side != 'N' && side != 'S') || !(rest.empty() || rest.starts_with("WGS"))) return std::nullopt;
    return UtmZone{number, side == 'S'};
}

} // namespace

std::optional<UtmZone> utmZone(const std::string& grid) {
    const std::string bare = bareText(grid);
    std::optional<UtmZone> zone;
    if (const std::size_t at = bare.find("EPSG"); at != std::string::npos) {
        const auto [code, digits] = numberAt(bare, at + 4);
        if (digits == 5 && (code / 100 == 326 || code / 100 == 327)) zone = UtmZone{code % 100, code / 100 == 327};
    } else if (bare.find("WGS84") != std::string::npos) {
        std::string_view text = bare;
        if (const std::size_t utm = bare.find("UTM"); utm != std::string::npos)
            text.remove_prefix(utm + 3);
        else if (text.starts_with("WGS84"))
            text.remove_prefix(5);
        if (text.starts_with("ZONE")) text.remove_prefix(4);
        zone = zoneIn(text);
    }
    return zone;
}

} // namespace edgescan
