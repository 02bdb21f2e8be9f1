// Transforms edges of the early view to the cells in which the late view would measure them.
#include "app/lab/calibration/seam_edges.h"

#include "app/lab/calibration/axis_ends.h"
#include "app/lab/calibration/twice_seen.h"
#include "core/base/angles.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgescan::inspect {
namespace {

constexpr double kSeamOffAxisDeg = 4.0, kSeamOffEndDeg = 0.5; // spin: as in twice_seen.cpp; sweep
constexpr int kSeamPx = 3;
constexpr Rgb kSeamGround{20, 22, 26}, kLateColour{255, 150, 40}, kEarlyColour{70, 160, 255}, kBothColour{255, 255, 255};

/// The lines of one view, and the values for look-ups in them.
struct SeamLines {
    const PolarGeometry& polar;
    double first = 0, turn = 0;
    LineSpan late{};

    [[nodiscard]] bool isLate(int line) const { return line >= late.first && line < late.first + late.count; }
    [[nodiscard]] bool isEarly(double lineDeg) const { return lineDeg - first >= 0 && lineDeg - first <= std::min(turn - 180.0, 180.0); }
};

bool offAxis(const PolarGeometry& polar, double beamDeg) {
    return polar.axis == Axis::Spin ? std::abs(beamDeg - 90.0) > kSeamOffAxisDeg
                                    : std::min(std::abs(beamDeg), std::abs(180.0 - beamDeg)) > kSeamOffEndDeg;
}

std::optional<SeenCell> edgeAt(const Scan& scan, const Grid<std::uint8_t>& edges, const PolarGeometry& polar, int line, int beam) {
    const double beamDeg = polar.beamDeg[static_cast<std::size_t>(beam)];
    if (edges.at(line, beam) == 0 || scan.state.at(line, beam) != CellState::Valid) return std::nullopt;
    if (!offAxis(polar, beamDeg)) return std::nullopt;
    const double rangeM = 0.001 * static_cast<double>(scan.rangeMm.at(line, beam));
    return seenCell(polar, line, beam, rangeM);
}

bool anyAround(const Grid<std::uint8_t>& grid, int line, int beam) {
    for (int i = std::max(0, line - 1); i <= std::min(grid.lines - 1, line + 1); ++i) {
        for (int j = std::max(0, beam - 1); j <= std::min(grid.beams - 1, beam + 1); ++j) {
            if (grid.at(i, j) != 0) return true;
        }
    }
    return false;
}

/// The angles that the fan covers: half a step beyond the last beam is still inside.
class Fan {
public:
    explicit Fan(const std::vector<double>& beamDeg) {
        const auto [least, most] = std::minmax_element(beamDeg.begin(), beamDeg.end());
        const double step = (*most - *least) / static_cast<double>(std::max<std::size_t>(1, beamDeg.size() - 1));
        leastDeg_ = *least - 0.5 * step;
        mostDeg_ = *most + 0.5 * step;
    }
    [[nodiscard]] bool has(double beamDeg) const { return beamDeg >= leastDeg_ && beamDeg <= mostDeg_; }

private:
    double leastDeg_ = 0, mostDeg_ = 0;
};

void drawEarly(SeamEdges& seam, const Scan& scan, const Grid<std::uint8_t>& edges, const SeamLines& lines,
               const MountingWithErrors& mounting) {
    const PolarGeometry& polar = lines.polar;
    const Fan fan(polar.beamDeg);
    std::vector<int> columnOf(polar.beamDeg.size(), -1);
    for (std::size_t n = 0; n < seam.beams.size(); ++n) columnOf[static_cast<std::size_t>(seam.beams[n])] = static_cast<int>(n);
    for (int line = 0; line < scan.lines(); ++line) {
        if (!lines.isEarly(polar.lineDeg[static_cast<std::size_t>(line)])) continue;
        for (const int beam : seam.beams) {
            const auto cell = edgeAt(scan, edges, polar, line, beam);
            const auto later = cell ? otherViewOf(*cell, View::Early, mounting) : std::nullopt;
            if (!later || !fan.has(later->beamDeg)) continue;
            const int at = nearestAngle(polar.beamDeg, later->beamDeg);
            const int row = nearestLine(polar, at, later->lineDeg);
            // For places outside the grid the nearest angle is at its border.
            const bool inside = later->lineDeg <= lines.first + lines.turn && lines.isLate(row);
            const int column = columnOf[static_cast<std::size_t>(at)];
            if (inside && seam.early.contains(row - seam.firstLine, column)) seam.early.at(row - seam.firstLine, column) = 1;
        }
    }
}

void countMet(SeamEdges& seam, const Scan& scan, const Grid<std::uint8_t>& edges, const SeamLines& lines,
              const MountingWithErrors& mounting) {
    const Fan fan(lines.polar.beamDeg);
    for (int row = 0; row < seam.late.lines; ++row) {
        for (int column = 0; column < seam.late.beams; ++column) {
            const auto cell = edgeAt(scan, edges, lines.polar, seam.firstLine + row, seam.beams[static_cast<std::size_t>(column)]);
            if (!cell) continue;
            seam.late.at(row, column) = 1;
            const auto before = otherViewOf(*cell, View::Late, mounting);
            if (!before || !lines.isEarly(before->lineDeg) || !fan.has(before->beamDeg)) continue;
            if (!offAxis(lines.polar, before->beamDeg)) continue; // omitted from both views
            ++seam.lateEdges;
            seam.matched += anyAround(seam.early, row, column) ? 1 : 0;
        }
    }
}

} // namespace

SeamEdges seamEdges(const Scan& scan, const Grid<std::uint8_t>& edges, const AssemblyErrors& errors) {
    SeamEdges seam;
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->lineDeg.empty() || turnOf(*polar) <= 180.0) return seam;
    const SeamLines lines{*polar, *std::min_element(polar->lineDeg.begin(), polar->lineDeg.end()), turnOf(*polar), lateLines(*polar)};
    seam.beams = beamsSeenTwice(*polar);
    if (lines.late.count == 0 || seam.beams.empty()) return {};
    seam.firstLine = lines.late.first;
    seam.late = seam.early = Grid<std::uint8_t>(lines.late.count, static_cast<int>(seam.beams.size()));
    const MountingWithErrors mounting = mountingWithErrors(*polar, errors);
    drawEarly(seam, scan, edges, lines, mounting);
    countMet(seam, scan, edges, lines, mounting);
    return seam;
}

Grid<Rgb> seamPicture(const SeamEdges& seam) {
    Grid<Rgb> picture(std::max(1, seam.late.lines * kSeamPx), std::max(1, seam.late.beams * kSeamPx), kSeamGround);
    for (int i = 0; i < seam.late.lines; ++i) {
        for (int j = 0; j < seam.late.beams; ++j) {
            const bool late = seam.late.at(i, j) != 0, early = seam.early.at(i, j) != 0;
            const Rgb colour = late && early ? kBothColour : late ? kLateColour : kEarlyColour;
            for (int n = 0; n < kSeamPx; ++n) {
                if (late) picture.at(i * kSeamPx + kSeamPx / 2, j * kSeamPx + n) = colour;
                if (early) picture.at(i * kSeamPx + n, j * kSeamPx + kSeamPx / 2) = colour;
            }
        }
    }
    return picture;
}

} // namespace edgescan::inspect
