// Redoing only what changed gives what a run from nothing gives, and the newest posting always wins.
#include "core/base/work_pool.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"
#include "tests/support/simulated_bell.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

namespace edgescan::edges {
namespace {

Settings randomlyTurned(Settings s, std::mt19937& random) {
    const auto rows = parameters();
    const Parameter& p = rows[random() % rows.size()];
    const double share = static_cast<double>(random() % 1001) / 1000.0;
    double value =
        p.choices.empty() ? p.minimum + share * std::min(p.maximum - p.minimum, 20000.0) : p.choices[random() % p.choices.size()].value;
    if (p.automatic != nullptr && random() % 3 == 0) value = kAutomatic;
    p.set(s, snapped(p, value));
    return checkSettings(s) ? s : Settings{};
}

TEST(Pipeline, RedoingOnlyWhatChangedEqualsARunFromNothing) {
    std::mt19937 random(31);
    std::vector<std::shared_ptr<const Scan>> scans;
    for (std::uint32_t seed = 0; seed < 3; ++seed) scans.push_back(std::make_shared<Scan>(test::boxesScan(40, 60, seed, 0.05)));
    Pipeline pipeline;
    Settings settings;
    std::set<int> methods;
    for (int step = 0; step < 1500; ++step) {
        settings = randomlyTurned(settings, random);
        methods.insert(static_cast<int>(settings.method));
        const auto& scan = scans[random() % 10 == 0 ? random() % 3 : 0];
        const auto detection = pipeline.run(scan, settings);
        const auto fresh = detectEdges(scan, settings);
        ASSERT_EQ(detection->gray->levels, fresh->gray->levels) << step;
        ASSERT_EQ(detection->smoothed == nullptr, fresh->smoothed == nullptr) << step;
        if (detection->smoothed) {
            ASSERT_EQ(*detection->smoothed, *fresh->smoothed) << step;
        }
        ASSERT_EQ(detection->classes == nullptr, fresh->classes == nullptr) << step;
        if (detection->classes) {
            ASSERT_EQ(detection->classes->cells, fresh->classes->cells) << step;
        }
        ASSERT_EQ(*detection->mask, *fresh->mask) << step;
        ASSERT_EQ(*detection->edges, *fresh->edges) << step;
        EXPECT_EQ(detection->scan, scan);
    }
    EXPECT_EQ(methods.size(), findParameter("method")->choices.size());
}

void expectAsFromNothing(const Detection& found, const Detection& fresh) {
    const auto equal = [](const auto& a, const auto& b) { return (a == nullptr) == (b == nullptr) && (a == nullptr || *a == *b); };
    EXPECT_EQ(found.gray->levels, fresh.gray->levels);
    EXPECT_EQ(found.gray->saturated, fresh.gray->saturated);
    EXPECT_TRUE(equal(found.masked, fresh.masked));
    EXPECT_TRUE(equal(found.smoothed, fresh.smoothed));
    EXPECT_TRUE(equal(found.mask, fresh.mask));
    EXPECT_TRUE(equal(found.classes, fresh.classes));
    EXPECT_TRUE(equal(found.edges, fresh.edges));
    ASSERT_EQ(found.responses == nullptr, fresh.responses == nullptr);
    if (!found.responses) return;
    EXPECT_EQ(*found.responses->jump, *fresh.responses->jump);
    EXPECT_EQ(found.responses->crease, fresh.responses->crease);
    EXPECT_EQ(found.responses->border, fresh.responses->border);
    EXPECT_EQ(found.responses->jumpMm, fresh.responses->jumpMm);
}

// Values that a parameter can take, far apart.
std::vector<double> someValues(const Parameter& p) {
    std::vector<double> values;
    for (const Choice& choice : p.choices) values.push_back(choice.value);
    if (p.several) return {p.minimum, p.maximum, 1.0, 6.0};
    if (p.automatic != nullptr) values.push_back(kAutomatic);
    const double most = std::min(p.maximum, p.sliderMaximum);
    for (const double share : {0.05, 0.3, 0.8}) {
        if (p.choices.empty()) values.push_back(snapped(p, p.minimum + share * (most - p.minimum)));
    }
    return values;
}

// Only the table says what a stage depends on: after a change of any parameter of any method, no old result may remain.
TEST(Pipeline, TurningAnyParameterOfAnyMethodEqualsARunFromNothing) {
    const auto scan = std::make_shared<const Scan>(test::boxesScan(30, 40, 4, 0.05));
    for (const MethodTraits& traits : methodTraits()) {
        for (const Parameter& p : parameters()) {
            Pipeline pipeline;
            Settings settings = cannySettings();
            settings.method = traits.method;
            settings.sigma = 1.1; // so that the kernel size is not the only influence
            (void)pipeline.run(scan, settings);
            for (const double value : someValues(p)) {
                SCOPED_TRACE(std::string(traits.key) + " --" + p.key + " " + formatValue(p, value));
                p.set(settings, value);
                expectAsFromNothing(*pipeline.run(scan, settings), *detectEdges(scan, settings));
                if (testing::Test::HasFailure()) return;
            }
        }
    }
}

TEST(Pipeline, EveryMethodHasOneMainThreshold) {
    for (const MethodTraits& traits : methodTraits()) {
        Settings settings;
        settings.method = traits.method;
        EXPECT_EQ(
            std::ranges::count_if(parameters(), [&](const Parameter& p) { return p.feeds == Stage::Threshold && p.usedBy(settings); }), 1)
            << traits.key;
        EXPECT_EQ(rowOf(traits.method).method, traits.method);
        EXPECT_EQ(rowOf(traits.method).response != nullptr, reads(traits.method, kReadsGray)) << traits.key;
    }
}

TEST(Pipeline, TheGrayImageIsMadeForThoseWhoReadIt) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 60, 1));
    Pipeline pipeline;
    Settings settings;
    const auto plus = pipeline.run(scan, settings);
    EXPECT_FALSE(plus->gray.isMade());
    settings.method = Method::Jumps;
    const auto jumps = pipeline.run(scan, settings);
    EXPECT_TRUE(jumps->gray == plus->gray && jumps->gray->levels.size() == scan->cells() && plus->gray.isMade());
    settings.method = Method::Canny;
    const auto canny = pipeline.run(scan, settings);
    EXPECT_EQ(std::ranges::count(canny->timings, "gray", &StageTime::stage), 1);
    EXPECT_TRUE(canny->gray.isMade());
    // A window that thresholds read is wider.
    EXPECT_FALSE(canny->gray == plus->gray);
    EXPECT_LT(canny->gray->scale.nearMm, plus->gray->scale.nearMm);
    EXPECT_GT(canny->gray->scale.farMm, plus->gray->scale.farMm);
    std::atomic<int> made = 0;
    const MadeWhenRead<int> value([&made] { return ++made; });
    std::vector<std::thread> readers;
    for (int n = 0; n < 4; ++n) readers.emplace_back([&value] { EXPECT_EQ(*value, 1); });
    for (std::thread& reader : readers) reader.join();
}

