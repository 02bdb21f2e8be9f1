// Finds settings that agree with cells that the operator marked as edge or as not an edge.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::edges {

/// A mark also covers the cells around it, because a line one cell wide is hard to click.
inline constexpr int kMarkReachCells = 2;

inline constexpr std::size_t kMostMarks = 1000; ///< of each kind

struct EdgeMarks {
    std::vector<std::uint32_t> wanted;   ///< there is an edge at the cell or within kMarkReachCells
    std::vector<std::uint32_t> unwanted; ///< there is no edge within kMarkReachCells
    [[nodiscard]] bool empty() const { return wanted.empty() && unwanted.empty(); }
    bool operator==(const EdgeMarks&) const = default;
};

struct EdgeProposal {
    Settings settings;   ///< with the threshold that fits the marks best
    int wantedMet = 0;   ///< number of satisfied wanted marks
    int unwantedMet = 0; ///< number of satisfied unwanted marks
    /// the threshold may be multiplied or divided by this with all marks still satisfied; below 1: some are not satisfied
    double margin = 0;
    std::size_t edges = 0;
    [[nodiscard]] bool meetsAllMarks() const { return margin >= 1.0; }
};

/// Proposals for the current method with all of its other settings, and for every other method with its default settings. First those that
/// satisfy all marks, by margin, then those that satisfy the most. For a method without such a threshold, its best one. Needs a mark; cells
/// outside of the grid are ignored. If `goOn` returns false, the proposals so far are returned.
[[nodiscard]] std::vector<EdgeProposal> edgeProposals(const std::shared_ptr<const Scan>& scan, const Settings& now, const EdgeMarks& marks,
                                                      const std::function<bool()>& goOn = {});

/// "EdgeScan+, Edge strength 1.35: all 4 marks, by a factor of 1.8".
[[nodiscard]] std::string proposalText(const EdgeProposal& proposal, const EdgeMarks& marks);

} // namespace edgescan::edges
