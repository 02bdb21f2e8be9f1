// Computes the rows of the rock table.
#include "core/rocks/attributes/attributes.h"

#include "core/base/bands.h"
#include "core/base/number_text.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/attributes/cells.h"
#include "core/rocks/attributes/visible_spans.h"
#include "core/rocks/segmentation/segments.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/beam_width.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace edgescan::rocks {
namespace {

constexpr double kStepM = 0.05;
constexpr double kMarginM = 0.05; // the measured range must be this much longer than the distance to the step
constexpr double kMostM = 30.0;
constexpr double kOffCells = 1.0; // largest distance, in cells, between the step and the nearest beam

// Finds the cell whose beam points best in a direction by moving from cell to cell. The angle to the direction decreases on the way, as it
// does on every grid of beams.
class BeamFinder {
public:
    BeamFinder(const Inputs& inputs, const CartesianTables& tables, std::size_t k)
        : inputs_(inputs), tables_(tables), line_(static_cast<int>(k / beams())), beam_(static_cast<int>(k % beams())) {}

    /// Returns false if no beam passes close enough.
    bool find(const Eigen::Vector3d& way) {
        double off = offOf(line_, beam_, way);
        for (bool moved = true; moved;) {
            moved = false;
            for (const auto& [i, j] :
                 {std::pair(line_ - 1, beam_), std::pair(line_ + 1, beam_), std::pair(line_, beam_ - 1), std::pair(line_, beam_ + 1)}) {
                if (!inputs_.scan->rangeMm.contains(i, j)) continue;
                const double there = offOf(i, j, way);
                if (!(there < off)) continue;
                off = there;
                line_ = i;
                beam_ = j;
                moved = true;
                break;
            }
        }
        const AngularSteps& steps = inputs_.surface->steps;
        const auto cell = static_cast<double>(std::max(steps.beam[static_cast<std::size_t>(beam_)], steps.lineAt(line_, beam_)));
        return off < kOffCells * cell;
    }
    [[nodiscard]] std::size_t cell() const { return inputs_.scan->rangeMm.index(line_, beam_); }

private:
    [[nodiscard]] std::size_t beams() const { return static_cast<std::size_t>(inputs_.scan->beams()); }
    [[nodiscard]] double offOf(int line, int beam, const Eigen::Vector3d& way) const {
        return (tables_.direction(line, beam) - way).norm();
    }

    const Inputs& inputs_;
    const CartesianTables& tables_;
    int line_, beam_;
};

/// Metres of free space below the point (frame of the scan, seen from its sensor near cell `k`), in steps of 5 cm. A step is free if a beam
/// passes through it and was measured to end behind it. Cells without a return do not count as free, so the true height may be larger.
/// `tables`: of the scan.
double freeHeightM(const Inputs& inputs, const CartesianTables& tables, const Eigen::Vector3d& pointM, std::size_t k,
                   const Eigen::Vector3d& up) {
    BeamFinder finder(inputs, tables, k);
    double freeM = 0.0;
    while (freeM < kMostM) {
        const Eigen::Vector3d step = pointM - tables.sensor() - (freeM + kStepM) * up;
        const double awayM = step.norm();
        if (!(awayM > kMarginM) || !finder.find(step / awayM)) break;
        const std::size_t cell = finder.cell();
        if (inputs.surface->inverse.support[cell] != Support::Measured) break;
        if (0.001 * static_cast<double>(inputs.scan->rangeMm[cell]) <= awayM + kMarginM) break;
        freeM += kStepM;
    }
    return freeM;
}

constexpr double kTolerance = 2.0; // times the resolution: this covers 89 % of the errors of a and 97 % of those of b
constexpr float kLeastDepthMm = 100.0F;
constexpr double kPushedBack = 0.3; // share of b: distance from the centre of the visible points to the estimated centre of the rock

// Of the row with this label, or of the next one.
std::size_t indexOf(std::span<const Rock> rocks, std::uint32_t label) {
    return static_cast<std::size_t>(std::ranges::lower_bound(rocks, label, {}, &Rock::label) - rocks.begin());
}

/// By label: the row of the earlier rock with the same segments; null if there was none.
std::vector<const Rock*> sameAsBefore(const RegionMap& map, const EarlierRows* before) {
    std::vector<const Rock*> same(static_cast<std::size_t>(map.rocks) + 1, nullptr);
    if (before == nullptr || before->map.regionOfSegment.size() != map.regionOfSegment.size()) return same;
    std::vector<std::uint32_t> segmentsNow(map.regions.size(), 0), segmentsThen(before->map.regions.size(), 0);
    std::vector<std::uint8_t> shared(map.regions.size(), 1); // 1 while all segments of the region belonged to one earlier region
    const auto thenOf = [&](std::uint32_t region) { return before->map.regionOfSegment[map.regions[region].firstSegment]; };
    for (std::size_t segment = 1; segment < map.regionOfSegment.size(); ++segment) {
        const std::uint32_t now = map.regionOfSegment[segment];
        const std::uint32_t then = before->map.regionOfSegment[segment];
        ++segmentsNow[now];
        ++segmentsThen[then];
        if (now != 0 && then != thenOf(now)) shared[now] = 0;
    }
    for (std::uint32_t label = 1; label <= map.rocks; ++label) {
        const std::uint32_t then = thenOf(label);
        if (shared[label] == 0 || then == 0 || then > before->map.rocks || segmentsNow[label] != segmentsThen[then]) continue;
        same[label] = rockOf(before->rocks, then);
    }
    return same;
}

class RowMaker {
public:
    RowMaker(const Segmentation& segments, const RegionMap& map, const EarlierRows* before)
        : segments_(segments), map_(map), known_(sameAsBefore(map, before)),
          cells_(cellsByRock(segments, map, [this](std::uint32_t label) { return known_[label] != nullptr; })),
          tables_(*segments.inputs.scan), up_(upOf(*segments.inputs.scan).up) {}

