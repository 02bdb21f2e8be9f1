// Files that a version of 20 November 2026 handled wrongly (../shared/data/hostile): each is refused, or opened with a warning.
// tests/unit/files/formats/promises_test.cpp makes files of these kinds, too, for clones without ../shared.
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/scan.h"
#include "tests/support/seed_files.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

const std::filesystem::path kHostile = edgescan::test::sharedFolder() / "data/hostile";

/// The expected text for a file; empty: it opens, and the fault was elsewhere (compare, a terminal).
const std::map<std::string, std::string> kSaid{
    {"eight_lines.json", ""},
    {"eight_lines.u16", ""},
    {"f_04.tif", "promises more pixels than a file"},
    {"false_starts_5kB.mcap", "promises to unpack to 62.9 MB"},
    {"g_200x1.json", ""},
    {"g_200x1.u16", ""},
    {"g_format_1.json", "not \"edgescan-raw-grid/1\""},
    {"m_crc_bad.mcap", "its checksum does not fit"},
    {"m_esc_meta.mcap", ""},
    {"m_zstd_trunc.mcap", "zstd"},
    {"mt_offset_huge.mcap", "which no scanner uses"},
    {"n_bomb_small.png", "promises more pixels than a file"},
    {"p_18.pcd", "which is more"},
    {"p_36.pcd", "is not ascii, binary or binary_compressed"},
    {"p_42.pcd", "the header promises 600 points, and more text follows them here"},
    {"plcut.las", "records behind the points cannot be read"},
    {"two_sweeps.mcap", "The recording holds 2 sweeps"},
    {"x_06.ptx", "there are more"},
    {"x_10.ptx", "not a place on earth"},
};

} // namespace

TEST(HostileFiles, EachIsRefusedOrTakenWithAWord) {
    EDGESCAN_NEEDS_SHARED("data/hostile");
    std::set<std::string> seen;
    for (const auto& entry : std::filesystem::directory_iterator(kHostile)) {
        const std::string name = entry.path().filename().string();
        if (name == "README.md") continue;
        seen.insert(name);
        const std::string extension = entry.path().extension().string();
        ReadingOptions options;
        if (extension == ".png" || extension == ".tif") options = seedOptions();
        const auto scan = openAsAsked(entry.path(), options);
        std::string said = scan ? std::string() : scan.error().sentence();
        if (scan) {
            for (const std::string& warning : scan->warnings) said += warning + " ";
        }
        const auto expected = kSaid.find(name);
        if (expected == kSaid.end()) continue; // a newer one: it did not crash
        if (expected->second.empty())
            EXPECT_TRUE(scan) << name << ": " << said;
        else
            EXPECT_NE(said.find(expected->second), std::string::npos) << name << ": " << said;
    }
    for (const auto& [name, words] : kSaid) EXPECT_TRUE(seen.contains(name)) << name << " is not there";
}

TEST(HostileFiles, ASweepOfARecordingIsChosen) {
    EDGESCAN_NEEDS_SHARED("data/hostile");
    const std::filesystem::path file = kHostile / "two_sweeps.mcap";
    const auto usual = openAsAsked(file);
    ASSERT_TRUE(usual) << usual.error().sentence();
    int same = 0;
    for (const std::size_t n : {0U, 1U}) {
        ReadingOptions options;
        options.scanIndex = n;
        const auto chosen = openAsAsked(file, options);
        ASSERT_TRUE(chosen) << chosen.error().sentence();
        same += chosen->rangeMm.cells == usual->rangeMm.cells ? 1 : 0;
    }
    EXPECT_EQ(same, 1) << "the other one has other ranges";
    ReadingOptions beyond;
    beyond.scanIndex = 2;
    const auto none = openAsAsked(file, beyond);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().sentence().find("use --scan 0 to 1"), std::string::npos) << none.error().sentence();
}
