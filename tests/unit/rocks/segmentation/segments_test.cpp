// Segments compared with slow, simple versions, on scans of boxes and on random surfaces.
#include "app/lab/sim/simulate.h"
#include "core/rocks/segmentation/barrier.h"
#include "core/rocks/segmentation/basins.h"
#include "core/rocks/segmentation/borders.h"
#include "core/rocks/segmentation/refinement.h"
#include "tests/support/rock_scene.h"
#include "tests/support/scans.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace edgescan::rocks {
namespace {

std::shared_ptr<const edges::Detection> boxes(std::uint32_t seed, edges::KeepFor keep = edges::KeepFor::Rocks) {
    return edges::detectEdges(std::make_shared<Scan>(test::boxesScan(50, 70, seed, 0.03)), edges::Settings{}, keep);
}

TEST(RockBarrier, DistanceIsThatToTheNearestBarrierOfAll) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const Inputs inputs = rockInputs(*boxes(seed));
        const Grid<float> distance = barrierDistance(inputs);
        const Grid<Support>& support = inputs.surface->inverse.support;
        int free = 0;
        for (int i = 0; i < distance.lines; ++i) {
            for (int j = 0; j < distance.beams; ++j) {
                double nearest = 1e9;
                for (int y = 0; y < distance.lines; ++y) {
                    for (int x = 0; x < distance.beams; ++x) {
                        if (distance.at(y, x) == 0) nearest = std::min(nearest, std::hypot(y - i, x - j));
                    }
                }
                ASSERT_NEAR(static_cast<double>(distance.at(i, j)), nearest, 1e-5);
                free += distance.at(i, j) > 0 ? 1 : 0;
                const bool onJump = (j + 1 < distance.beams && inputs.cracks->jumpBeams.at(i, j) > 1) ||
                                    (i + 1 < distance.lines && inputs.cracks->jumpLines.at(i, j) > 1) ||
                                    (j > 0 && inputs.cracks->jumpBeams.at(i, j - 1) > 1) ||
                                    (i > 0 && inputs.cracks->jumpLines.at(i - 1, j) > 1);
                EXPECT_FALSE((support.at(i, j) == Support::Void || onJump) && distance.at(i, j) > 0);
            }
        }
        EXPECT_GT(free, 500);
    }
}

TEST(RockBarrier, ASurfaceWithoutBarriersIsOneSegment) {
    const Inputs inputs = rockInputs(*edges::detectEdges(std::make_shared<Scan>(test::boxesScan(30, 30, 1, 0)), edges::Settings{}));
    Inputs flat = inputs;
    auto surface = std::make_shared<edges::DepthSurface>(*inputs.surface);
    std::fill(surface->inverse.support.cells.begin(), surface->inverse.support.cells.end(), Support::Measured);
    std::fill(surface->inverse.u.cells.begin(), surface->inverse.u.cells.end(), 0.2F);
    flat.surface = surface;
    auto cracks = std::make_shared<edges::DepthCracks>();
    flat.responses = std::make_shared<const edges::DepthResponses>(edges::depthResponses(*surface, {}, cracks.get()));
    flat.cracks = cracks;
    const Segmentation segments = segmentRocks(flat);
    EXPECT_EQ(segments.count(), 1U);
    EXPECT_TRUE(segments.borders.empty());
    EXPECT_TRUE(std::all_of(segments.segment.cells.begin(), segments.segment.cells.end(), [](std::uint32_t l) { return l == 1; }));
}

