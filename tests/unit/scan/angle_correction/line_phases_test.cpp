// Lines with different beam phases in a cycle: detected, merged, and never found where there are none.
#include "core/scan/angle_correction/line_phases.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace edgescan {
namespace {

/// Every n-th beam of a finer scan; on line i from beam offsets[i % count] on.
struct Phases {
    int spacing;
    std::vector<int> offsets;
};

Scan phased(const Scan& fine, const Phases& phases) {
    const auto& polar = std::get<PolarGeometry>(fine.geometry);
    Scan scan = fine;
    const int beams = fine.beams() / phases.spacing;
    PolarGeometry angles = polar;
    angles.beamDeg.clear();
    for (int j = 0; j < beams; ++j) angles.beamDeg.push_back(polar.beamDeg[static_cast<std::size_t>(j * phases.spacing)]);
    scan.rangeMm = Grid<float>(fine.lines(), beams);
    scan.state = Grid<CellState>(fine.lines(), beams);
    for (int i = 0; i < fine.lines(); ++i) {
        const int offset = phases.offsets[static_cast<std::size_t>(i) % phases.offsets.size()];
        for (int j = 0; j < beams; ++j) {
            scan.rangeMm.at(i, j) = fine.rangeMm.at(i, j * phases.spacing + offset);
            scan.state.at(i, j) = fine.state.at(i, j * phases.spacing + offset);
        }
    }
    scan.geometry = std::move(angles);
    return scan;
}

Scan simulated(Axis axis, std::uint64_t seed, int lines, int beams) {
    sim::SimulationSettings settings;
    settings.axis = axis;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    return sim::simulate(settings)->scan;
}

TEST(LinePhases, LinesOfACycleAreDetectedAndMerged) {
    const std::vector<std::pair<const char*, Phases>> turns{
        {"four", {4, {0, 1, 2, 3}}},
        {"four, crosswise", {4, {0, 2, 1, 3}}},
        {"three", {3, {0, 1, 2}}},
        {"two", {4, {0, 2}}},
        {"two, unequal", {10, {0, 3}}},
        {"three, unequal", {10, {0, 2, 6}}},
        {"four, unequal", {10, {0, 1, 4, 7}}},
    };
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        const Scan fine = simulated(axis, 5, 243, 1141);
        const auto& fineDeg = std::get<PolarGeometry>(fine.geometry).beamDeg;
        for (const auto& [name, phases] : turns) {
            SCOPED_TRACE(std::string(name) + (axis == Axis::Spin ? ", spin" : ", sweep"));
            const int count = static_cast<int>(phases.offsets.size());
            const Scan nominal = phased(fine, phases);
            const LinePhases phasesFound = linePhases(inverseRange(nominal));
            const std::vector<double>& found = phasesFound.steps;
            EXPECT_GE(phasesFound.significance, 6.0);
            ASSERT_EQ(static_cast<int>(found.size()), count);
            for (int k = 0; k < count; ++k)
                EXPECT_NEAR(found[static_cast<std::size_t>(k)],
                            static_cast<double>(phases.offsets[static_cast<std::size_t>(k)]) / phases.spacing, 0.05);
            const auto warning = displacementWarning(nominal);
            ASSERT_TRUE(warning);
            EXPECT_TRUE(isDisplacementWarning(*warning));
            EXPECT_NE(warning->find("the beams of " + std::to_string(count) + " lines in turn lie 0"), std::string::npos) << *warning;
            EXPECT_NE(warning->find(" times its uncertainty;"), std::string::npos) << *warning;
            const Scan straight = straightened(nominal);
            ASSERT_EQ(straight.lines(), (fine.lines() + count - 1) / count);
            ASSERT_EQ(straight.beams(), nominal.beams() * count);
            const auto& polar = std::get<PolarGeometry>(straight.geometry);
            EXPECT_TRUE(std::is_sorted(polar.beamDeg.begin(), polar.beamDeg.end()));
            // Each cell is that of the fine scan at its own angle.
            const auto& lineDeg = std::get<PolarGeometry>(fine.geometry).lineDeg;
            std::size_t cells = 0;
            const double stepDeg = fineDeg[1] - fineDeg[0];
            for (int row = 0; row < straight.lines(); ++row) {
                for (int j = 0; j < straight.beams(); ++j) {
                    const auto beam = static_cast<std::size_t>(j);
                    const double deg = polar.lineDeg[static_cast<std::size_t>(row)] + polar.lineSkewDeg[beam];
                    const int line =
                        row * count +
                        static_cast<int>(std::lround((deg - lineDeg[static_cast<std::size_t>(row * count)]) / (lineDeg[1] - lineDeg[0])));
                    if (line >= fine.lines()) {
                        EXPECT_EQ(straight.state.at(row, j), CellState::Lost);
                        continue;
                    }
                    const int place = phases.offsets[static_cast<std::size_t>(line % count)];
                    const int of = j / count * phases.spacing + place;
                    EXPECT_NEAR(polar.beamDeg[beam], fineDeg[static_cast<std::size_t>(of)], 0.5 * stepDeg);
                    ASSERT_EQ(straight.state.at(row, j), fine.state.at(line, of));
                    ASSERT_EQ(straight.rangeMm.at(row, j), fine.rangeMm.at(line, of));
                    ++cells;
                }
            }
            EXPECT_EQ(cells, nominal.cells());
        }
    }
}

TEST(LinePhases, VerticalEdgesHaveNoCombsOnceTheLinesAreSideBySide) {
    // Two slanted walls, the nearer one ends at 90.1 degrees.
    const Scan fine = test::makeScan(120, 721, [](int, int j) {
        const double deg = 0.25 * j;
        return deg < 90.1 ? std::round(3000.0 / std::cos((deg - 60) * std::numbers::pi / 180))
                          : std::round(6000.0 / std::cos((deg - 130) * std::numbers::pi / 180));
    });
    Scan named = fine;
    auto& polar = std::get<PolarGeometry>(named.geometry);
    for (int j = 0; j < named.beams(); ++j) polar.beamDeg[static_cast<std::size_t>(j)] = 0.25 * j;
    const Scan straight = straightened(phased(named, {4, {0, 1, 2, 3}}));
    ASSERT_EQ(straight.lines(), 30);
    const auto edges = edges::detectEdges(std::make_shared<const Scan>(straight), edges::Settings{});
    std::set<int> columns;
    int rows = 0;
    for (int i = 2; i < 28; ++i) {
        bool any = false;
        for (int j = 300; j < 420; ++j) {
            if (edges->mask->at(i, j) == 0) continue;
            columns.insert(j);
            any = true;
        }
        rows += any ? 1 : 0;
    }
    EXPECT_EQ(rows, 26);
    EXPECT_LE(columns.size(), 2U);
}

TEST(LinePhases, NoneAreSeenWhereThereAreNone) {
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const Scan scan = simulated(axis, seed, 250, 286);
            EXPECT_TRUE(linePhases(inverseRange(scan)).steps.empty()) << seed;
            EXPECT_EQ(displacementWarning(scan).value_or(""), "") << seed;
        }
    }
}

} // namespace
} // namespace edgescan
