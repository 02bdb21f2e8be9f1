// The contact sheet compared with single runs, and the steady run with every possible run.
#include "core/edges/tuning/values_of_setting.h"

#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace edgescan::edges {

TEST(ContactSheet, EachEntryIsWhatTheProgramShowsAtThatValue) {
    const auto scan = std::make_shared<const Scan>(test::boxesScan(80, 100, 3, 0.02));
    for (const char* key : {"sensitivity", "crease", "min-length"}) {
        const Parameter* parameter = findParameter(key);
        ASSERT_NE(parameter, nullptr) << key;
        const Settings settings;
        const auto values = sheetValues(*parameter, parameter->get(settings), 7);
        ASSERT_GE(values.size(), 2u) << key;
        std::vector<std::size_t> told;
        const auto entries = contactSheet(scan, settings, *parameter, values, [&](const SheetEntry& entry, const Detection& detection) {
            EXPECT_EQ(entry.edges, detection.edges->size());
            told.push_back(entry.edges);
            return true;
        });
        ASSERT_EQ(entries.size(), values.size());
        for (std::size_t n = 0; n < entries.size(); ++n) {
            Settings with = settings;
            parameter->set(with, values[n]);
            EXPECT_EQ(entries[n].edges, detectEdges(scan, with)->edges->size()) << key << " " << values[n];
            EXPECT_EQ(told[n], entries[n].edges);
        }
    }
}

TEST(ContactSheet, TheValueInUseIsOneOfThemAndNoneIsThereTwice) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.several) continue;
        const double now = parameter.get(Settings{});
        const auto values = sheetValues(parameter, now, 12);
        EXPECT_LE(values.size(), 12u);
        EXPECT_TRUE(std::ranges::is_sorted(values)) << parameter.key;
        EXPECT_EQ(std::ranges::adjacent_find(values), values.end()) << parameter.key;
        if (!std::isnan(now)) {
            EXPECT_EQ(std::ranges::count(values, now), 1) << parameter.key;
        }
        for (const double value : values) EXPECT_EQ(snapped(parameter, value), value) << parameter.key;
    }
}

TEST(ContactSheet, TheSteadyRunIsTheLongestThatLosesNoMoreThanAFifth) {
    std::mt19937 dice(7);
    for (int round = 0; round < 300; ++round) {
        std::vector<SheetEntry> entries(1 + dice() % 12);
        std::size_t edges = 1000;
        for (SheetEntry& entry : entries) {
            entry.edges = edges;
            edges -= edges * (dice() % 30) / 100;
        }
        markSteady(entries);
        const auto holds = [&](std::size_t from, std::size_t to) {
            const auto [least, most] =
                std::minmax_element(entries.begin() + static_cast<long>(from), entries.begin() + static_cast<long>(to) + 1,
                                    [](const auto& a, const auto& b) { return a.edges < b.edges; });
            return least->edges > 0 && static_cast<double>(least->edges) >= 0.8 * static_cast<double>(most->edges);
        };
        std::size_t longest = 0;
        for (std::size_t from = 0; from < entries.size(); ++from)
            for (std::size_t to = from; to < entries.size(); ++to)
                if (holds(from, to)) longest = std::max(longest, to - from);
        const auto marked = static_cast<std::size_t>(std::ranges::count(entries, true, &SheetEntry::steady));
        EXPECT_EQ(marked, longest == 0 ? 0 : longest + 1);
        if (marked == 0) continue;
        const auto first = static_cast<std::size_t>(std::ranges::find(entries, true, &SheetEntry::steady) - entries.begin());
        EXPECT_TRUE(holds(first, first + longest));
    }
}

TEST(ContactSheet, ItEndsOnRequest) {
    const auto scan = std::make_shared<const Scan>(test::boxesScan(40, 50, 3, 0.02));
    const Parameter& parameter = *findParameter("sensitivity");
    int made = 0;
    const auto entries =
        contactSheet(scan, {}, parameter, sheetValues(parameter, 1.0, 8), [&](const SheetEntry&, const Detection&) { return ++made < 3; });
    EXPECT_EQ(entries.size(), 3u);
}

} // namespace edgescan::edges
