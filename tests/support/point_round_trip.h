// Writes a scan as a bare list of points, rounded, shuffled and thinned, and compares the scan that is opened from the list.
#pragma once

#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/point_files.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numbers>
#include <random>

namespace edgescan::test {

struct RoundTrip {
    const char* format = "xyz"; ///< "xyz", "csv", "las", "pcd" (4-byte floats), "ply" (8-byte floats)
    int decimals = 3;           ///< of metres
    bool shuffled = false;
    double thinned = 0.0; ///< share of points left out
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero();
    CoordinateFrame frame = CoordinateFrame::Scanner; ///< another one needs the scan's placement
};

/// Points of cells, in the order of the file.
struct WrittenPoints {
    Points points;
    std::vector<std::uint32_t> cell;
};

inline WrittenPoints writtenPoints(const Scan& scan, const RoundTrip& trip, unsigned seed = 5) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const CartesianTables tables(scan);
    const double scale = std::pow(10.0, trip.decimals);
    std::optional<PlacedPoints> placed;
    if (trip.frame != CoordinateFrame::Scanner) placed.emplace(scan);
    WrittenPoints written;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid && unit(random) >= trip.thinned) written.cell.push_back(static_cast<std::uint32_t>(k));
    }
    if (trip.shuffled) std::shuffle(written.cell.begin(), written.cell.end(), random);
    for (const std::uint32_t k : written.cell) {
        const int line = static_cast<int>(k) / scan.beams(), beam = static_cast<int>(k) % scan.beams();
        Eigen::Vector3d p =
            placed ? placed->inFrame(trip.frame, line, beam, tables.point(k)) : Eigen::Vector3d(tables.point(k) + trip.sensorM);
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * scale) / scale;
        written.points.push_back(p);
    }
    return written;
}

inline std::string fileOf(const Points& points, const RoundTrip& trip) {
    const std::string format = trip.format;
    if (format == "las") return pointLas(points, std::pow(10.0, -trip.decimals));
    if (format == "pcd") return pointPcd(points);
    if (format == "ply") return pointPly(points);
    if (format == "csv") return pointText(points, trip.decimals, ',', "x,y,z\n");
    return pointText(points, trip.decimals);
}

/// The result of the comparison.
struct CameBack {
    std::string problem; ///< the error's sentence; empty: it opened
    int lines = 0, beams = 0;
    std::size_t written = 0;
    std::size_t lost = 0;   ///< points without a cell of their own
    std::size_t moved = 0;  ///< cells whose range differs from that of the same cell of the original
    std::size_t edges = 0;  ///< edge cells of the original
    std::size_t differ = 0; ///< cells in which the masks differ
    /// points so near the axis that rounding may move them by more than half a line: their line cannot be recovered
    std::size_t unclear = 0;
    std::size_t movedClear = 0;    ///< of `moved`: cells that had a point that is not such an unclear point
    std::size_t differRounded = 0; ///< mask cells that differ if each cell stays and gets the range of its rounded point
    double seconds = 0;            ///< time to open it
    bool turnedLines = false, turnedBeams = false;
    std::vector<std::array<double, 4>> examples; ///< of moved cells: line, beam, range before, range after
    std::vector<std::string> warnings;
};

/// The position of the cells of `found` in `original`: mirrored, and without lines and beams without points at the ends.
struct Alignment {
    bool turnLines = false, turnBeams = false;
    int firstLine = 0, firstBeam = 0;
    std::size_t agreeing = 0;

    /// Cell of the original; empty outside.
    [[nodiscard]] std::optional<std::size_t> cell(const Scan& original, const Scan& found, int i, int j) const {
        const int line = firstLine + (turnLines ? found.lines() - 1 - i : i);
        const int beam = firstBeam + (turnBeams ? found.beams() - 1 - j : j);
        if (!original.rangeMm.contains(line, beam)) return std::nullopt;
        return original.rangeMm.index(line, beam);
    }
};

inline bool sameRange(const Scan& original, std::size_t k, const Scan& found, int i, int j, double toleranceMm) {
    return original.state[k] == CellState::Valid && found.state.at(i, j) == CellState::Valid &&
           std::abs(original.rangeMm[k] - found.rangeMm.at(i, j)) <= static_cast<float>(toleranceMm);
}

