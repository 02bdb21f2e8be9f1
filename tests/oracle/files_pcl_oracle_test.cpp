// PCL reads EdgeScan's files, and EdgeScan reads PCL's. Needs pcl_common and pcl_io.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>

#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

using namespace edgescan;
using namespace edgescan::test;

namespace {

void expectSamePoints(const Scan& scan, const pcl::PCLPointCloud2& message) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    pcl::fromPCLPointCloud2(message, cloud);
    ASSERT_EQ(cloud.size(), scan.cells());
    const CartesianTables tables(scan);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d expected = tables.point(k);
        if (scan.state[k] == CellState::Valid)
            EXPECT_EQ(cloud[k].getVector3fMap(), expected.cast<float>());
        else
            EXPECT_FALSE(pcl::isFinite(cloud[k]));
    }
}

} // namespace

TEST(PclOracle, ReadsOurPcdAndPly) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 11, .beams = 17});
    for (const bool ascii : {false, true}) {
        ASSERT_TRUE(files::saveScan(scan, folder / "scan.pcd", {ascii}));
        ASSERT_TRUE(files::saveScan(scan, folder / "scan.ply", {ascii}));
        pcl::PCLPointCloud2 pcd;
        ASSERT_EQ(pcl::PCDReader().read((folder / "scan.pcd").string(), pcd), 0);
        EXPECT_EQ(pcd.width, 17U);
        EXPECT_EQ(pcd.height, 11U);
        expectSamePoints(scan, pcd);
        pcl::PCLPointCloud2 ply;
        ASSERT_EQ(pcl::PLYReader().read((folder / "scan.ply").string(), ply), 0);
        expectSamePoints(scan, ply);
    }
}

TEST(PclOracle, ReadsOurEdgesWithTheirFields) {
    const Folder folder;
    const Scan scan = makeScan({.lines = 11, .beams = 17});
    Grid<std::uint8_t> mask(11, 17, 255);
    ASSERT_TRUE(saveEdges(scan, mask, folder / "edges.pcd"));
    ASSERT_TRUE(saveCloud(scan, folder / "cloud.pcd", &mask));
    pcl::PCLPointCloud2 edges;
    ASSERT_EQ(pcl::PCDReader().read((folder / "edges.pcd").string(), edges), 0);
    EXPECT_EQ(edges.width, countCells(scan)[0]);
    EXPECT_EQ(edges.fields.size(), 7U);
    pcl::PCLPointCloud2 cloud;
    ASSERT_EQ(pcl::PCDReader().read((folder / "cloud.pcd").string(), cloud), 0);
    EXPECT_EQ(cloud.fields[cloud.fields.size() - 2].name, "edge");
    pcl::PointCloud<pcl::PointXYZRGBA> coloured;
    pcl::fromPCLPointCloud2(cloud, coloured);
    for (const auto& point : coloured) EXPECT_TRUE(point.r == 0 && point.g == 255 && point.b == 0) << "every point is an edge here";
}

TEST(PclOracle, ReadsMineCoordinatesAsMetresWithTheSensorInTheViewpoint) {
    const Folder folder;
    Scan scan = makeScan({.lines = 11, .beams = 17});
    scan.placement = randomPlacement(4, 1, true);
    ASSERT_TRUE(saveCloud(scan, folder / "cloud.pcd", nullptr, {.frame = CoordinateFrame::Mine}));
    pcl::PCLPointCloud2 cloud;
    Eigen::Vector4f origin;
    Eigen::Quaternionf turn;
    int version = 0;
    ASSERT_EQ(pcl::PCDReader().read((folder / "cloud.pcd").string(), cloud, origin, turn, version), 0);
    pcl::PointCloud<pcl::PointXYZ> points;
    pcl::fromPCLPointCloud2(cloud, points);
    std::size_t n = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        EXPECT_LT((points[n++].getVector3fMap().cast<double>() - minePoint(scan, k).localM).norm(), 1e-4);
    }
    EXPECT_EQ(n, points.size());
    const Eigen::Vector3d sensor = PlacedPoints(scan).local(0, 0, Eigen::Vector3d::Zero());
    EXPECT_LT((origin.head<3>().cast<double>() - sensor).norm(), 1e-4);
}

TEST(PclOracle, OurReaderReadsWhatPclWrites) {
    const Folder folder;
    const Scan scan = makeScan({});
    const auto points = listOf(scan, {});
    pcl::PointCloud<pcl::PointXYZI> cloud(60, 40);
    for (std::size_t k = 0; k < points.size(); ++k) {
        cloud[k].getVector3fMap() = points[k].cast<float>();
        cloud[k].intensity = 0.5F;
    }
    const std::string path = (folder / "pcl.pcd").string();
    for (int encoding = 0; encoding < 4; ++encoding) {
        SCOPED_TRACE(encoding);
        std::string file = path;
        if (encoding == 0)
            pcl::io::savePCDFileASCII(path, cloud);
        else if (encoding == 1)
            pcl::io::savePCDFileBinary(path, cloud);
        else if (encoding == 2)
            pcl::io::savePCDFileBinaryCompressed(path, cloud);
        else {
            file = (folder / "pcl.ply").string();
            pcl::PLYWriter().write<pcl::PointXYZI>(file, cloud, true, false);
        }
        const auto opened = files::openScan(file);
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(opened->rangeMm, scan.rangeMm);
        EXPECT_EQ(opened->state, scan.state);
        EXPECT_EQ(std::get<PolarGeometry>(opened->geometry), std::get<PolarGeometry>(scan.geometry));
    }
}
