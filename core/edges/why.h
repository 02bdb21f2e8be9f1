// Why a cell is an edge, or why it is none (VIEWER.md, idea 6).
#pragma once

#include "core/edges/frame.h"
#include "core/edges/probe.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// Where a strength stands between the thresholds.
enum class Standing : std::uint8_t { Below, Between, Above };

struct CellStrength {
    int line = 0;
    int beam = 0;
    double strength = 0.0; ///< in units of the thresholds
};

struct Why {
    Probe probe;
    bool takesPart = true;              ///< false: no range, or masked: no edge whatever the thresholds
    std::optional<double> smoothed;     ///< level after smoothing; null where the method smooths no levels
    std::optional<double> alongBeams;   ///< gradient, in units of the thresholds; Canny only
    std::optional<double> alongLines;   ///< likewise
    std::optional<double> directionDeg; ///< of the gradient: 0 along increasing beams, 90 along increasing lines
    double strength = 0.0;              ///< magnitude of the gradient, response of the detector, or strength of jump or crease
    double lower = 0.0;                 ///< thresholds; equal where there is only one
    double upper = 0.0;
    Standing standing = Standing::Below;
    std::optional<CellStrength> suppressedBy; ///< the neighbour across the edge that is stronger
    std::vector<CellStrength> chain;          ///< from the cell to the nearest strong one, both included; empty when there is none
    std::size_t chainCells = 0;               ///< cells that hang together with it above the lower threshold, itself included
    const char* parameter = "";               ///< key of the parameter that decides most directly
    std::optional<double> appearsAt;          ///< the cell is an edge up to this value of it; null: at none
    std::string verdict;                      ///< one sentence
};

/// `k` must be a cell of the frame's scan. Runs the method's stages again: about as costly as the frame itself.
[[nodiscard]] Why whyCell(const Frame& frame, std::size_t k);

/// Several lines for a person; the last one is the verdict.
[[nodiscard]] std::string whyText(const Why& why, const Settings& settings);

} // namespace edgescan
