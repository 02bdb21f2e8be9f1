// One table of words; then numbers.
#include "core/files/point_tables/angle_columns.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/files/point_tables/axis_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace edgescan::files {
namespace {

enum class AnglePart : std::uint8_t { Azimuth, Bearing, Elevation, Zenith, Range };

struct AngleWords {
    AnglePart part;
    std::vector<std::string_view> words;
};

const std::vector<AngleWords>& angleWordTable() {
    static const std::vector<AngleWords> rows{
        {AnglePart::Azimuth,
         {"azimuth", "azimut", "acimut", "azimute", "azymut", "atsimuutti", "asimut", "azi", "az", "yaw", "азимут", "方位角", "方位",
          "水平角"}},
        {AnglePart::Bearing,
         {"hz", "bearing", "horizontal", "horizontalwinkel", "hzwinkel", "horizontalangle", "richtung", "richtungswinkel", "rumbo",
          "gisement", "rumo", "hangle", "ha"}},
        {AnglePart::Elevation,
         {"elevation",    "elev",       "el",           "altitude",   "vertical",   "verticalangle", "vertikalwinkel", "hoehenwinkel",
          "pitch",        "elevacion",  "elevacao",     "elevazione", "elewacja",   "elevace",       "hoejdvinkel",    "hoydevinkel",
          "hoeydevinkel", "hoogtehoek", "korkeuskulma", "va",         "vangle",     "inclination",   "inclinacion",    "inclinacao",
          "inclinaison",  "site",       "уголместа",    "места",      "возвышение", "仰角",          "俯仰角",         "高度角",
          "垂直角",       "高低角"}},
        {AnglePart::Zenith,
         {"zenith", "zenit", "cenit", "zenital", "zenithal", "zenitwinkel", "zenitdistanz", "zenithdistance", "zenithangle", "polarangle",
          "v", "зенит", "天顶角", "天顶距", "天頂角"}},
        {AnglePart::Range,
         {"range",   "ranges",   "distance",       "dist",           "r",          "rho",     "radius",    "slopedistance", "slopedist",
          "sd",      "distanz",  "schraegdistanz", "schraegstrecke", "entfernung", "strecke", "distancia", "distanza",      "afstand",
          "avstand", "etaisyys", "odleglosc",      "vzdalenost",     "udaljenost", "mesafe",  "jarak",     "tavolsag",      "portee",
          "alcance", "rango",    "дальность",      "расстояние",     "距离",       "距離",    "斜距"}}};
    return rows;
}

/// Degrees per number of a word for a unit of angles.
std::optional<double> unitDegOf(std::string_view word) {
    struct AngleUnit {
        double deg;
        std::vector<std::string_view> names;
    };
    static const std::vector<AngleUnit> rows{
        {1.0, {"deg", "degs", "degree", "degrees", "grados", "graus", "degres", "altgrad", "grader", "gradi", "градусы", "度"}},
        {1e-2, {"cdeg", "centideg", "centidegrees"}},
        {1e-3, {"mdeg", "millideg", "millidegrees"}},
        {0.9, {"gon", "gons", "grads", "gradian", "gradians", "grades"}},
        {kDegreesPerRadian, {"rad", "rads", "radian", "radians", "radianes", "radianos", "radiant", "radianti", "радианы", "弧度"}},
        {kDegreesPerRadian * 1e-3, {"mrad", "millirad"}}};
    for (const AngleUnit& unit : rows) {
        if (std::ranges::find(unit.names, word) != unit.names.end()) return unit.deg;
    }
    return std::nullopt;
}

/// AngleWords next to the one that counts: "laser azimuth angle", "Vertikalwinkel 1".
bool goesWithAngle(std::string_view word) {
    static constexpr std::string_view kWords[]{"angle", "angles", "winkel", "angulo", "kulma", "vinkel", "hoek", "kat",      "uhel",
                                               "laser", "beam",   "scan",   "point",  "field", "slope",  "grad", "measured", "угол"};
    return std::ranges::find(kWords, word) != std::end(kWords);
}

std::optional<AnglePart> anglePartOf(std::string_view word) {
    for (const AngleWords& row : angleWordTable()) {
        if (std::ranges::find(row.words, word) != row.words.end()) return row.part;
    }
    return std::nullopt;
}

struct NamedAngle {
    std::optional<AnglePart> part; ///< empty: the name is about something else
    std::optional<double> unitDeg, unitMm;
};
NamedAngle namedAngle(const std::string& heading) {
    NamedAngle found;
    const auto [name, factor] = withoutFactor(heading);
    found.part = anglePartOf(headingLetters(name)); // "vertical angle", "Hz"
    const bool degreeSign = name.find("\xC2\xB0") != std::string::npos || name.find('\xB0') != std::string::npos;
    if (degreeSign) found.unitDeg = factor;
    std::vector<std::string> words = headingWords(name);
    std::erase_if(words, goesWithAngle);
    for (std::size_t n = 0; n < words.size(); ++n) {
        if (const auto unit = n > 0 ? unitDegOf(words[n]) : std::nullopt)
            found.unitDeg = factor * *unit;
        else if (const auto length = n > 0 ? unitNamed(words[n]) : std::nullopt)
            found.unitMm = factor * *length;
        else if (const auto part = anglePartOf(words[n]); part && !found.part)
            found.part = part;
        else if (n > 0 || !part)
            return {anglePartOf(headingLetters(name)), found.unitDeg, found.unitMm};
    }
    return found;
}

/// The power of ten of which all values are multiples, 1e-9 at least; 0: of none.
double angleStepOf(std::span<const Eigen::Vector2d> angles, int which) {
    for (double scale = 1; scale < 1e10; scale *= 10) {
        const bool whole = std::ranges::all_of(angles, [&](const Eigen::Vector2d& one) {
            const double value = one[which] * scale;
            return !std::isfinite(value) || std::abs(value - std::round(value)) < 1e-4;
        });
        if (whole) return 1.0 / scale;
    }
    return 0;
}

/// Which of the different values each one is, in rising order from the widest gap of a turn on; `kNoIndex` for what is not a number.
struct Ranks {
    std::vector<std::uint32_t> of;
    std::size_t values = 0;
};
Ranks ranksOf(std::span<const Eigen::Vector2d> angles, int which, double turn) {
    constexpr double kSame = 1e-9; // of a turn
    std::vector<double> values;
    for (const Eigen::Vector2d& one : angles) {
        if (one.allFinite()) values.push_back(one[which]);
    }
    std::ranges::sort(values);
    const auto same = [&](double a, double b) { return b - a < kSame * turn; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    if (values.empty()) return {};
    if (values.size() > 1 && values.back() - values.front() > (1 - kSame) * turn) values.pop_back(); // -180 and 180, 0 and 360
    std::size_t first = 0;
    double widest = turn - (values.back() - values.front());
    for (std::size_t n = 1; n < values.size(); ++n) {
        if (values[n] - values[n - 1] <= widest * (1 + kSame)) continue;
        widest = values[n] - values[n - 1];
        first = n;
    }
    Ranks ranks{std::vector<std::uint32_t>(angles.size(), kNoIndex), values.size()};
    for (std::size_t n = 0; n < angles.size(); ++n) {
        if (!angles[n].allFinite()) continue;
        const auto above = std::ranges::upper_bound(values, angles[n][which] + kSame * turn);
        const auto at = static_cast<std::size_t>(above - values.begin()) - 1;
        const bool again = angles[n][which] > values.back() + kSame * turn; // the end of the turn is its start
        ranks.of[n] = static_cast<std::uint32_t>(((again ? 0 : at) + values.size() - first) % values.size());
    }
    return ranks;
}

/// The other way round where the first row of the file has a larger index than its last one.
void followFile(Ranks& ranks) {
    if (ranks.of.empty() || ranks.of.front() == kNoIndex || ranks.of.back() == kNoIndex || ranks.of.front() <= ranks.of.back()) return;
    for (std::uint32_t& rank : ranks.of) {
        if (rank != kNoIndex) rank = static_cast<std::uint32_t>(ranks.values) - 1 - rank;
    }
}

/// Degrees per number of azimuth and elevation. Where one has no name of its unit it has that of the other. Without any, numbers within one
/// turn of radians are radians, and azimuths far beyond one turn are hundredths of a degree, as Velodyne counts.
std::array<double, 2> unitsDegOf(std::span<const Eigen::Vector2d> angles, const AngleColumns& columns) {
    constexpr double kMostRad = radians(360.0) + 1e-3, kMostGon = 4000, kMostElevation = 90;
    const auto& [azimuth, elevation] = columns.unitDeg;
    if (azimuth || elevation) return {azimuth ? *azimuth : *elevation, elevation ? *elevation : *azimuth};
    Eigen::Array2d largest(0, 0);
    for (const Eigen::Vector2d& one : angles) {
        if (one.allFinite()) largest = largest.max(one.array().abs());
    }
    if (largest[0] > kMostGon) return {0.01, largest[1] > kMostElevation ? 0.01 : 1.0};
    const double most = largest.maxCoeff();
    const double both = most > 360 ? 0.9 : most > kMostRad ? 1.0 : kDegreesPerRadian;
    return {both, both};
}

std::string angleUnitWords(const std::array<double, 2>& unitDeg) {
    const auto word = [](double deg) {
        if (deg == 0.01 || deg == 0.001) return deg == 0.01 ? "hundredths of a degree" : "thousandths of a degree";
        return deg == 1.0 ? "degrees" : deg == 0.9 ? "gon" : deg > 1 ? "radians" : "milliradians";
    };
    if (unitDeg[0] == unitDeg[1]) return word(unitDeg[0]);
    return withValues("%1 (azimuth) and %2 (elevation)", {word(unitDeg[0]), word(unitDeg[1])});
}

} // namespace

std::optional<AngleColumns> angleColumnsNamed(std::span<const std::string> names) {
    AngleColumns columns;
    std::array<bool, 3> found{};
    bool surveyed = false;
    for (std::size_t n = 0; n < names.size(); ++n) {
        const NamedAngle name = namedAngle(names[n]);
        if (!name.part) continue;
        const std::size_t which = *name.part <= AnglePart::Bearing ? 0 : *name.part <= AnglePart::Zenith ? 1 : 2;
        if (found[which]) continue;
        found[which] = true;
        if (which == 0) columns.azimuth = n;
        if (which == 1) columns.elevation = n;
        if (which == 2) columns.range = n;
        if (which == 2) columns.rangeUnitMm = name.unitMm;
        if (which < 2) columns.unitDeg[which] = name.unitDeg;
        surveyed = surveyed || *name.part == AnglePart::Bearing || *name.part == AnglePart::Zenith;
        columns.fromZenith = columns.fromZenith || *name.part == AnglePart::Zenith;
    }
    if (!found[0] || !found[1]) return std::nullopt;
    columns.clockwise = surveyed || columns.unitDeg[0] == 0.9 || columns.unitDeg[1] == 0.9;
    return columns;
}

void setCellsFromAngles(PointTable& table, std::span<const Eigen::Vector2d> angles, const AngleColumns& columns) {
    constexpr double kFilled = 0.5, kAlone = 0.95;
    if (!table.line.empty() || angles.size() != table.points.size() || angles.size() < 4) return;
    const std::array<double, 2> unitDeg = unitsDegOf(angles, columns);
    Ranks lines = ranksOf(angles, 0, 360.0 / unitDeg[0]), beams = ranksOf(angles, 1, 360.0 / unitDeg[1]);
    const std::size_t cells = lines.values * beams.values;
    if (lines.values < 2 || beams.values < 2 || kFilled * static_cast<double>(cells) > static_cast<double>(angles.size())) return;
    std::vector<bool> filled(cells, false);
    std::size_t alone = 0;
    for (std::size_t n = 0; n < angles.size(); ++n) {
        if (lines.of[n] == kNoIndex || beams.of[n] == kNoIndex) continue;
        const std::size_t k = std::size_t{lines.of[n]} * beams.values + beams.of[n];
        alone += filled[k] ? 0 : 1;
        filled[k] = true;
    }
    const auto least = kAlone * static_cast<double>(angles.size());
    if (static_cast<double>(alone) < least && table.returnNumber.empty()) return;
    followFile(lines);
    followFile(beams);
    table.line = std::move(lines.of);
    table.beam = std::move(beams.of);
}

void setPointsFromAngles(PointTable& table, const AngleColumns& columns) {
    std::vector<Eigen::Vector2d> angles;
    angles.reserve(table.points.size());
    for (const Eigen::Vector3d& p : table.points) angles.emplace_back(p.x(), p.y());
    const std::array<double, 2> unitDeg = unitsDegOf(angles, columns);
    const double azimuthRad = radians(unitDeg[0]), elevationRad = radians(unitDeg[1]);
    for (Eigen::Vector3d& p : table.points) {
        const double azimuth = columns.clockwise ? radians(90.0) - p.x() * azimuthRad : p.x() * azimuthRad;
        const double elevation = columns.fromZenith ? radians(90.0) - p.y() * elevationRad : p.y() * elevationRad;
        const double range = p.z() > 0 ? p.z() : 0.0;
        p = range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    }
    setCellsFromAngles(table, angles, columns);
    const double rounding =
        table.line.empty() ? 0.5 * std::max(angleStepOf(angles, 0) * azimuthRad, angleStepOf(angles, 1) * elevationRad) : 0.0;
    table.precision = {0.0, 1e-14 + rounding};
    const bool stated = columns.unitDeg[0] || columns.unitDeg[1];
    const std::string how = withValues(stated ? "angles in %1, azimuths %2" : "angles taken as %1, azimuths %2",
                                       {angleUnitWords(unitDeg), columns.clockwise ? "clockwise from y" : "counter-clockwise from x"});
    table.remarks.push_back(
        withValues(columns.fromZenith ? "Points were computed from the columns of angles and ranges, with %1 and heights from the zenith."
                                      : "Points were computed from the columns of angles and ranges, with %1.",
                   {how}));
}

} // namespace edgescan::files
