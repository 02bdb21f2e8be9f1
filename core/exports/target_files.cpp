// Writes targets.
#include "core/exports/target_files.h"

#include "core/base/csv_text.h"
#include "core/base/json_fields.h"
#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/exports/frame_points.h"
#include "core/files/formats/dxf_text.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/source.h"
#include "core/inspect/measure/cell_target.h"

#include <nlohmann/json.hpp>

#include <array>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;
using inspect::PinnedTarget;

constexpr const char* kPointLayer = "TARGETS";
constexpr const char* kNameLayer = "TARGET_NAMES";
constexpr const char* kNoteLayer = "TARGET_NOTES";
constexpr std::array<files::DxfLayer, 3> kTargetLayers{{{kPointLayer, "1"}, {kNameLayer, "7"}, {kNoteLayer, "7"}}};
constexpr double kTextHeightM = 0.10;

bool isTable(const std::filesystem::path& path) { return files::Source::lowerCase(path.extension()) == ".csv"; }

bool hasPlace(const Scan& scan, const PinnedTarget& target) {
    return target.cell < scan.cells() && scan.state[target.cell] == CellState::Valid;
}

std::string csvTargets(const edges::Detection& detection, const TargetList& targets, CoordinateFrame frame) {
    const Scan& scan = *detection.scan;
    const FramePoints points(scan, frame);
    const RangeNoise noise = inspect::noiseOf(detection);
    std::string text = "target,name,note,distance_m,tolerance_m";
    for (const char* name : coordinateNames(frame)) text += std::string(",") + name;
    text += ",line,beam,edge,pinned_utc,rock\n";
    const auto metres = [](double value) { return "," + fixedText(value, 3); }; // the digits of the window's table
    for (const PinnedTarget& target : targets) {
        text += std::to_string(target.number) + "," + csvCell(target.name) + "," + csvCell(target.note);
        if (hasPlace(scan, target)) {
            const inspect::CellTarget known = inspect::targetAt(detection, noise, target.cell);
            const Eigen::Vector3d place = points.at(target.cell);
            text += metres(known.distanceM) + (known.toleranceM > 0 ? metres(shownTolerance(known.toleranceM, 3)) : ",");
            for (int axis = 0; axis < 3; ++axis) text += metres(place[axis]);
        } else {
            text += ",,,,,";
        }
        const auto beams = static_cast<std::uint32_t>(scan.beams());
        text += "," + std::to_string(target.cell / beams) + "," + std::to_string(target.cell % beams) + ",";
        if (target.cell < scan.cells()) {
            const edges::Probe probe = edges::probeCell(detection, target.cell);
            text += edges::edgeName(probe.edge, probe.kind);
        }
        text += "," + csvCell(target.pinnedUtc) + "," + (target.rock > 0 ? std::to_string(target.rock) : "") + "\n";
    }
    return text;
}

std::string dxfTargets(const Scan& scan, const TargetList& targets, const FramePoints& points, const std::string& record) {
    Eigen::AlignedBox3d box;
    std::string without;
    for (const PinnedTarget& target : targets) {
        if (hasPlace(scan, target))
            box.extend(points.at(target.cell));
        else
            without += (without.empty() ? "" : ", ") + std::to_string(target.number);
    }
    files::DxfText drawing(false);
    drawing.comment(points.text());
    if (!without.empty()) drawing.comment("targets without a range are not in the drawing: " + without);
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) drawing.comment(line);
    drawing.begin(box, kTargetLayers);
    for (const PinnedTarget& target : targets) {
        if (!hasPlace(scan, target)) continue;
        const Eigen::Vector3d place = points.at(target.cell);
        drawing.point(kPointLayer, place);
        drawing.text(kNameLayer, place, kTextHeightM, std::to_string(target.number) + (target.name.empty() ? "" : " " + target.name));
        if (!target.note.empty())
            drawing.text(kNoteLayer, place - Eigen::Vector3d(0, 1.5 * kTextHeightM, 0), kTextHeightM, target.note); // a line below
    }
    return drawing.end();
}

} // namespace

OwnPart::Content targetContent(const edges::Detection& detection, const ExportOptions& options, const std::filesystem::path& path) {
    OwnPart::Content content;
    const Scan& scan = *detection.scan;
    if (!options.targets || !files::checkFrame(scan, options.frame, "")) return content;
    const FramePoints points(scan, options.frame);
    for (const PinnedTarget& target : *options.targets) {
        const bool placed = hasPlace(scan, target);
        if (placed) content.box.extend(points.at(target.cell));
        content.count += placed || isTable(path) ? 1 : 0;
    }
    return content;
}

Result<std::string> targetBytes(const ExportInput& input) {
    const std::string where = input.path.string();
    if (!input.options.targets || input.options.targets->empty())
        return Error{"there are no targets", where, "pin a target in the window first"};
    const Scan& scan = *input.detection.scan;
    if (auto known = files::checkFrame(scan, input.options.frame, where); !known) return known.error();
    if (isTable(input.path)) return csvTargets(input.detection, *input.options.targets, input.options.frame);
    if (targetContent(input.detection, input.options, input.path).count == 0)
        return Error{"nothing was measured at the cells of the targets", where, "write .csv, or pin cells with a range"};
    return dxfTargets(scan, *input.options.targets, FramePoints(scan, input.options.frame), input.record);
}

Json targetsRecord(const ExportOptions& options, const Scan& scan) {
    if (!options.targets) return {};
    const auto beams = static_cast<std::uint32_t>(scan.beams());
    Json list = Json::array();
    for (const PinnedTarget& target : *options.targets) {
        list.push_back({{"number", target.number},
                        {"name", target.name},
                        {"note", target.note},
                        {"line", target.cell / beams},
                        {"beam", target.cell % beams},
                        {"pinned_utc", target.pinnedUtc}});
        if (target.rock > 0) list.back()["rock"] = target.rock;
    }
    return list;
}

Result<Done> readTargets(const Json& record, const Scan& scan, const std::string& where, ExportOptions& options) {
    JsonFields fields(nlohmann::json{{"targets", nlohmann::json(record)}}, where, "verify with the version that made the export");
    auto targets = std::make_shared<TargetList>();
    for (JsonFields& each : fields.objects("targets")) {
        PinnedTarget target;
        target.number = static_cast<int>(each.wholeNumber("number", 1, 1'000'000));
        target.name = each.text("name");
        target.note = each.text("note");
        const auto line = each.wholeNumber("line", 0, static_cast<std::uint64_t>(scan.lines()) - 1);
        const auto beam = each.wholeNumber("beam", 0, static_cast<std::uint64_t>(scan.beams()) - 1);
        target.cell = static_cast<std::uint32_t>(line * static_cast<std::uint64_t>(scan.beams()) + beam);
        target.pinnedUtc = each.text("pinned_utc");
        if (each.has("rock")) target.rock = static_cast<std::uint32_t>(each.wholeNumber("rock", 1, UINT32_MAX));
        each.done();
        targets->push_back(std::move(target));
    }
    fields.done();
    if (fields.problem()) return *fields.problem();
    options.targets = std::move(targets);
    return Done{};
}

} // namespace edgescan::exports
