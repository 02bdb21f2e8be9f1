// From points and the sidecar of their file to cells: the sidecar lists the cell of each point.
#include "core/files/open_save/sidecar_grid.h"
#include "core/base/translated_text.h"

#include "core/base/checked_size.h"
#include "core/base/inputs.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/memory.h"
#include "core/base/physical_limits.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/files/point_tables/cell_runs.h"
#include "core/files/point_tables/description.h"
#include "core/scan/georef/placed_points.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* kEdgesOnly =
    "This file is an export of edge points, not a scan: all other cells count as no return. Open the scan to find edges.";

/// The grid of a list without ranges, and the cell of each of its points.
struct SidecarGrid {
    Scan scan;
    std::vector<std::uint32_t> cells;
    CoordinateFrame frame = CoordinateFrame::Scanner;
};

/// Angles, or room for the points that are still to be laid into their cells; false where the description has neither.
bool applyGeometry(Scan& scan, const GridDescription& grid) {
    auto polar = polarOf(grid);
    const bool known = grid.sensorM || polar;
    if (grid.sensorM) {
        const Grid<Vector3d> missing(scan.lines(), scan.beams(), Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
        scan.geometry = PointGeometry{missing, *grid.sensorM, std::move(polar)};
    } else if (polar) {
        scan.geometry = std::move(*polar);
    }
    return known;
}

/// Error: `what` says what is wrong with the record, as the end of a sentence.
Result<SidecarGrid> gridOf(const json& record, std::size_t points, const Source& source, const std::string& where) {
    const auto refused = [&](const char* what) { return Error{what, where, ""}; };
    const json::json_pointer hash("/export/sha256"), cells("/export/cells_of_points"), frame("/record/coordinates/frame"),
        content("/record/content");
    if (!record.contains(hash) || record.at(hash) != json(sha256Hex(source.bytes))) return refused("was written for another one");
    const auto grid = parseDescription(jsonText(record.at("grid")), where);
    if (!grid) return refused("describes no grid");
    if (!record.contains(cells) || !record.at(cells).is_string()) return refused("does not list the cells of the points");
    if (auto enough = checkMemory(productOf({grid->lines, grid->beams, grid->sensorM ? 40U : 16U}), where); !enough)
        return refused("has a grid for which there is not enough memory");
    SidecarGrid sidecar;
    Scan& scan = sidecar.scan;
    scan.rangeMm = Grid<float>(static_cast<int>(grid->lines), static_cast<int>(grid->beams));
    scan.state = Grid<CellState>(scan.lines(), scan.beams(), CellState::NoReturn);
    if (!applyGeometry(scan, *grid)) return refused("describes a grid without angles and without a sensor");
    auto list = cellsOfRuns(record.at(cells).get_ref<const std::string&>(), points, scan.cells());
    if (!list) return refused("lists other cells than the file has points");
    sidecar.cells = std::move(*list);
    applyStateRuns(scan, *grid);
    applyDescription(scan, *grid);
    if (record.contains(content) && record.at(content) == json("edge cloud")) scan.warnings.emplace_back(kEdgesOnly);
    if (record.contains(frame) && record.at(frame).is_string())
        sidecar.frame = frameNamed(record.at(frame).get<std::string>()).value_or(CoordinateFrame::Scanner);
    if (sidecar.frame != CoordinateFrame::Scanner && !scan.placement) return refused("does not hold the place of the scan in the mine");
    return sidecar;
}

/// As gridOf(); empty where the file has no sidecar with a grid.
std::optional<Result<SidecarGrid>> gridOfSidecar(std::size_t points, const Source& source) {
    const auto path = sidecarOf(source.path);
    if (!path) return std::nullopt;
    const auto bytes = readInput(*path);
    if (!bytes) return Error{withValues("cannot be read (%1)", {bytes.error().what}), path->string(), ""};
    const auto record = parseJsonObject(textOf(*bytes), kSidecarFormat, path->string());
    if (!record) return Error{withValues("cannot be read (%1)", {record.error().what}), path->string(), ""};
    if (!record->contains("grid")) return std::nullopt;
    return gridOf(*record, points, source, path->string());
}

/// A point in the scanner's frame, and how far its numbers may be off.
struct ReadPoint {
    Vector3d scannerM;
    double errorM = 0;
};

/// Turns the coordinates of the file back into the scanner's frame.
class BackToScanner {
public:
    BackToScanner(const SidecarGrid& grid, const PointTable& table) : grid_(grid), table_(table) {
        if (grid.frame != CoordinateFrame::Scanner) placed_.emplace(grid.scan);
    }
    [[nodiscard]] ReadPoint operator()(const Vector3d& p, std::uint32_t cell) const {
        const Vector3d local = grid_.frame == CoordinateFrame::Mine ? Vector3d(p - placed_->originEnhM()) : p;
        const double error = 2 * (table_.precision.absolute + table_.precision.relative * local.norm());
        if (!placed_) return {local, error};
        const auto beams = static_cast<std::uint32_t>(grid_.scan.beams());
        return {placed_->scanner(static_cast<int>(cell / beams), static_cast<int>(cell % beams), local), error};
    }

private:
    const SidecarGrid& grid_;
    const PointTable& table_;
    std::optional<PlacedPoints> placed_;
};

/// Where the numbers of the file do not distinguish the range from a whole number of counts, it was one.
float rangeOf(const ReadPoint& point, double unitMm) {
    const double mm = point.scannerM.norm() * 1000.0, counts = std::round(mm / unitMm) * unitMm;
    return static_cast<float>(std::abs(counts - mm) <= std::min(point.errorM * 1000.0, 0.45 * unitMm) ? counts : mm);
}

/// One point of the table into its cell; false when the cell cannot take it.
bool lay(const ReadPoint& point, std::size_t n, std::uint32_t cell, const PointTable& table, Scan& scan) {
    auto* cloud = std::get_if<PointGeometry>(&scan.geometry);
    if (scan.state[cell] == CellState::Valid) { // a point behind the nearest of its cell
        if (cloud != nullptr) scan.attached.push_back({cell, point.scannerM});
        return cloud != nullptr;
    }
    const bool given = n < table.rangeMm.size() && table.rangeMm[n] > 0 && physical::kRangeMm.hold(table.rangeMm[n]);
    if (cloud != nullptr) cloud->pointsM[cell] = point.scannerM;
    scan.rangeMm[cell] = given              ? table.rangeMm[n]
                         : cloud != nullptr ? static_cast<float>((point.scannerM - cloud->sensorM).norm() * 1000.0)
                                            : rangeOf(point, scan.unitMm);
    scan.state[cell] = CellState::Valid;
    return true;
}

} // namespace

