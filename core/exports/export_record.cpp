// The record of an export: all values of docs/reference/rules.md, "S7", each with its value, or null and the reason.
#include "core/exports/provenance.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/exports/record_parts.h"
#include "core/exports/report.h"
#include "core/exports/rock_files.h"
#include "core/files/point_tables/description.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/placement_json.h"
#include "core/scan/grid/acquisition.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <png.h>
#include <zlib.h>

#include <array>
#include <span>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotInFile = "the scan file does not say";

Json textOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// The text of each key; for all empty ones null with the reason.
Json known(std::initializer_list<std::pair<const char*, std::string>> texts) {
    Json object = Json::object();
    bool all = true;
    for (const auto& [key, text] : texts) {
        object[key] = textOrNull(text);
        all = all && !text.empty();
    }
    if (!all) object["reason"] = kNotInFile;
    return object;
}

Json scannerJson(const Acquisition& a) {
    return known({{"vendor", a.vendor}, {"model", a.model}, {"serial", a.serial}, {"firmware", a.firmware}});
}

Json scanJson(const Scan& scan) {
    const auto opened = parseOrderedJson(scan.openedWith, "");
    Json object{{"input", std::filesystem::path(scan.path).filename().string()},
                {"format", scan.format},
                {"sha256", textOrNull(scan.sha256)},
                {"grid_sha256", gridSha256(scan)},
                {"opened_with", opened && opened->is_object() ? *opened : Json::object()},
                {"lines", scan.lines()},
                {"beams", scan.beams()},
                {"unit_mm", scan.unitMm}};
    object.update(geometryReport(scan));
    if (!scan.note.empty()) object["note"] = scan.note;
    return object;
}

/// Adds a line to a list of runs [first, count].
void addToRuns(Json& runs, int line) {
    if (!runs.empty() && runs.back()[0].get<int>() + runs.back()[1].get<int>() == line)
        runs.back()[1] = runs.back()[1].get<int>() + 1;
    else
        runs.push_back({line, 1});
}

/// Lines without any data, and lines with missing beams.
Json acquisitionJson(const Scan& scan, const Acquisition& a) {
    Json gaps = Json::array(), inPart = Json::array();
    int received = 0;
    for (int i = 0; i < scan.lines(); ++i) {
        const CellState* states = scan.state.line(i);
        const auto lost = std::count(states, states + scan.beams(), CellState::Lost);
        received += lost < scan.beams() ? 1 : 0;
        if (lost > 0) addToRuns(lost < scan.beams() ? inPart : gaps, i);
    }
    const int expected = std::max(a.linesExpected, scan.lines());
    Json object{{"lines_expected", expected}, {"lines_received", received}, {"gaps", gaps}, {"gaps_in_part", inPart}};
    object.update(known({{"start_utc", a.startUtc},
                         {"end_utc", a.endUtc},
                         {"clock_source", a.clockSource},
                         {"contamination", a.contamination},
                         {"echo_filter", a.echoFilter}}));
    return object;
}

Json coordinatesJson(ExportContent content, const Scan& scan, CoordinateFrame frame) {
    const ExportKind& kind = exportKind(content);
    if (kind.holds == ExportKind::Holds::Picture)
        return {
            {"frame", "image"}, {"axis_order", {"line (row)", "beam (column)"}}, {"unit", kind.unit != nullptr ? Json(kind.unit) : Json()}};
    Json object{{"frame", frameName(frame)}, {"unit", "m"}};
    if (frame == CoordinateFrame::Scanner) object["axis_order"] = {"x", "y", "z"};
    if (frame == CoordinateFrame::MineLocal) object["axis_order"] = {"east", "north", "up"};
    if (frame == CoordinateFrame::Mine) object["axis_order"] = {"easting", "northing", "elevation"};
    object["origin_enh_m"] = nullptr;
    if (frame == CoordinateFrame::MineLocal && scan.placement) {
        const Eigen::Vector3d& origin = scan.placement->originEnhM;
        object["origin_enh_m"] = {origin.x(), origin.y(), origin.z()};
    }
    return object;
}

Json choicesJson(const files::WritingChoices& choices) {
    Json keys = Json::array();
    for (const files::WritingChoice& choice : files::kWritingChoices) {
        if (choices.*choice.member) keys.push_back(choice.key);
    }
    return keys;
}

std::string ascii(const Json& object) { return asciiJsonText(object); }

} // namespace