// Joins basins one after the other. Each time it searches all cracks for the highest saddle that joins two.
Grid<std::uint32_t> slowBasins(const Grid<float>& distance, const CellLinks& links) {
    const auto beams = static_cast<std::size_t>(distance.beams);
    Grid<std::uint32_t> basin(distance.lines, distance.beams);
    const auto linked = [&](int i, int j, int y, int x) {
        if (!distance.contains(y, x)) return false;
        const std::size_t first = std::min(distance.index(i, j), distance.index(y, x));
        return i == y ? links.toNextBeam(first) : links.toNextLine(first);
    };
    const int dy[] = {-1, 0, 0, 1};
    const int dx[] = {0, -1, 1, 0};
    for (std::size_t k = 0; k < basin.size(); ++k) {
        if (!links.solid(k)) continue;
        std::size_t at = k;
        while (true) {
            const int i = static_cast<int>(at / beams);
            const int j = static_cast<int>(at % beams);
            std::size_t best = at;
            for (int n = 0; n < 4; ++n) {
                if (!linked(i, j, i + dy[n], j + dx[n])) continue;
                const std::size_t there = distance.index(i + dy[n], j + dx[n]);
                if (distance[there] > distance[best]) best = there;
            }
            for (int n = 0; n < 2 && best == at; ++n) {
                if (!linked(i, j, i + dy[n], j + dx[n])) continue;
                const std::size_t there = distance.index(i + dy[n], j + dx[n]);
                if (distance[there] == distance[at]) best = there;
            }
            if (best == at) break;
            at = best;
        }
        basin[k] = static_cast<std::uint32_t>(at) + 1;
    }
    while (true) {
        std::map<std::uint32_t, float> peak;
        for (std::size_t k = 0; k < basin.size(); ++k) peak[basin[k]] = std::max(peak[basin[k]], distance[k]);
        float highest = -1;
        std::pair<std::uint32_t, std::uint32_t> pair;
        for (int i = 0; i < distance.lines; ++i) {
            for (int j = 0; j < distance.beams; ++j) {
                for (const auto& [y, x] : {std::pair(i, j + 1), std::pair(i + 1, j)}) {
                    if (!linked(i, j, y, x) || basin.at(i, j) == basin.at(y, x)) continue;
                    const float saddle = std::min(distance.at(i, j), distance.at(y, x));
                    const float lower = std::min(peak[basin.at(i, j)], peak[basin.at(y, x)]);
                    if (lower - saddle >= kShallow || saddle <= highest) continue;
                    highest = saddle;
                    pair = {basin.at(i, j), basin.at(y, x)};
                }
            }
        }
        if (highest < 0) break;
        std::replace(basin.cells.begin(), basin.cells.end(), pair.second, pair.first);
    }
    numberByFirstCell(basin);
    return basin;
}

TEST(Segments, BasinsAreThoseOfTheSlowWay) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const Inputs inputs = rockInputs(*boxes(seed));
        const Grid<float> distance = barrierDistance(inputs);
        const CellLinks links{inputs.surface->inverse.support, *inputs.cracks};
        const Grid<std::uint32_t> segment = segmentBasins(distance, links);
        EXPECT_EQ(segment, slowBasins(distance, links)) << "seed " << seed;
        EXPECT_GT(*std::max_element(segment.cells.begin(), segment.cells.end()), 3U);
    }
}

// Depth of the crack between (i, j) and the next cell below the line through the cells up to `lengthM` away on both sides, in the same
// segments, mm.
double slowDepthMm(const Inputs& inputs, const Grid<std::uint32_t>& segment, int i, int j, edges::Along along, double lengthM,
                   double most) {
    const int dy = along == edges::Along::Lines ? 1 : 0;
    const int dx = 1 - dy;
    const auto u = [&](int n) { return static_cast<double>(inputs.cracks->smoothed.at(i + n * dy, j + n * dx)); };
    const double nearest = std::max(u(0), u(1));
    const AngularSteps& steps = inputs.surface->steps;
    const double angle = static_cast<double>(dy == 1 ? steps.lineAt(i, j) : steps.beam[static_cast<std::size_t>(j)]);
    const double reach = std::clamp(std::round(lengthM * nearest / angle), 2.0, most);
    const auto same = [&](int n, int m) {
        return segment.contains(i + n * dy, j + n * dx) && segment.at(i + n * dy, j + n * dx) == segment.at(i + m * dy, j + m * dx);
    };
    int first = 0;
    while (-first < reach && same(first - 1, 0)) --first;
    int last = 1;
    while (last - 1 < reach && same(last + 1, 1)) ++last;
    if (first == 0 || last == 1) return 0;
    const auto chord = [&](int n) { return u(first) + (u(last) - u(first)) * (n - first) / (last - first); };
    return 1000 * std::max(chord(0) - u(0), chord(1) - u(1)) / (nearest * nearest);
}

