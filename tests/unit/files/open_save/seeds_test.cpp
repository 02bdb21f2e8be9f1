// Every reader with data from memory: its seeds open, and damaged seeds give a valid scan or one sentence.
#include "tests/support/damage.h"
#include "tests/support/seed_files.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

void holdsSoundly(const std::string& bytes, const SeedFile& seed) {
    const auto scan = readBytes(bytes, seed.extension, optionsOf(seed));
    if (!scan) {
        const std::string sentence = scan.error().sentence();
        EXPECT_TRUE(sentence.ends_with(".")) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        return;
    }
    const auto counts = countCells(*scan);
    ASSERT_EQ(scan->state.size(), scan->cells());
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}),
              static_cast<std::size_t>(scan->lines()) * static_cast<std::size_t>(scan->beams()));
    for (std::size_t k = 0; k < scan->cells(); ++k) {
        if (scan->state[k] == CellState::Valid) {
            ASSERT_TRUE(std::isfinite(scan->rangeMm[k]));
        }
    }
    for (const AttachedPoint& point : scan->attached) ASSERT_LT(point.cell, scan->cells());
}

} // namespace

TEST(Seeds, EveryReaderHasSmallOnesThatOpen) {
    std::set<std::string> readers;
    for (const SeedFile& seed : seedFiles()) {
        SCOPED_TRACE(seed.reader + seed.extension);
#ifndef EDGESCAN_WITH_TIFF
        if (seed.extension == ".tif") continue;
#endif
        readers.insert(seed.reader);
        EXPECT_LT(seed.bytes.size(), 10000U);
        const auto scan = readBytes(seed.bytes, seed.extension, optionsOf(seed));
        ASSERT_TRUE(scan) << scan.error().sentence();
        holdsSoundly(seed.bytes, seed);
    }
#ifndef EDGESCAN_TESTS_SQLITE
    readers.insert("ros_database");
#endif
    EXPECT_EQ(readers, (std::set<std::string>{"capture", "e57", "las", "mcap", "numpy", "obj", "packed", "pcd", "picture", "ply", "ptx",
                                              "range_csv", "raw_grid", "ros_database", "surpac", "text"}));
}

TEST(Seeds, CutAnywhereTheyAreASoundScanOrOneSentence) {
    for (const SeedFile& seed : seedFiles()) {
        SCOPED_TRACE(seed.reader + seed.extension);
        const std::size_t stride = std::max<std::size_t>(1, seed.bytes.size() / 120);
        for (std::size_t length = 0; length < seed.bytes.size(); length += stride) holdsSoundly(seed.bytes.substr(0, length), seed);
    }
}

TEST(Seeds, DamagedTheyAreASoundScanOrOneSentence) {
    std::mt19937 random(17);
    for (const SeedFile& seed : seedFiles()) {
        SCOPED_TRACE(seed.reader + seed.extension);
        for (int round = 0; round < 150; ++round) holdsSoundly(damaged(seed.bytes, random, round), seed);
    }
}

TEST(Seeds, ReadingFromMemoryTouchesNoFile) {
    const Folder folder;
    const auto seeds = seedFiles();
    const auto grid = std::find_if(seeds.begin(), seeds.end(), [](const auto& seed) { return seed.reader == "raw_grid"; });
    const std::string description = grid->bytes.substr(0, grid->bytes.find('\0'));
    EXPECT_NE(refusalOf(description, ".json").find("holds 0 bytes where 6 lines x 11 beams need 132"), std::string::npos);
    EXPECT_NE(refusalOf("12", ".u16").find("counts alone"), std::string::npos);
}
