// Finds the regions at one level and decides which of them are rocks.
#include "core/rocks/selection/rock_map.h"

#include "core/base/portable_math.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/segments.h"
#include "core/rocks/selection/confidence.h"
#include "core/rocks/selection/region_of_interest.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

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

/// The bulge of each region as a share of its chord, -0.3 .. 0.3; positive: convex towards the scanner. `regionOfSegment`: by segment,
/// below `regions`; 0 means no region.
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

constexpr std::uint32_t kFewestValleys = 5;
constexpr std::uint32_t kFewestJumps = 3;
constexpr double kOneWay = 0.8; // least share of the jumps with the same nearer side

// Weights of R, the log odds "rock" (docs/method/rocks.md, "Step 7").
constexpr std::array<double, kScoreInputs> kPer{4.8, -0.3, -1.2, 14.3, 8.1, -2.0, 2.14}; // by scoreInputs()
constexpr double kScoreOffset = -15.1;
constexpr double kFlat = 0.05; // one in 300 rocks is as flat as this
constexpr double kMostZ = 6.0;
constexpr int kSurroundingSides = 3; // a region that reaches so many sides of the sweep ...
constexpr double kLeastNear = 0.05;  // ... is a rock only if it is the nearer side on this share of its outline
constexpr double kDeviations = 4.0;  // a size is this many standard deviations

// From the spread of the points about their mean.
void measureSpread(Region& region) {
    const SegmentSums& sums = region.sums;
    if (sums.cells < 3) return;
    const double n = sums.cells;
    const Eigen::Vector3d mean = sums.sumM / n;
    const Eigen::Matrix3d spread = sums.sumM2 / n - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d deviations = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt(); // ascending
    region.longM = kDeviations * deviations[2];
    const double boxM2 = kDeviations * deviations[1] * region.longM;
    if (boxM2 <= 0.0) return; // all points are on one line
    region.depthRatio = deviations[0] / deviations[2];
    region.boxShare = sums.areaM2 / boxM2;
}

// How far the level of the map is from the merges that make and end each region. A group's number is its first segment.
void measureLevels(const MergeTree& tree, RegionMap& map) {
    std::vector<double> within(map.regionOfSegment.size(), -kMostLevels), above(within.size(), kMostLevels);
    for (const Merge& merge : tree.merges) {
        const double levels = merge.height - map.settings.level;
        if (levels <= 0) {
            within[merge.remaining] = std::max(levels, -kMostLevels);
        } else {
            for (const std::uint32_t group : {merge.remaining, merge.gone}) above[group] = std::min(above[group], levels);
        }
    }
    for (Region& region : map.regions) {
        region.levelsBelow = -within[region.firstSegment];
        region.levelsAbove = above[region.firstSegment];
    }
}

// Sums of the segments of each region; indices as in `regions`.
void addSegments(const Segmentation& segments, RegionMap& map) {
    for (std::uint32_t segment = 1; segment <= segments.count(); ++segment)
        map.regions[map.regionOfSegment[segment]].sums.add(segments.sums[segment]);
}

void addBorders(const Segmentation& segments, RegionMap& map) {
    std::vector<RegionBorder> parts;
    for (RegionBorder border : segments.borders) {
        border.a = map.regionOfSegment[border.a];
        border.b = map.regionOfSegment[border.b];
        if (border.a != border.b) parts.push_back(border.a < border.b ? border : border.reversed());
    }
    map.borders = summedBorders(std::move(parts));
    for (const RegionBorder& border : map.borders) {
        const double cracks = border.cracks;
        for (const std::uint32_t side : {border.a, border.b}) {
            Region& region = map.regions[side];
            region.outlineCracks += border.cracks;
            region.nearShare += side == border.a ? border.jumpsA : border.jumpsB;
            region.edgeShare += static_cast<double>(border.sumE2) * kEvidenceStep;
            region.evidence += std::min(border.meanZ(), kMostZ) * cracks;
        }
    }
    for (Region& region : map.regions) {
        const double cracks = std::max(1.0, static_cast<double>(region.outlineCracks));
        region.nearShare /= cracks;
        const bool alone = region.outlineCracks == 0; // without a neighbour that it could be merged with
        region.edgeShare = alone ? 1.0 : region.edgeShare / cracks;
        region.evidence = alone ? kMostZ : region.evidence / cracks;
    }
}

