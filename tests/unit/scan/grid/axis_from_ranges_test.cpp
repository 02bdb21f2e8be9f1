// The axis from the ranges: of simulated bells in both mountings, and where ranges cannot show it. A growing sweep and a file use it.
#include "core/scan/grid/axis_from_ranges.h"

#include "app/lab/emulator/telegram.h"
#include "app/lab/sim/simulate.h"
#include "core/files/plausibility/opening_check.h"
#include "core/scan/grid/assumed_mounting.h"
#include "tests/support/live_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgescan {
namespace {

Scan bell(Axis axis, const char* scene, std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.scene = scene;
    settings.seed = seed;
    settings.axis = axis;
    settings.lines = 300;
    settings.beams = 191; // one per degree
    settings.footprint = false;
    return std::move(sim::simulate(settings)->scan);
}

const PolarGeometry& polarOf(const Scan& scan) { return std::get<PolarGeometry>(scan.geometry); }

std::optional<Axis> seenIn(const Scan& scan, int lines) {
    Grid<float> range(lines, scan.beams());
    Grid<CellState> state(lines, scan.beams());
    std::copy_n(scan.rangeMm.cells.begin(), range.size(), range.cells.begin());
    std::copy_n(scan.state.cells.begin(), state.size(), state.cells.begin());
    return axisFromRanges(range, state, polarOf(scan).beamDeg);
}

template <typename RangeOf>
std::optional<Axis> seenWhere(const RangeOf& rangeOf) {
    constexpr int kLines = 200, kBeams = 191;
    Grid<float> range(kLines, kBeams);
    std::vector<double> beamDeg;
    for (int j = 0; j < kBeams; ++j) beamDeg.push_back(j - 5.0);
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) range.at(i, j) = static_cast<float>(rangeOf(i, j));
    }
    return axisFromRanges(range, Grid<CellState>(kLines, kBeams, CellState::Valid), beamDeg);
}

} // namespace

TEST(AxisFromRanges, IsThatOfTheBellOrUnknown) {
    int found = 0;
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const char* scene : {"hangup", "pile"}) {
            for (const std::uint64_t seed : {401U, 402U, 403U}) {
                const Scan scan = bell(axis, scene, seed);
                EXPECT_FALSE(seenIn(scan, 40)) << "too few lines";
                for (const int lines : {80, 120, 200, 300}) {
                    const auto seen = seenIn(scan, lines);
                    EXPECT_EQ(seen.value_or(axis), axis) << scene << " " << seed << " " << lines;
                    found += seen && lines == 300 ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GE(found, 11) << "of 12";
}

TEST(AxisFromRanges, IsUnknownWhereRangesDoNotShowIt) {
    EXPECT_FALSE(seenWhere([](int, int j) { return 4000 + 10 * j; })) << "the stepper does not turn";
    EXPECT_FALSE(seenWhere([](int i, int j) { return 4000 + 37 * (i % 90) + 10 * j; })) << "a robot that drives";
    EXPECT_EQ(seenWhere([](int i, int j) { return 4000 + (j < 70 || j > 120 ? 37 * (i % 90) : 0); }), Axis::Spin);
    EXPECT_EQ(seenWhere([](int i, int j) { return 4000 + (j > 30 && j < 160 ? 37 * (i % 90) : 0); }), Axis::Sweep);
    EXPECT_FALSE(axisFromRanges({}, {}, {}));
}

// Lines of a sweep mounting, of which the scanner says nothing: the cloud gets its shape as soon as the ranges show the axis, and the next
// sweep begins with it.
TEST(AxisFromRanges, AGrowingSweepTakesItAndSaysSo) {
    const Scan scan = bell(Axis::Sweep, "hangup", 404);
    const auto telegrams = scanner::telegramsOf(scan);
    ASSERT_TRUE(telegrams);
    scanner::SweepSettings settings = scanner::assumedSweep();
    settings.expectedLines = scan.lines();
    const auto after = [&](int lines, const scanner::SweepSettings& with) {
        scanner::SweepAssembler assembler(with);
        for (int n = 0; n < lines; ++n) {
            scanner::ScanTelegram telegram = (*telegrams)[static_cast<std::size_t>(n % scan.lines())];
            telegram.telegramCounter = static_cast<std::uint16_t>(100 + n);
            telegram.scanCounter = static_cast<std::uint16_t>(200 + n);
            telegram.sinceStartUs = static_cast<std::uint32_t>(5'000'000 + 40'000 * n);
            test::pushTelegram(assembler, telegram, test::hostNsOfLine(n));
        }
        const auto shown = assembler.snapshot();
        EXPECT_EQ(assembler.progress().axis, polarOf(*shown).axis);
        EXPECT_EQ(assembler.progress().firstLineDeg, polarOf(*shown).lineDeg.front());
        return shown;
    };
    EXPECT_EQ(polarOf(*after(60, settings)).axis, Axis::Spin);
    EXPECT_EQ(polarOf(*after(60, settings)).lineDeg.front(), 0.0);
    EXPECT_EQ(assumedIn(*after(60, settings)), Assumed::Mounting);
    const auto whole = after(200, settings);
    EXPECT_EQ(polarOf(*whole).axis, Axis::Sweep);
    EXPECT_TRUE(isAxisFromRanges(*whole));
    EXPECT_EQ(assumedIn(*whole), Assumed::Step);
    const auto next = after(scan.lines() + 20, settings);
    EXPECT_EQ(next->lines(), 20);
    EXPECT_EQ(polarOf(*next).axis, Axis::Sweep) << "the ranges of the sweep before";
    settings.stepAssumed = false;
    EXPECT_EQ(assumedIn(*after(200, settings)), Assumed::SeenAxis);
    // As far on both sides of the viewing direction, until the angle of the first line is given.
    settings.degPerLine = 0.6;
    EXPECT_EQ(polarOf(*after(200, settings)).lineDeg.front(), -90.0);
    settings.axisAssumed = false; // given, right or wrong
    EXPECT_EQ(assumedIn(*after(200, settings)), Assumed::Direction);
    EXPECT_FALSE(mountingAssumed(*after(200, settings))) << "lengths do not depend on it";
    settings.firstAssumed = false;
    EXPECT_EQ(polarOf(*after(200, settings)).axis, Axis::Spin);
    EXPECT_EQ(assumedIn(*after(200, settings)), Assumed::Nothing);
}

TEST(AxisFromRanges, SpeaksAgainstTheOtherMountingOfAFile) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        Scan scan = bell(axis, "pile", 405);
        const auto against = [&] {
            const auto points = files::openingCheck(scan, {});
            return std::ranges::find_if(points, [](const auto& point) { return std::string_view(point.what) == "Mounting"; })
                ->against.text();
        };
        EXPECT_EQ(against(), "");
        std::get<PolarGeometry>(scan.geometry).axis = axis == Axis::Spin ? Axis::Sweep : Axis::Spin;
        EXPECT_NE(against().find(axis == Axis::Spin ? "as with spin" : "as with sweep"), std::string::npos) << against();
    }
}

} // namespace edgescan
