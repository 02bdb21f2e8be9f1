// ezdxf, an independent DXF library, reads the drawings that EdgeScan writes: points, layers, polylines, and its audit reports no fault.
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/cloud_columns.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace edgescan;
using namespace edgescan::test;
using nlohmann::json;

namespace {

// The system's own Python has this package; another one on the PATH may not have it.
bool ezdxfIsThere() { return std::system("/usr/bin/python3 -c 'import ezdxf' >/dev/null 2>&1") == 0; }

constexpr const char* kReader = R"(
import ezdxf, json, sys
drawing = ezdxf.readfile(sys.argv[1])
errors = [str(e) for e in drawing.audit().errors]
space = drawing.modelspace()
points = [[p.dxf.layer, *p.dxf.location] for p in space.query("POINT")]
lines = [[l.dxf.layer, bool(l.is_closed), [list(v.dxf.location) for v in l.vertices]] for l in space.query("POLYLINE")]
json.dump({"release": drawing.dxfversion, "units": drawing.units, "fixes": [str(e) for e in drawing.audit().fixes], "errors": errors, "points": points, "lines": lines, "layers": [l.dxf.name for l in drawing.layers]}, open(sys.argv[2], "w"))
)";

json readByEzdxf(const Folder& folder, const std::string& name) {
    writeText(folder / "read.py", kReader);
    const std::string command = "/usr/bin/python3 " + (folder / "read.py").string() + " " + (folder / name).string() + " " +
                                (folder / "out.json").string() + " 2>" + (folder / "err").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << readText(folder / "err");
    return json::parse(readText(folder / "out.json"));
}

} // namespace

TEST(EzdxfOracle, ReadsPointsLayersAndLines) {
    if (!ezdxfIsThere()) GTEST_SKIP() << "python3-ezdxf is not installed: no independent reader of DXF";
    const Folder folder;
    Scan scan = makeScan({.lines = 24, .beams = 31});
    scan.placement = randomPlacement(3, 1, true);
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
    ASSERT_GT(detection->edges->size(), 10U);
    for (const bool release2000 : {false, true}) {
        const CoordinateFrame coordinates = release2000 ? CoordinateFrame::Mine : CoordinateFrame::Scanner;
        const files::WritingChoices choices{.dxf2000 = release2000, .shortLines = release2000};
        ASSERT_TRUE(saveCloud(scan, folder / "cloud.dxf", detection->mask.get(),
                              {.frame = coordinates, .record = "{\"a\":1}", .choices = choices}));
        const json read = readByEzdxf(folder, "cloud.dxf");
        EXPECT_EQ(read["release"], release2000 ? "AC1015" : "AC1009");
        EXPECT_EQ(read["units"], 6) << "metres";
        EXPECT_EQ(read["fixes"], json::array());
        EXPECT_EQ(read["errors"], json::array());
        for (const char* layer : {"CLOUD", "EDGE_POINTS", "EDGE_LINES"}) EXPECT_NE(read["layers"].dump().find(layer), std::string::npos);
        const files::CloudColumns expected = files::validPoints(scan, detection->mask.get(), coordinates);
        ASSERT_EQ(read["points"].size(), expected.width);
        std::size_t edges = 0;
        for (std::size_t n = 0; n < expected.width; ++n) {
            for (int axis = 0; axis < 3; ++axis) {
                const double wanted = std::visit([&](const auto& v) { return static_cast<double>(v[n]); },
                                                 expected.columns[static_cast<std::size_t>(axis)].values);
                EXPECT_NEAR(read["points"][n][static_cast<std::size_t>(axis) + 1].get<double>(), wanted, 6e-5);
            }
            edges += read["points"][n][0] == "EDGE_POINTS" ? 1 : 0;
        }
        EXPECT_EQ(edges, detection->edges->size());
        EXPECT_GT(read["lines"].size(), 0U);
        for (const json& line : read["lines"]) {
            EXPECT_EQ(line[0], "EDGE_LINES");
            EXPECT_GE(line[2].size(), release2000 ? 2U : 3U);
        }
    }
}