TEST(Segments, BordersHoldEachCrackBetweenTwoSegmentsOnce) {
    const Inputs inputs = rockInputs(*boxes(2));
    const Grid<std::uint32_t> segment = segmentBasins(barrierDistance(inputs), {inputs.surface->inverse.support, *inputs.cracks});
    const std::vector<SegmentBorder> borders = segmentBorders(inputs, segment);
    std::map<std::pair<std::uint32_t, std::uint32_t>, SegmentBorder> slow;
    const CrackMeasure measure(inputs, segment);
    for (int i = 0; i < segment.lines; ++i) {
        for (int j = 0; j < segment.beams; ++j) {
            for (const edges::Along along : {edges::Along::Beams, edges::Along::Lines}) {
                const int y = along == edges::Along::Lines ? i + 1 : i;
                const int x = along == edges::Along::Beams ? j + 1 : j;
                if (!segment.contains(y, x) || segment.at(i, j) == segment.at(y, x) || segment.at(i, j) == kNoSegment ||
                    segment.at(y, x) == kNoSegment)
                    continue;
                const std::uint32_t p = segment.at(i, j);
                const std::uint32_t q = segment.at(y, x);
                SegmentBorder& border = slow[{std::min(p, q), std::max(p, q)}];
                const CrackEvidence evidence = measure.at(i, j, along);
                ASSERT_NEAR(evidence.valleyMm, slowDepthMm(inputs, segment, i, j, along, 0.12, 12), 1e-6);
                ASSERT_NEAR(evidence.wideMm, slowDepthMm(inputs, segment, i, j, along, 0.5, 40), 1e-6);
                const double v = std::clamp(evidence.valleyMm / 30, -2.0, 2.0);
                const double w = std::clamp(evidence.wideMm / 125, -2.0, 2.0);
                ASSERT_NEAR(evidence.z, 7 * evidence.e1 + 9 * evidence.e2 + 0.5 * v + 1.5 * w - 9, 1e-9);
                border.sumWide += std::llround(w * 65536);
                border.sumZ += std::llround(evidence.z * 65536);
                ++border.cracks;
                const float jump = (along == edges::Along::Beams ? inputs.cracks->jumpBeams : inputs.cracks->jumpLines).at(i, j);
                if (jump <= 1) continue;
                const bool firstIsNearer = inputs.cracks->smoothed.at(i, j) >= inputs.cracks->smoothed.at(y, x);
                ++((firstIsNearer ? p : q) == std::min(p, q) ? border.jumpsA : border.jumpsB);
            }
        }
    }
    ASSERT_EQ(borders.size(), slow.size());
    for (const SegmentBorder& border : borders) {
        const SegmentBorder& other = slow.at({border.a, border.b});
        EXPECT_EQ(border.sumZ, other.sumZ);
        EXPECT_EQ(border.sumWide, other.sumWide);
        EXPECT_EQ(border.cracks, other.cracks);
        EXPECT_EQ(border.jumpsA, other.jumpsA);
        EXPECT_EQ(border.jumpsB, other.jumpsB);
    }
}

TEST(Segments, SumsAreThoseOfTheCells) {
    const Segmentation segments = test::segmentationOf(std::make_shared<Scan>(test::boxesScan(50, 70, 3, 0.03)));
    std::vector<std::uint32_t> cells(segments.sums.size());
    for (std::size_t k = 0; k < segments.segment.size(); ++k) {
        if (segments.inputs.surface->inverse.support[k] == Support::Measured) ++cells[segments.segment[k]];
        EXPECT_FALSE(segments.inputs.surface->inverse.support[k] == Support::Void && segments.segment[k] != kNoSegment);
    }
    std::size_t inRuns = 0;
    for (std::uint32_t segment = 1; segment <= segments.count(); ++segment) EXPECT_EQ(segments.sums[segment].cells, cells[segment]);
    for (const SegmentRun& run : segments.beamRuns) inRuns += run.end - run.begin;
    std::size_t inOtherRuns = 0;
    for (const SegmentRun& run : segments.lineRuns) inOtherRuns += run.end - run.begin;
    EXPECT_EQ(inRuns, inOtherRuns);
    EXPECT_EQ(inRuns, segments.segment.size() -
                          static_cast<std::size_t>(std::count(segments.segment.cells.begin(), segments.segment.cells.end(), kNoSegment)));
}

TEST(Segments, RefinementMovesARaggedBorderToTheStepAndNothingElse) {
    // Two planes at 4 m and 5 m; the border is a zigzag of three cells about the step.
    InverseRange inverse{Grid<float>(40, 40, 0.2F), Grid<Support>(40, 40, Support::Measured)};
    Grid<std::uint32_t> segment(40, 40);
    Grid<std::uint32_t> wanted(40, 40);
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            if (j < 20) inverse.u.at(i, j) = 0.25F;
            wanted.at(i, j) = j < 20 ? 1 : 2;
            segment.at(i, j) = j < 20 + i % 4 - 1 ? 1 : 2;
        }
    }
    const Grid<float> none(40, 40);
    refineSegments(inverse, {none, none, none, none, none}, {5, 0.2}, 30, segment, 2);
    EXPECT_EQ(segment, wanted);
}