    /// Of the labels behind `first`, up to `last`.
    [[nodiscard]] std::vector<Rock> rows(int first, int last) const {
        std::vector<Rock> rocks;
        Buffers buffers;
        for (auto label = static_cast<std::uint32_t>(first) + 1; label <= static_cast<std::uint32_t>(last); ++label) {
            if (map_.regions[label].sums.cells > 0) rocks.push_back(row(label, buffers));
        }
        return rocks;
    }

private:
    struct Buffers; // reused for each rock

    [[nodiscard]] Rock row(std::uint32_t label, Buffers& buffers) const {
        const Region& region = map_.regions[label];
        Rock rock;
        rock.label = label;
        rock.cells = region.sums.cells;
        rock.areaM2 = region.sums.areaM2;
        rock.unoccluded = region.nearShare;
        rock.confidence = region.confidence;
        rock.score = region.score;
        rock.byHand = region.byHand;
        if (rock.cells == 0) return rock;
        rock.centreM = tables_.sensor() + region.sums.sumM / static_cast<double>(rock.cells);
        if (const Rock* known = known_[label])
            copyMeasures(*known, rock);
        else
            measure(rock, buffers);
        return rock;
    }

    static void copyMeasures(const Rock& known, Rock& rock) {
        rock.cell = known.cell;
        rock.longestCaliperM = known.longestCaliperM;
        rock.shortestCaliperM = known.shortestCaliperM;
        rock.distanceM = known.distanceM;
        rock.toleranceM = known.toleranceM;
        rock.freeHeightM = known.freeHeightM;
    }

    // Quantiles of the ranges of a rock, mm: 5, 50 and 95 %.
    struct Ranges {
        float front, middle, back;

        // Limit that excludes cells on the rim of a rock whose beam passed the rock: they are behind it by more than its depth. Seen from
        // the side, a few of them would double a span.
        [[nodiscard]] float farthest() const { return back + std::max(back - front, kLeastDepthMm); }
    };
    // `rangesMm` is not empty; reorders it.
    static Ranges rangesOf(std::vector<float>& rangesMm) {
        const auto last = static_cast<double>(rangesMm.size() - 1);
        const auto front = rangesMm.begin() + static_cast<std::ptrdiff_t>(0.05 * last);
        const auto back = rangesMm.begin() + static_cast<std::ptrdiff_t>(0.95 * last);
        const auto middle = rangesMm.begin() + static_cast<std::ptrdiff_t>(rangesMm.size() / 2);
        std::nth_element(rangesMm.begin(), middle, rangesMm.end());
        std::nth_element(rangesMm.begin(), front, middle);
        if (back > middle) std::nth_element(middle + 1, back, rangesMm.end());
        return {*front, *middle, *back};
    }

    // Coordinates of the points of a rock.
    struct RockPoints {
        std::vector<std::uint32_t> cell;
        std::vector<double> x, y, z; // m

        [[nodiscard]] std::size_t count() const { return cell.size(); }
        void resize(std::size_t count) {
            cell.resize(count);
            for (auto* values : {&x, &y, &z}) values->resize(count);
        }
        // Coordinate of each point along a direction, measured from `from`.
        void along(const Eigen::Vector3d& way, const Eigen::Vector3d& from, std::vector<double>& lengths) const {
            lengths.resize(count());
            alongWay(way, from, lengths.data());
        }

