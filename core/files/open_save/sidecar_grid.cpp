// From points and a known grid to cells: by direction, and by order where directions meet.
#include "core/files/open_save/sidecar_grid.h"

#include "core/base/checked_size.h"
#include "core/base/inputs.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/memory.h"
#include "core/base/physical_limits.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/point_tables/description.h"
#include "core/scan/georef/placed_points.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMostOffDeg = 0.02;  // a point farther from every beam or line is of another grid
constexpr double kGuessOffDeg = 3.0;  // of a direction worked out with another line's place of the scanner
constexpr double kRoundingM = 1.0e-3; // of the coarsest format: LAS, whole millimetres

/// The cells that a list's grid has, empty, with the place in the mine.
struct SidecarGrid {
    Scan scan;
    CoordinateFrame frame = CoordinateFrame::Scanner;
};

std::optional<SidecarGrid> readSidecar(PointTable& table, const Source& source) {
    const fs::path path = sidecarPath(source.path);
    const auto bytes = readInput(path);
    if (!bytes) return std::nullopt;
    const auto record = parseJsonObject(textOf(*bytes), kSidecarFormat, path.string());
    if (!record || !record->contains("grid")) return std::nullopt;
    const nlohmann::json::json_pointer hash("/export/sha256"), way("/record/coordinates/frame");
    if (!record->contains(hash) || record->at(hash) != nlohmann::json(sha256Hex(source.bytes))) {
        table.remarks.push_back("The record beside the file was written for another one, so the grid in it was not used.");
        return std::nullopt;
    }
    const auto grid = parseDescription(jsonText(record->at("grid")), path.string());
    if (!grid || grid->sensorM) return std::nullopt; // points about another sensor name no cell by their direction
    if (auto enough = checkMemory(productOf({grid->lines, grid->beams, 16}), path.string()); !enough) {
        table.remarks.push_back("There is not enough memory for the grid beside the file, so that grid was not used.");
        return std::nullopt;
    }
    auto polar = polarOf(*grid);
    if (!polar) return std::nullopt;
    SidecarGrid sidecar;
    Scan& scan = sidecar.scan;
    scan.geometry = std::move(*polar);
    scan.rangeMm = Grid<float>(static_cast<int>(grid->lines), static_cast<int>(grid->beams));
    scan.state = Grid<CellState>(scan.lines(), scan.beams(), CellState::NoReturn);
    applyStateRuns(scan, *grid);
    takeDescription(scan, *grid);
    if (record->contains(way) && record->at(way).is_string()) {
        const auto frame = frameNamed(record->at(way).get<std::string>());
        if (!frame) return std::nullopt;
        sidecar.frame = *frame;
    }
    if (sidecar.frame != CoordinateFrame::Scanner && !scan.placement) return std::nullopt;
    return sidecar;
}

/// Angles in order, for looking one up.
class SortedAngles {
public:
    explicit SortedAngles(const std::vector<double>& degrees) {
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            for (const double turn : {-360.0, 0.0, 360.0}) sorted_.emplace_back(degrees[i] + turn, i);
        }
        std::ranges::sort(sorted_);
    }
    /// Calls `take(index, off)` for every angle within `mostOff`.
    template <class Take>
    void near(double degrees, double mostOff, Take take) const {
        auto at = std::ranges::lower_bound(sorted_, std::pair(degrees - mostOff, std::size_t{0}));
        for (; at != sorted_.end() && at->first <= degrees + mostOff; ++at) take(at->second, std::abs(at->first - degrees));
    }

private:
    std::vector<std::pair<double, std::size_t>> sorted_;
};

/// Which cell a direction belongs to.
class CellFinder {
public:
    /// `roundingM`: how far the numbers may be off.
    CellFinder(const Scan& scan, double roundingM)
        : scan_(scan), polar_(std::get<PolarGeometry>(scan.geometry)), beams_(polar_.beamDeg), lines_(polar_.lineDeg),
          roundingM_(roundingM) {}

