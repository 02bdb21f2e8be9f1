// The lines of a sweep divided among threads: the same to the last bit, wherever the seams are.
#include "app/lab/sim/simulate.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <gtest/gtest.h>

#include <random>

namespace edgescan::edges {
namespace {

void expectSameWithAnyThreads(const Scan& scan, const Settings& settings) {
    const DepthSurface surface = depthSurface(scan, {}, 1);
    DepthCracks cracks;
    const DepthResponses responses = depthResponses(surface, settings, &cracks, 1);
    const DepthEdges edges = decideDepthEdges(responses, settings, 1);
    for (const int threads : {0, 2, 3, 7, 1000}) {
        const DepthSurface otherSurface = depthSurface(scan, {}, threads);
        EXPECT_EQ(otherSurface.slips.measured, surface.slips.measured) << threads;
        EXPECT_EQ(otherSurface.inverse.u, surface.inverse.u) << threads;
        DepthCracks otherCracks;
        const DepthResponses other = depthResponses(otherSurface, settings, &otherCracks, threads);
        EXPECT_EQ(*other.jump, *responses.jump) << threads;
        EXPECT_EQ(other.crease, responses.crease) << threads;
        for (const auto grid :
             {&DepthCracks::smoothed, &DepthCracks::jumpBeams, &DepthCracks::jumpLines, &DepthCracks::foldBeams, &DepthCracks::foldLines})
            EXPECT_EQ(otherCracks.*grid, cracks.*grid) << threads;
        EXPECT_EQ(otherSurface.inverse.support, surface.inverse.support) << threads;
        EXPECT_EQ(other.border, responses.border) << threads;
        EXPECT_EQ(other.silhouettes, responses.silhouettes) << threads;
        const DepthEdges otherEdges = decideDepthEdges(other, settings, threads);
        EXPECT_EQ(otherEdges.mask, edges.mask) << threads;
        EXPECT_EQ(otherEdges.kind, edges.kind) << threads;
    }
}

TEST(DepthBands, GiveTheSameResponses) {
    sim::SimulationSettings simulation;
    simulation.lines = 210;
    simulation.beams = 161;
    simulation.slips = 0.05;
    simulation.dropouts = 0.02;
    const auto simulated = sim::simulate(simulation);
    ASSERT_TRUE(simulated);
    Settings settings;
    expectSameWithAnyThreads(simulated->scan, settings);
    settings.noiseMm = 30; // two passes of smoothing, lines through three cells
    expectSameWithAnyThreads(simulated->scan, settings);
}

// Gaps of one to six cells, along and across the seams of any number of bands.
TEST(DepthBands, FillTheSameGaps) {
    sim::SimulationSettings simulation;
    simulation.lines = 90;
    simulation.beams = 61;
    auto simulated = sim::simulate(simulation);
    ASSERT_TRUE(simulated);
    Scan& scan = simulated->scan;
    std::mt19937 random(5);
    for (int gap = 0; gap < 400; ++gap) {
        const int line = static_cast<int>(random() % 90), beam = static_cast<int>(random() % 61),
                  cells = 1 + static_cast<int>(random() % 6);
        const bool along = random() % 2 == 0;
        for (int n = 0; n < cells; ++n) {
            if (scan.rangeMm.contains(line + (along ? 0 : n), beam + (along ? n : 0)))
                scan.state.at(line + (along ? 0 : n), beam + (along ? n : 0)) = CellState::NoReturn;
        }
    }
    const InverseRange one = inverseRange(scan, 1);
    for (int threads = 2; threads < 40; ++threads) {
        const InverseRange other = inverseRange(scan, threads);
        EXPECT_EQ(other.u, one.u) << threads;
        EXPECT_EQ(other.support, one.support) << threads;
    }
}

} // namespace
} // namespace edgescan::edges
