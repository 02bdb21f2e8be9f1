// Lengths and angles between cells that somebody picked, each with what is known of its error (docs/targets.md, "How well it is known").
#pragma once

#include "core/inspect/measure/cell_target.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

enum class MeasureKind : std::uint8_t {
    Distance, ///< between two cells
    Vertical, ///< how much higher the second lies than the first
    Angle,    ///< at the second of three
    Spans,    ///< a x b: between the first two, and between the other two
    Path,     ///< along the surface, under the straight line of cells between two
    Throat,   ///< the narrowest free way between two rims; its cells are those of narrowestBetween() (throat.h)
};
inline constexpr int kMeasureKinds = 6;

struct MeasureTraits {
    MeasureKind kind;
    const char* key;   ///< in files
    const char* label; ///< on the screen
    std::size_t cells; ///< that it takes
};
/// One row per kind.
[[nodiscard]] std::span<const MeasureTraits> measureTraits();
[[nodiscard]] const MeasureTraits& traitsOf(MeasureKind kind);
[[nodiscard]] std::optional<MeasureKind> measureKindNamed(std::string_view key);

struct MeasuredLength {
    double valueM = 0.0;
    double toleranceM = 0.0; ///< two standard deviations
    double smallestM = 0.0;  ///< what is resolved at the farther end of the two
    bool isBelow = false;    ///< the two cells are nearer to each other than that: there is no number
};

struct MeasuredCells {
    MeasureKind kind = MeasureKind::Distance;
    std::vector<MeasuredLength> lengths; ///< one; two of Spans; none of Angle
    double angleDeg = 0.0;               ///< of Angle
    double angleToleranceDeg = 0.0;      ///< likewise, two standard deviations
    bool angleIsBelow = false;           ///< one of its sides is below what is resolved
    int leaps = 0;                       ///< of Path: jumps and gaps that it goes over
    bool upAssumed = false;              ///< of Vertical: the scan has no pose, up is the scanner's z
    std::vector<double> rangesM;         ///< of its cells
};

/// Error in the place of a picked point, m^2, frame of the scan: noise of the range along the beam; across it the point lies anywhere in
/// the width of the beam, and what was meant anywhere up to half way to the next cell.
[[nodiscard]] Eigen::Matrix3d placeCovariance(const Eigen::Vector3d& direction, double sigmaRangeM, const Resolution& resolution);

/// Empty where a cell does not exist, is not valid or has no neighbour's direction, where the cells are too few or too many for the kind,
/// or where the angle has a side of no length.
[[nodiscard]] std::optional<MeasuredCells> measureCells(const Scan& scan, const RangeNoise& noise, MeasureKind kind,
                                                        std::span<const std::uint32_t> cells);

/// "0.512 m ± 0.034", "< 88 mm".
[[nodiscard]] std::string lengthText(const MeasuredLength& length);
/// All of it: "0.512 m ± 0.034", "0.51 × < 0.09 m", "148.2° ± 2.1".
[[nodiscard]] std::string measureText(const MeasuredCells& measured);
/// Where it came from: "at 5.21 and 5.30 m", and that up is assumed.
[[nodiscard]] std::string measureBasis(const MeasuredCells& measured);

} // namespace edgescan
