// Changes between two scans of one place, cell by cell on the grid of the later one.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/inspect/registration/scan_alignment.h"
#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::inspect {

/// The basis of the registration.
enum class RegistrationBasis : std::uint8_t {
    OneScan,  ///< both are the same scan, with two settings or opened twice
    Poses,    ///< both have a placement, or the request has poses
    Surfaces, ///< only their surfaces: at least one has no placement
};

struct RegistrationRequest {
    /// later, earlier: transforms from the scanner frame to a common frame, instead of the scans' own placements
    std::optional<std::array<RigidTransform, 2>> poses{};
    bool bySurfaces = false; ///< also correct existing placements by the surfaces
};

struct RegistrationResult {
    RegistrationBasis by = RegistrationBasis::OneScan;
    bool inMine = false; ///< by the placements of both scans; false for poses of the request: those of a simulation, or --poses-3dtk
    /// cell k of one scan is cell k of the other; otherwise points were moved to the cells that they fall into
    bool sameCells = true;
    std::optional<ScanAlignment> surfaces; ///< the remaining distance of the surfaces, also if they were not moved; empty for one scan
    std::optional<RigidTransform> moved;   ///< by which the earlier scan's points were moved in the common frame; empty: not at all
    bool outOfSpec = false;                ///< the warnings give the reasons
    std::vector<std::string> warnings;

    /// Otherwise the surfaces do not fit, and areas or lengths of change would be those of the registration.
    [[nodiscard]] bool measurable() const { return !surfaces || surfaces->residualM <= kMostResidualM; }
};

/// The earlier scan on the grid of the later one.
struct EarlierOnGrid {
    std::shared_ptr<const Scan> scan;                ///< lines x beams of the later scan; ranges in mm from its sensor
    std::shared_ptr<const Grid<std::uint8_t>> edges; ///< 255 = edge of the earlier scan
    RegistrationResult how;
    std::size_t edgesLeftOut = 0; ///< edge cells of the earlier scan that do not fall into a cell of the later one
};

/// The points of the later and of the earlier scan in one frame, as they were registered. Both must be those of earlierOnGridOf().
[[nodiscard]] std::array<PlacedScan, 2> inOneFrame(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                                   const RegistrationResult& how, const RegistrationRequest& wish = {});

/// `edges`: of the earlier scan, not 0 = edge. Scans without a placement are registered by their surfaces; the result is OUT OF SPEC and
/// carries a warning (docs/reference/rules.md, "S20"). Error: only one of them has a placement and `bySurfaces` is false, the surfaces do
/// not determine the registration, or the two scans have no common direction.
Result<EarlierOnGrid> earlierOnGridOf(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                      const std::shared_ptr<const Grid<std::uint8_t>>& edges, const RegistrationRequest& wish = {});

enum class EdgeChange : std::uint8_t {
    None,
    Unchanged, ///< an edge in both
    Gained,    ///< an edge only in the later scan, where the earlier one measured
    Lost,      ///< an edge only in the earlier scan, where the later one measured
    Unknown,   ///< an edge in one scan where the other did not measure: unknown
};

enum class RangeChange : std::uint8_t {
    Unknown,       ///< missing in both scans
    Same,          ///< difference within the noise of both
    Nearer,        ///< than before
    Farther,       ///< than before
    NoReturnNow,   ///< measured before, no return now
    NoReturnBefore ///< measured now, no return before
};

/// Criteria for changes of edges and ranges. Constant, so that all users get the same result.
/// for another scan: an edge within this many cells counts as the same one; for the same scan: 0
inline constexpr int kEdgeReachCells = 1;
inline constexpr double kChangeSigmas = 4.0;       ///< a range changed if it differs by more than this, also from all neighbours
inline constexpr std::size_t kSmallestRegion = 40; ///< cells

struct EdgeChanges {
    Grid<EdgeChange> cells; ///< lines x beams
    std::size_t unchanged = 0, gained = 0, lost = 0, unknown = 0;
    std::size_t earlierUnchanged = 0; ///< edges of the earlier scan that are in both; `unchanged` counts those of the later one
};

/// Masks: lines x beams, not 0 = edge. An edge is in both scans if the other has one within `reach` cells, including diagonals; the cells
/// that count as `kept` are those of the later scan.
[[nodiscard]] EdgeChanges edgeChanges(const Grid<std::uint8_t>& later, const Grid<std::uint8_t>& earlier, const Grid<CellState>& laterState,
                                      const Grid<CellState>& earlierState, int reach);

struct RangeChanges {
    Grid<RangeChange> cells; ///< lines x beams
    Grid<float> byMm;        ///< lines x beams, mm: later minus earlier, above 0 = farther; 0 unless Nearer or Farther
    std::size_t same = 0, nearer = 0, farther = 0, noReturnNow = 0, noReturnBefore = 0;
};

/// The noise of both scans, and the error of their registration.
struct ChangeNoise {
    RangeNoise later, earlier;
    double placesMm = 0.0; ///< one standard deviation of the registration, mm
    /// One standard deviation of the difference of two ranges.
    [[nodiscard]] double at(double rangeM) const;
};

/// A cell changed if its range is outside the span of the nine cells of the other scan around it, and the other scan's range is outside the
/// span of its own nine, by kChangeSigmas each. So a border that moved by less than a cell is not a change.
[[nodiscard]] RangeChanges rangeChanges(const Scan& later, const Scan& earlier, const ChangeNoise& noise);

/// Connected cells (8 neighbours) that are all nearer, or all farther, than before.
struct ChangedRegion {
    bool farther = false;
    std::size_t cells = 0;
    std::uint32_t cell = 0; ///< the cell nearest to the middle
    int firstLine = 0, lastLine = 0, firstBeam = 0, lastBeam = 0;
    double areaM2 = 0.0;   ///< m^2 across the beams, at the smaller of both ranges
    double byM = 0.0;      ///< median change, m, above 0
    double toleranceM = 0; ///< m, for one cell: two standard deviations
    double rangeM = 0.0;   ///< m, of that cell in the later scan
};

/// Regions with at least kSmallestRegion cells; largest area first, ties by first cell.
[[nodiscard]] std::vector<ChangedRegion> changedRegions(const Scan& later, const RangeChanges& changes, const ChangeNoise& noise);

struct SceneChange {
    EarlierOnGrid earlier;
    EdgeChanges edges;
    RangeChanges ranges;                ///< empty grids for one scan
    std::vector<ChangedRegion> regions; ///< the same
    ChangeNoise noise;
    double differMm = 0.0; ///< mm: half of the cells measured in both scans differ by less than this; includes registration error and noise
};

/// One side of a comparison: a scan and its edges, not 0 = edge.
struct ScanEdges {
    std::shared_ptr<const Scan> scan;
    std::shared_ptr<const Grid<std::uint8_t>> mask;
};

/// Error: those of earlierOnGridOf().
Result<SceneChange> sceneChange(const ScanEdges& later, const ScanEdges& earlier, const RegistrationRequest& wish = {});

/// The same if only edges of the later scan changed: all else is reused.
[[nodiscard]] SceneChange withEdges(SceneChange change, const ScanEdges& later);

} // namespace edgescan::inspect
