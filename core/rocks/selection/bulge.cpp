// Computes bulges over runs of cells.
#include "core/rocks/selection/bulge.h"

#include "core/base/portable_math.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace edgescan::rocks {
namespace {

constexpr std::uint32_t kShortestRun = 6;
constexpr double kMostBulge = 0.3;
constexpr double kSmallAngle = 0.5; // radians; up to this, three terms give the sine to seven digits

double sineOf(double angle) {
    if (angle > kSmallAngle) return portable::sin(angle);
    const double square = angle * angle;
    return angle * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0)));
}

struct Bulge {
    double beforeM = 0.0, chordsM = 0.0;
};

// Ranges at two ends and in the middle, and the angles from the first end.
struct Chord {
    double u1, u2, u;   // 1/m
    double whole, part; // radians
};
void add(Bulge& bulge, const Chord& c) {
    const double sine = sineOf(c.whole);
    if (!(sine > 0)) return; // a run over more than half a turn has no chord
    const double onChord = (c.u1 * sineOf(c.whole - c.part) + c.u2 * sineOf(c.part)) / sine;
    if (!(onChord > 0)) return;
    const double r1 = 1.0 / c.u1;
    const double r2 = 1.0 / c.u2;
    const double half = sineOf(0.5 * c.whole);
    bulge.beforeM += 1.0 / onChord - 1.0 / c.u;
    bulge.chordsM += std::sqrt((r1 - r2) * (r1 - r2) + 4.0 * r1 * r2 * half * half);
}

// Sums of the angles from the first index on, by index.
std::vector<double> addedAngles(const std::vector<float>& steps) {
    std::vector<double> angles;
    double angle = 0;
    for (const float step : steps) {
        angles.push_back(angle);
        angle += static_cast<double>(step);
    }
    return angles;
}

} // namespace

std::vector<double> regionBulges(const Segmentation& segments, std::span<const std::uint32_t> regionOfSegment, std::size_t regions) {
    std::vector<Bulge> bulges(regions);
    const Grid<float>& u = segments.inputs.cracks->smoothed;
    const AngularSteps& steps = segments.inputs.surface->steps;
    const auto beams = static_cast<std::size_t>(u.beams);
    const auto walk = [&](const std::vector<SegmentRun>& runs, const std::vector<double>& angles, bool isBeams) {
        for (std::size_t first = 0; first < runs.size();) {
            const std::uint32_t region = regionOfSegment[runs[first].segment];
            std::size_t last = first;
            while (last + 1 < runs.size() && runs[last + 1].row == runs[first].row && runs[last + 1].begin == runs[last].end &&
                   regionOfSegment[runs[last + 1].segment] == region)
                ++last;
            const std::size_t begin = runs[first].begin;
            const std::size_t end = runs[last].end;
            const std::size_t row = runs[first].row;
            first = last + 1;
            if (region == 0 || end - begin < kShortestRun) continue;
            const auto at = [&](std::size_t n) { return static_cast<double>(u[isBeams ? row * beams + n : n * beams + row]); };
            const std::size_t middle = (begin + end - 1) / 2;
            const double scale = isBeams ? 1.0 : static_cast<double>(steps.fromAxis[row]);
            add(bulges[region], {at(begin + 1), at(end - 2), at(middle), scale * (angles[end - 2] - angles[begin + 1]),
                                 scale * (angles[middle] - angles[begin + 1])});
        }
    };
    walk(segments.beamRuns, addedAngles(steps.beam), true);
    walk(segments.lineRuns, addedAngles(steps.line), false);
    std::vector<double> shares;
    for (const Bulge& bulge : bulges)
        shares.push_back(bulge.chordsM > 0 ? std::clamp(bulge.beforeM / bulge.chordsM, -kMostBulge, kMostBulge) : 0.0);
    return shares;
}

} // namespace edgescan::rocks
