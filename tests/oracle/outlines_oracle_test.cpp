// ezdxf and GDAL, independent readers, open the outlines of rocks: numbers and layers of a drawing, and lines in their coordinate system.
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/rock_files.h"
#include "core/rocks/attributes/study.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace edgescan;
using namespace edgescan::test;
using nlohmann::json;

namespace {

// The system's own Python has these packages; another one on the PATH may not have them.
bool isThere(const std::string& package) {
    return std::system(("/usr/bin/python3 -c 'import " + package + "' >/dev/null 2>&1").c_str()) == 0;
}

rocks::Study placedStudy(const std::string& grid) {
    Scan scan = *rockScene("hangup", 77, 160, 183).scan;
    auto placement = std::make_shared<Placement>(*randomPlacement(4, 1, true));
    placement->grid = grid;
    scan.placement = placement;
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(scan)), edges::Settings{}, edges::KeepFor::Rocks);
    return rocks::studyRocks(rocks::rockInputs(*detection), {});
}

json readBy(const std::string& script, const rocks::Study& study, const std::string& name) {
    const Folder folder;
    const auto bytes = exports::outlineBytes(study, CoordinateFrame::Mine, name, "{}");
    EXPECT_TRUE(bytes) << bytes.error().sentence();
    writeText(folder / name, *bytes);
    writeText(folder / "read.py", "import json, sys\n" + script + "\njson.dump(found, open(sys.argv[2], 'w'))\n");
    const std::string command = "/usr/bin/python3 " + (folder / "read.py").string() + " " + (folder / name).string() + " " +
                                (folder / "out.json").string() + " 2>" + (folder / "err").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << readText(folder / "err");
    return json::parse(readText(folder / "out.json"));
}

constexpr const char* kByEzdxf = R"(
import ezdxf
drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
space = drawing.modelspace()
found = {"faults": len(audit.errors) + len(audit.fixes), "numbers": [[t.dxf.layer, t.dxf.text] for t in space.query("TEXT")],
         "lines": [[p.dxf.layer, bool(p.is_closed), len(p.vertices)] for p in space.query("POLYLINE")]})";

constexpr const char* kByGdal = R"(
from osgeo import ogr
data = ogr.Open(sys.argv[1])
layer = data.GetLayer(0)
system = layer.GetSpatialRef()
found = {"code": system.GetAuthorityCode(None), "degrees": bool(system.IsGeographic()), "extent": layer.GetExtent(),
         "rocks": [[f.GetField("rock"), f.GetField("easting_m"), f.GetGeometryRef().GetGeometryName()] for f in layer]})";

} // namespace

TEST(EzdxfOracle, ReadsOutlinesAndNumbersOfRocks) {
    if (!isThere("ezdxf")) GTEST_SKIP() << "python3-ezdxf is not installed: no independent reader of DXF";
    const rocks::Study study = placedStudy("");
    const json read = readBy(kByEzdxf, study, "rocks.dxf");
    EXPECT_EQ(read["faults"], 0);
    ASSERT_EQ(read["numbers"].size(), study.rocks.size());
    for (std::size_t n = 0; n < study.rocks.size(); ++n)
        EXPECT_EQ(read["numbers"][n], json({"ROCK_NUMBERS", std::to_string(study.rocks[n].label)}));
    ASSERT_GE(read["lines"].size(), study.rocks.size());
    for (const json& line : read["lines"]) {
        EXPECT_TRUE(line[0] == "ROCKS" || line[0] == "ROCKS_DOUBTFUL") << line;
        EXPECT_TRUE(line[1].get<bool>());
        EXPECT_GE(line[2], 3);
    }
}

TEST(GdalOracle, ReadsOutlinesInTheirCoordinateSystem) {
    if (!isThere("osgeo")) GTEST_SKIP() << "python3-gdal is not installed: no independent reader of GeoJSON";
    for (const std::string grid : {"UTM 17N, WGS84", "Mine North 1987"}) {
        const rocks::Study study = placedStudy(grid);
        const json read = readBy(kByGdal, study, "rocks.geojson");
        EXPECT_EQ(read["code"], grid.starts_with("UTM") ? json("32617") : json());
        EXPECT_FALSE(read["degrees"].get<bool>()) << grid;
        ASSERT_EQ(read["rocks"].size(), study.rocks.size());
        EXPECT_EQ(read["rocks"][0][0], 1);
        EXPECT_EQ(read["rocks"][0][2], "MULTILINESTRING");
        for (const json& rock : read["rocks"]) {
            EXPECT_GE(rock[1], read["extent"][0]);
            EXPECT_LE(rock[1], read["extent"][1]);
        }
    }
}
