// Headings of other programs: the same points result with all names and additional columns, a guess is reported, and columns that are not
// x, y and z are refused with the right reason.
#include "core/files/open_save/open_scan.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct Heading {
    const char* names;
    const char* row; ///< x, y and z are replaced by coordinates, n by the row's number, i by a small integer
    double perMetre = 1;
};

std::string rowOf(const Heading& heading, const Eigen::Vector3d& point, std::size_t n) {
    std::string row;
    for (const char* c = heading.row; *c != '\0'; ++c) {
        if (*c >= 'x' && *c <= 'z')
            row += numberText("%.7f", point[*c - 'x'] * heading.perMetre);
        else if (*c == 'n')
            row += std::to_string(n);
        else if (*c == 'i')
            row += std::to_string(n * 7 % 90);
        else
            row += *c;
    }
    return row + "\n";
}

std::string listUnder(const Heading& heading, const std::vector<Eigen::Vector3d>& points) {
    std::string text = *heading.names == '\0' ? std::string() : std::string(heading.names) + "\n";
    for (std::size_t n = 0; n < points.size(); ++n) text += rowOf(heading, points[n], n + 5);
    return text;
}

class ColumnHeadings : public testing::Test {
protected:
    Result<Scan> opened(const Heading& heading) {
        writeText(folder_ / "list.csv", listUnder(heading, listOf(expected_, {})));
        return openScan(folder_ / "list.csv");
    }
    void expectSame(const Heading& heading) {
        const auto scan = opened(heading);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected_.rangeMm);
        EXPECT_EQ(scan->state, expected_.state);
    }
    static bool tellsOfColumns(const Scan& scan) {
        return std::ranges::any_of(scan.warnings, [](const std::string& w) { return w.find("were taken for") != w.npos; });
    }

    const Folder folder_;
    const Scan expected_ = makeScan({});
};

TEST_F(ColumnHeadings, OfOtherPrograms) {
    for (const Heading& heading : std::initializer_list<Heading>{
             {"OBJECTID,POINT_X,POINT_Y,POINT_Z", "n,x,y,z"},
             {"\"intensity\",\"Points:0\",\"Points:1\",\"Points:2\"", "i,x,y,z"},
             {"\"Points_m_XYZ:0\",\"Points_m_XYZ:1\",\"Points_m_XYZ:2\",azimuth,distance_m", "x,y,z,i,1.5"},
             {"TIMESTAMP (ns),RANGE (mm),X1 (mm),Y1 (mm),Z1 (mm)", "n,i,x,y,z", 1000},
             {"id,Easting (X),Northing (Y),Elevation (Z)", "n,x,y,z"},
             {"PTN,XPT,YPT,ZPT", "n,x,y,z"},
             {"time,field.x,field.y,field.z", "n,x,y,z"},
             {"intensity,cartesianX,cartesianY,cartesianZ", "i,x,y,z"},
             {"i,pos.z,pos.y,pos.x", "i,z,y,x"},
             {"id,Xmm,Ymm,Zmm", "n,x,y,z", 1000},
             {"X ('),Y ('),Z (')", "x,y,z", 1000 / 304.8},
             {"id;X [′];Y [′];Z [′]", "n;x;y;z", 1000 / 304.8},
             {"Easting (0.01 m),Northing (0.01 m),RL (0.01 m)", "x,y,z", 100},
             {"X (1/1000 m),Y (1/1000 m),Z (1/1000 m)", "x,y,z", 1000},
             {"PointID;Point X;Point Y;Point Z", "Pn;x;y;z"},
             {"Punkt,Rechtswert,Hochwert,H\xc3\xb6he", "n,x,y,z"},
             {"Punkt,Rechtswert,Hochwert,H\xf6he", "n,x,y,z"},
             {"id,Este,Norte,Elevaci\xc3\xb3n", "n,x,y,z"},
             {"id,Norte,Este,Cota", "n,y,x,z"},
         }) {
        SCOPED_TRACE(heading.names);
        expectSame(heading);
        const auto scan = opened(heading);
        EXPECT_FALSE(scan && tellsOfColumns(*scan));
    }
}

TEST_F(ColumnHeadings, WhatIsNoneOfThemIsNoCoordinate) {
    // The names of normals, origins and sizes end in x, y and z, too.
    expectSame({"nx,ny,nz,x,y,z", "0.1,0.2,0.97,x,y,z"});
    expectSame({"ori_x,ori_y,ori_z,x,y,z", "i,i,i,x,y,z"});
    expectSame({"normal_x,normal_y,normal_z,Points:0,Points:1,Points:2", "0.1,0.2,0.97,x,y,z"});
}

TEST_F(ColumnHeadings, AGuessIsReported) {
    for (const Heading& heading :
         std::initializer_list<Heading>{{"", "i x y z"}, {"column 1,column 2,column 3", "x,y,z"}, {"x,y,z", "x,y,z,0.5,0.5"}}) {
        SCOPED_TRACE(heading.names);
        const auto scan = opened(heading);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected_.rangeMm);
        EXPECT_TRUE(tellsOfColumns(*scan));
    }
}

TEST_F(ColumnHeadings, ARowOfUnitsBelowIsNoHeading) {
    for (const Heading& heading : std::initializer_list<Heading>{
             {"z,y,x\nm,m,m", "z,y,x"}, {"id;Z;Y;X\n-;[mm];[mm];[mm]", "n;z;y;x", 1000}, {"Z\tY\tX\n(m)\t(m)\t(m)", "z\ty\tx"}}) {
        SCOPED_TRACE(heading.names);
        expectSame(heading);
    }
    const auto scan = opened({"x,y,z,i\nm,m,m,-", "x,y,z,i"});
    ASSERT_TRUE(scan);
    EXPECT_FALSE(tellsOfColumns(*scan));
}

TEST_F(ColumnHeadings, OtherThingsThanPointsAreRefused) {
    const auto refused = [&](const Heading& heading, const std::string& what) {
        SCOPED_TRACE(heading.names);
        const auto scan = opened(heading);
        ASSERT_FALSE(scan);
        EXPECT_NE(scan.error().sentence().find(what), std::string::npos) << scan.error().sentence();
    };
    refused({"line,angle_deg,range_mm", "n,x,y"}, "angles and ranges");
    refused({"azimuth,distance", "x,y"}, "numbers where a point needs three");
    refused({"temperature,humidity,pressure", "x,y,z"}, "no x, y and z that are understood");
    refused({"start_n,start_e,start_rl,end_n,end_e,end_rl", "x,y,z,x,y,z"}, "names axes");
    refused({"Southing Westing RL q", "x y z x"}, "names axes");
    refused({"lat,lon,alt", "x,y,z"}, "degrees of latitude and longitude");
    refused({"x,y,intensity", "x,y,i"}, "two coordinates of a point and not the third");
    refused({"", "n,x,y,z,ROCK"}, "words among the numbers");
    refused({"x,y,z", "1,5,2,25,n,i"}, "decimal commas between commas");
    refused({"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float", "x y z x y z x y z"}, "a file of VTK");
    refused({"OFF\n3 0 0", "x y z"}, "an OFF mesh");
    refused({"ncols 6\nnrows 4", "x y z x y z"}, "a raster of heights");
}

} // namespace