std::string gridSha256(const Scan& scan) {
    Sha256 hash;
    const auto add = [&hash](const auto& values) { hash.add(std::as_bytes(std::span(values))); };
    add(files::descriptionText(files::headOf(scan), "", -1));
    add(scan.rangeMm.cells);
    add(scan.state.cells);
    if (const auto* points = std::get_if<PointGeometry>(&scan.geometry)) add(points->pointsM.cells);
    for (const AttachedPoint& point : scan.attached) add(std::array{point.pointM.x(), point.pointM.y(), point.pointM.z()});
    return hash.hex();
}

Json programOfRecords() {
    const std::string eigen =
        std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
    return {{"name", "EdgeScan"},
            {"version", version()},
            {"commit", commit()},
            {"libraries",
             {{"OpenCV", cv::getVersionString()}, {"Eigen", eigen}, {"libpng", png_get_libpng_ver(nullptr)}, {"zlib", zlibVersion()}}}};
}

std::string sealed(Json record) {
    record.erase("record_sha256");
    const std::string rest = ascii(record);
    record["record_sha256"] = sha256Hex(std::as_bytes(std::span(rest)));
    return ascii(record);
}

Json sealedSidecar(Json sidecar) {
    sidecar.erase("sidecar_sha256");
    const std::string rest = ascii(sidecar);
    sidecar["sidecar_sha256"] = sha256Hex(std::as_bytes(std::span(rest)));
    return sidecar;
}

bool sidecarIsWhole(const Json& sidecar) { return sidecar.is_object() && sealedSidecar(sidecar) == sidecar; }

bool recordIsWhole(const Json& record) { return record.is_object() && record.contains("record_sha256") && sealed(record) == ascii(record); }

std::string exportRecord(ExportContent content, const edges::Detection& detection, const ExportOptions& options) {
    const Scan& scan = *detection.scan;
    Json warnings = scan.warnings;
    if (scan.placement) {
        for (const std::string& warning : scan.placement->warnings) warnings.push_back(warning);
    }
    const Acquisition acquisition = scan.acquisition ? *scan.acquisition : Acquisition{};
    Json record{{"format", kRecordFormat},
                {"content", exportKind(content).record},
                {"text", options.ascii},
                {"choices", choicesJson(options.choices)},
                {"scan", scanJson(scan)},
                {"cells", cellsReport(scan)},
                {"scanner", scannerJson(acquisition)},
                {"acquisition", acquisitionJson(scan, acquisition)},
                {"coordinates", coordinatesJson(content, scan, options.frame)},
                {"pose", scan.placement ? placementToJson(*scan.placement) : Json()}};
    if (!scan.placement) record["pose_reason"] = "no pose was given and the scan file holds none";
    record["attached_points"] = {{"in_scan", scan.attached.size()}, {"included", options.includeAttached}};
    if (options.selection && isCloud(content)) record["selection"] = selectionRecord(options);
    if (const OwnPart* own = exportKind(content).own) {
        if (Json part = own->record(options, scan); !part.is_null()) record[own->key] = std::move(part);
    }
    if (exportKind(content).needs != ExportKind::Needs::Scan) {
        record["settings"] = edges::settingsToJson(detection.settings);
        record["default_settings"] = {{"name", edges::kDefaultSet.name},
                                      {"version", edges::kDefaultSet.version},
                                      {"changed", edges::changedFromDefault(detection.settings)}};
        record["roughness"] = roughnessReport(detection);
        record["edges"] = detection.edges->size();
        record["classes"] = classesReport(detection);
        record["edge_mask_sha256"] = maskSha256(*detection.mask);
        if (detection.filled) {
            record["filled"] = filledReport(*detection.filled);
            record["filled"]["in_export"] = options.choices.filled && isCloud(content);
            const auto onFilled =
                std::ranges::count_if(detection.filled->cells, [&](const auto& c) { return (*detection.mask)[c.cell] != 0; });
            if (isCloud(content) && !options.choices.filled && onFilled > 0)
                warnings.push_back(std::to_string(onFilled) +
                                   " edge cells lie on filled ranges and are not in this file; --with-filled writes them.");
        }
        if (options.rocks && isOfRocks(content)) record["rocks"] = rocksRecord(*options.rocks);
    }
    record["program"] = programOfRecords();
    record["warnings"] = warnings;
    record["operator"] = textOrNull(options.operatorName);
    record["role"] = textOrNull(options.role);
    return sealed(record);
}

} // namespace edgescan::exports