// One pass of the refinement as docs/method/rocks.md describes it, from the segments before it. 0 where a cell may not choose.
class SlowPass {
public:
    SlowPass(const Inputs& inputs, double most, const Grid<std::uint32_t>& segment)
        : in_(inputs), most_(most), segment_(segment), inverse_(inputs.surface->inverse) {}

    [[nodiscard]] bool touches(int i, int j) const {
        bool other = false;
        for (int n = 0; n < 9; ++n) {
            const int y = i + n / 3 - 1;
            const int x = j + n % 3 - 1;
            other =
                other || (segment_.contains(y, x) && inverse_.support.at(y, x) != Support::Void && segment_.at(y, x) != segment_.at(i, j));
        }
        return other && inverse_.support.at(i, j) != Support::Void;
    }
    [[nodiscard]] std::uint32_t choice(int i, int j) const {
        std::map<std::uint32_t, double> nearby; // segments and the weighted numbers of neighbours in them
        for (int n = 0; n < 9; ++n) {
            const int y = i + n / 3 - 1;
            const int x = j + n % 3 - 1;
            if (segment_.contains(y, x) && segment_.at(y, x) != kNoSegment)
                nearby[segment_.at(y, x)] += n == 4 ? 0 : 1 - 0.5 * edge(i, j, y, x);
        }
        std::uint32_t best = segment_.at(i, j);
        double least = 1e9;
        for (const auto& [segment, counted] : nearby) {
            const double off = deviations(i, j, segment);
            const double cost = (off > most_ ? most_ + 0.01 * (off - most_) : off) - 2 * counted;
            if ((segment_.at(i, j) == kNoSegment && off >= 20) || cost >= least) continue;
            least = cost;
            best = segment;
        }
        return best;
    }

private:
    [[nodiscard]] double edge(int i, int j, int y, int x) const {
        const edges::DepthCracks& c = *in_.cracks;
        const auto step = [&](int a, int b, int d, int e) { // weight of neighbours in a line
            const bool lines = a != d;
            const int k = std::min(a, d);
            const int l = std::min(b, e);
            const Grid<float>& fold = lines ? c.foldLines : c.foldBeams;
            const float jump = (lines ? c.jumpLines : c.jumpBeams).at(k, l);
            return static_cast<double>(std::clamp(std::max({jump, -fold.at(a, b), -fold.at(d, e)}), 0.0F, 1.0F));
        };
        if (i == y || j == x) return step(i, j, y, x);
        return std::min(std::max(step(i, j, i, x), step(i, x, y, x)), std::max(step(i, j, y, j), step(y, j, y, x)));
    }
    [[nodiscard]] double deviations(int i, int j, std::uint32_t segment) const {
        std::vector<Eigen::Vector3d> rows;
        std::vector<double> values;
        for (int y = i - 4; y <= i + 4; ++y) {
            for (int x = j - 4; x <= j + 4; ++x) {
                if (!segment_.contains(y, x) || segment_.at(y, x) != segment || touches(y, x)) continue;
                rows.emplace_back(1, x - j, y - i);
                values.push_back(static_cast<double>(inverse_.u.at(y, x)));
            }
        }
        if (rows.empty()) return most_;
        double fit = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
        if (rows.size() >= 6) {
            Eigen::Matrix3d squares = Eigen::Vector3d(0, 0.5, 0.5).asDiagonal();
            Eigen::Vector3d right = Eigen::Vector3d::Zero();
            for (std::size_t n = 0; n < rows.size(); ++n) {
                squares += rows[n] * rows[n].transpose();
                right += rows[n] * values[n];
            }
            fit = squares.fullPivLu().solve(right)[0];
        }
        const double rangeM = 1 / static_cast<double>(inverse_.u.at(i, j));
        return 1000 * std::abs(1 / std::max(fit, 1e-4) - rangeM) / std::max(in_.responses->noise.at(rangeM), 0.1);
    }

