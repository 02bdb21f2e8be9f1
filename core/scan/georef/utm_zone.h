// The UTM zone that a pose names.
#pragma once

#include <optional>
#include <string>

namespace edgescan {

struct UtmZone {
    int number = 0;
    bool south = false;
    [[nodiscard]] bool exists() const { return number >= 1 && number <= 60; }
};

/// "UTM 17N, WGS84", "WGS 84 / UTM zone 17S", "EPSG:32617"; and "17N, WGS84", as the fields zone and datum of a pose give it.
[[nodiscard]] std::optional<UtmZone> utmZone(const std::string& grid);

} // namespace edgescan
