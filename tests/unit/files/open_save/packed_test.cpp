// Scans compressed with gzip, scans from pipes, and files of other programs.
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/containers/compression/chunks.h"
#include "core/containers/compression/gunzip.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/packed_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/seed_files.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

ReadingOptions packedOptions(const SeedFile& seed) {
    return seed.reader == "picture" || seed.reader == "range_csv" || seed.reader == "numpy" ? seedOptions() : ReadingOptions{};
}

} // namespace

TEST(Packed, EveryFormatOpensAsIfItWereNot) {
    for (const SeedFile& seed : seedFiles()) {
        if (seed.reader == "packed") continue; // compressed twice it is refused
        SCOPED_TRACE(seed.reader + seed.extension);
        const auto plain = readBytes(seed.bytes, seed.extension, packedOptions(seed));
        const std::string packed = gzipBytes(seed.bytes);
        const auto scan = readBytes(packed, seed.extension + ".gz", packedOptions(seed));
#ifndef EDGESCAN_WITH_TIFF
        if (seed.extension == ".tif") continue;
#endif
        ASSERT_TRUE(plain) << plain.error().sentence();
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, plain->rangeMm);
        EXPECT_EQ(scan->state, plain->state);
        EXPECT_EQ(scan->format, plain->format);
        if (seed.reader != "raw_grid") { // its hash is that of the counts
            EXPECT_EQ(scan->sha256, sha256Hex(std::as_bytes(std::span(packed)))) << "of the file as it lies there";
        }
        if (seed.extension != ".3d" && seed.reader != "range_csv") { // the content decides the format
            EXPECT_TRUE(readBytes(packed, ".whatever", packedOptions(seed)));
        }
    }
}

TEST(Packed, SeveralMembersAreOneFileAndTheNameIsThatOfTheScan) {
    const Folder folder;
    const Scan made = makeScan(ScanShape{});
    ASSERT_TRUE(saveScan(made, folder / "wall.pcd"));
    const std::string plain = readText(folder / "wall.pcd");
    std::string packed;
    for (std::size_t at = 0; at < plain.size(); at += 5000) packed += gzipBytes(plain.substr(at, 5000));
    writeText(folder / "wall.pcd.gz", packed + std::string(100, '\0')); // padded, as on tapes
    const auto scan = openScan(folder / "wall.pcd.gz");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, made.rangeMm);
    EXPECT_EQ(scan->name, "wall");
    EXPECT_FALSE(saveScan(made, folder / "other.pcd.gz")) << "nothing is written packed, so nothing may be called so";
}

TEST(Packed, DamageAndBombsAreRefused) {
    const std::string text = textOf(listOf(makeScan(ScanShape{}), {}), {});
    const std::string packed = gzipBytes(text);
    EXPECT_NE(refusalOf(packed.substr(0, packed.size() / 2), ".xyz.gz").find("end too early"), std::string::npos);
    std::string broken = packed;
    broken[broken.size() / 2] ^= 0x55;
    EXPECT_NE(refusalOf(broken, ".xyz.gz"), "");
    EXPECT_NE(refusalOf(packed + "trailing", ".xyz.gz").find("other bytes follow the packed data"), std::string::npos);
    EXPECT_NE(refusalOf(gzipBytes(packed), ".xyz.gz").find("a gzip archive in another one"), std::string::npos);
    EXPECT_NE(refusalOf(gzipBytes("1 2 3\n4 x 6\n"), ".xyz.gz").find("memory.xyz.gz (unpacked): line 2"), std::string::npos);
    // 64 MB of zeros in 64 kB: the output is limited by the size of the input.
    const std::string bomb = gzipBytes(std::string(std::size_t{64} << 20U, '\0'));
    ASSERT_LT(bomb.size(), 100'000U);
    EXPECT_NE(refusalOf(bomb, ".gz").find("far more than a scan of its size can be"), std::string::npos);
}

TEST(Packed, PipesAreReadToTheirEnd) {
    const Folder folder;
    const Scan made = makeScan(ScanShape{.lines = 80, .beamStart = 20});
    const std::string text = textOf(listOf(made, {}), {});
    ASSERT_GT(text.size(), 70'000U); // more than a pipe holds
    const auto pipe = folder / "pipe.xyz";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { writeText(pipe, text); });
    const auto scan = openScan(pipe);
    writer.join();
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, made.rangeMm);
}

TEST(Packed, APipeThatNobodyFillsCanBeGivenUp) {
    const Folder folder;
    const auto pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    ReadingOptions options;
    int asked = 0;
    options.progress = [&](const char*, double) { return ++asked < 5; };
    const auto scan = openScan(pipe, options);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().what, "cancelled");
}

TEST(Packed, UnpackingZstdIsCancelled) {
    const std::string zeros = zstdZeros(6);
    if (!containers::zstdSize(ByteView(reinterpret_cast<const std::uint8_t*>(zeros.data()), zeros.size()))) GTEST_SKIP();
    ReadingOptions options;
    int asked = 0;
    options.progress = [&](const char* stage, double) { return std::string_view(stage) != "unpacking" || ++asked < 3; };
    const Folder folder;
    writeText(folder / "zeros.xyz.zst", zeros);
    const auto scan = openScan(folder / "zeros.xyz.zst", options);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().what, "cancelled");
}

TEST(Packed, FilesOfOtherProgramsAreNamedWithWhatConvertsThem) {
    const std::string binary("\x01\x02\x00\x03 something", 14);
    struct Named {
        std::string bytes;
        const char* extension;
        const char* what;
        const char* hint;
    };
    for (const Named& named : {Named{binary, ".fls", "FARO scan", "FARO SCENE"}, Named{binary, ".rxp", "RIEGL", "RiSCAN PRO"},
                               Named{binary, ".rdbx", "RIEGL database", "LAS"}, Named{binary, ".zfs", "Z+F scan", "LaserControl"},
                               Named{binary, ".ZFPRJ", "Z+F project", "LaserControl"}, Named{binary, ".lgs", "Leica", "Cyclone"},
                               Named{binary, ".rcp", "ReCap", "E57"}}) {
        const std::string sentence = refusalOf(named.bytes, named.extension);
        EXPECT_NE(sentence.find(named.what), std::string::npos) << sentence;
        EXPECT_NE(sentence.find(named.hint), std::string::npos) << sentence;
    }
}
