// Writes labels, rows and hulls of rocks.
#include "core/exports/rock_files.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/exports/frame_points.h"
#include "core/exports/rock_report.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/source.h"
#include "core/rocks/attributes/hulls.h"

#include <nlohmann/json.hpp>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

void appendPlace(std::string& text, const Eigen::Vector3d& place, int decimals) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendFixed(text, place[axis], decimals);
    }
}

std::string plyHulls(const std::vector<rocks::Hull>& hulls, const FramePoints& points, const std::string& record) {
    std::size_t corners = 0;
    std::size_t triangles = 0;
    for (const rocks::Hull& hull : hulls) {
        corners += hull.cells.size();
        triangles += hull.triangles.size();
    }
    std::string text = "ply\nformat ascii 1.0\ncomment " + points.text() +
                       "\ncomment convex hulls of visible points, never a volume\ncomment " + rocks::kRockCaveat + "\n";
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) text += "comment " + line + "\n";
    text += "element vertex " + std::to_string(corners) + "\nproperty double x\nproperty double y\nproperty double z\nproperty uint rock\n";
    text += "element face " + std::to_string(triangles) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const rocks::Hull& hull : hulls) {
        for (const std::uint32_t k : hull.cells) {
            appendPlace(text, points.at(k), points.decimals());
            text += " " + std::to_string(hull.label) + "\n";
        }
    }
    std::size_t first = 0;
    for (const rocks::Hull& hull : hulls) {
        for (const auto& [a, b, c] : hull.triangles)
            text += "3 " + std::to_string(first + a) + " " + std::to_string(first + b) + " " + std::to_string(first + c) + "\n";
        first += hull.cells.size();
    }
    return text;
}

std::string objHulls(const std::vector<rocks::Hull>& hulls, const FramePoints& points, const std::string& record) {
    std::string text = "# " + points.text() + "\n# convex hulls of visible points, never a volume\n# " + rocks::kRockCaveat + "\n";
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) text += "# " + line + "\n";
    std::size_t first = 1;
    for (const rocks::Hull& hull : hulls) {
        if (hull.triangles.empty()) continue;
        text += "o rock_" + std::to_string(hull.label) + "\n";
        for (const std::uint32_t k : hull.cells) {
            text += "v ";
            appendPlace(text, points.at(k), points.decimals());
            text += '\n';
        }
        for (const auto& [a, b, c] : hull.triangles)
            text += "f " + std::to_string(first + a) + " " + std::to_string(first + b) + " " + std::to_string(first + c) + "\n";
        first += hull.cells.size();
    }
    return text;
}

} // namespace

Result<Grid<std::uint16_t>> labelPicture(const rocks::Study& study, const std::string& where) {
    if (study.map.rocks > UINT16_MAX)
        return Error{"there are " + std::to_string(study.map.rocks) + " numbers of rocks and a picture of 16 bits numbers 65535", where,
                     "ask for larger rocks with --min-cells"};
    const Grid<std::uint32_t> labels = rocks::rockLabels(*study.segmentation, study.map);
    Grid<std::uint16_t> picture(labels.lines, labels.beams);
    for (std::size_t k = 0; k < labels.size(); ++k) picture[k] = static_cast<std::uint16_t>(labels[k]);
    return picture;
}

Result<std::string> tableBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                               const std::filesystem::path& path) {
    if (auto known = files::checkFrame(*study.segmentation->inputs.scan, frame, path.string()); !known) return known.error();
    return rocksTable(study, frame, names);
}

Result<std::string> reportBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                                const std::filesystem::path& path, const std::string& record) {
    if (auto known = files::checkFrame(*study.segmentation->inputs.scan, frame, path.string()); !known) return known.error();
    Json whole{{"schema", kRocksSchema}};
    whole.update(rocksReport(study, frame, names));
    // A later version that verifies the export makes the same file, even if the scan was moved.
    const auto parsed = parseOrderedJson(record, "");
    if (parsed) {
        whole["input"] = parsed->at(Json::json_pointer("/scan/input"));
        whole["version"] = parsed->at(Json::json_pointer("/program/version"));
    }
    return jsonText(whole, 2) + "\n";
}

Result<std::string> hullBytes(const rocks::Study& study, CoordinateFrame frame, const std::filesystem::path& path,
                              const std::string& record) {
    const Scan& scan = *study.segmentation->inputs.scan;
    if (auto known = files::checkFrame(scan, frame, path.string()); !known) return known.error();
    const bool isPly = files::Source::lowerCase(path.extension()) == ".ply";
    if (!isPly && files::Source::lowerCase(path.extension()) != ".obj")
        return Error{"the extension names no format for this", path.string(), "use .ply or .obj"};
    const std::vector<rocks::Hull> all = rocks::rockHulls(*study.segmentation, study.map);
    std::vector<rocks::Hull> hulls;
    for (const rocks::Rock* rock : rocks::rocksToList(study)) hulls.push_back(all[rock->label - 1]);
    return (isPly ? plyHulls : objHulls)(hulls, FramePoints(scan, frame), record);
}

Json rocksRecord(const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    Json record{{"settings", rocks::rockSettingsToJson(study.settings)},
                {"edits", rocks::rockEditsToJson(study.edits, scan.lines(), scan.beams())},
                {"count", study.rocks.size()},
                {"labels_sha256", labelsSha256(rocks::rockLabels(*study.segmentation, study.map))},
                {"note", rocks::kRockCaveat}};
    if (study.listed) record["listed"] = *study.listed;
    return record;
}

} // namespace edgescan::exports