    private:
        void alongWay(const Eigen::Vector3d& way, const Eigen::Vector3d& from, double* __restrict lengths) const {
            for (std::size_t n = 0; n < count(); ++n)
                lengths[n] = (way[0] * (x[n] - from[0]) + way[1] * (y[n] - from[1])) + way[2] * (z[n] - from[2]);
        }
    };
    struct Buffers {
        std::vector<float> rangesMm;
        RockPoints points;
        PlanePoints projected;
        std::vector<double> heights;
    };
    // Collects the points of those of its cells that are not farther than `farthestMm`.
    void collect(std::uint32_t label, float farthestMm, RockPoints& points) const {
        const Grid<float>& rangeMm = segments_.inputs.scan->rangeMm;
        const std::span<const std::uint32_t> cells = cells_.of(label);
        points.resize(cells.size());
        std::size_t count = 0;
        const auto beams = static_cast<std::uint32_t>(rangeMm.beams);
        std::uint32_t line = cells.front() / beams;
        for (const std::uint32_t k : cells) { // ascending
            if (rangeMm[k] > farthestMm) continue;
            while (k >= (line + 1) * beams) ++line;
            const Eigen::Vector3d point = tables_.point(static_cast<int>(line), static_cast<int>(k - line * beams));
            points.cell[count] = k;
            points.x[count] = point[0];
            points.y[count] = point[1];
            points.z[count++] = point[2];
        }
        points.resize(count);
    }

    // Computes the values that need every point.
    void measure(Rock& rock, Buffers& buffers) const {
        auto& [rangesMm, points, projected, heights] = buffers;
        const Eigen::Vector3d sight = (rock.centreM - tables_.sensor()).normalized();
        const Eigen::Vector3d right = sight.unitOrthogonal();
        const Eigen::Vector3d below = sight.cross(right);
        rangesMm.clear();
        for (const std::uint32_t k : cells_.of(rock.label)) rangesMm.push_back(segments_.inputs.scan->rangeMm[k]);
        const Ranges ranges = rangesOf(rangesMm);
        collect(rock.label, ranges.farthest(), points);
        points.along(right, rock.centreM, projected.x);
        points.along(below, rock.centreM, projected.y);
        points.along(up_, Eigen::Vector3d::Zero(), heights);
        double nearest = HUGE_VAL;
        for (std::size_t n = 0; n < points.count(); ++n) {
            const double offX = points.x[n] - rock.centreM[0];
            const double offY = points.y[n] - rock.centreM[1];
            const double offZ = points.z[n] - rock.centreM[2];
            const double off = (offX * offX + offY * offY) + offZ * offZ;
            if (!(off < nearest)) continue;
            nearest = off;
            rock.cell = points.cell[n];
        }
        const auto lowest = static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin());
        const Eigen::Vector3d lowestPoint(points.x[lowest], points.y[lowest], points.z[lowest]);
        const Calipers calipers = calipersOf(projected);
        rock.longestCaliperM = calipers.longest;
        rock.shortestCaliperM = calipers.shortest;
        rock.distanceM = 0.001 * static_cast<double>(ranges.middle);
        const double spacingM = std::sqrt(rock.areaM2 / rock.cells);
        rock.toleranceM = kTolerance * (spacingM + BeamWidth{}.at(rock.distanceM));
        rock.freeHeightM = freeHeightM(segments_.inputs, tables_, lowestPoint, points.cell[lowest], up_);
    }

    const Segmentation& segments_;
    const RegionMap& map_;
    std::vector<const Rock*> known_;
    CellsByRock cells_;
    CartesianTables tables_;
    Eigen::Vector3d up_;
};

void addNeighbours(const RegionMap& map, std::vector<Rock>& rocks) {
    const auto rowOf = [&](std::uint32_t label) -> Rock& { return rocks[indexOf(rocks, label)]; };
    for (const RegionBorder& border : map.borders) {
        const bool contact = touch(border);
        if (border.b > map.rocks) { // borders are ascending and b is the larger label
            if (contact && border.a <= map.rocks) rowOf(border.a).touchesOther = true;
            continue;
        }
        Rock& a = rowOf(border.a);
        Rock& b = rowOf(border.b);
        if (contact) {
            a.contacts.push_back(b.label);
            b.contacts.push_back(a.label);
        }
        const std::uint32_t nearer = nearerSide(border);
        if (nearer == 0) continue;
        const bool isABefore = nearer == border.a;
        (isABefore ? a : b).rocksBehind.push_back((isABefore ? b : a).label);
        (isABefore ? b : a).rocksInFront.push_back((isABefore ? a : b).label);
    }
    for (Rock& rock : rocks) {
        for (auto* list : {&rock.rocksBehind, &rock.rocksInFront, &rock.contacts}) std::sort(list->begin(), list->end());
    }
}

