// PCD and PLY of every kind: encodings, types, extra fields, organised or not.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <liblzf/lzf.h>

#include <cmath>
#include <cstring>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

template <class T>
void append(std::string& bytes, T value, bool bigEndian = false) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (bigEndian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

std::string packed(const std::string& bytes) {
    std::string out(2 * bytes.size() + 64, '\0');
    out.resize(lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), out.data(), static_cast<unsigned>(out.size())));
    return out;
}

std::string header(std::size_t width, std::size_t height, const std::string& fields, const std::string& encoding,
                   const std::string& viewpoint = "0 0 0 1 0 0 0") {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "WIDTH " + std::to_string(width) + "\nHEIGHT " +
           std::to_string(height) + "\nVIEWPOINT " + viewpoint + "\nPOINTS " + std::to_string(width * height) + "\nDATA " + encoding + "\n";
}
const std::string kFloats = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
const std::string kMixed = "FIELDS label normal x y z _ rgba\nSIZE 2 4 8 8 8 1 4\nTYPE U F F F F U U\nCOUNT 1 3 1 1 1 5 1\n";

} // namespace

TEST(Pcd, PolarGridsOfEveryEncodingAreExact) {
    const Folder folder;
    const Scan expected = makeScan({});
    const auto points = listOf(expected, {});
    std::string ascii, binary, mixed, columns, wide;
    for (const auto& p : points) {
        ascii += numberText("%.7g", p.x()) + " " + numberText("%.7g", p.y()) + " " + numberText("%.7g", p.z()) + "\n";
        for (int a = 0; a < 3; ++a) append(binary, static_cast<float>(p[a]));
        append<std::uint16_t>(mixed, 7);
        for (int a = 0; a < 3; ++a) append(mixed, 0.5F);
        for (int a = 0; a < 3; ++a) append(mixed, p[a]);
        mixed.append(9, '\0');
    }
    for (int a = 0; a < 3; ++a) {
        for (const auto& p : points) append(columns, static_cast<float>(p[a]));
    }
    std::string compressed;
    append(compressed, static_cast<std::uint32_t>(packed(columns).size()));
    append(compressed, static_cast<std::uint32_t>(columns.size()));
    compressed += packed(columns);
    const std::size_t width = 60;
    const std::size_t height = 40;
    for (const bool organised : {true, false}) {
        const std::size_t w = organised ? width : width * height;
        const std::size_t h = organised ? height : 1;
        for (const auto& [name, text] :
             {std::pair("ascii", header(w, h, kFloats, "ascii") + ascii), std::pair("binary", header(w, h, kFloats, "binary") + binary),
              std::pair("mixed", header(w, h, kMixed, "binary") + mixed),
              std::pair("compressed", header(w, h, kFloats, "binary_compressed") + compressed)}) {
            SCOPED_TRACE(std::string(name) + (organised ? " organised" : ""));
            writeText(folder / "cloud.pcd", text);
            const auto scan = openScan(folder / "cloud.pcd");
            ASSERT_TRUE(scan) << scan.error().sentence();
            EXPECT_EQ(scan->rangeMm, expected.rangeMm);
            EXPECT_EQ(scan->state, expected.state);
            ASSERT_TRUE(std::holds_alternative<PolarGeometry>(scan->geometry));
            EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
        }
    }
}

TEST(Pcd, OrganisedCloudOfACameraKeepsItsPointsAndViewpoint) {
    const Folder folder;
    std::string bytes;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 16; ++j) {
            const bool missing = (i + j) % 5 == 0;
            const float z = missing ? NAN : 2.0F;
            for (const float v : {static_cast<float>(j - 8) * 0.01F * z, static_cast<float>(i - 6) * 0.01F * z, z}) append(bytes, v);
        }
    }
    writeText(folder / "camera.pcd", header(16, 12, kFloats, "binary", "0.5 0 0 1 0 0 0") + bytes);
    const auto scan = openScan(folder / "camera.pcd");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 12);
    EXPECT_EQ(scan->beams(), 16);
    const auto& points = std::get<PointGeometry>(scan->geometry);
    EXPECT_EQ(points.sensorM, Eigen::Vector3d(0.5, 0, 0));
    EXPECT_EQ(points.pointsM.at(6, 8), Eigen::Vector3d(0, 0, 2));
    EXPECT_NEAR(scan->rangeMm.at(6, 8), std::hypot(500.0, 2000.0), 1e-3);
    EXPECT_EQ(scan->state.at(0, 0), CellState::NoReturn);
    EXPECT_TRUE(std::isnan(points.pointsM.at(0, 0).x()));
}

