// The lines of a sweep shared out among threads: the same to the last bit, wherever the seams lie.
#include "core/depth/depth_edges.h"
#include "core/sim/simulate.h"

#include <gtest/gtest.h>

namespace edgescan {
namespace {

void expectSameWithAnyThreads(const Scan& scan, const DepthEdgeSettings& settings) {
    const DepthSurface surface = depthSurface(scan, true, 1);
    DepthCracks cracks;
    const DepthResponses responses = depthResponses(surface, settings, &cracks, 1);
    for (const int threads : {0, 2, 3, 7, 1000}) {
        const DepthSurface otherSurface = depthSurface(scan, true, threads);
        EXPECT_EQ(otherSurface.slips.measured, surface.slips.measured) << threads;
        EXPECT_EQ(otherSurface.inverse.u, surface.inverse.u) << threads;
        DepthCracks otherCracks;
        const DepthResponses other = depthResponses(otherSurface, settings, &otherCracks, threads);
        EXPECT_EQ(other.jump, responses.jump) << threads;
        EXPECT_EQ(other.crease, responses.crease) << threads;
        for (const auto grid :
             {&DepthCracks::smoothed, &DepthCracks::jumpBeams, &DepthCracks::jumpLines, &DepthCracks::foldBeams, &DepthCracks::foldLines})
            EXPECT_EQ(otherCracks.*grid, cracks.*grid) << threads;
    }
}

TEST(DepthBands, GiveTheSameResponses) {
    SimulationSettings simulation;
    simulation.lines = 210;
    simulation.beams = 161;
    simulation.slips = 0.05;
    simulation.dropouts = 0.02;
    const auto simulated = simulate(simulation);
    ASSERT_TRUE(simulated);
    DepthEdgeSettings settings;
    expectSameWithAnyThreads(simulated->scan, settings);
    settings.noiseAt5mMm = 30; // two passes of smoothing, lines through three cells
    expectSameWithAnyThreads(simulated->scan, settings);
}

} // namespace
} // namespace edgescan
