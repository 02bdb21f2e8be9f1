// The draw of scenes, and runs that are stopped and go on.
#include "app/lab/families/family_report.h"
#include "app/lab/families/scene_sources.h"
#include "app/lab/families/stored_scene.h"
#include "app/lab/sim/scene.h"
#include "tests/support/packed_files.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <fstream>
#include <set>

namespace edgescan::lab {
namespace {

Family smallBells() {
    return {.name = "small bells", .source = &kSimulator, .kind = "hangup", .variants = {{"small", [](sim::SimulationSettings& s) {
                                                                                              s.lines = 60;
                                                                                              s.beams = 80;
                                                                                          }}}};
}

FamilyRunSettings smallRun(const Family& family) {
    edges::Settings lower;
    lower.sensitivity = 1.3;
    FamilyRunSettings run;
    run.families = {&family};
    run.contestants = {{"default", "", edges::Settings{}}, {"sensitive", "", lower}};
    run.draw = {"a test", 3, false};
    return run;
}

std::string textOfRun(const FamilyRunSettings& run, const GoOn& goOn = {}) {
    const auto scored = runFamilies(run, goOn);
    return scored ? familiesJson(*scored, run.contestants).dump() : scored.error().what;
}

TEST(Families, SeedsAreStableAndDisjoint) {
    EXPECT_EQ(drawnSeed("a commit", "hangup", 0), 192356832377948U);
    std::set<std::uint64_t> seeds;
    for (const char* draw : {"a commit", "another"}) {
        for (const Family& family : families()) {
            for (std::size_t n = 0; n < 100; ++n) EXPECT_TRUE(seeds.insert(drawnSeed(draw, family.name, n)).second);
        }
    }
    EXPECT_LT(*seeds.rbegin(), 999'999'999'999'999U);
}

TEST(Families, EachFamilyThatCanBeMadeHasTenFreshScenesAndEveryVariant) {
    std::set<std::string> names;
    for (const Family& family : families()) {
        EXPECT_EQ(findFamily(family.name), &family);
        const auto orders = drawnScenes(family, {.text = "x"}, {.shared = "/nowhere"});
        if (family.source != &kSimulator) {
            EXPECT_FALSE(orders) << family.name;
            continue;
        }
        ASSERT_TRUE(orders) << family.name;
        EXPECT_GE(orders->size(), std::max<std::size_t>(10, family.variants.size()));
        for (const SceneOrder& order : *orders) EXPECT_TRUE(names.insert(order.name).second) << order.name;
    }
}

TEST(Families, AStoppedRunGoesOnFromTheStoreAndGivesTheSame) {
    const test::TemporaryFolder folder;
    const Family family = smallBells();
    FamilyRunSettings run = smallRun(family);
    const std::string whole = textOfRun(run);
    EXPECT_NE(whole.find("\"mean\""), std::string::npos) << whole;
    run.threads = 1;
    run.store = folder / "store";
    std::atomic<int> asked{0};
    EXPECT_EQ(textOfRun(run, [&asked] { return ++asked < 100; }), "stopped");
    run.threads = 3;
    EXPECT_EQ(textOfRun(run), whole);
    EXPECT_EQ(textOfRun(run, [] { return false; }), whole); // no scene is made again
    for (const auto& file : std::filesystem::directory_iterator(run.store)) std::ofstream(file.path()) << "{";
    EXPECT_EQ(textOfRun(run), whole); // damaged scores are made again
    run.program = "another";
    EXPECT_EQ(textOfRun(run, [] { return false; }), "stopped");
}

TEST(Families, RecordedFiguresThatFallAreNamed) {
    const Family family = smallBells();
    FamilyRunSettings run = smallRun(family);
    run.draw.fresh = 1;
    auto scored = runFamilies(run);
    ASSERT_TRUE(scored);
    nlohmann::json record = recordedFigures(*scored);
    const auto same = fallenFigures(*scored, record, "record");
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->empty());
    record["scenes"].begin().value()["outline"] = 1.0;
    EXPECT_EQ(fallenFigures(*scored, record, "record")->size(), 1U);
    record["scenes"]["bells that are gone"] = record["scenes"].begin().value();
    EXPECT_EQ(fallenFigures(*scored, record, "record")->size(), 2U);
    scored->front().scenes.front().name = "another scene";
    EXPECT_FALSE(fallenFigures(*scored, record, "record"));
}

TEST(Families, ARunReadsItsOwnJson) {
    const Family family = smallBells();
    const FamilyRunSettings run = smallRun(family);
    const auto scored = runFamilies(run);
    ASSERT_TRUE(scored);
    const nlohmann::json json = familiesJson(*scored, run.contestants);
    const auto before = namedScoresFrom(json, "default", "json");
    ASSERT_TRUE(before) << before.error().sentence();
    EXPECT_TRUE(verdictAgainst(*scored, 0, *before, {}).passes);
    EXPECT_FALSE(namedScoresFrom(json, "nobody", "json"));
    EXPECT_FALSE(namedScoresFrom(nlohmann::json::object(), "default", "json"));
    auto fewer = *scored;
    fewer.front().scenes.pop_back(); // the hardest scene could be left out
    EXPECT_FALSE(verdictAgainst(fewer, 0, *before, {}).passes);
}

std::string npy(const std::string& type, const std::string& shape, const std::string& numbers) {
    return test::npyBytes(test::npyHeader("'" + type + "'", false, "(" + shape + ")"), numbers);
}

TEST(Families, AStoredSceneHasItsTruth) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "scan.json") << R"({"format": "edgescan-raw-grid/1", "data": "scan.u16", "lines": 3, "beams": 4, "unit_mm": 1.0,
        "no_return": [0], "beam_deg": {"start": 50, "step": 1}, "line_deg": {"start": 0, "step": 1}, "axis": "sweep"})";
    std::ofstream(folder / "scan.u16") << std::string(24, '\x10');
    const auto store = [&folder](const std::string& gt, const std::string& shape) {
        std::ofstream(folder / "scan.npz") << test::zipBytes(
            {{"gt.npy", npy("|u1", shape, gt)},
             {"dc.npy", npy("|b1", shape, std::string("\1\0\0\0\0\0\0\0\0\0\0\0", 12))},
             {"obj.npy", npy("<i2", shape, std::string("\0\0\1\0\12\0\13\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 24))}},
            true);
        return storedScene(folder.path());
    };
    const std::string gt("\0\1\0\4\0\0\0\0\0\0\0\3", 12);
    const auto scene = store(gt, "3, 4");
    ASSERT_TRUE(scene) << scene.error().sentence();
    const std::vector<std::uint8_t> classes(gt.begin(), gt.end()), ignore{255, 0, 255, 0, 255, 255, 0, 0, 255, 0, 0, 0};
    EXPECT_EQ(scene->truth->edges.edgeClass.cells, classes);
    EXPECT_EQ(scene->truth->edges.ignore.cells, ignore);
    EXPECT_EQ(scene->truth->object.at(0, 1), sim::kWallObject);
    EXPECT_EQ(scene->truth->object.at(0, 3), sim::kFirstRock + 1);
    EXPECT_FALSE(store(gt, "4, 3"));
    EXPECT_FALSE(store(gt, "3, 5"));
    EXPECT_FALSE(store("\7" + gt.substr(1), "3, 4"));
}

TEST(Families, StoredScenesOfRealStonesAreRead) {
    EDGESCAN_NEEDS_SHARED("data/real_stones/scenes/polar_t01");
    const Family& polar = *findFamily("polar");
    const FamilyPlaces places{.shared = test::sharedFolder()};
    const auto orders = drawnScenes(polar, {}, places);
    ASSERT_TRUE(orders);
    const auto scene = makeScene(polar, orders->front(), places, {});
    ASSERT_TRUE(scene) << scene.error().sentence();
    const SceneScore score = sceneScore(*scene, {"default", "", edges::Settings{}});
    ASSERT_TRUE(score.edges);
    EXPECT_GT(score.edges->all.f(), 0.6);
}

} // namespace
} // namespace edgescan::lab