TEST(Pipeline, AThresholdTouchesNeitherGrayNorSmoothing) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 60, 1));
    Pipeline pipeline;
    Settings settings = cannySettings();
    const auto first = pipeline.run(scan, settings);
    EXPECT_EQ(pipeline.run(scan, settings), first);
    settings.lower = 40;
    const auto second = pipeline.run(scan, settings);
    EXPECT_EQ(second->gray, first->gray);
    EXPECT_EQ(second->smoothed, first->smoothed);
    EXPECT_NE(second->mask, first->mask);
    settings.kernel = 5;
    const auto third = pipeline.run(scan, settings);
    EXPECT_EQ(third->gray, first->gray);
    EXPECT_NE(third->smoothed, first->smoothed);
}

TEST(Pipeline, AHandOnAThresholdBuildsOneMapAndGetsWhatTheMethodGives) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(50, 70, 1, 0.04));
    for (const Method method : {Method::Canny, Method::LogRange, Method::Kirsch, Method::MarrHildreth}) {
        Pipeline pipeline;
        Settings settings = cannySettings();
        settings.method = method;
        (void)pipeline.run(scan, settings);
        int maps = 0;
        for (const double threshold : {8.0, 9.5, 12.0, 3.0, 40.0, 0.5}) {
            settings.lower = settings.stepPercent = threshold;
            if (method != Method::LogRange) settings.stepPercent = Settings{}.stepPercent;
            if (method == Method::LogRange) settings.lower = cannySettings().lower;
            const auto detection = pipeline.run(scan, settings);
            ASSERT_EQ(*detection->mask, *detectEdges(scan, settings)->mask) << threshold;
            maps += static_cast<int>(std::ranges::count(detection->timings, "threshold map", &StageTime::stage));
            EXPECT_EQ(std::ranges::count(detection->timings, "canny", &StageTime::stage), 0);
        }
        EXPECT_EQ(maps, 1);
        settings.kernel = 5; // another map
        (void)pipeline.run(scan, settings);
        settings.lower = settings.stepPercent = 7;
        ASSERT_EQ(*pipeline.run(scan, settings)->mask, *detectEdges(scan, settings)->mask);
    }
}

