// The points of a whole line equal those of its cells one by one, bit by bit.
#include "core/scan/grid/cartesian.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace edgescan;
using namespace edgescan::test;

namespace {

template <class Number>
bool sameBits(const std::vector<Number>& line, int beam, double expected) {
    const auto rounded = static_cast<Number>(expected);
    return std::memcmp(&line[static_cast<std::size_t>(beam)], &rounded, sizeof rounded) == 0;
}

template <class Number>
void expectLinesAsCells(const Scan& scan) {
    const CartesianTables tables(scan);
    const auto beams = static_cast<std::size_t>(scan.beams());
    std::vector<Number> x(beams), y(beams), z(beams);
    for (int line = 0; line < scan.lines(); ++line) {
        tables.pointsOfLine(line, x.data(), y.data(), z.data());
        for (int beam = 0; beam < scan.beams(); ++beam) {
            const Eigen::Vector3d p = tables.point(line, beam);
            ASSERT_TRUE(sameBits(x, beam, p.x()) && sameBits(y, beam, p.y()) && sameBits(z, beam, p.z()))
                << "line " << line << " beam " << beam;
        }
    }
}

void expectBoth(const Scan& scan) {
    expectLinesAsCells<double>(scan);
    expectLinesAsCells<float>(scan);
}

} // namespace

TEST(PointsOfLine, AreThoseOfItsCells) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const int beams : {1, 2, 7, 16, 33, 181}) {
            Scan scan = makeScan({.axis = axis, .lines = 9, .beams = beams, .seed = 3});
            for (std::size_t k = 0; k < scan.cells(); k += 5) scan.state[k] = static_cast<CellState>(k % 3);
            expectBoth(scan);
            auto& polar = std::get<PolarGeometry>(scan.geometry);
            polar.lineDirection = -1;
            for (int j = 0; j < beams; ++j) polar.lineSkewDeg.push_back(0.01 * j);
            expectBoth(scan);
        }
    }
}

TEST(PointsOfLine, OfAnOrganisedCloudAreAsRead) {
    Scan scan = makeScan({.lines = 6, .beams = 20, .seed = 4});
    PointGeometry given;
    given.pointsM = Grid<Eigen::Vector3d>(6, 20, Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k < scan.cells(); ++k) given.pointsM[k] = {0.1 * static_cast<double>(k), 1e6 / 3, -static_cast<double>(k)};
    scan.geometry = given;
    scan.state[7] = CellState::NoReturn;
    expectBoth(scan);
}

// The tables of the last angles are stored.
TEST(PointsOfLine, FollowTheAnglesOfTheirScan) {
    const Scan scan = makeScan({.lines = 6, .beams = 20, .seed = 4});
    const auto changed = [&scan](auto change) {
        Scan other = scan;
        change(std::get<PolarGeometry>(other.geometry));
        return other;
    };
    const std::vector<Scan> scans{changed([](PolarGeometry& polar) { polar.beamDeg[3] += 0.25; }),
                                  scan,
                                  changed([](PolarGeometry& polar) { polar.lineDeg[2] -= 0.5; }),
                                  changed([](PolarGeometry& polar) { polar.lineDirection = -1; }),
                                  scan,
                                  changed([](PolarGeometry& polar) { polar.lineSkewDeg.assign(20, 0.125); })};
    for (const Scan& each : scans) {
        const CartesianTables tables(each);
        for (std::size_t k = 0; k < each.cells(); ++k) {
            if (each.state[k] == CellState::Valid) {
                ASSERT_LT((tables.point(k) - pointOfCell(each, k)).norm(), 1e-9) << "cell " << k;
            }
        }
    }
}
