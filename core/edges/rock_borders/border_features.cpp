// Measures how an edge looks from its surroundings. Plain arithmetic in a fixed order: every machine gets the same bits.
#include "core/edges/rock_borders/border_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr float kUnitOfU = 1048576.0F; // 1/m
constexpr float kUnitOfFold = 256.0F;
constexpr float kMostFold = 6.0F, kMostJump = 12.0F;
constexpr float kFolds = 0.35F;                               // of a threshold: from here on a cell folds, or may be an edge
constexpr float kLeastU = 1.0F / 60.0F;                       // of voids, 1/m; farther places are not distinguished from them
constexpr float kMost = 60.0F;                                // distances between points
constexpr int kNear = 4;                                      // cells on both sides that must be in the grid
constexpr std::array<int, 8> kAway{1, 2, 3, 4, 6, 8, 12, 16}; // cells across the edge
constexpr std::uint64_t kCandidate = std::uint64_t{1} << 32;

// The folds as the trees learnt them: before those of a rough scan are weighed.
const Grid<float>& foldsOf(const DepthResponses& responses) {
    return responses.unweighed.size() > 0 ? responses.unweighed : responses.crease;
}

float limited(float value, float most) { return std::clamp(value, -most, most); }

} // namespace

// The course of the surface through a cell: how much farther than the cell the cells across and along the edge are, in distances between
// points. The side that is farther away is `far`.
struct BorderMeasure::Course {
    bool known = false;
    int across = 0, along = 0; // steps in lines (0 or 1 for each), of the direction across: 1 if it goes from line to line
    int towards = 1;           // sign of the step to the far side
    float spacing = 0;         // mm, across
    std::array<float, kAway.size()> near{}, far{};
    std::array<float, 3> bendsAlong{};  // along the edge, over 2, 4 and 8 cells
    std::array<float, 2> slopesAlong{}; // along the edge, to the cells 3 away on both sides
};

BorderMeasure::BorderMeasure(const DepthSurface& surface, const DepthResponses& responses, const Settings& settings)
    : surface_(surface), responses_(responses), creases_(static_cast<float>(settings.creaseDeg / 30.0)) {
    const Grid<float>& u = surface.inverse.u;
    const Grid<float>& jump = *responses.jump;
    const Grid<float>& folds = foldsOf(responses);
    const auto foldAt = [&](std::size_t k) { return std::min(kMostFold, std::abs(folds[k]) * creases_); };
    inverseRanges_ = {u.lines, u.beams, [&](std::size_t k) { return static_cast<std::uint64_t>(u[k] * kUnitOfU); }};
    folds_ = {u.lines, u.beams, [&](std::size_t k) { return static_cast<std::uint32_t>(foldAt(k) * kUnitOfFold); }};
    edges_ = {u.lines, u.beams, [&](std::size_t k) {
                  const float fold = foldAt(k);
                  return (fold > kFolds ? 1U : 0U) + (std::max(fold, jump[k]) > kFolds ? kCandidate : 0U);
              }};
}

// Beyond the grid: that of its last cell.
float BorderMeasure::rangeAt(int line, int beam) const {
    const Grid<float>& u = surface_.inverse.u;
    return 1000.0F / std::max(u.at(std::clamp(line, 0, u.lines - 1), std::clamp(beam, 0, u.beams - 1)), kLeastU);
}

BorderMeasure::Course BorderMeasure::courseAt(int line, int beam) const {
    const float range = rangeAt(line, beam);
    const AngularSteps& steps = surface_.steps;
    const float ofBeams = range * std::max(steps.beam[static_cast<std::size_t>(beam)], 1e-5F);
    const float ofLines = range * std::max(steps.lineAt(line, beam), 1e-5F);
    const auto away = [&](int lines, int beams, float spacing) {
        return limited((rangeAt(line + lines, beam + beams) - range) / spacing, kMost);
    };
    const auto bend = [&](int lines, int beams, float spacing) {
        const auto at = [&](int n) { return std::abs(away(-n * lines, -n * beams, spacing) + away(n * lines, n * beams, spacing)); };
        return at(2) * 0.5F + at(4) * 0.25F;
    };
    Course course;
    const bool acrossBeams = bend(0, 1, ofBeams) >= bend(1, 0, ofLines);
    const int lines = acrossBeams ? 0 : 1, beams = 1 - lines;
    const Grid<float>& u = surface_.inverse.u;
    course.known = acrossBeams ? beam >= kNear && beam + kNear < u.beams : line >= kNear && line + kNear < u.lines;
    course.across = lines;
    course.spacing = acrossBeams ? ofBeams : ofLines;
    const float spacingAlong = acrossBeams ? ofLines : ofBeams;
    course.towards = away(4 * lines, 4 * beams, course.spacing) >= away(-4 * lines, -4 * beams, course.spacing) ? 1 : -1;
    for (std::size_t n = 0; n < kAway.size(); ++n) {
        const int cells = kAway[n] * course.towards;
        course.far[n] = away(cells * lines, cells * beams, course.spacing);
        course.near[n] = away(-cells * lines, -cells * beams, course.spacing);
    }
    const auto along = [&](int cells) { return away(cells * beams, cells * lines, spacingAlong); };
    course.bendsAlong = {(along(-2) + along(2)) / 2, (along(-4) + along(4)) / 4, (along(-8) + along(8)) / 8};
    course.slopesAlong = {along(-3), along(3)};
    return course;
}

