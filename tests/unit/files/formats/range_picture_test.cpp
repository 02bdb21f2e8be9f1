// Range pictures: PNG by our own writer and by libpng's rules, TIFF as libtiff writes it.
#include "core/containers/png/png.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/range_image.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"
#include "tests/support/typed_angles.h"

#include <gtest/gtest.h>

#ifdef EDGESCAN_WITH_TIFF
#include <tiffio.h>
#endif

#include <numeric>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

void expectSameRanges(const Scan& expected, const Result<Scan>& scan) {
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    EXPECT_EQ(scan->state, expected.state);
    const auto counts = countCells(*scan);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), scan->cells());
}

#ifdef EDGESCAN_WITH_TIFF
struct TiffStyle {
    int compression = COMPRESSION_NONE;
    bool floats = false;
    const char* mode = "w";
    std::uint32_t rowsPerStrip = 7;
};
void writeTiff(const Scan& scan, const std::filesystem::path& path, const TiffStyle& style) {
    TIFF* tiff = TIFFOpen(path.c_str(), style.mode);
    ASSERT_NE(tiff, nullptr);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(scan.beams()));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(scan.lines()));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, style.floats ? 32 : 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, style.floats ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, style.compression);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, style.rowsPerStrip);
    for (int i = 0; i < scan.lines(); ++i) {
        std::vector<float> floats(scan.rangeMm.line(i), scan.rangeMm.line(i) + scan.beams());
        std::vector<std::uint16_t> whole(floats.begin(), floats.end());
        TIFFWriteScanline(tiff, style.floats ? static_cast<void*>(floats.data()) : whole.data(), static_cast<std::uint32_t>(i), 0);
    }
    TIFFClose(tiff);
}
#endif

} // namespace

TEST(RangePng, SavedRangesComeBack) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Scan scan = makeScan({.noReturns = 0.2 * seed, .seed = seed});
        ASSERT_TRUE(containers::savePng16(rangePicture(scan), folder / "range.png"));
        expectSameRanges(scan, openScan(folder / "range.png", typedAngles(scan)));
    }
}

TEST(RangePng, Lms511AnglesAreTakenForItsWidthAndOthersAreAskedFor) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 3, .beams = 1141, .beamStep = 0.1});
    ASSERT_TRUE(containers::savePng16(rangePicture(scan), folder / "range.png"));
    const auto opened = openScan(folder / "range.png");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_DOUBLE_EQ(std::get<PolarGeometry>(opened->geometry).beamDeg.front(), -5.0);
    EXPECT_EQ(opened->format, "range PNG");
    ASSERT_TRUE(containers::savePng16(rangePicture(makeScan({})), folder / "range.png"));
    const auto narrow = openScan(folder / "range.png");
    ASSERT_FALSE(narrow);
    EXPECT_NE(narrow.error().sentence().find("a picture of 60 ranges per line does not say its angles; give --beam-start"),
              std::string::npos)
        << narrow.error().sentence();
}

TEST(RangePng, OtherPicturesAreNamed) {
    const Folder folder;
    ASSERT_TRUE(containers::savePng8(Grid<std::uint8_t>(5, 1141, 9), folder / "mask.png"));
    const auto mask = openScan(folder / "mask.png");
    ASSERT_FALSE(mask);
    EXPECT_NE(mask.error().sentence().find("PNG picture of 8 bit gray, and ranges need 16 bit gray"), std::string::npos);
    ASSERT_TRUE(containers::savePng16(Grid<std::uint16_t>(50, 1141, 900), folder / "range.png"));
    const std::string png = readText(folder / "range.png");
    EXPECT_NE(refusalOf(png.substr(0, png.size() / 2), ".png").find("cannot be read"), std::string::npos);
    std::string lies = png;
    lies.replace(20, 4, std::string("\x7f\xff\xff\xff", 4)); // the height; the checksum of the header is wrong now, too
    EXPECT_FALSE(readBytes(lies, ".png"));
}

#ifdef EDGESCAN_WITH_TIFF
TEST(RangeTiff, EveryUsualKindOpens) {
    const Folder folder;
    const Scan scan = makeScan({});
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
        for (const bool floats : {false, true}) {
            for (const char* mode : {"wl", "wb", "wl8"}) {
                SCOPED_TRACE(std::to_string(compression) + (floats ? " floats " : " whole ") + mode);
                writeTiff(scan, folder / "range.tif", {compression, floats, mode});
                const auto opened = openScan(folder / "range.tif", typedAngles(scan));
                expectSameRanges(scan, opened);
                EXPECT_EQ(opened->format, "range TIFF");
            }
        }
    }
}

TEST(RangeTiff, DamageIsOneSentence) {
    const Folder folder;
    const Scan scan = makeScan({});
    writeTiff(scan, folder / "range.tif", {COMPRESSION_LZW});
    const std::string tiff = readText(folder / "range.tif");
    const ReadingOptions options = typedAngles(scan);
    for (std::size_t length = 5; length < tiff.size(); length += 97) {
        const std::string sentence = refusalOf(tiff.substr(0, length), ".tif", options);
        EXPECT_FALSE(sentence.empty()) << length;
    }
}
#endif
