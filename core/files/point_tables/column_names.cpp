// One table of names.
#include "core/files/point_tables/column_names.h"

#include "core/files/point_tables/axis_words.h"

#include <algorithm>
#include <array>

namespace edgescan::files {
namespace {

struct KnownName {
    const char* name;
    ColumnRole role;
};

using Role = ColumnRole;

// A role's usual name first. Lower case, letters and digits only.
constexpr KnownName kNames[]{
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
    {"returnnumber", Role::ReturnNumber},
    {"return", Role::ReturnNumber},
    {"returnno", Role::ReturnNumber},
    {"returnnum", Role::ReturnNumber},
    {"echo", Role::ReturnNumber},
    {"echonumber", Role::ReturnNumber},
    {"echono", Role::ReturnNumber},
    {"este", Role::X}, // Spanish and Portuguese; French below
    {"leste", Role::X},
    {"norte", Role::Y},
    {"cota", Role::Z},
    {"elevacion", Role::Z},
    {"elevacao", Role::Z},
    {"altura", Role::Z},
    {"altitud", Role::Z},
    {"est", Role::X},
    {"nord", Role::Y},
    {"cote", Role::Z},
    {"xpt", Role::X}, // Datamine
    {"ypt", Role::Y},
    {"zpt", Role::Z},
    {"x1", Role::X}, // of the first return, as Ouster writes it
    {"y1", Role::Y},
    {"z1", Role::Z},
};

/// "Easting [m]", "x_mm", "z(m)", "Xmm": the name without its unit, and millimetres per unit.
struct Name {
    std::string_view given; ///< without the unit
    std::optional<double> unitMm;
};
Name nameOf(std::string_view given) {
    constexpr std::string_view kBefore = "_ ([/-";
    for (std::size_t cut = given.find_first_of(kBefore, 1); cut != std::string_view::npos; cut = given.find_first_of(kBefore, cut + 1)) {
        const auto unit = unitNamed(headingLetters(given.substr(cut))); // the longest unit: "US survey feet" is not "feet"
        if (unit && headingLetters(given.substr(0, cut)) != "range") return {given.substr(0, cut), unit}; // range_mm is a name of its own
    }
    const bool glued = given.size() > 1 && std::string_view("xyzXYZ").find(given.front()) != std::string_view::npos;
    if (const auto unit = glued ? unitNamed(headingLetters(given.substr(1))) : std::nullopt) return {given.substr(0, 1), unit};
    return {given, std::nullopt};
}

/// Words that say what all three columns are of, and not which one a column is.
bool saysNothing(std::string_view word) {
    static constexpr std::string_view kWords[]{"point",      "points", "pos",         "position",  "positions", "coord", "coords",
                                               "coordinate", "field",  "coordinates", "cartesian", "xyz",       "m",     "pt"};
    return std::ranges::find(kWords, word) != std::end(kWords);
}

std::size_t rankIn(const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find_if(kNames, [&](const KnownName& k) { return name == k.name; }) - kNames);
}

/// "Point X", "pos_x", "field.x", "cartesianX", ParaView's "Points:0".
std::optional<std::string> axisAmongWords(std::vector<std::string> words) {
    const bool some = std::erase_if(words, saysNothing) > 0;
    if (words.size() != 1) return std::nullopt;
    const std::string_view word = words[0];
    for (const auto& [digit, axis] : {std::pair{'0', "x"}, {'1', "y"}, {'2', "z"}}) {
        const bool alone = word.size() == 1 && (word[0] == digit || word[0] == axis[0]);
        const bool joined = word.back() == axis[0] && saysNothing(word.substr(0, word.size() - 1));
        if ((some && alone) || joined) return axis;
    }
    return std::nullopt;
}

/// Place in the table; a name that is only found without some of its words follows all that are found whole.
std::optional<std::size_t> rankOf(std::string_view given) {
    const std::size_t whole = rankIn(headingLetters(given));
    if (whole < std::size(kNames)) return whole;
    const std::size_t bracket = given.find_first_of("([", 1); // "Easting (X)"
    const std::size_t before = bracket == std::string_view::npos ? std::size(kNames) : rankIn(headingLetters(given.substr(0, bracket)));
    if (before < std::size(kNames)) return std::size(kNames) + before;
    if (const auto axis = axisAmongWords(headingWords(given))) return 2 * std::size(kNames) + rankIn(*axis);
    const auto axis = axisNamed(given); // axis_words.h
    static constexpr const char* kAxes[]{"x", "y", "z"};
    return axis ? std::optional(3 * std::size(kNames) + rankIn(kAxes[static_cast<std::size_t>(*axis)])) : std::nullopt;
}

bool isOneOf(const std::string& name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

} // namespace

NamedColumns columnsNamed(std::span<const std::string> names) {
    NamedColumns found;
    std::array<std::size_t, kColumnRoles> rank{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto itsRank = rankOf(nameOf(names[i]).given);
        if (!itsRank) continue;
        const auto role = static_cast<std::size_t>(kNames[*itsRank % std::size(kNames)].role);
        if (found.of[role] && rank[role] <= *itsRank) continue;
        found.of[role] = i;
        rank[role] = *itsRank;
    }
    if (const auto line = found[ColumnRole::Line]) found.rowsAndColumns = headingLetters(names[*line]).starts_with("row");
    found.angles = found.hasCell() ? std::nullopt : angleColumnsNamed(names);
    if (!found.hasPoint() && found.angles && found.angles->range) {
        found.anglesForPoint = true;
        found.of[0] = found.angles->azimuth;
        found.of[1] = found.angles->elevation;
        found.of[2] = found.angles->range;
        found.of[static_cast<std::size_t>(ColumnRole::RangeMm)].reset();
        found.unitMm = found.angles->rangeUnitMm;
    }
    if (!found.hasPoint() || found.anglesForPoint) return found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (const auto unit = nameOf(names[*found.of[axis]]).unitMm) found.unitMm = unit;
    }
    return found;
}

std::optional<std::string> contentsNamed(std::span<const std::string> names) {
    const NamedColumns named = columnsNamed(names);
    if (named.hasPoint()) return std::nullopt;
    const auto has = [&](std::initializer_list<std::string_view> any) {
        return std::ranges::any_of(names, [&](const std::string& name) {
            const auto words = headingWords(name);
            return isOneOf(headingLetters(name), any) ||
                   std::ranges::any_of(words, [&](const std::string& word) { return isOneOf(word, any); });
        });
    };
    if (has({"lat", "latitude"}) && has({"lon", "long", "lng", "longitude"})) return "degrees of latitude and longitude";
    if (named.angles) return "angles and no ranges";
    if (has({"range", "ranges", "distance", "dist", "radius", "rho", "r", "rangemm"}) &&
        has({"angle", "azimuth", "az", "theta", "phi", "bearing", "inclination", "zenith", "deg", "hz"}))
        return "angles and ranges";
    const int axes = int{named.of[0].has_value()} + int{named.of[1].has_value()} + int{named.of[2].has_value()};
    if (axes == 2) return "two coordinates of a point and not the third";
    return std::nullopt;
}

bool nameAnAxis(std::span<const std::string> names) { return std::ranges::any_of(names, speaksOfAxis); }

} // namespace edgescan::files