TEST(Pipeline, ChangingTheDecisionRepeatsNoMeasurement) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(60, 80, 1));
    Pipeline pipeline;
    Settings settings;
    const auto first = pipeline.run(scan, settings);
    settings.sensitivity = 2.0;
    settings.hysteresisPercent = 60;
    settings.minimumLength = 9;
    settings.classes = kClassJump;
    const auto second = pipeline.run(scan, settings);
    EXPECT_EQ(second->responses, first->responses);
    EXPECT_NE(second->edges->size(), first->edges->size());
    settings.creaseDeg = 60;
    const auto third = pipeline.run(scan, settings);
    EXPECT_NE(third->responses, first->responses);
    // The sweep is cleaned and its noise measured once.
    EXPECT_EQ(std::ranges::count(first->timings, "surface", &StageTime::stage), 1);
    EXPECT_EQ(std::ranges::count(third->timings, "surface", &StageTime::stage), 0);
    settings.straighten = !settings.straighten;
    EXPECT_EQ(std::ranges::count(pipeline.run(scan, settings)->timings, "surface", &StageTime::stage), 1);
}

TEST(Pipeline, OnALaneManySettingsEndWithTheLast) {
    const auto scan = std::make_shared<const Scan>(test::boxesScan(200, 300, 2));
    std::shared_ptr<const Detection> detection;
    std::atomic<bool> done{false};
    Settings settings = cannySettings();
    WorkPool pool;
    Pipeline pipeline;
    Lane lane(pool, Urgency::Now);
    for (int i = 0; i < 200; ++i) {
        settings.lower = 5 + i;
        lane.post([&, settings] {
            detection = pipeline.run(scan, settings);
            done = settings.lower == 204;
        });
    }
    ASSERT_TRUE(test::waitUntil([&] { return done.load(); }));
    EXPECT_EQ(*detection->mask, *detectEdges(scan, settings)->mask);
}

// What is measured for a whole scan, the noise, is the same of its parts: so their edges are, 12 cells within the rim.
TEST(Pipeline, EdgesOfAPartAreThoseOfTheWhole) {
    constexpr int kLines = 200, kBeams = 300, kPart = 100, kRim = 12;
    const auto bell = test::simulatedBell(kLines, kBeams);
    ASSERT_TRUE(bell);
    const Grid<std::uint8_t> whole = *detectEdges(std::make_shared<const Scan>(*bell), {})->mask;
    for (const int first : {0, kLines - kPart}) {
        auto part = std::make_shared<Scan>(*bell);
        auto& angles = std::get<PolarGeometry>(part->geometry).lineDeg;
        angles = std::vector<double>(angles.begin() + first, angles.begin() + first + kPart);
        part->rangeMm = Grid<float>(kPart, kBeams);
        part->state = Grid<CellState>(kPart, kBeams);
        const auto from = static_cast<std::ptrdiff_t>(first) * kBeams;
        std::copy_n(bell->rangeMm.cells.begin() + from, part->cells(), part->rangeMm.cells.begin());
        std::copy_n(bell->state.cells.begin() + from, part->cells(), part->state.cells.begin());
        const Grid<std::uint8_t> mask = *detectEdges(part, {})->mask;
        int both = 0, either = 0;
        for (int i = kRim; i < kPart - kRim; ++i) {
            for (int j = kRim; j < kBeams - kRim; ++j) {
                const bool ofPart = mask.at(i, j) != 0, ofWhole = whole.at(first + i, j) != 0;
                both += ofPart && ofWhole ? 1 : 0;
                either += ofPart || ofWhole ? 1 : 0;
            }
        }
        EXPECT_GT(either, 1000);
        EXPECT_GE(both, 0.99 * either) << first;
    }
}

} // namespace
} // namespace edgescan::edges
