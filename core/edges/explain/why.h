// Why a cell is an edge, or why it is none.
#pragma once

#include "core/edges/explain/probe.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/judgement.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// Where a strength stands between the thresholds.
enum class Standing : std::uint8_t { Below, Between, Above };

struct Why : Judgement {
    Probe probe;
    std::optional<double> smoothed; ///< level after smoothing; null where the method smooths no levels
    const char* unit = "";          ///< of strength and thresholds: "levels", "% of range" (of a straight step), "x"
    Standing standing = Standing::Below;
    std::vector<CellStrength> chain;         ///< from the cell to the nearest strong one, both included; empty when there is none
    std::size_t chainCells = 0;              ///< cells that hang together with it above the lower threshold, itself included
    std::vector<std::uint32_t> chainMembers; ///< these, ascending
    std::optional<CellStrength> chainTop;    ///< the strongest of these
    const char* parameter = "";              ///< key of the parameter that decides most directly
    std::optional<double> appearsAt;         ///< the cell is an edge up to this value of it; null: at none
    std::string verdict;                     ///< one sentence, with the key of the parameter as typed on the command line
};

/// `k` must be a cell of the detection's scan. Runs the method's stages again: about as costly as the detection itself.
[[nodiscard]] Why whyCell(const Detection& detection, std::size_t k);

/// How parameters are called: by the flags of the command line, or by the labels of the sliders.
enum class Naming : std::uint8_t { Keys, Labels };
[[nodiscard]] std::string whyVerdict(const Why& why, const Settings& settings, Naming naming);

/// Several lines for a person who sees the sliders: what was measured, and against which limits.
[[nodiscard]] std::string whyNumbers(const Why& why, const Settings& settings);
/// The same with the verdict as the last line.
[[nodiscard]] std::string whyText(const Why& why, const Settings& settings);

} // namespace edgescan