// As PCL stores what a depth camera sees: labels and colours around the coordinates, and NaN where the camera measured nothing.
TEST(Pcd, ACloudOfADepthCameraWithLabelsAndColoursOpensAsItsGrid) {
    const Folder folder;
    std::string bytes;
    std::size_t measured = 0;
    for (int i = 0; i < 48; ++i) {
        for (int j = 0; j < 64; ++j) {
            const double x = (j - 31.5) / 55, y = (i - 23.5) / 55;
            const double off = x * x + y * y;
            const bool ball = off < 0.03;
            const bool shadow = !ball && off < 0.04;
            measured += shadow ? 0 : 1;
            const auto z = static_cast<float>(shadow ? NAN : ball ? 1.5 - std::sqrt(0.09 - 2.25 * off) : 2.5);
            append<std::uint32_t>(bytes, ball ? 1 : 0);
            for (const float v : {static_cast<float>(x) * z, static_cast<float>(y) * z, z}) append(bytes, v);
            append<std::uint32_t>(bytes, 0xFF804020U);
        }
    }
    const char* const fields = "FIELDS label x y z rgba\nSIZE 4 4 4 4 4\nTYPE U F F F U\nCOUNT 1 1 1 1 1\n";
    writeText(folder / "camera.pcd", header(64, 48, fields, "binary") + bytes);
    const auto scan = openScan(folder / "camera.pcd");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 48);
    EXPECT_EQ(scan->beams(), 64);
    EXPECT_TRUE(std::holds_alternative<PointGeometry>(scan->geometry));
    EXPECT_EQ(countCells(*scan)[0], measured);
}

TEST(Pcd, KinectCloudsOpenAsTheirGrid) {
    EDGESCAN_NEEDS_SHARED("data/mosd_kinect");
    for (const char* name : {"test16.pcd", "test55.pcd"}) {
        const auto scan = openScan(edgescan::test::sharedFolder() / "data/mosd_kinect" / name);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->lines(), 480);
        EXPECT_EQ(scan->beams(), 640);
        EXPECT_TRUE(std::holds_alternative<PointGeometry>(scan->geometry));
        EXPECT_GT(countCells(*scan)[0], 150000U);
    }
}

TEST(Pcd, SentencesSayWhatIsWrong) {
    const Folder folder;
    const auto refused = [&](const std::string& text, const char* expected) {
        writeText(folder / "cloud.pcd", text);
        const auto scan = openScan(folder / "cloud.pcd");
        ASSERT_FALSE(scan) << expected;
        EXPECT_NE(scan.error().sentence().find(expected), std::string::npos) << scan.error().sentence();
    };
    refused(header(10, 10, kFloats, "binary") + "short", "promises 100 points of 12 bytes and the file holds 5 bytes");
    refused(header(1000000000, 1000000000, kFloats, "binary") + "short", "more points than any file");
    refused(header(65536, 65535, kFloats, "binary") + "short", "the file holds 5 bytes");
    refused(header(10, 10, kFloats, "ascii") + "1 2 3\n", "promises 100 points");
    refused(header(2, 1, kFloats, "ascii") + "1 2 3\n4 5\n", "line 13: holds 2 numbers");
    refused(header(10, 10, kFloats, "zip"), "is not ascii");
    refused(header(10, 10, "FIELDS a b c\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n", "binary"), "no fields x, y and z");
    refused(header(10, 10, "FIELDS x y z\nSIZE 4 4\nTYPE F F F\nCOUNT 1 1 1\n", "binary"), "gives 2 sizes");
    refused(header(10, 10, "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nCOUNT 1 1 1\n", "binary"), "type or size");
    refused(header(10, 10, "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 18446744073709551615\n", "binary"), "type or size");
    refused(header(10, 10, kFloats, "binary_compressed") + std::string("\xff\xff\xff\xff\xb0\x04\x00\x00", 8), "compressed bytes");
    refused(header(0, 10, kFloats, "binary"), "no points");
    refused("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nWIDTH -5\n", "line 4: this header line");
    refused("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\n", "no DATA line");
}

