// Scanners whose beams turn all round: columns of ranges, one for each shot of all beams, and the turns that they make.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::robots {

/// One shot of all beams, in the order of SpinningBeams.
struct SpinningColumn {
    double azimuthDeg = 0;         ///< of the first beam that is fired, from 0 to 360
    std::int64_t timeNs = 0;       ///< since 1970 UTC
    std::vector<float> rangeMm;    ///< 0: no return
    std::vector<float> reflection; ///< strength of the return, as the scanner counts it
};

/// The beams of a scanner, by elevation from below.
struct SpinningBeams {
    std::string vendor, model;
    std::vector<double> elevationDeg;
    std::vector<double> laterS;     ///< after the first beam of the shot, seconds; empty: all at once
    std::vector<double> azimuthDeg; ///< added to that of the column; empty: 0
    bool clockwise = true;          ///< azimuths grow clockwise, seen from above
    double unitMm = 1.0;            ///< of the ranges
};

/// Indices of the first columns of each turn: an azimuth that starts again begins one.
[[nodiscard]] std::vector<std::size_t> turnsOf(const std::vector<SpinningColumn>& columns);

/// The grid of columns `first` to `last` (behind it): a line for each column, a beam for each beam. Columns that are missing between two
/// others are lost lines. Warnings name them.
[[nodiscard]] Scan scanOfTurn(const std::vector<SpinningColumn>& columns, std::size_t first, std::size_t last, const SpinningBeams& beams);

} // namespace edgescan::robots
