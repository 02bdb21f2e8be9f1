// Well-known text of UTM zones and of local systems.
#include "core/files/formats/coordinate_system.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace edgescan::files {
namespace {

struct Zone {
    int number = 0; ///< 1 to 60
    bool south = false;
};

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
std::optional<Zone> zoneIn(std::string_view text) {
    const auto [number, digits] = numberAt(std::string(text), 0);
    if (digits == 0 || digits > 2 || text.size() <= digits) return std::nullopt;
    const char side = text[digits];
    const std::string_view rest = text.substr(digits + 1);
    if ((side != 'N' && side != 'S') || !(rest.empty() || rest.starts_with("WGS"))) return std::nullopt;
    return Zone{number, side == 'S'};
}

/// "UTM 17N, WGS84", "WGS 84 / UTM zone 17S", "EPSG:32617"; and "17N, WGS84", as the fields zone and datum of a pose give it.
std::optional<Zone> utmZone(const std::string& grid) {
    const std::string bare = bareText(grid);
    std::optional<Zone> zone;
    if (const std::size_t at = bare.find("EPSG"); at != std::string::npos) {
        const auto [code, digits] = numberAt(bare, at + 4);
        if (digits == 5 && (code / 100 == 326 || code / 100 == 327)) zone = Zone{code % 100, code / 100 == 327};
    } else if (bare.find("WGS84") != std::string::npos) {
        std::string_view text = bare;
        if (const std::size_t utm = bare.find("UTM"); utm != std::string::npos)
            text.remove_prefix(utm + 3);
        else if (text.starts_with("WGS84"))
            text.remove_prefix(5);
        if (text.starts_with("ZONE")) text.remove_prefix(4);
        zone = zoneIn(text);
    }
    return zone && zone->number >= 1 && zone->number <= 60 ? zone : std::nullopt;
}

int codeOf(const Zone& zone) { return (zone.south ? 32700 : 32600) + zone.number; }

std::string utmWkt(const Zone& zone) {
    const std::string code = std::to_string(codeOf(zone));
    return "PROJCS[\"WGS 84 / UTM zone " + std::to_string(zone.number) + (zone.south ? "S" : "N") +
           "\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563,AUTHORITY[\"EPSG\",\"7030\"]],"
           "AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0,AUTHORITY[\"EPSG\",\"8901\"]],UNIT[\"degree\",0.0174532925199433,"
           "AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4326\"]],PROJECTION[\"Transverse_Mercator\"],"
           "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\"," +
           std::to_string(zone.number * 6 - 183) +
           "],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\"," +
           (zone.south ? "10000000" : "0") +
           "],UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH],AUTHORITY[\"EPSG\",\"" + code +
           "\"]]";
}

/// A quotation mark would end the name; other signs are not ASCII.
std::string quotable(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '"' || c < ' ' || c > '~'; }, '_');
    return name.substr(0, 120);
}

} // namespace

std::optional<int> epsgCode(const std::string& grid) {
    const auto zone = utmZone(grid);
    return zone ? std::optional(codeOf(*zone)) : std::nullopt;
}

std::string coordinateSystemWkt(const CloudColumns& cloud) {
    std::string name = "EdgeScan scanner frame (local)";
    std::string axes = "AXIS[\"X\",EAST],AXIS[\"Y\",NORTH]";
    if (cloud.frame != CoordinateFrame::Scanner) {
        if (const auto zone = utmZone(cloud.grid); zone && cloud.frame == CoordinateFrame::Mine) return utmWkt(*zone);
        name = "Mine grid (local)" + (cloud.grid.empty() ? "" : ": " + cloud.grid);
        axes = "AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH]";
    }
    if (cloud.frame == CoordinateFrame::MineLocal)
        name += ", from E " + fixedText(cloud.originM.x(), 3) + " N " + fixedText(cloud.originM.y(), 3) + " El " +
                fixedText(cloud.originM.z(), 3);
    return "LOCAL_CS[\"" + quotable(name) + "\",LOCAL_DATUM[\"" + quotable(name) + "\",0],UNIT[\"metre\",1]," + axes + "]";
}

} // namespace edgescan::files
