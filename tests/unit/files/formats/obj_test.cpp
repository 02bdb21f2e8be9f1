// OBJ vertices, written and read.
#include "core/files/open_save/save_scan.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

std::string verticesOf(const Scan& scan) {
    std::string text = "# made by hand\nmtllib none.mtl\no Scan\n";
    for (const auto& p : listOf(scan, {})) {
        text += "v";
        for (int a = 0; a < 3; ++a) text += "  " + numberText("%.6f", p[a]);
        text += " 0.5 0.5 0.5\nvn 0 0 1\n";
    }
    return text + "f 1 2 3\n";
}

} // namespace

TEST(Obj, VerticesOpenAsTheirGrid) {
    const Scan expected = makeScan({});
    for (const char* extension : {".obj", ".txt"}) {
        const auto scan = readBytes(verticesOf(expected), extension);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->format, "OBJ");
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
    }
}

TEST(Obj, SavedScansFindTheirGridAgain) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Scan scan = makeScan({.beamStart = 20, .noReturns = 0.15 * seed, .seed = seed});
        ASSERT_TRUE(saveScan(scan, folder / "scan.obj"));
        const auto back = openScan(folder / "scan.obj");
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_EQ(back->rangeMm, scan.rangeMm);
        EXPECT_EQ(countCells(*back), countCells(scan));
        const auto counts = countCells(*back);
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), back->cells());
    }
}

TEST(Obj, EdgesHaveTheirVertices) {
    const Scan scan = makeScan({});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams(), 255);
    const auto bytes = edgeBytes(scan, mask, "edges.obj");
    ASSERT_TRUE(bytes);
    std::size_t vertices = 0;
    for (std::size_t at = bytes->find("\nv "); at != std::string::npos; at = bytes->find("\nv ", at + 1)) ++vertices;
    EXPECT_EQ(vertices, countCells(scan)[0]);
}

TEST(Obj, DamageIsNamedByLine) {
    EXPECT_NE(refusalOf("o x\nv 1 2 3\nv 1,5 2 3\n", ".obj").find("line 3: \"1,5\" has a decimal comma"), std::string::npos);
    EXPECT_NE(refusalOf("o x\nv 1 2 3\nv 1 2\n", ".obj").find("line 3: this vertex does not hold three numbers"), std::string::npos);
    EXPECT_NE(refusalOf("o x\nf 1 2 3\n", ".obj").find("no vertices"), std::string::npos);
    EXPECT_NE(refusalOf("v a b c\n", ".obj").find("line 1"), std::string::npos);
}