float BorderMeasure::heightAt(int line, int beam, int reach) const {
    const Grid<float>& u = surface_.inverse.u;
    line = std::clamp(line, 0, u.lines - 1);
    beam = std::clamp(beam, 0, u.beams - 1);
    const auto window = inverseRanges_.around(line, beam, reach);
    const float mean = 1000.0F * kUnitOfU * static_cast<float>(window.cells) / static_cast<float>(std::max<std::uint64_t>(window.sum, 1));
    const float range = rangeAt(line, beam);
    const float spacing =
        range * std::sqrt(std::max(surface_.steps.beam[static_cast<std::size_t>(beam)] * surface_.steps.lineAt(line, beam), 1e-10F));
    return limited((mean - range) / spacing, kMost);
}

float BorderMeasure::largestJump(int line, int beam, int reach) const {
    const Grid<float>& jump = *responses_.jump;
    float largest = 0;
    for (int i = std::max(0, line - reach); i <= std::min(jump.lines - 1, line + reach); ++i) {
        const float* jumps = jump.line(i);
        for (int j = std::max(0, beam - reach); j <= std::min(jump.beams - 1, beam + reach); ++j) largest = std::max(largest, jumps[j]);
    }
    return std::min(kMostJump, largest);
}

bool BorderMeasure::measure(std::size_t cell, BorderFeatures& features) const {
    const Grid<float>& u = surface_.inverse.u;
    const Grid<Support>& support = surface_.inverse.support;
    if (support[cell] == Support::Void || u[cell] < kLeastU) return false;
    const int line = static_cast<int>(cell / static_cast<std::size_t>(u.beams)),
              beam = static_cast<int>(cell % static_cast<std::size_t>(u.beams));
    const Course course = courseAt(line, beam);
    if (!course.known) return false;
    const float jump = std::min(kMostJump, (*responses_.jump)[cell]);
    const float fold = limited(foldsOf(responses_)[cell] * creases_, kMostFold);
    float* to = features.data();
    const auto add = [&to](float value) { *to++ = value; };
    // Steps.
    add(jump);
    add(jump >= std::abs(fold) ? 1.0F : 0.0F);
    for (const int reach : {1, 2, 5}) add(largestJump(line, beam, reach));
    float voids = 0;
    for (int i = std::max(0, line - 2); i <= std::min(u.lines - 1, line + 2); ++i) {
        for (int j = std::max(0, beam - 2); j <= std::min(u.beams - 1, beam + 2); ++j)
            voids += support.at(i, j) == Support::Void ? 1.0F : 0.0F;
    }
    add(voids);
    // Fold.
    add(fold);
    add(std::abs(fold));
    // Across.
    for (const float away : course.near) add(away);
    for (const float away : course.far) add(away);
    for (std::size_t n = 0; n < kAway.size(); ++n) add((course.near[n] + course.far[n]) / static_cast<float>(kAway[n]));
    add(course.near[3] - course.near[0]);
    add(course.far[3] - course.far[0]);
    // Along.
    for (const float bend : course.bendsAlong) add(bend);
    for (const float slope : course.slopesAlong) add(slope);
    // Height.
    for (const int reach : {3, 7, 15, 30}) add(heightAt(line, beam, reach));
    const int lines = 4 * course.across * course.towards, beams = 4 * (1 - course.across) * course.towards;
    add(heightAt(line - lines, beam - beams, 7));
    add(heightAt(line + lines, beam + beams, 7));
    // Folds.
    for (const int reach : {3, 7, 15}) {
        const auto window = folds_.around(line, beam, reach);
        add(static_cast<float>(window.sum) / (kUnitOfFold * static_cast<float>(window.cells)));
    }
    const auto share = [&](int reach, bool candidates) {
        const auto window = edges_.around(line, beam, reach);
        const std::uint64_t count = candidates ? window.sum / kCandidate : window.sum % kCandidate;
        return static_cast<float>(count) / static_cast<float>(window.cells);
    };
    add(share(15, false));
    add(share(2, true));
    add(share(5, true));
    // Distance.
    const float range = rangeAt(line, beam);
    add(course.spacing);
    add(0.001F * range);
    add(static_cast<float>(responses_.noise.at(0.001 * static_cast<double>(range))) / course.spacing);
    assert(to == features.data() + features.size());
    return true;
}

BorderEvidence evidenceOf(int feature) {
    // The number of features of each kind, in their order.
    static constexpr std::array<int, kBorderEvidences> kCounts{6, 2, 26, 5, 6, 6, 3};
    static_assert(kCounts[0] + kCounts[1] + kCounts[2] + kCounts[3] + kCounts[4] + kCounts[5] + kCounts[6] == kBorderFeatures);
    int kind = 0;
    for (int last = kCounts[0]; feature >= last; last += kCounts[static_cast<std::size_t>(kind)]) ++kind;
    return static_cast<BorderEvidence>(kind);
}

} // namespace edgescan::edges