TEST(Pcd, DamagedCompressedPointsAreRefused) {
    const Folder folder;
    const auto sentence = [&](const std::string& points) {
        std::string bytes = header(3, 1, kFloats, "binary_compressed");
        append(bytes, static_cast<std::uint32_t>(points.size()));
        append<std::uint32_t>(bytes, 36);
        writeText(folder / "cloud.pcd", bytes + points);
        const auto scan = openScan(folder / "cloud.pcd");
        return scan ? std::string() : scan.error().sentence();
    };
    // Twelve literal bytes, then 24 copied from twelve before; the copy overlaps itself.
    const std::string run = "\x0b" + std::string(12, 'a');
    EXPECT_EQ(sentence(run + "\xe0\x0f\x0b").find("the compressed points are damaged"), std::string::npos);
    for (const std::string& bad :
         {std::string(), run, run + "\xe0", run + "\xe0\x0f", run + "\xe0\x0f\x0c", run + "\xe0\x0e\x0b", run + "\xe0\x10\x0b"})
        EXPECT_NE(sentence(bad).find("the compressed points are damaged"), std::string::npos) << sentence(bad);
}

// PCL 1.15 and before write colours that are whole numbers with a fourth byte, and three of them into the header.
TEST(Ply, ColoursAsPclSavesThemWithAByteThatTheHeaderDoesNotName) {
    const Folder folder;
    const Scan expected = makeScan({});
    const auto points = listOf(expected, {});
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment PCL generated\nelement vertex " + std::to_string(points.size());
    text += "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double x\nproperty double y\nproperty double z\n";
    text += "element face 0\nelement camera 1\nproperty float view_px\nend_header\n";
    for (const auto& p : points) {
        append<std::uint32_t>(text, 0x00804020U);
        for (int a = 0; a < 3; ++a) append(text, p[a]);
    }
    append(text, 0.0F);
    writeText(folder / "cloud.ply", text);
    const auto scan = openScan(folder / "cloud.ply");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    EXPECT_TRUE(std::any_of(scan->warnings.begin(), scan->warnings.end(), [](const std::string& warning) {
        return warning.find("as PCL writes it behind colours") != std::string::npos;
    }));
    writeText(folder / "longer.ply", text + "x");
    EXPECT_FALSE(openScan(folder / "longer.ply"));
}

TEST(Ply, EncodingsAndExtraProperties) {
    const Folder folder;
    const Scan expected = makeScan({});
    const auto points = listOf(expected, {});
    for (const std::string encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        SCOPED_TRACE(encoding);
        const bool big = encoding == "binary_big_endian";
        std::string text = "ply\nformat " + encoding + " 1.0\ncomment made by hand\nobj_info 1\n";
        std::string body;
        if (encoding != "ascii") {
            text += "element camera 1\nproperty float f\n";
            append(body, 1.5F, big);
        }
        text += "element vertex " + std::to_string(points.size()) +
                "\nproperty uchar red\nproperty double x\nproperty double y\nproperty double z\nelement face 0\nproperty list uchar int "
                "vertex_indices\nend_header\n";
        for (const auto& p : points) {
            if (encoding == "ascii") {
                body += "7 " + numberText("%.9g", p.x()) + " " + numberText("%.9g", p.y()) + " " + numberText("%.9g", p.z()) + "\n";
                continue;
            }
            body += '\x07';
            for (int a = 0; a < 3; ++a) append(body, p[a], big);
        }
        writeText(folder / "cloud.ply", text + body);
        const auto scan = openScan(folder / "cloud.ply");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
        writeText(folder / "cut.ply", (text + body).substr(0, text.size() + body.size() / 2));
        EXPECT_FALSE(openScan(folder / "cut.ply"));
    }
}
