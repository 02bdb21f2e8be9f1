// PCD v0.7: text or binary records; colours as PCL knows them; mine coordinates as metres from their origin.
#include "core/files/formats/pcd.h"

#include "core/base/number_text.h"
#include "core/files/point_tables/column_rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace edgescan::files {
namespace {

/// Of each kind of column.
struct PcdType {
    const char* size;
    const char* type;
};
PcdType pcdTypeOf(const CloudColumn& column) {
    static constexpr std::array<PcdType, 4> kTypes{{{"4", "F"}, {"8", "F"}, {"4", "U"}, {"1", "U"}}};
    return kTypes[column.values.index()];
}

template <class Word>
std::string headerLine(const char* key, const CloudColumns& cloud, Word word) {
    std::string line = key;
    for (const CloudColumn& column : cloud.columns) {
        line += ' ';
        line += word(column);
    }
    line += '\n';
    return line;
}

/// red, green and blue as the one field that PCL, Open3D, CloudCompare and three.js know: the bits 0x00RRGGBB as a number of type F.
void packColours(CloudColumns& cloud) {
    const std::array<const CloudColumn*, 3> channels{columnNamed(cloud, "red"), columnNamed(cloud, "green"), columnNamed(cloud, "blue")};
    if (std::ranges::count(channels, nullptr) > 0) return;
    std::vector<float> packed;
    packed.reserve(rowsOf(cloud));
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        std::uint32_t colour = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            colour |= static_cast<std::uint32_t>(numberIn(*channels[channel], row)) << (16U - 8U * channel);
        packed.push_back(std::bit_cast<float>(colour));
    }
    dropColumns(cloud, isColour);
    cloud.columns.push_back({"rgb", std::move(packed)});
}

void appendThree(std::string& text, const Eigen::Vector3d& v) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendShortest(text, v[axis]);
    }
}

} // namespace

Result<std::string> pcdBytes(CloudColumns cloud, const std::string& where, bool ascii) {
    if (auto enough = checkRoom(cloud, where, ascii ? 12 : 8); !enough) return enough.error();
    std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
    packColours(cloud);
    Eigen::Vector3d viewpoint = cloud.sensorM;
    // PCL and Open3D read coordinates of 4 bytes only.
    if (cloud.frame == CoordinateFrame::Mine && !cloud.choices.doubles) {
        subtractOrigin(cloud);
        viewpoint -= cloud.originM;
        text += std::string("# ") + kPcdOrigin;
        appendThree(text, cloud.originM);
        text += " m Easting Northing Elevation: add it to x y z and to VIEWPOINT\n";
    }
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    appendComments(text, cloud, "# ");
    text += "VERSION 0.7\n";
    text += headerLine("FIELDS", cloud, [](const CloudColumn& c) { return c.name; });
    text += headerLine("SIZE", cloud, [](const CloudColumn& c) { return pcdTypeOf(c).size; });
    text += headerLine("TYPE", cloud, [](const CloudColumn& c) { return pcdTypeOf(c).type; });
    text += headerLine("COUNT", cloud, [](const CloudColumn&) { return "1"; });
    text += "WIDTH " + std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) + "\nVIEWPOINT ";
    appendThree(text, viewpoint);
    text += " 1 0 0 0\nPOINTS " + std::to_string(rowsOf(cloud)) + "\nDATA " + (ascii ? "ascii" : "binary") + "\n";
    if (ascii)
        appendRows(text, cloud, ' ');
    else
        appendRecords(text, cloud);
    return text;
}

} // namespace edgescan::files
