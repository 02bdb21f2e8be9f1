// Well-known text of UTM zones and of local systems.
#include "core/files/formats/coordinate_system.h"

#include "core/base/number_text.h"
#include "core/scan/georef/utm_zone.h"

#include <algorithm>

namespace edgescan::files {
namespace {

int codeOf(const UtmZone& zone) { return (zone.south ? 32700 : 32600) + zone.number; }

std::string utmWkt(const UtmZone& zone) {
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
    return zone && zone->exists() ? std::optional(codeOf(*zone)) : std::nullopt;
}

std::string coordinateSystemWkt(const CloudColumns& cloud) {
    std::string name = "EdgeScan scanner frame (local)";
    std::string axes = "AXIS[\"X\",EAST],AXIS[\"Y\",NORTH]";
    if (cloud.frame != CoordinateFrame::Scanner) {
        if (const auto zone = utmZone(cloud.grid); zone && zone->exists() && cloud.frame == CoordinateFrame::Mine) return utmWkt(*zone);
        name = "Mine grid (local)" + (cloud.grid.empty() ? "" : ": " + cloud.grid);
        axes = "AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH]";
    }
    if (cloud.frame == CoordinateFrame::MineLocal)
        name += ", from E " + fixedText(cloud.originM.x(), 3) + " N " + fixedText(cloud.originM.y(), 3) + " El " +
                fixedText(cloud.originM.z(), 3);
    return "LOCAL_CS[\"" + quotable(name) + "\",LOCAL_DATUM[\"" + quotable(name) + "\",0],UNIT[\"metre\",1]," + axes + "]";
}

} // namespace edgescan::files
