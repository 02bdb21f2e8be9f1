// Scores a mask against the true edges.
#include "app/lab/score/score.h"

#include "app/lab/score/match.h"
#include "app/lab/sim/truth/thin.h"

#include <array>

namespace edgescan::lab {
namespace {

using ClassCounts = std::array<std::size_t, 5>;

std::size_t outlineOf(const ClassCounts& counts) { return counts[1] + counts[2] + counts[4]; }

// Number of unmatched detections, without cells that are not scored.
std::size_t falseCells(const Grid<std::uint8_t>& thin, const std::vector<MatchedPair>& pairs, const Grid<std::uint8_t>& ignore) {
    Grid<std::uint8_t> left = thin;
    for (const MatchedPair& pair : pairs) left[pair.detected] = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < left.size(); ++k) count += left[k] != 0 && ignore[k] == 0 ? 1 : 0;
    return count;
}

} // namespace

EdgeCounts& EdgeCounts::operator+=(const EdgeCounts& other) {
    truth += other.truth;
    found += other.found;
    false_ += other.false_;
    return *this;
}

double EdgeCounts::precision() const {
    return found + false_ == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(found + false_);
}
double EdgeCounts::recall() const { return truth == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(truth); }
double EdgeCounts::f() const {
    const double p = precision();
    const double r = recall();
    return p + r == 0.0 ? 0.0 : 2 * p * r / (p + r);
}

EdgeScore& EdgeScore::operator+=(const EdgeScore& other) {
    occluding += other.occluding;
    outline += other.outline;
    crease += other.crease;
    all += other.all;
    strictOutline += other.strictOutline;
    return *this;
}

EdgeMatches matchWithTruth(const Grid<std::uint8_t>& mask, const sim::EdgeTruth& truth, double tolerance) {
    // A true cell that is not scored can also be matched: then the detection is not a false alarm, and the match does not count.
    Grid<std::uint8_t> every(mask.lines, mask.beams);
    Grid<std::uint8_t> outline(mask.lines, mask.beams);
    for (std::size_t k = 0; k < every.size(); ++k) {
        const std::uint8_t c = truth.edgeClass[k];
        every[k] = c != 0 ? 255 : 0;
        outline[k] = c != 0 && c != static_cast<std::uint8_t>(sim::EdgeClass::Crease) ? 255 : 0;
    }
    EdgeMatches matches{sim::thinned(mask), {}, {}};
    matches.all = matchEdges(matches.thin, every, tolerance);
    matches.outline = matchEdges(matches.thin, outline, tolerance);
    return matches;
}

EdgeScore scoreMatches(const EdgeMatches& matches, const sim::EdgeTruth& truth) {
    ClassCounts wanted{};
    for (std::size_t k = 0; k < truth.edgeClass.size(); ++k) {
        if (truth.ignore[k] == 0) ++wanted[truth.edgeClass[k]];
    }
    ClassCounts found{};
    for (const MatchedPair& pair : matches.all) {
        if (truth.ignore[pair.truth] == 0) ++found[truth.edgeClass[pair.truth]];
    }
    const std::size_t wrong = falseCells(matches.thin, matches.all, truth.ignore);
    std::size_t outlineFound = 0;
    for (const MatchedPair& pair : matches.outline) outlineFound += truth.ignore[pair.truth] == 0 ? 1 : 0;

    EdgeScore score;
    score.occluding = {wanted[1] + wanted[4], found[1] + found[4], wrong};
    score.outline = {outlineOf(wanted), outlineOf(found), wrong};
    score.crease = {wanted[3], found[3], wrong};
    score.all = {outlineOf(wanted) + wanted[3], outlineOf(found) + found[3], wrong};
    score.strictOutline = {outlineOf(wanted), outlineFound, falseCells(matches.thin, matches.outline, truth.ignore)};
    return score;
}

} // namespace edgescan::lab
