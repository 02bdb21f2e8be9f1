// What changed between two pictures of one place, cell by cell on the grid of the later one.
#pragma once

#include "core/inspect/change_detection/line_up.h"
#include "core/scan/grid/inverse_range.h"

#include <cstdint>
#include <vector>

namespace edgescan {

enum class EdgeChange : std::uint8_t {
    None,
    Kept,   ///< an edge in both
    Gained, ///< an edge of the later one alone, where the earlier one measured
    Lost,   ///< an edge of the earlier one alone, where the later one measured
    Unseen, ///< an edge of one of them where the other measured nothing: nobody can tell
};

enum class RangeChange : std::uint8_t {
    Unknown,       ///< neither has a range
    Same,          ///< within the noise of both
    Nearer,        ///< than before
    Farther,       ///< than before
    NoReturnNow,   ///< measured before
    NoReturnBefore ///< measured now
};

/// How edges and ranges are told apart. Fixed, so that two people see the same.
inline constexpr int kEdgeReachCells = 1;          ///< of another scan: an edge within so many cells is the same one; of one scan: 0
inline constexpr double kChangeSigmas = 4.0;       ///< a range changed when it differs by more, and from all neighbours too
inline constexpr std::size_t kSmallestRegion = 40; ///< cells

struct EdgeChanges {
    Grid<EdgeChange> cells; ///< lines x beams
    std::size_t kept = 0, gained = 0, lost = 0, unseen = 0;
};

/// Masks: lines x beams, not 0 = edge. An edge of one has the other's within `reach` cells, diagonals too; kept are cells of the later one.
[[nodiscard]] EdgeChanges edgeChanges(const Grid<std::uint8_t>& later, const Grid<std::uint8_t>& earlier, const Grid<CellState>& laterState,
                                      const Grid<CellState>& earlierState, int reach);

struct RangeChanges {
    Grid<RangeChange> cells; ///< lines x beams
    Grid<float> byMm;        ///< lines x beams: later less earlier, above 0 = farther; 0 unless Nearer or Farther
    std::size_t same = 0, nearer = 0, farther = 0, noReturnNow = 0, noReturnBefore = 0;
};

/// The noise of both scans, and how well they lie on each other.
struct ChangeNoise {
    RangeNoise later, earlier;
    double placesMm = 0.0; ///< one standard deviation of how the one lies on the other
    /// One standard deviation of a difference of two ranges.
    [[nodiscard]] double at(double rangeM) const;
};

/// A cell changed when its range lies outside those of the nine cells of the other scan round it, and the other's outside those of its own
/// nine, by kChangeSigmas each: a border that moved by less than a cell is no change.
[[nodiscard]] RangeChanges rangeChanges(const Scan& later, const Scan& earlier, const ChangeNoise& noise);

/// Cells that hang together (8 neighbours) and all came nearer, or all went farther.
struct ChangedRegion {
    bool farther = false;
    std::size_t cells = 0;
    std::uint32_t cell = 0; ///< of them the one nearest the middle
    int firstLine = 0, lastLine = 0, firstBeam = 0, lastBeam = 0;
    double areaM2 = 0.0;   ///< across the beams, at the nearer of both ranges
    double byM = 0.0;      ///< median change, above 0
    double toleranceM = 0; ///< of one cell: two standard deviations
    double rangeM = 0.0;   ///< of that cell in the later scan
};

/// From kSmallestRegion cells on; largest area first, ties by first cell.
[[nodiscard]] std::vector<ChangedRegion> changedRegions(const Scan& later, const RangeChanges& changes, const ChangeNoise& noise);

struct SceneChange {
    EarlierOnGrid earlier;
    EdgeChanges edges;
    RangeChanges ranges;                ///< empty grids for one scan
    std::vector<ChangedRegion> regions; ///< likewise
    ChangeNoise noise;
    double differMm = 0.0; ///< of the cells that both measured half differ by less: how well the one lies on the other, noise included
};

/// One side of a comparison: a scan and its edges, not 0 = edge.
struct ScanEdges {
    std::shared_ptr<const Scan> scan;
    std::shared_ptr<const Grid<std::uint8_t>> mask;
};

/// Error: as onGridOf().
Result<SceneChange> sceneChange(const ScanEdges& later, const ScanEdges& earlier, const LineUpWish& wish = {});

/// The same when only edges of the later scan changed: everything else is taken over.
[[nodiscard]] SceneChange withEdges(SceneChange change, const ScanEdges& later);

} // namespace edgescan
