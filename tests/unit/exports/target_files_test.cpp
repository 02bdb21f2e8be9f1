// Targets as files: places in the frame that was asked for, names and notes as typed, and a record from which `verify` makes the file
// again.
#include "core/base/number_text.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/provenance.h"
#include "core/exports/target_files.h"
#include "core/exports/verify.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/cell_target.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <sstream>

namespace edgescan::test {
namespace {

using namespace exports;

struct Pinned {
    Folder folder;
    std::shared_ptr<const edges::Detection> detection;
    ExportOptions options;
};

/// Two cells with a range and one without, on a scan with a place or without.
void fill(Pinned& of, bool placed) {
    Scan scan = boxesScan(60, 90, 4, 0.05);
    if (placed) scan.placement = std::make_shared<const Placement>(*randomPlacement(3, 1, true));
    ASSERT_TRUE(files::saveScan(scan, of.folder / "scan.json"));
    of.detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(of.folder / "scan.json")), edges::Settings{});
    std::vector<std::uint32_t> valid, empty;
    for (std::uint32_t k = 0; k < scan.cells(); ++k) (scan.state[k] == CellState::Valid ? valid : empty).push_back(k);
    ASSERT_FALSE(empty.empty());
    TargetList targets(3);
    targets[0].name = "cl\xC3\xA9";
    targets[0].note = "loose, watch\nit";
    targets[0].cell = valid[100];
    targets[1].number = 4;
    targets[1].rock = 12;
    targets[1].cell = valid[2000];
    targets[2].number = 5;
    targets[2].name = "hole";
    targets[2].cell = empty.front();
    of.options.targets = std::make_shared<const TargetList>(targets);
    of.options.frame = placed ? CoordinateFrame::Mine : CoordinateFrame::Scanner;
}

TEST(TargetFiles, TableAndDrawingHaveThePlacesOfTheCardsInTheirFrame) {
    for (const bool placed : {false, true}) {
        Pinned on;
        fill(on, placed);
        const inspect::CellTarget known =
            inspect::targetAt(*on.detection, inspect::noiseOf(*on.detection), on.options.targets->front().cell);
        const Eigen::Vector3d place = placed ? *known.probe.mineM : known.probe.pointM;
        const auto table = exportWithProvenance(ExportContent::Targets, *on.detection, on.folder / "t.csv", on.options);
        ASSERT_TRUE(table) << table.error().sentence();
        EXPECT_EQ(table->count, 3U);
        EXPECT_EQ(table->coordinates->frame, on.options.frame);
        EXPECT_TRUE(table->coordinates->box.contains(place));
        const std::string csv = readText(on.folder / "t.csv");
        const std::string names = placed ? "easting_m,northing_m,elevation_m" : "x_m,y_m,z_m";
        EXPECT_TRUE(csv.starts_with("target,name,note,distance_m,tolerance_m," + names + ",line,beam,edge,pinned_utc,rock\n1,cl\xC3\xA9,"))
            << csv;
        for (int axis = 0; axis < 3; ++axis) EXPECT_NE(csv.find("," + fixedText(place[axis], 3) + ","), std::string::npos) << csv;
        // The digits of the table in the window: millimetres, with zeros at the end.
        const std::string measured = csv.substr(csv.find("\n4,") + 1);
        EXPECT_TRUE(measured.substr(0, measured.find('\n')).ends_with(",12")) << "its rock, also in verify below: " << measured;
        std::stringstream cells(measured.substr(0, measured.find('\n')));
        std::string cell;
        for (int n = 0; std::getline(cells, cell, ',') && n < 8; ++n)
            EXPECT_TRUE(n < 3 || (cell.size() > 4 && cell[cell.size() - 4] == '.')) << cell;
        EXPECT_NE(csv.find("\n5,hole,,,,,,,"), std::string::npos) << csv;
        EXPECT_NE(csv.find(",no edge,", csv.find("\n5,hole")), std::string::npos) << csv;

        const auto drawing = exportWithProvenance(ExportContent::Targets, *on.detection, on.folder / "t.dxf", on.options);
        ASSERT_TRUE(drawing) << drawing.error().sentence();
        EXPECT_EQ(drawing->count, 2U);
        const std::string dxf = readText(on.folder / "t.dxf");
        std::string at;
        for (int axis = 0; axis < 3; ++axis) at += std::to_string(10 * (axis + 1)) + "\n" + fixedText(place[axis], 4) + "\n";
        EXPECT_NE(dxf.find("POINT\n8\nTARGETS\n" + at), std::string::npos) << at;
        EXPECT_NE(dxf.find("\n1\n1 cl\\U+00E9\n"), std::string::npos);
        EXPECT_NE(dxf.find("\n1\nloose, watch it\n"), std::string::npos) << "a line break would end the group";
        EXPECT_NE(dxf.find("targets without a range are not in the drawing: 5\n"), std::string::npos);
        EXPECT_NE(dxf.find(placed ? "asting" : "scanner"), std::string::npos) << "the frame is in the file";
        for (const char* name : {"t.csv", "t.dxf"})
            EXPECT_TRUE(verifyExport(on.folder / name)->identical) << verificationText(*verifyExport(on.folder / name));
    }
}

TEST(TargetFiles, WithoutTargetsNothingIsWritten) {
    Pinned on;
    fill(on, false);
    ExportOptions none = on.options;
    none.targets = nullptr;
    EXPECT_FALSE(exportWithProvenance(ExportContent::Targets, *on.detection, on.folder / "t.csv", none));
    none.targets = std::make_shared<const TargetList>(TargetList{on.options.targets->back()});
    EXPECT_FALSE(exportWithProvenance(ExportContent::Targets, *on.detection, on.folder / "t.dxf", none)) << "nothing to draw";
    EXPECT_FALSE(std::filesystem::exists(on.folder / "t.dxf") || std::filesystem::exists(on.folder / "t.csv"));
}

} // namespace
} // namespace edgescan::test
