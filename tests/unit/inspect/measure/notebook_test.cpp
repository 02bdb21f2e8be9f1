// Targets and measurements in their file: read back as written, and refused if they are invalid or belong to another scan.
#include "core/base/bounded_json.h"
#include "core/inspect/measure/notebook.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <random>

namespace edgescan::inspect {
namespace {

const NotebookScan kThis{std::string(64, 'a'), "bell", 20, 30};

Notebook someNotebook() {
    Notebook notebook;
    notebook.targets.push_back({1, "keystone \xC3\xA9 \"left\"", 125, true, "2026-11-20T10:15:30.000Z", {{"Distance", "4.911 m ± 0.009"}}});
    notebook.targets.push_back({7, "", 599, false, "", {}});
    notebook.measures.push_back({MeasureKind::Spans, {1, 2, 3, 599}});
    notebook.measures.push_back({MeasureKind::Angle, {5, 6, 7}});
    notebook.measures.push_back({MeasureKind::Distance, {31, 40}, {32, 40}});
    notebook.measures.push_back({MeasureKind::Section, {31, 32, 70, 100}, {}, {0.25, 0.4375}});
    for (StoredMeasure& measure : notebook.measures) measure.number = nextMeasureNumber({{}, {notebook.measures.data(), &measure}});
    notebook.measures.back().number = 7; // others were removed
    notebook.targets.back().clicked = 598;
    notebook.targets.back().note = "watch \xE2\x96\xB2 it";
    return notebook;
}

TEST(Notebook, IsReadBackAsItWasWritten) {
    const auto read = notebookFromText(notebookText(someNotebook(), kThis), kThis, "here");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(*read, someNotebook());
    EXPECT_EQ(nextNumber(*read), 8);
    EXPECT_EQ(nextNumber({}), 1);
    EXPECT_EQ(nextMeasureNumber(*read), 8);
    EXPECT_EQ(nextMeasureNumber({}), 1);
    EXPECT_EQ(measureName(read->measures.back()), "M7");
}

// Targets are written as "number:cell".
Notebook notebookOf(const std::vector<std::pair<int, std::uint32_t>>& targets) {
    Notebook notebook;
    for (const auto& [number, cell] : targets) {
        notebook.targets.push_back({number, "", cell, false, "", {}});
        notebook.measures.push_back({.cells = {cell, cell + 1}, .number = number});
    }
    return notebook;
}

TEST(Notebook, WhatTwoWindowsDidIsMerged) {
    struct Row {
        const char* what;
        std::vector<std::pair<int, std::uint32_t>> base, mine, theirs, merged;
    };
    const std::vector<Row> rows{
        {"one window alone", {{1, 5}}, {{1, 5}, {2, 6}}, {{1, 5}}, {{1, 5}, {2, 6}}},
        {"both add", {{1, 5}}, {{1, 5}, {2, 6}}, {{1, 5}, {3, 7}}, {{1, 5}, {2, 6}, {3, 7}}},
        {"both add the same number", {{1, 5}}, {{1, 5}, {2, 6}}, {{1, 5}, {2, 7}}, {{1, 5}, {3, 6}, {2, 7}}},
        {"both add the same", {}, {{1, 6}}, {{1, 6}}, {{1, 6}}},
        {"I remove", {{1, 5}, {2, 6}}, {{2, 6}}, {{1, 5}, {2, 6}, {3, 7}}, {{2, 6}, {3, 7}}},
        {"the other one removes", {{1, 5}, {2, 6}}, {{1, 5}, {2, 6}, {3, 7}}, {{2, 6}}, {{2, 6}, {3, 7}}},
        {"both remove", {{1, 5}}, {}, {}, {}},
        {"of two alike one stays", {{1, 5}, {2, 5}}, {{2, 5}}, {{1, 5}, {2, 5}}, {{2, 5}}},
        {"of two alike the other window leaves one", {{1, 5}, {2, 5}}, {{1, 5}, {2, 5}}, {{1, 5}}, {{1, 5}}},
        {"the order is mine", {{1, 5}}, {{3, 7}, {2, 6}, {1, 5}}, {{1, 5}}, {{3, 7}, {2, 6}, {1, 5}}},
    };
    for (const Row& row : rows) {
        const Notebook merged = mergedNotebook(notebookOf(row.base), notebookOf(row.mine), notebookOf(row.theirs));
        EXPECT_EQ(merged.targets, notebookOf(row.merged).targets) << row.what;
        EXPECT_EQ(merged.measures.size(), row.merged.size()) << row.what;
        EXPECT_TRUE(std::ranges::is_sorted(merged.measures, {}, &StoredMeasure::number)) << row.what;
    }
}

TEST(Notebook, OfAnEntryThatBothWindowsHaveTheChangeStays) {
    const Notebook base = notebookOf({{1, 5}});
    Notebook mine = base, theirs = base;
    mine.targets.front().name = "mine";
    theirs.targets.front().name = "theirs";
    EXPECT_EQ(mergedNotebook(base, mine, theirs).targets, mine.targets);
    EXPECT_EQ(mergedNotebook(base, base, theirs).targets, theirs.targets);
    EXPECT_EQ(mergedNotebook(base, mine, {}).targets, mine.targets);
    EXPECT_EQ(mergedNotebook(base, {}, theirs).targets, theirs.targets);
    // The other window renumbered what this one named meanwhile.
    const Notebook renumbered = notebookOf({{1, 9}, {2, 5}});
    EXPECT_EQ(mergedNotebook(base, mine, renumbered).targets.front().number, 2);
    EXPECT_EQ(mergedNotebook(base, mine, renumbered).targets.size(), 2U);
}

TEST(Notebook, AnUndoneStepLeavesWhatAnotherWindowAdded) {
    const Notebook before = notebookOf({{1, 5}}), after = notebookOf({{1, 5}, {2, 6}});
    const auto undone = [&](const Notebook& value, const Notebook& now) {
        return withOthers(value, value == after ? before : after, now).targets;
    };
    EXPECT_EQ(undone(before, after), before.targets);
    EXPECT_EQ(undone(before, notebookOf({{1, 5}, {3, 6}, {2, 7}})), notebookOf({{1, 5}, {2, 7}}).targets);
    EXPECT_EQ(undone(after, notebookOf({{1, 5}, {2, 7}})), notebookOf({{1, 5}, {3, 6}, {2, 7}}).targets);
    Notebook known = after; // the rows of the card came after the pin
    known.targets.back().asPinned = {{"Distance", "5 m"}};
    EXPECT_EQ(undone(before, known), before.targets);
}

TEST(Notebook, OfAnotherScanIsRefused) {
    const std::string text = notebookText(someNotebook(), kThis);
    for (const NotebookScan& other : {NotebookScan{std::string(64, 'b'), "bell", 20, 30}, NotebookScan{kThis.sha256, "sweep 2", 20, 30},
                                      NotebookScan{kThis.sha256, "bell", 30, 20}}) {
        const auto read = notebookFromText(text, other, "here");
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().sentence(), "here: these targets were picked on another scan; move the file away to begin a new one.");
        EXPECT_NE(notebookFileName(other), "");
    }
    EXPECT_NE(notebookFileName(kThis), notebookFileName({kThis.sha256, "sweep 2", 20, 30}));
    EXPECT_EQ(notebookFileName({"", "live", 20, 30}), "") << "what is of no file is not kept";
}

TEST(Notebook, HostileContentIsRefusedWithASentence) {
    using Json = nlohmann::json;
    const Json whole = *parseJson(notebookText(someNotebook(), kThis), "");
    const auto refused = [&](const std::function<void(Json&)>& change) {
        Json changed = whole;
        change(changed);
        const auto read = notebookFromText(changed.dump(), kThis, "here");
        EXPECT_FALSE(read) << changed.dump();
        if (!read) {
            EXPECT_LT(read.error().sentence().size(), 400U);
        }
    };
    refused([](Json& j) { j["format"] = "edgescan-targets/2"; });
    refused([](Json& j) { j["measures"].back().erase("shares"); });
    refused([](Json& j) { j["measures"].back()["shares"] = {0.25, 1.5}; });
    refused([](Json& j) { j["measures"].front()["shares"] = {0.25, 0.5}; });
    refused([](Json& j) { j["more"] = 1; });
    refused([](Json& j) { j["scan"]["more"] = 1; });
    refused([](Json& j) { j["targets"][0]["more"] = 1; });
    refused([](Json& j) { j["targets"] = "none"; });
    refused([](Json& j) { j["targets"][1]["number"] = 1; }); // twice
    refused([](Json& j) { j["targets"][0]["number"] = 0; });
    refused([](Json& j) { j["targets"][0]["number"] = 1.5; });
    refused([](Json& j) { j["targets"][0]["name"] = std::string(61, 'n'); });
    refused([](Json& j) { j["targets"][0]["cell"] = {20, 0}; });
    refused([](Json& j) { j["targets"][0]["cell"] = {-1, 0}; });
    refused([](Json& j) { j["targets"][0]["cell"] = {0.5, 0}; });
    refused([](Json& j) { j["targets"][0]["cell"] = 4; });
    refused([](Json& j) { j["targets"][0].erase("cell"); });
    refused([](Json& j) { j["targets"][0]["locked"] = "yes"; });
    refused([](Json& j) { j["targets"][0]["pinned_utc"] = "yesterday"; });
    refused([](Json& j) { j["targets"][0]["as_pinned"] = {{"a", 3}}; });
    refused([](Json& j) { j["targets"][0]["as_pinned"] = {{"a", std::string(500, 'v')}}; });
    refused([](Json& j) {
        j["targets"][0]["as_pinned"] = Json::array();
        for (int n = 0; n < 41; ++n) j["targets"][0]["as_pinned"].push_back({"a", "b"});
    });
    refused([](Json& j) {
        for (int n = 8; n < 300; ++n) {
            j["targets"].push_back(j["targets"][1]);
            j["targets"].back()["number"] = n;
        }
    });
    refused([](Json& j) { j["measures"][0]["kind"] = "volume"; });
    refused([](Json& j) { j["measures"][0]["number"] = 2; }); // that of the next one
    refused([](Json& j) { j["measures"][3]["number"] = 0; });
    refused([](Json& j) { j["measures"][0]["cells"].erase(0); });
    refused([](Json& j) { j["measures"][0]["cells"][0] = {0, 30}; });
    refused([](Json& j) { j["scan"].erase("lines"); });
    for (const char* text : {"", "[]", "null", "{\"format\": 3}", "{"}) EXPECT_FALSE(notebookFromText(text, kThis, "here")) << text;
    EXPECT_FALSE(notebookFromText(std::string(100'000, '['), kThis, "here"));
    EXPECT_FALSE(notebookFromText("{\"a\":\"" + std::string(2'000'000, 'x') + "\"}", kThis, "here"));
}

TEST(Notebook, DamageNeverReadsAsSomethingElseThanANotebook) {
    const std::string text = notebookText(someNotebook(), kThis);
    std::mt19937 random(11);
    int taken = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = text;
        for (int n = 0; n < 1 + round % 3; ++n) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        const auto read = notebookFromText(damaged, kThis, "here");
        if (!read) continue;
        ++taken;
        for (const PinnedTarget& target : read->targets) EXPECT_LT(target.cell, 600U);
        for (const StoredMeasure& measure : read->measures) {
            EXPECT_EQ(measure.cells.size(), traitsOf(measure.kind).cells);
            for (const std::uint32_t k : measure.cells) EXPECT_LT(k, 600U);
        }
    }
    EXPECT_GT(taken, 0);
}

} // namespace
} // namespace edgescan::inspect