void judge(Region& region, const RockSettings& settings) {
    if (region.sums.cells < static_cast<std::uint32_t>(settings.minimumCells)) return;
    measureSpread(region);
    const std::array<double, kScoreInputs> inputs = scoreInputs(region, settings);
    region.score = std::inner_product(kPer.begin(), kPer.end(), inputs.begin(), kScoreOffset);
    region.kind = looksLikeRock(region, settings) ? RegionKind::Rock : RegionKind::NotRock;
}

// By region: the region of `plain` that has the same cells, or 0.
std::vector<std::uint32_t> sameRegions(const Segmentation& segments, const RegionMap& map, const RegionMap& plain) {
    constexpr std::uint32_t kUnknown = UINT32_MAX;
    std::vector<std::uint32_t> same(map.regions.size(), kUnknown);
    for (std::uint32_t segment = 1; segment <= segments.count(); ++segment) {
        std::uint32_t& region = same[map.regionOfSegment[segment]];
        const std::uint32_t before = plain.regionOfSegment[segments.cutFrom[segment]];
        region = region == kUnknown || region == before ? before : 0;
    }
    for (std::size_t n = 0; n < same.size(); ++n) {
        if (same[n] == kUnknown || plain.regions[same[n]].sums.cells != map.regions[n].sums.cells) same[n] = 0;
    }
    return same;
}

// From what the scan shows: neither a region of interest nor a decision by hand about other regions changes it.
void setConfidence(const Segmentation& segments, const RegionMap* plain, RegionMap& map) {
    const std::vector<ConfidenceInputs> inputs = confidenceInputs(map);
    const std::vector<std::uint32_t> same =
        plain != nullptr ? sameRegions(segments, map, *plain) : std::vector<std::uint32_t>(inputs.size());
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        Region& region = map.regions[n];
        if (region.kind != RegionKind::Fines)
            region.confidence = same[n] != 0 ? plain->regions[same[n]].confidence : confidenceOf(inputs[n]);
        if (region.kind == RegionKind::Rock && region.confidence < kLeastConfidence) region.kind = RegionKind::NotRock;
    }
}

// Counts the sides of the sweep that each region reaches.
void countSweepSides(const Segmentation& segments, RegionMap& map) {
    constexpr int kMargin = 1;
    const Grid<std::uint32_t>& segment = segments.segment;
    std::vector<std::uint8_t> lastSide(map.regions.size());
    std::uint8_t side = 0;
    const auto visitSide = [&](int firstLine, int lines, int firstBeam, int beams) {
        ++side;
        for (int i = std::max(0, firstLine); i < std::min(firstLine + lines, segment.lines); ++i) {
            for (int j = std::max(0, firstBeam); j < std::min(firstBeam + beams, segment.beams); ++j) {
                const std::uint32_t n = map.regionOfSegment[segment.at(i, j)];
                map.regions[n].sweepSides += lastSide[n] != side ? 1 : 0;
                lastSide[n] = side;
            }
        }
    };
    visitSide(0, kMargin, 0, segment.beams);
    visitSide(segment.lines - kMargin, kMargin, 0, segment.beams);
    visitSide(0, segment.lines, 0, kMargin);
    visitSide(0, segment.lines, segment.beams - kMargin, kMargin);
}

// Rocks first, then the largest first.
void putInOrder(RegionMap& map) {
    std::vector<std::uint32_t> order(map.regions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t n) {
        return std::tuple(map.regions[n].kind, -map.regions[n].sums.areaM2, map.regions[n].firstSegment);
    };
    std::sort(order.begin() + 1, order.end(), [&](std::uint32_t x, std::uint32_t y) { return key(x) < key(y); });
    renumber(map, order);
    map.rocks = static_cast<std::uint32_t>(
        std::count_if(map.regions.begin() + 1, map.regions.end(), [](const Region& r) { return r.kind == RegionKind::Rock; }));
}

Grid<std::uint32_t> painted(const Segmentation& segments, const std::vector<std::uint32_t>& colours) {
    Grid<std::uint32_t> grid(segments.segment.lines, segments.segment.beams);
    for (std::size_t k = 0; k < grid.size(); ++k) grid[k] = colours[segments.segment[k]];
    return grid;
}

} // namespace

