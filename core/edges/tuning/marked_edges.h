// Settings that agree with cells that somebody marked as edge or as none.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace edgescan {

/// A mark stands for the cells round it too: nobody clicks a line one cell wide.
inline constexpr int kMarkReachCells = 2;

inline constexpr std::size_t kMostMarks = 1000; ///< of either kind

struct EdgeMarks {
    std::vector<std::uint32_t> wanted;   ///< an edge lies at the cell or within kMarkReachCells
    std::vector<std::uint32_t> unwanted; ///< none does
    [[nodiscard]] bool empty() const { return wanted.empty() && unwanted.empty(); }
    bool operator==(const EdgeMarks&) const = default;
};

struct EdgeProposal {
    Settings settings; ///< with the threshold that suits the marks best
    int kept = 0;      ///< of the marks that are wanted
    int leftOut = 0;   ///< of those that are not
    double margin = 0; ///< the threshold may be multiplied or divided by so much with all marks still right; below 1: some are wrong
    std::size_t edges = 0;
    [[nodiscard]] bool separates() const { return margin >= 1.0; }
};

/// Of the method set now with all of its other settings, and of every other method with its usual ones: what separates the marks first,
/// by margin, then what gets most of them right. Of a method without a threshold that suits, the best one it has. Needs a mark; cells that
/// do not exist are passed over. False from `goOn` ends it with what is known.
[[nodiscard]] std::vector<EdgeProposal> edgeProposals(const std::shared_ptr<const Scan>& scan, const Settings& now, const EdgeMarks& marks,
                                                      const std::function<bool()>& goOn = {});

/// "EdgeScan+, Edge strength 1.35: all 4 marks, by a factor of 1.8".
[[nodiscard]] std::string proposalText(const EdgeProposal& proposal, const EdgeMarks& marks);

} // namespace edgescan