fs::path sidecarPath(const fs::path& exported) { return fs::path(exported.string() + ".provenance.json"); }

std::optional<fs::path> sidecarOf(const fs::path& exported) {
    std::error_code ignored;
    for (const fs::path& name : namesOf(exported)) {
        if (fs::path path = sidecarPath(name); fs::is_regular_file(path, ignored)) return path;
    }
    return std::nullopt;
}

std::optional<Scan> scanOfSidecar(PointTable& table, const std::optional<WrittenPlace>& place, const Source& source) {
    if (!table.description.empty() || source.options->unitMm || source.inMemory) return std::nullopt;
    const auto isListed = [&](const Vector3d& p) { return !place || isReturn(p); }; // PTX holds every cell
    const auto listed = static_cast<std::size_t>(std::ranges::count_if(table.points, isListed));
    auto found = gridOfSidecar(listed, source);
    if (!found) return std::nullopt;
    const auto notUsed = [&](const std::string& why) {
        table.remarks.push_back(withValues("The record next to the file %1, so the grid in it was not used.", {why}));
        return std::nullopt;
    };
    if (!*found) return notUsed(found->error().what);
    SidecarGrid& grid = **found;
    const BackToScanner back(grid, table);
    Scan& scan = grid.scan;
    const bool intensities = !table.intensity.empty() && !place; // PTX: scaled to 0 to 1
    if (intensities) scan.intensity = Grid<float>(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t n = 0, next = 0; n < table.points.size(); ++n) {
        const Vector3d& read = table.points[n];
        if (!isListed(read)) continue;
        const std::uint32_t cell = grid.cells[next++];
        if (!read.allFinite()) continue; // filled, and not measured
        if (!lay(back(place ? Vector3d(place->turn * read + place->place) : read, cell), n, cell, table, scan))
            return notUsed("lists a cell twice");
        if (intensities && scan.attached.empty()) scan.intensity[cell] = table.intensity[n]; // attached points follow all others
    }
    scan.format = table.format;
    scan.warnings.insert(scan.warnings.end(), table.remarks.begin(), table.remarks.end());
    return std::move(scan);
}

} // namespace edgescan::files
