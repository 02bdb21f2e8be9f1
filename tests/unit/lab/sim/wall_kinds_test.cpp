// The kinds of wall: each differs from the plain one, is background everywhere, and follows from the seed.
#include "app/lab/sim/simulate.h"
#include "app/lab/sim/wall_kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace edgescan::sim {
namespace {

Simulation swept(const std::string& scene, const std::string& kind, int rocks = 0) {
    SimulationSettings settings;
    settings.scene = scene;
    settings.wallKind = kind;
    settings.lines = 60;
    settings.beams = 80;
    settings.rocks = rocks;
    settings.truth = true;
    Result<Simulation> result = simulate(settings);
    EXPECT_TRUE(result) << (result ? "" : result.error().sentence());
    return result ? std::move(*result) : Simulation{};
}

TEST(WallKinds, TheFirstIsTheWallOfBefore) {
    EXPECT_STREQ(wallKinds().front().name, "plain");
    EXPECT_EQ(SimulationSettings{}.wallKind, wallKinds().front().name);
    EXPECT_EQ(wallKindNamed("granite"), nullptr);
}

TEST(WallKinds, EachIsBackgroundAndHasASurfaceOfItsOwn) {
    std::set<std::vector<float>> seen;
    for (const WallKind& kind : wallKinds()) {
        // The muck is on the ground, which is in view in the scene pile.
        const std::string scene = kind.groundM != nullptr ? "pile" : "empty";
        const Simulation sweep = swept(scene, kind.name);
        EXPECT_TRUE(seen.insert(sweep.scan.rangeMm.cells).second) << kind.name;
        const std::size_t hits = static_cast<std::size_t>(std::ranges::count(sweep.truth->object.cells, kWallObject));
        EXPECT_EQ(hits + static_cast<std::size_t>(std::ranges::count(sweep.truth->object.cells, 0)), sweep.scan.cells()) << kind.name;
        EXPECT_GT(hits, sweep.scan.cells() / 2) << kind.name;
    }
    EXPECT_EQ(swept("empty", "blocky").scan.rangeMm, swept("empty", "blocky").scan.rangeMm);
    EXPECT_NE(swept("pile", "muck").scan.rangeMm, swept("pile", "plain").scan.rangeMm);
}

TEST(WallKinds, RocksJamInAllButTheTunnel) {
    for (const WallKind& kind : wallKinds()) {
        SimulationSettings settings;
        settings.wallKind = kind.name;
        settings.lines = 20;
        settings.beams = 30;
        settings.rocks = 60;
        settings.truth = true;
        const auto sweep = simulate(settings);
        EXPECT_EQ(static_cast<bool>(sweep), kind.archFits) << kind.name;
        if (!sweep) continue;
        EXPECT_GT(std::ranges::max(sweep->truth->object.cells), kWallObject) << kind.name;
    }
}

TEST(WallKinds, UnknownKindsAreRefusedWithTheList) {
    SimulationSettings settings;
    settings.wallKind = "granite";
    const auto refused = simulate(settings);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("plain, rough, blocky"), std::string::npos);
}

} // namespace
} // namespace edgescan::sim
