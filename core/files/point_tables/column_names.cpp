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

constexpr std::size_t kByShared = 4; // rank of an axis that is found because other headings share its other words

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
    {"returnnumber", Role::ReturnNumber}, // these also with a word for a number: rankOfReturn()
    {"return", Role::ReturnNumber},
    {"ret", Role::ReturnNumber},
    {"rtn", Role::ReturnNumber},
    {"rn", Role::ReturnNumber},
    {"echo", Role::ReturnNumber},
    {"retorno", Role::ReturnNumber},
    {"eco", Role::ReturnNumber},
    {"targetindex", Role::ReturnNumber},
    {"scalarreturnnumber", Role::ReturnNumber},
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
    std::string_view given; ///< without the unit and an "in" before it
    std::optional<double> unitMm;
};
Name nameOf(std::string_view given) {
    constexpr std::string_view kBefore = "_ ([/-";
    const auto [bare, factor] = withoutFactor(given);
    for (std::size_t cut = bare.find_first_of(kBefore, 1); cut != std::string::npos; cut = bare.find_first_of(kBefore, cut + 1)) {
        const auto unit = unitNamed(headingLetters(std::string_view(bare).substr(cut))); // the longest: "US survey feet" is not "feet"
        if (!unit || headingLetters(given.substr(0, cut)) == "range") continue;          // range_mm is a name of its own
        const std::string_view name = given.substr(0, cut);
        return {name.ends_with(" in") ? name.substr(0, name.size() - 3) : name, factor * *unit};
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

/// Place in the table of a name for which return of its pulse a point is: "Echo Nr", "pulse return id", "scalar_Return_Number". "Number of
/// returns" is not one.
std::size_t rankOfReturn(std::string_view given) {
    static constexpr std::string_view kBefore[]{"scalar", "field", "pulse", "laser", "las"},
        kBehind[]{"", "number", "no", "nr", "num", "index", "idx", "id", "n"};
    std::string letters;
    for (const std::string& word : headingWords(given)) letters += std::ranges::find(kBefore, word) == std::end(kBefore) ? word : "";
    for (const std::string_view behind : kBehind) {
        const std::size_t rank = letters.ends_with(behind) ? rankIn(letters.substr(0, letters.size() - behind.size())) : std::size(kNames);
        if (rank < std::size(kNames) && kNames[rank].role == Role::ReturnNumber) return rank;
    }
    return std::size(kNames);
}

/// Place in the table; a name that is only found without some of its words follows all that are found whole. `shared`: axis_words.h
std::optional<std::size_t> rankOf(std::string_view given, std::span<const std::string> shared) {
    const std::size_t whole = rankIn(headingLetters(given));
    if (whole < std::size(kNames)) return whole;
    if (const std::size_t number = rankOfReturn(given); number < std::size(kNames)) return number;
    const std::size_t bracket = given.find_first_of("([", 1); // "Easting (X)"
    const std::size_t before = bracket == std::string_view::npos ? std::size(kNames) : rankIn(headingLetters(given.substr(0, bracket)));
    if (before < std::size(kNames)) return std::size(kNames) + before;
    if (const auto axis = axisAmongWords(headingWords(given))) return 2 * std::size(kNames) + rankIn(*axis);
    static constexpr const char* kAxes[]{"x", "y", "z"};
    const auto alone = axisNamed(given);
    const auto axis = alone ? alone : axisNamed(given, shared);
    if (!axis) return std::nullopt;
    return (alone ? 3 : kByShared) * std::size(kNames) + rankIn(kAxes[static_cast<std::size_t>(*axis)]);
}

/// Names that only count columns: "col1", "field_2", "a".
bool isPlaceholder(const std::string& name) {
    static constexpr std::string_view kWords[]{"",      "c", "col", "column", "columna", "coluna",  "colonne", "spalte",
                                               "field", "f", "var", "v",      "value",   "unnamed", "channel", "ch"};
    std::string letters = headingLetters(name);
    std::erase_if(letters, [](char c) { return c >= '0' && c <= '9'; });
    return letters.size() == 1 || std::ranges::find(kWords, letters) != std::end(kWords);
}

bool isOneOf(const std::string& name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

} // namespace

NamedColumns columnsNamed(std::span<const std::string> names) {
    NamedColumns found;
    std::array<std::size_t, kColumnRoles> rank{};
    std::array<bool, kColumnRoles> several{}; // columns of one rank by words that others share: which of them is meant is unknown
    std::vector<std::string> bare;
    for (const std::string& name : names) bare.emplace_back(nameOf(name).given);
    const std::vector<std::string> shared = wordsNextToAxes(bare);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto itsRank = rankOf(bare[i], shared);
        if (!itsRank) continue;
        const auto role = static_cast<std::size_t>(kNames[*itsRank % std::size(kNames)].role);
        if (found.of[role] && rank[role] == *itsRank && *itsRank >= kByShared * std::size(kNames)) several[role] = true;
        if (found.of[role] && rank[role] <= *itsRank) continue;
        found.of[role] = i;
        rank[role] = *itsRank;
        several[role] = false;
    }
    for (std::size_t role = 0; role < kColumnRoles; ++role) {
        if (several[role]) found.of[role].reset();
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
    if (has({"lat", "latitude", "latitud", "breite", "breitengrad", "широта", "纬度", "緯度"}) &&
        has({"lon", "long", "lng", "longitude", "longitud", "laenge", "laengengrad", "долгота", "经度", "経度"}))
        return "degrees of latitude and longitude";
    if (named.angles) return "angles and no ranges";
    if (has({"range", "ranges", "distance", "dist", "radius", "rho", "r", "rangemm"}) &&
        has({"angle", "azimuth", "az", "theta", "phi", "bearing", "inclination", "zenith", "deg", "hz"}))
        return "angles and ranges";
    const int axes = int{named.of[0].has_value()} + int{named.of[1].has_value()} + int{named.of[2].has_value()};
    if (axes == 2) return "two coordinates of a point and not the third";
    return std::nullopt;
}

std::size_t namesOfAxes(std::span<const std::string> names) { return static_cast<std::size_t>(std::ranges::count_if(names, speaksOfAxis)); }

bool onlyCount(std::span<const std::string> names) { return std::ranges::all_of(names, isPlaceholder); }

} // namespace edgescan::files
