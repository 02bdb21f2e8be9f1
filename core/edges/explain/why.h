// Explains why a cell is an edge, or why it is not.
#pragma once

#include "core/base/translated_text.h"
#include "core/edges/explain/cell_values.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/judgement.h"
#include "core/edges/rock_borders/rock_borders.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::edges {

/// The position of a strength relative to the two thresholds.
enum class StrengthLevel : std::uint8_t { Below, Between, Above };

struct Why : Judgement {
    Probe probe;
    std::optional<double> smoothed; ///< level after smoothing; null if the method does not smooth levels
    const char* unit = "";          ///< unit of strength and thresholds: "levels", "% of range" (of a straight step), "x"
    StrengthLevel level = StrengthLevel::Below;
    std::vector<CellStrength> chain;         ///< path from the cell to the nearest strong one, including both; empty if there is none
    std::size_t chainCells = 0;              ///< number of cells connected with it above the lower threshold, including itself
    std::vector<std::uint32_t> chainMembers; ///< these, ascending
    std::optional<CellStrength> chainTop;    ///< the strongest of them
    const char* parameter = "";              ///< key of the parameter with the most direct influence
    std::optional<double> appearsAt;         ///< the cell is an edge up to this value of the parameter; null: at no value
    bool leftOut = false;                    ///< it is an edge, but only rock borders are shown
    std::optional<BorderPercent> border;     ///< of an edge and of one that is left out; null: the method does not measure the surface
    std::vector<BorderReason> borderReasons; ///< the three that decided it
    std::string verdict;                     ///< one sentence, with the parameter's key as on the command line
};

/// `k` must be a cell of the detection's scan. Runs the method's stages again, so it costs about as much as the detection.
[[nodiscard]] Why whyCell(const Detection& detection, std::size_t k);

/// The first of these that holds for a cell without an edge.
enum class NoEdge : std::uint8_t {
    NotBorder,         ///< it is one, but not likely enough the border of a rock
    StrongerNeighbour, ///< a cell next to it is as strong or stronger, and an edge is one cell wide
    StepOfNeighbour,   ///< its step is strong enough, but belongs to the nearer cell
    TooWeak,           ///< not above the lower threshold
    NoStrongPlace,     ///< no chain of cells leads to one above the upper threshold
    TooShort,          ///< its chain has fewer cells than the minimum length
};
[[nodiscard]] NoEdge noEdgeReason(const Why& why);

/// A strength or a threshold with two digits, from 10 on with one. It is rounded down, as the largest threshold is at which a cell is an
/// edge: "1.73 ... disappears above 1.72" would contradict itself.
[[nodiscard]] std::string strengthNumber(double value);

/// The names of parameters: the flags of the command line, or the labels of the sliders.
enum class Naming : std::uint8_t { Keys, Labels };
[[nodiscard]] std::string whyVerdict(const Why& why, const Settings& settings, Naming naming, Translated translated = asWritten);

[[nodiscard]] const char* evidenceKey(BorderEvidence evidence); ///< one word, for JSON
/// How likely it is the border of a rock, and what decided that: one or two sentences; empty where `border` is.
[[nodiscard]] std::string whyBorder(const Why& why, Translated translated = asWritten);

/// Several lines for the window: the measurements and their limits.
[[nodiscard]] std::string whyNumbers(const Why& why, const Settings& settings, Translated translated = asWritten);
/// The same, with the verdict as the last line.
[[nodiscard]] std::string whyText(const Why& why, const Settings& settings);

} // namespace edgescan::edges