const char* regionKindName(RegionKind kind) {
    switch (kind) {
    case RegionKind::Rock:
        return "rock";
    case RegionKind::NotRock:
        return "not_rock";
    case RegionKind::Fines:
        return "fines";
    case RegionKind::Outside:
        break;
    }
    return "outside";
}

void renumber(RegionMap& map, std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> place(map.regions.size());
    std::vector<Region> regions(order.size());
    for (std::uint32_t n = 1; n < order.size(); ++n) {
        if (order[n] == 0) continue;
        place[order[n]] = n;
        regions[n] = map.regions[order[n]];
    }
    map.regions = std::move(regions);
    for (std::uint32_t& region : map.regionOfSegment) region = place[region];
    for (RegionBorder& border : map.borders) {
        border.a = place[border.a];
        border.b = place[border.b];
        if (border.a > border.b) border = border.reversed();
    }
    map.borders = summedBorders(std::move(map.borders));
}

bool isTooFar(const Region& region, const RockSettings& settings) {
    return !((region.sums.sumM / static_cast<double>(region.sums.cells)).norm() < settings.farthestM);
}

std::array<double, kScoreInputs> scoreInputs(const Region& region, const RockSettings& settings) {
    return {region.bulge,     region.nearShare,  std::max(0.0, region.longM - settings.largestM),
            region.edgeShare, region.depthRatio, std::max(0.0, kFlat - region.depthRatio),
            region.boxShare};
}

bool looksLikeRock(const Region& region, const RockSettings& settings) {
    // The outline of what reaches three sides of the sweep is that of the regions in front of it.
    const bool surrounds = region.sweepSides >= kSurroundingSides && region.nearShare < kLeastNear;
    return region.score > 0 && !surrounds && !isTooFar(region, settings);
}

RegionMap rocksAt(const Segmentation& segments, const MergeTree& tree, const RockSettings& settings, std::span<const RockCall> called,
                  const RegionMap* plain) {
    RegionMap map;
    map.settings = settings;
    map.regionOfSegment = groupsAt(tree, segments.count(), settings.level);
    std::vector<std::uint32_t> place(map.regionOfSegment.size());
    map.regions.emplace_back();
    for (std::uint32_t segment = 1; segment <= segments.count(); ++segment) {
        std::uint32_t& region = map.regionOfSegment[segment];
        if (region == segment) {
            place[segment] = static_cast<std::uint32_t>(map.regions.size());
            map.regions.emplace_back().firstSegment = segment;
        }
        region = place[region]; // the region of this segment was found before
    }
    measureLevels(tree, map);
    addSegments(segments, map);
    addBorders(segments, map);
    countSweepSides(segments, map);
    const std::vector<double> bulges = regionBulges(segments, map.regionOfSegment, map.regions.size());
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        map.regions[n].bulge = bulges[n];
        judge(map.regions[n], settings);
    }
    setConfidence(segments, plain, map);
    markOutsideRegion(segments, map);
    for (const RockCall& call : called) {
        Region& region = map.regions[map.regionOfSegment[call.segment]];
        if (region.sums.cells == 0) continue;
        const bool isOne = map.regionOfSegment[call.joined] == map.regionOfSegment[call.segment];
        if (call.joined != kNoSegment && (!isOne || region.kind != RegionKind::NotRock)) continue;
        region.kind = call.rock ? RegionKind::Rock : RegionKind::NotRock;
        region.byHand = true;
    }
    putInOrder(map);
    return map;
}

Grid<std::uint32_t> regionLabels(const Segmentation& segments, const RegionMap& map) { return painted(segments, map.regionOfSegment); }

bool touch(const RegionBorder& border) { return border.valleys >= kFewestValleys; }

std::uint32_t nearerSide(const RegionBorder& border) {
    const std::uint32_t jumps = border.jumpsA + border.jumpsB;
    if (jumps < kFewestJumps || std::max(border.jumpsA, border.jumpsB) < kOneWay * jumps) return 0;
    return border.jumpsA > border.jumpsB ? border.a : border.b;
}

Grid<std::uint32_t> rockLabels(const Segmentation& segments, const RegionMap& map) {
    std::vector<std::uint32_t> colours = map.regionOfSegment;
    for (std::uint32_t& region : colours) region = region <= map.rocks ? region : 0;
    return painted(segments, colours);
}

} // namespace edgescan::rocks