// Estimated middle of the rock: behind the centre of its visible points.
Eigen::Vector3d middleOf(const Rock& rock, const Eigen::Vector3d& sensor) {
    return rock.centreM + kPushedBack * rock.shortestCaliperM * (rock.centreM - sensor).normalized();
}

void addArches(std::vector<Rock>& rocks, const Eigen::Vector3d& sensor, const Eigen::Vector3d& up) {
    for (Rock& rock : rocks) {
        const Eigen::Vector3d here = middleOf(rock, sensor);
        for (std::size_t m = 0; m < rock.contacts.size(); ++m) {
            for (std::size_t n = m + 1; n < rock.contacts.size(); ++n) {
                const Eigen::Vector3d one = middleOf(*rockOf(rocks, rock.contacts[m]), sensor);
                const Eigen::Vector3d other = middleOf(*rockOf(rocks, rock.contacts[n]), sensor);
                const Eigen::Vector3d p = one - here;
                const Eigen::Vector3d q = other - here;
                const double angle = std::atan2(p.cross(q).norm(), p.dot(q)) * 180.0 / std::numbers::pi;
                if (rock.archDeg && angle <= *rock.archDeg) continue;
                rock.archDeg = angle;
                rock.archBetween = {rock.contacts[m], rock.contacts[n]};
                // The point of the line between both centres that is directly above or below the rock.
                const Eigen::Vector3d line = other - one;
                const Eigen::Vector3d level = line - up * up.dot(line);
                const double along = std::clamp(level.dot(here - one) / std::max(level.squaredNorm(), 1e-12), 0.0, 1.0);
                rock.isBelowContacts = up.dot(here - (one + along * line)) < 0;
            }
        }
    }
}

} // namespace

const Rock* rockOf(std::span<const Rock> rocks, std::uint32_t label) {
    const std::size_t n = indexOf(rocks, label);
    return n < rocks.size() && rocks[n].label == label ? &rocks[n] : nullptr;
}

bool isDoubtful(const Rock& rock) { return rounded(rock.confidence, 1000) < kSureConfidence; }

std::string confidenceText(const Rock& rock) { return fixedText(std::floor(rounded(rock.confidence, 1000) * 100 + 1e-6) / 100, 2); }

UpDirection upOf(const Scan& scan) {
    if (!scan.placement || scan.cells() == 0) return {};
    const PlacedPoints placed(scan);
    const int line = scan.lines() / 2;
    const int beam = scan.beams() / 2;
    const Eigen::Vector3d up = placed.scanner(line, beam, Eigen::Vector3d::UnitZ()) - placed.scanner(line, beam, Eigen::Vector3d::Zero());
    return {up.normalized(), false};
}

std::vector<Rock> rockRows(const Segmentation& segments, const RegionMap& map, const EarlierRows* before) {
    const RowMaker maker(segments, map, before);
    const auto parts = madeOfParts(static_cast<int>(map.rocks), bandsFor(segments.segment.size(), 0),
                                   [&](int first, int last) { return maker.rows(first, last); });
    std::vector<Rock> rocks;
    for (const std::vector<Rock>& part : parts) rocks.insert(rocks.end(), part.begin(), part.end());
    addNeighbours(map, rocks);
    addArches(rocks, CartesianTables(*segments.inputs.scan).sensor(), upOf(*segments.inputs.scan).up);
    return rocks;
}

void addLikelyJoins(const MergeTree& tree, const RegionMap& map, std::vector<Rock>& rocks) {
    const std::vector<std::uint32_t> group =
        groupsAt(tree, static_cast<std::uint32_t>(map.regionOfSegment.size()) - 1, map.settings.level + kLikelyJoin);
    std::map<std::uint32_t, std::vector<std::uint32_t>> labels; // by group
    const auto groupOf = [&](const Rock& rock) { return group[map.regions[rock.label].firstSegment]; };
    for (const Rock& rock : rocks) labels[groupOf(rock)].push_back(rock.label);
    for (Rock& rock : rocks) {
        rock.maybeOneWith = labels[groupOf(rock)];
        std::erase(rock.maybeOneWith, rock.label);
    }
}

RegionCounts regionCounts(const RegionMap& map, RegionKind kind) {
    RegionCounts counts;
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        if (map.regions[n].kind != kind || map.regions[n].sums.cells == 0) continue;
        ++counts.regions;
        counts.cells += map.regions[n].sums.cells;
        counts.areaM2 += map.regions[n].sums.areaM2;
    }
    return counts;
}

} // namespace edgescan::rocks
