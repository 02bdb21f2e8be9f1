// Lengths and angles between picked cells, with their uncertainty (docs/guide/measure.md, "How well it is known").
#pragma once

#include "core/base/translated_text.h"
#include "core/inspect/measure/cell_target.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::inspect {

enum class MeasureKind : std::uint8_t {
    Distance, ///< between two cells
    Vertical, ///< height of the second cell above the first
    Angle,    ///< at the second of three cells
    Spans,    ///< a x b: the distance of the first two cells, and that of the other two
    Path,     ///< along the surface, below the straight line of cells between two
    Throat,   ///< the narrowest free distance between two rims; its cells are those of narrowestBetween() (throat.h)
    Section,  ///< between two points of a section (section.h), each between two neighbouring cells: the nearer one first
};
inline constexpr int kMeasureKinds = 7;

struct MeasureTraits {
    MeasureKind kind;
    const char* key;   ///< key in files
    const char* label; ///< label in the window
    std::size_t cells; ///< number of cells
    bool inViews;      ///< its cells are clicked in the views
};
/// One row per kind.
[[nodiscard]] std::span<const MeasureTraits> measureTraits();
[[nodiscard]] const MeasureTraits& traitsOf(MeasureKind kind);
[[nodiscard]] std::optional<MeasureKind> measureKindNamed(std::string_view key);

/// The lines between the cells of a measurement: pairs of indices.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> linksOf(MeasureKind kind);

struct MeasuredLength {
    double valueM = 0.0;
    double toleranceM = 0.0; ///< two standard deviations
    double smallestM = 0.0;  ///< the resolution at the farther of the two ends
    bool isBelow = false;    ///< the two cells are closer than that: the length is not reported
};

struct MeasuredCells {
    MeasureKind kind = MeasureKind::Distance;
    std::vector<MeasuredLength> lengths; ///< one; two for Spans; empty for Angle
    double angleDeg = 0.0;               ///< only for Angle
    double angleToleranceDeg = 0.0;      ///< only for Angle; two standard deviations
    bool angleIsBelow = false;           ///< one of its sides is below the resolution
    int leaps = 0;                       ///< only for Path: number of jumps and gaps that it crosses
    /// How far an end is behind the surface under the line; 0: neither end is. Across a jump within 15 cells of the end, or one of more
    /// than a third of the length.
    double behindM = 0.0;
    double nearerBetweenM = 0.0;      ///< the same across another jump: something is in front of the middle of the line
    double inFrontM = 0.0;            ///< the same for an end in front of that surface; not for Throat, which is such a length
    double slopeDeg = 0.0;            ///< only for Distance: of the line, positive where its second end is the higher one
    double slopeToleranceDeg = 0.0;   ///< only for Distance; two standard deviations
    bool upAssumed = false;           ///< only for Vertical and Distance: the scan has no placement, so up is the scanner's z axis
    std::vector<double> rangesM;      ///< of its cells
    int fromClicks = 0;               ///< only for Throat: number of cells from a click to its end, at most
    double fromClicksM = 0.0;         ///< only for Throat: the same in metres, across the beams at the range of the end
    double spreadM = 0.0;             ///< only for Throat: how far those clicks next to these are from them; 0: not known
    double clicksM = 0.0;             ///< only for Throat: distance of the two clicked points; 0: not known
    double leastM = 0.0, mostM = 0.0; ///< only for Throat: shortest and longest that clicks next to these find; 0: not known
    double turnedDeg = 0.0;           ///< only for Throat: its line from that of two clicks, as the scanner sees them; 0 to 90
    double clickBehindM = 0.0;        ///< only for Throat: how far a click is behind its end, across a jump; 0: neither click is
    bool isDark = false;              ///< only for Throat: no cell between its ends has a range
    bool byOneClick = false;          ///< only for Throat: of one click into the opening

    /// Only for Throat: how much farther away than the other one an end is, if that is a large share of the length; else 0.
    [[nodiscard]] double endsApartM() const;
    /// Only for Throat: true if clicks next to these find lengths that differ by a fifth of it.
    [[nodiscard]] bool dependsMuch() const;
    /// Only for Throat: true if the way between the clicks is shorter, because its sides are not where they are.
    [[nodiscard]] bool isLongerThanClicks() const;
    /// Only for Throat: true if an end is farther from its click than the throat is wide: it may be another opening.
    [[nodiscard]] bool isFarFromClicks() const;
    /// True if measureRemarks() has a warning (▲).
    [[nodiscard]] bool isWarned() const;
};

/// Covariance of the place of a picked point, m^2, frame of the scan. Along the beam: the noise of the range. Across the beam: the point is
/// anywhere within the width of the beam, and the intended point is anywhere up to half a cell away.
[[nodiscard]] Eigen::Matrix3d placeCovariance(const Eigen::Vector3d& direction, double sigmaRangeM, const Resolution& resolution);

/// A point of the surface, and the cell nearest to it.
struct SurfacePoint {
    Eigen::Vector3d pointM;
    std::uint32_t cell;
};
/// How their distance is known: as between two picked cells, but without the way to the next cell, because the points are between cells.
[[nodiscard]] MeasuredLength lengthBetween(const Scan& scan, const RangeNoise& noise, const SurfacePoint& a, const SurfacePoint& b);

/// `shares`: for Section only, of the way from the first cell of each point to its second. Empty if a cell does not exist, is not valid or
/// has no neighbour with a direction; if the number of cells is wrong for the kind; or if a side of the angle has no length.
[[nodiscard]] std::optional<MeasuredCells> measureCells(const Scan& scan, const RangeNoise& noise, MeasureKind kind,
                                                        std::span<const std::uint32_t> cells, std::span<const double> shares = {});

/// For Throat: where its ends are, seen from the clicks, and how far it depends on the clicks. Its ± then
/// includes the lengths that clicks next to these find. `clicked`: of each of its cells (twice the same: one click
/// into the opening, see throatThrough()); empty: these are its cells.
void measureClicks(const Scan& scan, std::span<const std::uint32_t> cells, std::span<const std::uint32_t> clicked, MeasuredCells& measured);

/// "0.512 m ± 0.034", "< 88 mm".
[[nodiscard]] std::string lengthText(const MeasuredLength& length);
/// All values: "0.512 m ± 0.034", "0.51 × < 0.09 m", "148.2° ± 2.1".
[[nodiscard]] std::string measureText(const MeasuredCells& measured);
/// The ranges ("at 5.21, 5.30 m"), and what a reader must know of the ends and of the way between them. Warnings begin with ▲.
[[nodiscard]] std::vector<std::string> measureRemarks(const MeasuredCells& measured, Translated translated = asWritten);
/// All remarks in one line.
[[nodiscard]] std::string measureBasis(const MeasuredCells& measured, Translated translated = asWritten);

} // namespace edgescan::inspect