    /// The nearest cell after `last`; of those that the rounding of the numbers does not distinguish the first: a list is in the order of
    /// the cells. Empty when no cell is near enough.
    [[nodiscard]] std::optional<std::size_t> cellOf(const Vector3d& p, std::ptrdiff_t last, double mostOff = kMostOffDeg) const {
        const bool sweep = polar_.axis == Axis::Sweep;
        const double out = sweep ? std::hypot(p.y(), p.z()) : std::hypot(p.x(), p.y());
        const double range = std::max(p.norm(), 1e-6);
        const double beam = kDegrees * (sweep ? std::atan2(out, p.x()) : std::atan2(p.z(), out));
        const double line = kDegrees * (sweep ? std::atan2(-p.y(), p.z()) : std::atan2(p.y(), p.x()));
        const double nearAxis = std::max(out / range, 1e-6); // a line angle off counts as much less there
        const double rounding = kDegrees * roundingM_ / range;
        const double limit = std::min(mostOff + rounding, 30.0);
        near_.clear();
        const auto tryPair = [&](double beamDeg, double lineDeg) {
            beams_.near(beamDeg, limit, [&](std::size_t j, double beamOff) {
                const double skew = polar_.lineSkewDeg.empty() ? 0.0 : polar_.lineSkewDeg[j];
                lines_.near(polar_.lineDirection * lineDeg - skew, std::min(limit / nearAxis, 360.0), [&](std::size_t i, double lineOff) {
                    const std::size_t k = scan_.rangeMm.index(static_cast<int>(i), static_cast<int>(j));
                    if (static_cast<std::ptrdiff_t>(k) > last) near_.emplace_back(std::hypot(beamOff, lineOff * nearAxis), k);
                });
            });
        };
        tryPair(beam, line);
        tryPair(sweep ? -beam : 180.0 - beam, line + 180.0);
        if (near_.empty()) return std::nullopt;
        const double best = std::ranges::min(near_).first;
        std::size_t first = scan_.cells();
        for (const auto& [off, k] : near_) {
            if (off <= best + rounding + 1e-6) first = std::min(first, k);
        }
        return first;
    }

private:
    const Scan& scan_;
    const PolarGeometry& polar_;
    SortedAngles beams_, lines_;
    double roundingM_;
    mutable std::vector<std::pair<double, std::size_t>> near_; // of one call: off, cell
};

/// The scanner's frame again. The line matters where the scanner is off the stepper's axis: it is found with a first guess, then again.
class BackToScanner {
public:
    BackToScanner(const SidecarGrid& grid, const CellFinder& finder) : grid_(grid), finder_(finder) {
        if (grid.frame != CoordinateFrame::Scanner) placed_.emplace(grid.scan);
    }
    [[nodiscard]] std::pair<std::optional<std::size_t>, Vector3d> operator()(const Vector3d& p, std::ptrdiff_t last) const {
        if (!placed_) return {finder_.cellOf(p, last), p};
        const Vector3d local = grid_.frame == CoordinateFrame::Mine ? Vector3d(p - placed_->originEnhM()) : p;
        const auto beams = static_cast<std::size_t>(grid_.scan.beams());
        std::size_t cell = static_cast<std::size_t>(std::max<std::ptrdiff_t>(last, 0)); // the cell before is near in the list
        for (int round = 0; round < 8; ++round) {
            const Vector3d point = placed_->scanner(static_cast<int>(cell / beams), static_cast<int>(cell % beams), local);
            const auto found = finder_.cellOf(point, last);
            if (found && *found == cell) return {found, point};
            const auto guess = found ? found : finder_.cellOf(point, -1, kGuessOffDeg);
            if (!guess || (!found && *guess == cell)) break;
            cell = *guess;
        }
        return {std::nullopt, p};
    }

private:
    const SidecarGrid& grid_;
    const CellFinder& finder_;
    std::optional<PlacedPoints> placed_;
};

/// A range that was a whole number of counts is one again.
float rangeOf(double mm, double unitMm) {
    const double counts = std::round(mm / unitMm);
    return static_cast<float>(std::abs(counts * unitMm - mm) <= std::min(kRoundingM * 1000.0, unitMm) * 0.45 ? counts * unitMm : mm);
}

} // namespace

fs::path sidecarPath(const fs::path& exported) { return fs::path(exported.string() + ".provenance.json"); }

std::optional<Scan> scanOfSidecar(PointTable& table, const std::optional<WrittenPlace>& place, const Source& source) {
    std::error_code ignored;
    const bool mayBeThere = table.description.empty() && !source.options->unitMm && !source.inMemory;
    if (!mayBeThere || !fs::is_regular_file(sidecarPath(source.path), ignored)) return std::nullopt;
    auto grid = readSidecar(table, source);
    if (!grid) return std::nullopt;
    const CellFinder finder(grid->scan, std::max(2.0 * table.precision.absolute, 1e-5));
    const BackToScanner back(*grid, finder);
    Scan& scan = grid->scan;
    std::ptrdiff_t last = -1; // the cells of the points ascend
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        const Vector3d& read = table.points[n];
        if (place ? !isReturn(read) : !read.allFinite()) continue;
        const auto [cell, point] = back(place ? Vector3d(place->turn * read + place->place) : read, last);
        if (!cell) {
            table.remarks.push_back("Point " + std::to_string(n + 1) +
                                    " is in no cell of the grid beside the file, so that grid was not used.");
            return std::nullopt;
        }
        last = static_cast<std::ptrdiff_t>(*cell);
        const bool given = n < table.rangeMm.size() && table.rangeMm[n] > 0 && physical::kRangeMm.hold(table.rangeMm[n]);
        scan.rangeMm[*cell] = given ? table.rangeMm[n] : rangeOf(point.norm() * 1000.0, scan.unitMm);
        scan.state[*cell] = CellState::Valid;
        if (table.intensity.empty() || place) continue; // PTX: scaled to 0 to 1
        if (scan.intensity.size() == 0) scan.intensity = Grid<float>(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
        scan.intensity[*cell] = table.intensity[n];
    }
    scan.format = table.format;
    scan.warnings.insert(scan.warnings.end(), table.remarks.begin(), table.remarks.end());
    return std::move(scan);
}

} // namespace edgescan::files
