// Straight ways over the grid of a scan, and whether nothing is in the way between two of its points.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace edgescan::inspect {

inline constexpr int kCellsAtEnds = 4;     ///< before and behind a jump, for the straight lines that meet there
inline constexpr int kWidestVoid = 7;      ///< cells without a range between two surfaces, over which a jump is seen
inline constexpr int kFewestOnSurface = 4; ///< cells of a surface: fewer are dust

/// A straight way over the grid from a cell. The first kCellsAtEnds cells are before that cell.
struct WayOut {
    std::vector<std::uint32_t> cells;
    std::vector<double> rangesM; ///< 0 without a range
};

/// Up to `cells` cells in a direction whose larger part is 1.
[[nodiscard]] WayOut wayOut(const Scan& scan, std::uint32_t k, double lineStep, double beamStep, int cells);

/// A cell at a side of an opening.
struct RimCell {
    std::uint32_t cell;
    Eigen::Vector3d pointM;
};

/// The angle between the two cells, radians.
[[nodiscard]] double openingRad(const CartesianTables& tables, std::uint32_t a, std::uint32_t b);

/// True if the two ranges differ by more than the opening is wide there: the farther one is not at the rim of the same opening.
[[nodiscard]] bool isBehind(double rangeM, double otherM, double openingRad);

/// True if no cell was measured in front of the straight line between the two points or on it, half of the cells between have the next
/// surface well behind the line (a hollow of a rock is not an opening), and most of the others a little (the line does not run over rock).
[[nodiscard]] bool isOpen(const Scan& scan, const CartesianTables& tables, const RimCell& from, const RimCell& to);

/// On the straight way over the grid between two measured cells, the middle of the longest run of cells without a range over which no
/// surface goes on, else the farthest cell. Empty without cells between the two.
[[nodiscard]] std::optional<std::uint32_t> openingBetween(const Scan& scan, std::uint32_t a, std::uint32_t b);

/// The sides of the opening around `into`, which is openingBetween() two cells on near rock, on the straight way between the two: that next
/// to `a` first. Empty if what is seen there is not as far behind the sides as they are apart.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> sidesBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                                       std::uint32_t b, std::uint32_t into);

/// The shortest ways across the middles of closed openings, as of throatThrough(); the way of a cell is found once.
class Crossings {
public:
    Crossings(const Scan& scan, const CartesianTables& tables) : scan_(scan), tables_(tables) {}
    /// The ends of the way across the opening around `into`, which is openingBetween() the two cells. Empty also if that way does not cross
    /// the one between the cells: they are at another part of the opening than its middle.
    [[nodiscard]] std::optional<std::array<std::uint32_t, 2>> between(std::uint32_t a, std::uint32_t b, std::uint32_t into);

private:
    const Scan& scan_;
    const CartesianTables& tables_;
    std::map<std::uint32_t, std::optional<std::array<std::uint32_t, 2>>> sides_; // by the cell in the opening
};

} // namespace edgescan::inspect
