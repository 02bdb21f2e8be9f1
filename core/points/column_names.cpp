// One table of names.
#include "core/points/column_names.h"

#include <algorithm>
#include <array>

namespace edgescan {
namespace {

struct KnownName {
    const char* name;
    ColumnRole role;
};

using Role = ColumnRole;

// A role's usual name first. Lower case, letters and digits only.
constexpr std::array<KnownName, 69> kNames{{
    {"x", Role::X},
    {"easting", Role::X},
    {"eastings", Role::X},
    {"east", Role::X},
    {"e", Role::X},
    {"xcoord", Role::X},
    {"xcoordinate", Role::X},
    {"coordx", Role::X},
    {"posx", Role::X},
    {"rechtswert", Role::X},
    {"ostwert", Role::X},
    {"y", Role::Y},
    {"northing", Role::Y},
    {"northings", Role::Y},
    {"north", Role::Y},
    {"n", Role::Y},
    {"ycoord", Role::Y},
    {"ycoordinate", Role::Y},
    {"coordy", Role::Y},
    {"posy", Role::Y},
    {"hochwert", Role::Y},
    {"nordwert", Role::Y},
    {"z", Role::Z},
    {"elevation", Role::Z},
    {"elev", Role::Z},
    {"height", Role::Z},
    {"altitude", Role::Z},
    {"alt", Role::Z},
    {"rl", Role::Z},
    {"reducedlevel", Role::Z},
    {"level", Role::Z},
    {"h", Role::Z},
    {"el", Role::Z},
    {"zcoord", Role::Z},
    {"zcoordinate", Role::Z},
    {"coordz", Role::Z},
    {"posz", Role::Z},
    {"up", Role::Z},
    {"u", Role::Z},
    {"line", Role::Line},
    {"lineindex", Role::Line},
    {"scanline", Role::Line},
    {"row", Role::Line},
    {"rowindex", Role::Line},
    {"ring", Role::Line},
    {"lineno", Role::Line},
    {"rows", Role::Line},
    {"beam", Role::Beam},
    {"beamindex", Role::Beam},
    {"column", Role::Beam},
    {"columnindex", Role::Beam},
    {"col", Role::Beam},
    {"colindex", Role::Beam},
    {"beamno", Role::Beam},
    {"rangemm", Role::RangeMm},
    {"state", Role::State},
    {"scannerx", Role::ScannerX},
    {"scannery", Role::ScannerY},
    {"scannerz", Role::ScannerZ},
    {"hoehe", Role::Z},
    {"filledsd", Role::FilledSdMm}, // filled_sd_mm without its unit
    {"intensity", Role::Intensity},
    {"scalarintensity", Role::Intensity}, // as CloudCompare names it in PLY
    {"reflectance", Role::Intensity},
    {"reflectivity", Role::Intensity},
    {"rssi", Role::Intensity},
    {"rssi1", Role::Intensity},
    {"remission", Role::Intensity},
    {"amplitude", Role::Intensity},
}};

std::string plain(std::string_view text) {
    std::string letters;
    for (char c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
    }
    return letters;
}

std::optional<double> unitNamed(const std::string& text) {
    if (text == "mm" || text == "millimetre" || text == "millimetres" || text == "millimeter" || text == "millimeters") return 1.0;
    if (text == "cm" || text == "centimetre" || text == "centimetres" || text == "centimeter" || text == "centimeters") return 10.0;
    if (text == "km" || text == "kilometre" || text == "kilometres" || text == "kilometer" || text == "kilometers") return 1e6;
    if (text == "ft" || text == "feet" || text == "foot" || text == "ift") return 304.8;
    if (text == "usft" || text == "ftus" || text == "ussurveyfeet") return 1200.0 / 3937.0 * 1000.0;
    if (text == "in" || text == "inch" || text == "inches") return 25.4;
    if (text == "m" || text == "metre" || text == "metres" || text == "meter" || text == "meters") return 1000.0;
    return std::nullopt;
}

/// "Easting [m]", "x_mm", "z(m)": the name without its unit, and millimetres per unit.
struct Name {
    std::string text;
    std::optional<double> unitMm;
};
Name nameOf(std::string_view given) {
    const std::size_t cut = given.find_last_of("_ ([/");
    if (cut != std::string_view::npos && cut > 0) {
        if (const auto unit = unitNamed(plain(given.substr(cut)))) {
            Name name{plain(given.substr(0, cut)), unit};
            if (name.text != "range") return name; // range_mm is a name of its own
        }
    }
    return {plain(given), std::nullopt};
}

} // namespace

NamedColumns columnsNamed(std::span<const std::string> names) {
    NamedColumns found;
    std::array<std::size_t, kColumnRoles> rank{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Name name = nameOf(names[i]);
        const auto known = std::find_if(kNames.begin(), kNames.end(), [&](const KnownName& k) { return name.text == k.name; });
        if (known == kNames.end()) continue;
        const auto role = static_cast<std::size_t>(known->role);
        const auto itsRank = static_cast<std::size_t>(known - kNames.begin());
        if (found.of[role] && rank[role] <= itsRank) continue;
        found.of[role] = i;
        rank[role] = itsRank;
    }
    if (!found.hasPoint()) return found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (const auto unit = nameOf(names[*found.of[axis]]).unitMm) found.unitMm = unit;
    }
    return found;
}

} // namespace edgescan
