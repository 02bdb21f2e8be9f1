// Compares scores before and after a change.
#include "app/lab/families/protocol.h"

#include "app/lab/sim/random.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgescan::lab {
namespace {

constexpr double kRounding = 1e-9;

std::vector<double> fOf(const std::vector<SceneScore>& scores, const ScoreGroup& group) {
    std::vector<double> values;
    for (const SceneScore& score : scores) values.push_back(score.edges ? ((*score.edges).*group.counts).f() : 0.0);
    return values;
}

std::string signedText(double value) { return (value >= 0 ? "+" : "") + fixedText(value, 4); }

// Cells per scene, by class.
std::array<double, edges::kDepthEdges> meanCells(const std::vector<SceneScore>& scores, CellsByClass SceneScore::*cells) {
    std::array<double, edges::kDepthEdges> mean{};
    for (const SceneScore& score : scores) {
        for (std::size_t n = 0; n < mean.size(); ++n)
            mean[n] += static_cast<double>((score.*cells)[n]) / static_cast<double>(scores.size());
    }
    return mean;
}

bool isFaceOrJump(std::size_t n) {
    using edges::DepthEdge;
    const auto one = static_cast<DepthEdge>(n);
    return one == DepthEdge::None || one == DepthEdge::Jump || one == DepthEdge::Convex || one == DepthEdge::Concave;
}

void judgeCounts(const PairedFamily& family, bool named, Verdict& verdict) {
    const bool falseOnes = family.measure == Measure::FalseCells;
    const auto before = meanCells(family.before, falseOnes ? &SceneScore::away : &SceneScore::cells);
    const auto after = meanCells(family.after, falseOnes ? &SceneScore::away : &SceneScore::cells);
    for (std::size_t n = 0; n < before.size(); ++n) {
        const double change = after[n] - before[n];
        if (falseOnes && (change <= 0 || !isFaceOrJump(n))) continue;
        if (std::abs(change) <= std::max(kMostCountShare * before[n], 1.0)) continue; // a cell per scene is chance
        verdict.sentences.push_back(family.name + ": " + (falseOnes ? "false cells" : "edge cells") + " of the class " +
                                    kCellClassNames[n] + " per scene change from " + fixedText(before[n], 1) + " to " +
                                    fixedText(after[n], 1) + (named ? ", which is named." : ", by more than 10 %."));
        if (!named) verdict.passes = false;
    }
}

void judgeFalls(const PairedFamily& family, const ScoreGroup& group, Verdict& verdict) {
    const std::vector<double> before = fOf(family.before, group), after = fOf(family.after, group);
    struct Fall {
        const char* what;
        double by, most;
    };
    for (const Fall& fall : {Fall{"mean", meanOf(before) - meanOf(after), kMostMeanFall},
                             Fall{"worst tenth", worstTenth(before) - worstTenth(after), kMostWorstFall}}) {
        if (fall.by <= fall.most + kRounding) continue;
        verdict.passes = false;
        verdict.sentences.push_back(family.name + ": the " + fall.what + " of F " + group.name + " falls by " + fixedText(fall.by, 4) +
                                    ", more than " + shortestText(fall.most) + ".");
    }
}

} // namespace

double meanOf(const std::vector<double>& values) {
    return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double worstTenth(std::vector<double> values) {
    std::ranges::sort(values);
    values.resize((values.size() + 9) / 10);
    return meanOf(values);
}

GroupChange groupChange(const std::vector<PairedFamily>& families, const ScoreGroup& group) {
    constexpr std::size_t kRounds = 2000;
    GroupChange change;
    std::vector<std::vector<double>> differences;
    for (const PairedFamily& family : families) {
        if (family.measure != Measure::Edges || family.before.empty()) continue;
        const std::vector<double> before = fOf(family.before, group), after = fOf(family.after, group);
        change.before += meanOf(before);
        change.after += meanOf(after);
        differences.emplace_back();
        for (std::size_t n = 0; n < before.size(); ++n) differences.back().push_back(after[n] - before[n]);
    }
    if (differences.empty()) return change;
    const auto count = static_cast<double>(differences.size());
    change.before /= count;
    change.after /= count;
    std::vector<double> rounds;
    std::uint64_t state = 0;
    for (std::size_t round = 0; round < kRounds; ++round) {
        double sum = 0.0;
        for (const std::vector<double>& family : differences) {
            double ofFamily = 0.0;
            for (std::size_t n = 0; n < family.size(); ++n) ofFamily += family[sim::mixed(++state) % family.size()];
            sum += ofFamily / static_cast<double>(family.size());
        }
        rounds.push_back(sum / count);
    }
    std::ranges::sort(rounds);
    change.low = rounds[kRounds / 40];
    change.high = rounds[kRounds - 1 - kRounds / 40];
    return change;
}

Verdict judged(const std::vector<PairedFamily>& families, const std::vector<std::string>& named) {
    Verdict verdict;
    for (std::size_t n = 0; n < kScoreGroups.size(); ++n) {
        const ScoreGroup& group = kScoreGroups[n];
        GroupChange& change = verdict.groups[n] = groupChange(families, group);
        const bool falls = group.judged && change.after < change.before - kRounding;
        if (falls) verdict.passes = false;
        verdict.sentences.push_back(std::string("F ") + group.name + ": the mean over the families changes from " +
                                    fixedText(change.before, 4) + " to " + fixedText(change.after, 4) + " (" +
                                    signedText(change.after - change.before) + ", 95 % interval " + signedText(change.low) + " to " +
                                    signedText(change.high) + ")" + (falls ? ", and it must not fall." : "."));
        for (const PairedFamily& family : families) {
            if (group.judged && family.measure == Measure::Edges && !family.before.empty()) judgeFalls(family, group, verdict);
        }
    }
    for (const PairedFamily& family : families) {
        if (family.measure == Measure::Edges || family.before.empty()) continue;
        judgeCounts(family, std::ranges::find(named, family.name) != named.end(), verdict);
    }
    return verdict;
}

} // namespace edgescan::lab
