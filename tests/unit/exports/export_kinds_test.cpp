// The table of exports: every content has its own row, and no two rows share a word.
#include "core/exports/export_kinds.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace edgescan::exports {
namespace {

TEST(ExportKinds, EveryContentHasItsOwnRow) {
    ASSERT_EQ(exportKinds().size(), static_cast<std::size_t>(ExportContent::End));
    for (const ExportKind& kind : exportKinds()) {
        EXPECT_EQ(&exportKind(kind.content), &kind);
        EXPECT_EQ(exportKindNamed(kind.record), &kind);
        EXPECT_NE(kind.make, nullptr);
        EXPECT_STRNE(countedThings(kind), "");
        EXPECT_STRNE(kind.tail, "");
        EXPECT_EQ(kind.window.menu == nullptr, kind.window.title == nullptr) << kind.key;
        EXPECT_EQ(kind.window.title == nullptr, kind.window.tail == nullptr) << kind.key;
        EXPECT_EQ(kind.flag == nullptr, kind.help == nullptr) << kind.key;
    }
    EXPECT_EQ(exportKindNamed("no such export"), nullptr);
}

TEST(ExportKinds, WordsAreUnique) {
    std::set<std::string> keys, records, flags;
    for (const ExportKind& kind : exportKinds()) {
        EXPECT_TRUE(keys.insert(kind.key).second) << kind.key;
        EXPECT_TRUE(records.insert(kind.record).second) << kind.record;
        if (kind.flag == nullptr) continue;
        EXPECT_TRUE(flags.insert((isOfRocks(kind.content) ? "rocks " : "detect ") + std::string(kind.flag)).second) << kind.flag;
    }
}

TEST(ExportKinds, NamesSayTheFrameOfCoordinatesAlone) {
    const auto name = [](ExportContent content, const char* extension) {
        return exportFileName(exportKind(content), extension, CoordinateFrame::MineLocal);
    };
    EXPECT_EQ(name(ExportContent::EdgeCloud, ".las"), "edges_OFFSET.las");
    EXPECT_EQ(name(ExportContent::EdgeImage, ".png"), "edges.png");
    EXPECT_EQ(name(ExportContent::RockOutlines, ".dxf"), "rocks_OFFSET.dxf");
    EXPECT_EQ(name(ExportContent::RockOutlines, ".geojson"), "rocks.geojson");
    EXPECT_EQ(name(ExportContent::RockPictureOutlines, ".json"), "picture-outlines.json");
    EXPECT_EQ(name(ExportContent::RockReport, ".json"), "rocks.json");
    EXPECT_EQ(name(ExportContent::RockHulls, ".obj"), "hulls_OFFSET.obj");
}

TEST(ExportKinds, AnExtensionThatNamesNoFormatIsRefused) {
    const auto check = [](ExportContent content, const char* path) { return checkExtension(exportKind(content), path, path, " or "); };
    EXPECT_TRUE(check(ExportContent::RockHulls, "a.OBJ"));
    EXPECT_TRUE(check(ExportContent::RockCloud, "a.las"));
    EXPECT_TRUE(check(ExportContent::EdgeImage, "a.png"));
    EXPECT_FALSE(check(ExportContent::EdgeImage, "a.anything"));
    EXPECT_FALSE(check(ExportContent::FullCloud, "a.png"));
    const auto refused = check(ExportContent::RockOutlines, "a.obj");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().sentence(), "a.obj: the extension names no format for this; use .dxf or .geojson.");
}

} // namespace
} // namespace edgescan::exports
