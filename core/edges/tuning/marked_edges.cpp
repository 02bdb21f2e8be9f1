// Computes one threshold map for each candidate. With it, every threshold is a comparison.
#include "core/edges/tuning/marked_edges.h"

#include "core/base/number_text.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/threshold_map.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edgescan::edges {
namespace {

constexpr double kRoom = 1.1; // if there are no unwanted marks: distance of the threshold from the largest one that satisfies all marks

/// The highest threshold at which a cell within reach is an edge.
double highestNear(const ThresholdMap& map, std::uint32_t k) {
    const auto& highest = map.highest;
    const int line = static_cast<int>(k) / highest.beams, beam = static_cast<int>(k) % highest.beams;
    double found = -1.0;
    for (int i = std::max(0, line - kMarkReachCells); i <= std::min(highest.lines - 1, line + kMarkReachCells); ++i) {
        for (int j = std::max(0, beam - kMarkReachCells); j <= std::min(highest.beams - 1, beam + kMarkReachCells); ++j)
            found = std::max(found, highest.at(i, j));
    }
    return found;
}

std::vector<double> highestOf(const ThresholdMap& map, const std::vector<std::uint32_t>& cells) {
    std::vector<double> values;
    for (const std::uint32_t k : cells) {
        if (k < map.highest.size()) values.push_back(highestNear(map, k));
    }
    std::ranges::sort(values);
    return values;
}

/// The nearest value on the slider's scale, within its limits.
double onSlider(const Parameter& parameter, double value) {
    const double digits = std::pow(10.0, parameter.decimals);
    return std::clamp(std::round(value * digits) / digits, parameter.minimum, parameter.maximum);
}

struct Right {
    int kept = 0, leftOut = 0;
};

Right rightAt(double threshold, const std::vector<double>& wanted, const std::vector<double>& unwanted) {
    return {static_cast<int>(std::ranges::count_if(wanted, [&](double v) { return v >= threshold; })),
            static_cast<int>(std::ranges::count_if(unwanted, [&](double v) { return v < threshold; }))};
}

/// Thresholds between the values of all marks, and beyond them.
std::vector<double> thresholdsToTry(const Parameter& parameter, const std::vector<double>& wanted, const std::vector<double>& unwanted) {
    std::vector<double> values = wanted;
    values.insert(values.end(), unwanted.begin(), unwanted.end());
    std::erase_if(values, [](double v) { return !(v > 0.0) || std::isinf(v); });
    std::ranges::sort(values);
    std::vector<double> tries{parameter.minimum};
    for (std::size_t n = 0; n < values.size(); ++n)
        tries.push_back(onSlider(parameter, n == 0 ? values[n] / kRoom : std::sqrt(values[n - 1] * values[n])));
    if (!values.empty()) tries.push_back(onSlider(parameter, values.back() * kRoom));
    return tries;
}

/// The factor by which the threshold may change with all marks still satisfied; below 1 if a mark is not satisfied.
double marginOf(double threshold, const std::vector<double>& wanted, const std::vector<double>& unwanted) {
    double margin = std::numeric_limits<double>::infinity();
    if (!wanted.empty()) margin = std::min(margin, threshold > 0.0 ? wanted.front() / threshold : std::numeric_limits<double>::infinity());
    if (!unwanted.empty() && unwanted.back() > 0.0) margin = std::min(margin, threshold / std::nextafter(unwanted.back(), 1e300));
    return std::max(0.0, margin);
}

EdgeProposal proposalOf(const std::shared_ptr<const Scan>& scan, const Settings& settings, const EdgeMarks& marks) {
    const auto detection = detectEdges(scan, settings);
    const ThresholdMap map = thresholdMapOf(*detection);
    const Parameter& parameter = sweptParameter(settings.method);
    const std::vector<double> wanted = highestOf(map, marks.wanted), unwanted = highestOf(map, marks.unwanted);
    EdgeProposal best;
    double bestThreshold = parameter.get(settings);
    const auto rank = [](const EdgeProposal& p) { return std::tuple(p.wantedMet + p.unwantedMet, p.margin); };
    std::vector<double> tries = thresholdsToTry(parameter, wanted, unwanted);
    tries.push_back(bestThreshold);
    bool first = true;
    for (const double threshold : tries) {
        const Right right = rightAt(threshold, wanted, unwanted);
        EdgeProposal one{settings, right.kept, right.leftOut, 0.0, 0};
        const bool all = right.kept == static_cast<int>(wanted.size()) && right.leftOut == static_cast<int>(unwanted.size());
        one.margin = all ? std::max(1.0, marginOf(threshold, wanted, unwanted)) : 0.0;
        if (!first && !(rank(one) > rank(best))) continue;
        first = false;
        best = one;
        bestThreshold = threshold;
    }
    parameter.set(best.settings, bestThreshold);
    const Grid<std::uint8_t> mask = edgesAt(map, bestThreshold);
    best.edges = mask.size() - static_cast<std::size_t>(std::ranges::count(mask.cells, 0));
    return best;
}

} // namespace

std::vector<EdgeProposal> edgeProposals(const std::shared_ptr<const Scan>& scan, const Settings& now, const EdgeMarks& marks,
                                        const std::function<bool()>& goOn) {
    std::vector<EdgeProposal> proposals;
    if (marks.empty()) return proposals;
    std::vector<Settings> candidates{now};
    for (const MethodTraits& traits : methodTraits()) {
        if (traits.method == now.method) continue;
        Settings usual;
        usual.method = traits.method;
        candidates.push_back(usual);
    }
    for (const Settings& candidate : candidates) {
        if (goOn && !goOn()) break;
        proposals.push_back(proposalOf(scan, candidate, marks));
    }
    const auto before = [](const EdgeProposal& a, const EdgeProposal& b) {
        return std::tuple(a.meetsAllMarks(), a.wantedMet + a.unwantedMet, a.margin) >
               std::tuple(b.meetsAllMarks(), b.wantedMet + b.unwantedMet, b.margin);
    };
    std::ranges::stable_sort(proposals, before);
    return proposals;
}

std::string proposalText(const EdgeProposal& proposal, const EdgeMarks& marks) {
    const Parameter& parameter = sweptParameter(proposal.settings.method);
    const auto all = marks.wanted.size() + marks.unwanted.size();
    std::string text = std::string(traitsOf(proposal.settings.method).label) + ", " + parameter.label + " " +
                       fixedText(parameter.get(proposal.settings), parameter.decimals) + ": ";
    if (!proposal.meetsAllMarks())
        return text + std::to_string(proposal.wantedMet + proposal.unwantedMet) + " of " + std::to_string(all) + " marks, " +
               std::to_string(proposal.edges) + " edge cells";
    text += all == 1 ? "the mark" : "all " + std::to_string(all) + " marks";
    if (std::isfinite(proposal.margin)) text += ", by a factor of " + fixedText(proposal.margin, 2);
    return text + ", " + std::to_string(proposal.edges) + " edge cells";
}

} // namespace edgescan::edges