inline Alignment alignmentOf(const Scan& original, const Scan& found, double toleranceMm) {
    Alignment best;
    const int lines = original.lines() - found.lines();
    const int beams = original.beams() - found.beams();
    const int every = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(found.cells()) / 4000)));
    for (int tried = 0; tried < 4; ++tried) {
        for (int firstLine = std::min(lines, 0); firstLine <= std::clamp(lines, 0, 12); ++firstLine) {
            for (int firstBeam = std::min(beams, 0); firstBeam <= std::clamp(beams, 0, 12); ++firstBeam) {
                if (firstLine < -12 || firstBeam < -12) continue;
                Alignment a{tried % 2 == 1, tried / 2 == 1, firstLine, firstBeam, 0};
                for (int i = 0; i < found.lines(); i += every) {
                    for (int j = 0; j < found.beams(); j += every) {
                        const auto k = a.cell(original, found, i, j);
                        a.agreeing += k && sameRange(original, *k, found, i, j, toleranceMm) ? 1 : 0;
                    }
                }
                if (a.agreeing > best.agreeing) best = a;
            }
        }
    }
    return best;
}

inline std::shared_ptr<const Grid<std::uint8_t>> maskOf(const Scan& scan) {
    return edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{})->mask;
}

/// The original, with the cells that were not written as no returns.
inline Scan onlyWritten(Scan scan, const std::vector<std::uint32_t>& cells) {
    std::vector<bool> is(scan.cells(), false);
    for (const std::uint32_t k : cells) is[k] = true;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (!is[k] && scan.state[k] == CellState::Valid) scan.state[k] = CellState::NoReturn;
    }
    return scan;
}

/// The scan with its lines or beams in the opposite order.
inline Scan turnedOver(const Scan& scan, bool lines, bool beams) {
    Scan turned = scan;
    auto* polar = std::get_if<PolarGeometry>(&turned.geometry);
    if (polar == nullptr) return turned;
    if (lines) std::reverse(polar->lineDeg.begin(), polar->lineDeg.end());
    if (beams) std::reverse(polar->beamDeg.begin(), polar->beamDeg.end());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            const std::size_t from = scan.rangeMm.index(lines ? scan.lines() - 1 - i : i, beams ? scan.beams() - 1 - j : j);
            turned.rangeMm.at(i, j) = scan.rangeMm[from];
            turned.state.at(i, j) = scan.state[from];
        }
    }
    return turned;
}

/// Written points, by cell, whose line cannot be recovered from their rounded numbers.
inline std::vector<bool> unclearCells(const Scan& scan, const WrittenPoints& written, const RoundTrip& trip) {
    std::vector<bool> unclear(scan.cells(), false);
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return unclear;
    const CartesianTables tables(scan);
    const double roundedM = 0.5 * std::pow(10.0, -trip.decimals) * std::numbers::sqrt2; // of the two coordinates across the axis
    for (const std::uint32_t k : written.cell) {
        const auto i = static_cast<std::size_t>(k) / static_cast<std::size_t>(scan.beams());
        double step = 360;
        if (i > 0) step = std::min(step, std::abs(polar->lineDeg[i] - polar->lineDeg[i - 1]));
        if (i + 1 < polar->lineDeg.size()) step = std::min(step, std::abs(polar->lineDeg[i + 1] - polar->lineDeg[i]));
        const Eigen::Vector3d p = tables.point(k);
        const double fromAxis = polar->axis == Axis::Spin ? std::hypot(p.x(), p.y()) : std::hypot(p.y(), p.z());
        unclear[k] = fromAxis * std::sin(step / 2 * std::numbers::pi / 180) <= roundedM;
    }
    return unclear;
}

