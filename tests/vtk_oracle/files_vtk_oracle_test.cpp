// VTK's readers read what we write, and we read what VTK's writers write. A program of its own: the core's tests link no VTK.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkDelimitedTextReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOBJWriter.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSimplePointsReader.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

using namespace edgescan;
using namespace edgescan::test;

namespace {

std::vector<Eigen::Vector3d> validPointsOf(const Scan& scan) {
    const CartesianTables tables(scan);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) points.push_back(tables.point(k));
    }
    return points;
}

void expectPoints(const std::vector<Eigen::Vector3d>& expected, vtkPoints* found, double tolerance) {
    ASSERT_NE(found, nullptr);
    ASSERT_EQ(static_cast<std::size_t>(found->GetNumberOfPoints()), expected.size());
    for (std::size_t n = 0; n < expected.size(); ++n) {
        Eigen::Vector3d p;
        found->GetPoint(static_cast<vtkIdType>(n), p.data());
        ASSERT_LT((p - expected[n]).norm(), tolerance) << n;
    }
}

vtkNew<vtkPolyData> polyDataOf(const std::vector<Eigen::Vector3d>& points) {
    vtkNew<vtkPoints> vtk;
    vtk->SetDataTypeToFloat();
    for (const Eigen::Vector3d& p : points) vtk->InsertNextPoint(p.data());
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk);
    return data;
}

} // namespace

TEST(VtkOracle, PlyReaderReadsOurClouds) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 21, .beams = 34});
    const auto expected = validPointsOf(scan);
    for (const bool ascii : {false, true}) {
        ASSERT_TRUE(saveCloud(scan, folder / "cloud.ply", nullptr, {ascii}));
        vtkNew<vtkPLYReader> reader;
        reader->SetFileName((folder / "cloud.ply").c_str());
        reader->Update();
        expectPoints(expected, reader->GetOutput()->GetPoints(), 1e-6);
    }
}

TEST(VtkOracle, ObjReaderReadsOurVertices) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 21, .beams = 34});
    Grid<std::uint8_t> mask(21, 34, 255);
    ASSERT_TRUE(saveCloud(scan, folder / "cloud.obj", &mask));
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName((folder / "cloud.obj").c_str());
    reader->Update();
    expectPoints(validPointsOf(scan), reader->GetOutput()->GetPoints(), 2e-6);
}

TEST(VtkOracle, TextReadersReadOurTablesAlsoInMineCoordinates) {
    const Folder folder;
    Scan scan = makeScan({.lines = 21, .beams = 34});
    ASSERT_TRUE(saveEdges(scan, Grid<std::uint8_t>(21, 34, 255), folder / "edges.csv"));
    vtkNew<vtkDelimitedTextReader> reader;
    reader->SetFileName((folder / "edges.csv").c_str());
    reader->SetFieldDelimiterCharacters(",");
    reader->SetHaveHeaders(true);
    reader->DetectNumericColumnsOn();
    reader->Update();
    vtkTable* table = reader->GetOutput();
    const auto expected = validPointsOf(scan);
    ASSERT_EQ(static_cast<std::size_t>(table->GetNumberOfRows()), expected.size());
    const char* const names[]{"x_m", "y_m", "z_m"};
    for (std::size_t n = 0; n < expected.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(table->GetValueByName(static_cast<vtkIdType>(n), names[axis]).ToDouble(), expected[n][axis], 1e-6);
    }
    EXPECT_NE(table->GetColumnByName("range_mm"), nullptr);
}

TEST(VtkOracle, WeReadWhatItsPlyWriterWrites) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 21, .beams = 34, .noReturns = 0});
    for (const int type : {VTK_ASCII, VTK_BINARY}) {
        for (const int order : {VTK_LITTLE_ENDIAN, VTK_BIG_ENDIAN}) {
            const auto data = polyDataOf(listOf(scan, {}));
            vtkNew<vtkPLYWriter> writer;
            writer->SetFileName((folder / "vtk.ply").c_str());
            writer->SetInputData(data);
            writer->SetFileType(type);
            writer->SetDataByteOrder(order);
            ASSERT_EQ(writer->Write(), 1);
            const auto opened = files::openScan(folder / "vtk.ply");
            ASSERT_TRUE(opened) << opened.error().sentence();
            EXPECT_EQ(opened->rangeMm, scan.rangeMm);
            EXPECT_EQ(opened->state, scan.state);
        }
    }
}

TEST(VtkOracle, WeReadWhatItsObjWriterWrites) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 21, .beams = 34, .noReturns = 0});
    const auto data = polyDataOf(listOf(scan, {}));
    vtkNew<vtkOBJWriter> writer;
    writer->SetFileName((folder / "vtk.obj").c_str());
    writer->SetInputData(data);
    writer->Write();
    const auto opened = files::openScan(folder / "vtk.obj");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(opened->rangeMm, scan.rangeMm);
    EXPECT_EQ(opened->state, scan.state);
}

TEST(VtkOracle, DoublesOfMineCoordinatesSurviveItsPlyReader) {
    // vtkPLYReader keeps points as floats: what it shows of mine coordinates is coarse, what it shows of local ones is exact. This is
    // why "local" is offered.
    const Folder folder;
    Scan scan = makeScan({.lines = 9, .beams = 14});
    scan.placement = randomPlacement(4, 1, true);
    ASSERT_TRUE(saveCloud(scan, folder / "local.ply", nullptr, {.frame = CoordinateFrame::MineLocal}));
    ASSERT_TRUE(saveCloud(scan, folder / "mine.csv", nullptr, {.frame = CoordinateFrame::Mine}));
    vtkNew<vtkPLYReader> local;
    local->SetFileName((folder / "local.ply").c_str());
    local->Update();
    vtkNew<vtkDelimitedTextReader> mine;
    mine->SetFileName((folder / "mine.csv").c_str()); // as it is: a header row and rows
    mine->SetFieldDelimiterCharacters(",");
    mine->SetHaveHeaders(true);
    mine->DetectNumericColumnsOn();
    mine->Update();
    const auto& origin = scan.placement->originEnhM;
    vtkTable* table = mine->GetOutput();
    ASSERT_EQ(table->GetNumberOfRows(), local->GetOutput()->GetNumberOfPoints());
    ASSERT_GT(table->GetNumberOfRows(), 50);
    for (vtkIdType n = 0; n < table->GetNumberOfRows(); ++n) {
        double p[3];
        local->GetOutput()->GetPoint(n, p);
        EXPECT_NEAR(table->GetValueByName(n, "easting_m").ToDouble(), origin.x() + p[0], 1e-3);
        EXPECT_NEAR(table->GetValueByName(n, "northing_m").ToDouble(), origin.y() + p[1], 1e-3);
        EXPECT_NEAR(table->GetValueByName(n, "elevation_m").ToDouble(), origin.z() + p[2], 1e-3);
    }
}