    const Inputs& in_;
    double most_;
    const Grid<std::uint32_t>& segment_;
    const InverseRange& inverse_;
};

TEST(Segments, RefinementIsThatOfTheSlowWay) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const double most = seed % 2 == 0 ? 5 : 30;
        const Inputs inputs = rockInputs(*boxes(seed));
        Grid<std::uint32_t> segment = segmentBasins(barrierDistance(inputs), {inputs.surface->inverse.support, *inputs.cracks});
        const std::uint32_t count = *std::max_element(segment.cells.begin(), segment.cells.end());
        Grid<std::uint32_t> slow = segment;
        std::vector<std::uint32_t> cells(count + 1);
        for (const std::uint32_t l : segment.cells) ++cells[l];
        for (std::uint32_t& l : slow.cells) l = cells[l] < kSmallestSegment ? kNoSegment : l;
        const Grid<std::uint32_t> before = slow;
        for (int pass = 0; pass < 4; ++pass) {
            const Grid<std::uint32_t> from = slow;
            const SlowPass one(inputs, most, from);
            for (int i = 0; i < slow.lines; ++i) {
                for (int j = 0; j < slow.beams; ++j) {
                    if (one.touches(i, j)) slow.at(i, j) = one.choice(i, j);
                }
            }
        }
        refineSegments(inputs.surface->inverse, *inputs.cracks, inputs.responses->noise, most, segment, count);
        EXPECT_EQ(segment, slow) << "seed " << seed;
        EXPECT_NE(slow, before) << "seed " << seed;
    }
}

TEST(Segments, DeviationsCountForLongerWhereBeamsOverlap) {
    const auto most = [](float step) { return mostDeviations({{step, step}, {step, step}, {1.0F, 1.0F}}); };
    EXPECT_EQ(most(0.0058F), 5.0);  // a third of a degree
    EXPECT_EQ(most(0.0029F), 30.0); // a sixth
    EXPECT_GT(most(0.0036F), 5.0);
    EXPECT_LT(most(0.0036F), 30.0);
    EXPECT_EQ(mostDeviations({}), 30.0);
}

TEST(Segments, ASmallSegmentIsTakenByItsNeighbourOrStaysOpenWhereNothingFits) {
    InverseRange inverse{Grid<float>(40, 40, 0.2F), Grid<Support>(40, 40, Support::Measured)};
    Grid<std::uint32_t> segment(40, 40, 1U);
    for (int n = 0; n < 3; ++n) {
        segment.at(10, 10 + n) = 2;
        segment.at(25, 10 + n) = 3;
        inverse.u.at(25, 10 + n) = 0.4F; // far in front of the plane
    }
    const Grid<float> none(segment.lines, segment.beams);
    refineSegments(inverse, {none, none, none, none, none}, {5, 0.2}, 30, segment, 3);
    EXPECT_EQ(segment.at(10, 11), 1U);
    EXPECT_EQ(segment.at(25, 11), kNoSegment);
    EXPECT_EQ(std::count(segment.cells.begin(), segment.cells.end(), kNoSegment), 3);
}

TEST(RockInputs, AreTheSameHoweverTheyWereMade) {
    const auto plain = boxes(5, edges::KeepFor::Edges);
    const auto kept = boxes(5);
    EXPECT_EQ(*plain->mask, *kept->mask);
    EXPECT_EQ(plain->cracks, nullptr);
    ASSERT_NE(kept->cracks, nullptr);
    const Inputs one = rockInputs(*plain);
    const Inputs other = rockInputs(*kept);
    EXPECT_EQ(one.cracks->smoothed, other.cracks->smoothed);
    EXPECT_EQ(one.cracks->jumpBeams, other.cracks->jumpBeams);
    EXPECT_EQ(one.cracks->jumpLines, other.cracks->jumpLines);
    EXPECT_EQ(one.cracks->foldBeams, other.cracks->foldBeams);
    EXPECT_EQ(one.cracks->foldLines, other.cracks->foldLines);
    EXPECT_EQ(*one.responses->jump, *other.responses->jump);
    EXPECT_EQ(one.responses->crease, other.responses->crease);
    edges::Settings canny;
    canny.method = edges::Method::Canny;
    const Inputs third = rockInputs(*edges::detectEdges(plain->scan, canny));
    EXPECT_EQ(third.cracks->smoothed, one.cracks->smoothed);
}

} // namespace
} // namespace edgescan::rocks