/// The scan with the ranges of its rounded points, each in its own cell.
inline Scan withRoundedRanges(Scan scan, const WrittenPoints& written, const RoundTrip& trip) {
    std::optional<PlacedPoints> placed;
    if (trip.frame != CoordinateFrame::Scanner) placed.emplace(scan);
    for (std::size_t n = 0; n < written.cell.size(); ++n) {
        Eigen::Vector3d p = written.points[n] - trip.sensorM;
        const int line = static_cast<int>(written.cell[n]) / scan.beams(), beam = static_cast<int>(written.cell[n]) % scan.beams();
        if (trip.frame == CoordinateFrame::Mine) p -= placed->originEnhM();
        if (placed) p = placed->scanner(line, beam, p);
        scan.rangeMm[written.cell[n]] = static_cast<float>(1000 * p.norm());
    }
    return scan;
}

/// A shuffled list has no direction: the original is compared in the direction that was found.
inline CameBack compared(const Scan& asWritten, const Scan& found, std::size_t written, double toleranceMm,
                         const std::vector<bool>& unclearAsWritten = {}) {
    CameBack back;
    back.written = written;
    back.lines = found.lines();
    back.beams = found.beams();
    back.warnings = found.warnings;
    const auto valid = countCells(found)[static_cast<std::size_t>(CellState::Valid)];
    back.lost = written - std::min(valid, written);
    const Alignment turned = alignmentOf(asWritten, found, toleranceMm);
    back.turnedLines = turned.turnLines;
    back.turnedBeams = turned.turnBeams;
    const Scan original = turnedOver(asWritten, turned.turnLines, turned.turnBeams);
    const Alignment a = alignmentOf(original, found, toleranceMm);
    back.unclear = static_cast<std::size_t>(std::ranges::count(unclearAsWritten, true));
    const auto isUnclear = [&](std::size_t k) {
        if (unclearAsWritten.empty()) return false;
        const auto line = static_cast<int>(k / static_cast<std::size_t>(original.beams()));
        const auto beam = static_cast<int>(k % static_cast<std::size_t>(original.beams()));
        return unclearAsWritten[original.rangeMm.index(turned.turnLines ? original.lines() - 1 - line : line,
                                                       turned.turnBeams ? original.beams() - 1 - beam : beam)];
    };
    const auto expected = maskOf(original);
    const auto mask = maskOf(found);
    std::vector<bool> seen(original.cells(), false);
    for (int i = 0; i < found.lines(); ++i) {
        for (int j = 0; j < found.beams(); ++j) {
            const auto k = a.cell(original, found, i, j);
            const bool edge = mask->at(i, j) != 0;
            if (!k) {
                back.differ += edge ? 1 : 0;
                continue;
            }
            seen[*k] = true;
            if (found.state.at(i, j) == CellState::Valid && !sameRange(original, *k, found, i, j, toleranceMm)) {
                back.movedClear += original.state[*k] == CellState::Valid && !isUnclear(*k) ? 1 : 0;
                if (++back.moved % 97 == 1) back.examples.push_back({double(i), double(j), original.rangeMm[*k], found.rangeMm.at(i, j)});
            }
            back.differ += edge != ((*expected)[*k] != 0) ? 1 : 0;
        }
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
        back.edges += (*expected)[k] != 0 ? 1 : 0;
        back.differ += !seen[k] && (*expected)[k] != 0 ? 1 : 0;
    }
    return back;
}

inline CameBack roundTrip(const Scan& scan, const RoundTrip& trip) {
    const WrittenPoints written = writtenPoints(scan, trip);
    const std::string bytes = fileOf(written.points, trip);
    const auto start = std::chrono::steady_clock::now();
    ReadingOptions options;
    if (!trip.sensorM.isZero(0.0)) options.sensorM = trip.sensorM;
    const auto found = files::readScanBytes(std::as_bytes(std::span(bytes)), std::string(".") + trip.format, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!found) {
        CameBack back;
        back.problem = found.error().sentence();
        return back;
    }
    const Scan reference = onlyWritten(scan, written.cell);
    CameBack back = compared(reference, *found, written.points.size(), 1000 * std::pow(10.0, -trip.decimals) + 1,
                             unclearCells(reference, written, trip));
    const auto asItWas = maskOf(reference);
    const auto rounded = maskOf(withRoundedRanges(reference, written, trip));
    for (std::size_t k = 0; k < reference.cells(); ++k) back.differRounded += (*asItWas)[k] != (*rounded)[k] ? 1 : 0;
    back.seconds = seconds;
    return back;
}

} // namespace edgescan::test
