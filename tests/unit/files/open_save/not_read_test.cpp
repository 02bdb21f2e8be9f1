// Every reader says what of a file it did not read: a second array or page, an orientation, bytes behind the last record.
#include "core/files/recording/save_recording.h"
#include "tests/support/seed_files.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

std::vector<SeedFile> everyReader() {
    std::vector<SeedFile> seeds = seedFiles();
    const auto recording = recordingOf(makeScan({.lines = 6, .beams = 11, .beamStart = 20}), "seed");
    EXPECT_TRUE(recording);
    if (recording) seeds.push_back({"recording", ".mcap", std::string(recording->begin(), recording->end())});
#ifndef EDGESCAN_WITH_TIFF
    std::erase_if(seeds, [](const SeedFile& seed) { return seed.extension == ".tif"; });
#endif
    return seeds;
}

/// The warnings of `bytes` that the seed itself does not have. A refusal is one as well.
std::vector<std::string> newWarnings(const std::string& bytes, const SeedFile& seed) {
    const auto before = readBytes(seed.bytes, seed.extension, optionsOf(seed));
    EXPECT_TRUE(before) << before.error().sentence();
    const auto after = readBytes(bytes, seed.extension, optionsOf(seed));
    if (!after) return {after.error().sentence()};
    std::vector<std::string> warnings = after->warnings;
    std::erase_if(warnings, [&](const std::string& text) { return std::ranges::find(before->warnings, text) != before->warnings.end(); });
    return warnings;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += text + "\n";
    return all;
}

const SeedFile& seedOf(const std::vector<SeedFile>& seeds, const std::string& extension) {
    return *std::ranges::find(seeds, extension, &SeedFile::extension);
}

/// A TIFF entry of one 16-bit number.
std::string tiffEntry(std::uint16_t tag, std::uint16_t value) {
    std::string entry;
    putAt(entry, 0, tag);
    putAt(entry, 2, std::uint16_t{3});
    putAt(entry, 4, std::uint32_t{1});
    putAt(entry, 8, std::uint32_t{value});
    return entry;
}

/// The seed with one more entry in its directory, whose place is taken by a copy behind the pixels.
std::string withEntry(std::string tiff, const std::string& entry) {
    const auto at = valueAt<std::uint32_t>(tiff, 4);
    const auto entries = valueAt<std::uint16_t>(tiff, at);
    std::string directory = tiff.substr(at, 2 + 12U * entries + 4);
    directory.insert(2 + 12 * 6, entry); // in the order of the tags: behind 273
    putAt(directory, 0, static_cast<std::uint16_t>(entries + 1));
    putAt(tiff, 4, static_cast<std::uint32_t>(tiff.size()));
    return tiff + directory;
}

std::string pngChunk(const std::string& kind, const std::string& content) {
    const std::string body = kind + content;
    const auto bigEndian = [](std::uint32_t value) {
        std::string text;
        for (const unsigned shift : {24U, 16U, 8U, 0U}) text += static_cast<char>(value >> shift & 255U);
        return text;
    };
    const auto crc = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return bigEndian(static_cast<std::uint32_t>(content.size())) + body + bigEndian(static_cast<std::uint32_t>(crc));
}

} // namespace

TEST(NotRead, BytesBehindTheLastRecordAreReported) {
    for (const SeedFile& seed : everyReader()) {
        for (const std::string& tail : {std::string("\x07 more"), std::string("more text\n"), std::string(5000, '\x07')}) {
            SCOPED_TRACE(seed.reader + seed.extension + " of " + std::to_string(seed.bytes.size()) + " bytes, " +
                         std::to_string(tail.size()));
            EXPECT_FALSE(newWarnings(seed.bytes + tail, seed).empty());
        }
    }
}

TEST(NotRead, TheSameFileOnceMoreIsReported) {
    for (const SeedFile& seed : everyReader()) {
        if (seed.reader == "range_csv" || seed.reader == "capture") continue; // rows and telegrams go on
        SCOPED_TRACE(seed.reader + seed.extension + " of " + std::to_string(seed.bytes.size()) + " bytes");
        EXPECT_FALSE(newWarnings(seed.bytes + seed.bytes, seed).empty());
    }
}

TEST(NotRead, PaddingWithZerosIsSilent) {
    for (const SeedFile& seed : everyReader()) {
        const bool binary = seed.bytes.find('\0') != std::string::npos && seed.reader != "capture" && seed.reader != "raw_grid";
        if (!binary) continue;
        SCOPED_TRACE(seed.reader + seed.extension);
        const std::string page = seed.bytes + std::string(4096 - seed.bytes.size() % 4096, '\0');
        EXPECT_EQ(joined(newWarnings(page, seed)), "");
    }
}

TEST(NotRead, ASecondArrayIsReported) {
    const auto seeds = everyReader();
    const SeedFile array = seedOf(seeds, ".npy");
    EXPECT_NE(joined(newWarnings(array.bytes + array.bytes, array)).find("more than one array"), std::string::npos);
}

#ifdef EDGESCAN_WITH_TIFF
TEST(NotRead, ASecondPageAndAnOrientationOfATiffAreReported) {
    const auto seeds = everyReader();
    const SeedFile tiff = seedOf(seeds, ".tif");
    EXPECT_NE(joined(newWarnings(withEntry(tiff.bytes, tiffEntry(274, 6)), tiff)).find("orientation 6"), std::string::npos);
    EXPECT_EQ(joined(newWarnings(withEntry(tiff.bytes, tiffEntry(274, 1)), tiff)), "");
    std::string twoPages = tiff.bytes;
    const auto first = valueAt<std::uint32_t>(twoPages, 4);
    const std::size_t length = 2 + 12U * valueAt<std::uint16_t>(twoPages, first) + 4;
    putAt(twoPages, first + length - 4, static_cast<std::uint32_t>(tiff.bytes.size()));
    twoPages += tiff.bytes.substr(first, length);
    EXPECT_NE(joined(newWarnings(twoPages, tiff)).find("2 pictures"), std::string::npos);
}
#endif

TEST(NotRead, AnOrientationOfAPngIsReported) {
    const auto seeds = everyReader();
    const SeedFile png = seedOf(seeds, ".png");
    for (const int orientation : {1, 3, 8}) {
        std::string exif("II*\0\x08\0\0\0\x01\0", 10);
        exif += tiffEntry(274, static_cast<std::uint16_t>(orientation)) + std::string(4, '\0');
        std::string turned = png.bytes;
        turned.insert(8 + 25, pngChunk("eXIf", exif)); // behind the header
        const std::string warnings = joined(newWarnings(turned, png));
        EXPECT_EQ(warnings.find("orientation " + std::to_string(orientation)) != std::string::npos, orientation != 1) << warnings;
    }
    EXPECT_NE(joined(newWarnings(png.bytes.substr(0, png.bytes.size() - 12), png)).find("IEND"), std::string::npos);
}

TEST(NotRead, AMeshBehindTheVerticesIsReported) {
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 100\nproperty float x\nproperty float y\nproperty float z\n"
                            "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    std::string points;
    for (int n = 0; n < 100; ++n)
        points += numberText("%.3f", 3 + n % 7 * 0.1) + " " + numberText("%.3f", n * 0.013 - 2) + " " +
                  numberText("%.3f", n * 37 % 100 * 0.011) + "\n";
    const auto scan = readBytes(ply + points + "3 0 1 2\n", ".ply");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_NE(joined(scan->warnings).find("1 face"), std::string::npos) << joined(scan->warnings);
}
