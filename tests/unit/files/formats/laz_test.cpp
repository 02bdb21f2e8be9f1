// LAZ, compressed by LASzip itself, opens like the LAS it was made from; without LASzip it is refused with a sentence.
#include "core/files/open_save/save_scan.h"
#include "tests/support/bytes.h"
#include "tests/support/point_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

#ifdef EDGESCAN_WITH_LASZIP
#include <laszip/laszip_api.h>
#endif

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

#ifdef EDGESCAN_WITH_LASZIP

namespace {

/// Compresses a LAS file point by point.
void pack(const std::filesystem::path& las, const std::filesystem::path& laz) {
    laszip_POINTER reader = nullptr;
    laszip_POINTER writer = nullptr;
    ASSERT_EQ(laszip_create(&reader), 0);
    ASSERT_EQ(laszip_create(&writer), 0);
    laszip_BOOL compressed = 1;
    ASSERT_EQ(laszip_open_reader(reader, las.c_str(), &compressed), 0);
    EXPECT_EQ(compressed, 0);
    laszip_header* header = nullptr;
    ASSERT_EQ(laszip_get_header_pointer(reader, &header), 0);
    ASSERT_EQ(laszip_set_header(writer, header), 0);
    ASSERT_EQ(laszip_open_writer(writer, laz.c_str(), 1), 0);
    const laszip_U64 count = std::max<laszip_U64>(header->number_of_point_records, header->extended_number_of_point_records);
    laszip_point* point = nullptr;
    ASSERT_EQ(laszip_get_point_pointer(reader, &point), 0);
    for (laszip_U64 n = 0; n < count; ++n) {
        ASSERT_EQ(laszip_read_point(reader), 0);
        ASSERT_EQ(laszip_set_point(writer, point), 0);
        ASSERT_EQ(laszip_write_point(writer), 0);
    }
    EXPECT_EQ(laszip_close_writer(writer), 0);
    EXPECT_EQ(laszip_close_reader(reader), 0);
    laszip_destroy(reader);
    laszip_destroy(writer);
}

} // namespace

TEST(Laz, WhatLaszipPackedIsTheGridThatWasSaved) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 60, .beams = 90});
    ASSERT_TRUE(saveCloud(scan, folder / "cloud.las", nullptr)); // points only, without information about the grid
    pack(folder / "cloud.las", folder / "cloud.laz");
    EXPECT_LT(std::filesystem::file_size(folder / "cloud.laz"), std::filesystem::file_size(folder / "cloud.las"));
    const auto las = openScan(folder / "cloud.las");
    const auto laz = openScan(folder / "cloud.laz");
    ASSERT_TRUE(las) << las.error().sentence();
    ASSERT_TRUE(laz) << laz.error().sentence();
    EXPECT_EQ(laz->format, "LAZ");
    EXPECT_EQ(laz->rangeMm, las->rangeMm);
    EXPECT_EQ(laz->state, las->state);
    EXPECT_EQ(las->rangeMm, scan.rangeMm); // by the columns line, beam and range_mm, which both hold as extra bytes
    // Every byte of the file was read; what follows it is reported.
    const auto said = [](const auto& opened) {
        return std::ranges::any_of(opened->warnings, [](const auto& w) { return w.find("were not read") != std::string::npos; });
    };
    EXPECT_FALSE(said(laz));
    const auto longer = readBytes(readText(folder / "cloud.laz") + "twelve bytes", ".laz");
    ASSERT_TRUE(longer) << longer.error().sentence();
    EXPECT_TRUE(std::ranges::any_of(longer->warnings, [](const auto& w) { return w.starts_with("12 bytes behind "); }));
    // Truncated anywhere, it is refused; if only the table of chunks is missing, it opens completely.
    const std::string bytes = readText(folder / "cloud.laz");
    for (std::size_t cut = 10; cut < bytes.size(); cut += bytes.size() / 60) {
        const auto part = readBytes(bytes.substr(0, cut), ".laz");
        EXPECT_TRUE(!part || part->rangeMm == las->rangeMm) << cut;
    }
}

TEST(Laz, LaterReturnsAreAttachedAsThoseOfLas) {
    const Folder folder;
    Points all;
    for (const Eigen::Vector3d& p : listOf(makeScan({.lines = 24, .beams = 28}), {.keepMissing = false})) {
        all.push_back(p);
        all.emplace_back(p * 1.2);
    }
    std::string bytes = pointLas(all, 1e-6);
    for (std::size_t n = 0; n < all.size(); ++n) bytes[227 + 20 * n + 14] = static_cast<char>((n % 2 + 1) | 2U << 3U); // of two returns
    writeText(folder / "cloud.las", bytes);
    pack(folder / "cloud.las", folder / "cloud.laz");
    const auto las = openScan(folder / "cloud.las"), laz = openScan(folder / "cloud.laz");
    ASSERT_TRUE(las) << las.error().sentence();
    ASSERT_TRUE(laz) << laz.error().sentence();
    EXPECT_EQ(laz->rangeMm, las->rangeMm);
    EXPECT_EQ(laz->attached.size(), all.size() / 2);
}

#else

TEST(Laz, WithoutLaszipItIsRefusedInWords) {
    const Folder folder;
    ASSERT_TRUE(saveCloud(makeScan({}), folder / "cloud.las", nullptr));
    std::string bytes = readText(folder / "cloud.las");
    bytes[104] = static_cast<char>(bytes[104] | 0x80); // LAZ marks its point format in this way
    EXPECT_NE(refusalOf(bytes, ".laz").find("was made without LASzip"), std::string::npos) << refusalOf(bytes, ".laz");
}

#endif
