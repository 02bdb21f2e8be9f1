// DXF output, read by a small parser of group codes; and edges as chains.
#include "core/edges/settings/settings.h"
#include "core/files/formats/edge_chains.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct Entity {
    std::string kind;
    std::multimap<int, std::string> codes;
};
/// Pairs of a code line and a value line, as every DXF reader takes them.
std::vector<Entity> entitiesIn(const std::string& dxf) {
    std::vector<Entity> entities;
    std::istringstream in(dxf);
    std::string code;
    std::string value;
    std::string section;
    bool inSections = false;
    std::string lastValue;
    while (std::getline(in, code)) {
        EXPECT_TRUE(static_cast<bool>(std::getline(in, value)));
        const int number = std::stoi(code);
        if (number == 0) {
            inSections = value == "SECTION";
            if (section == "ENTITIES") entities.push_back({value, {}});
        } else if (number == 2 && inSections) {
            section = value;
        } else if (section == "ENTITIES" && !entities.empty()) {
            entities.back().codes.emplace(number, value);
        }
        lastValue = value;
    }
    EXPECT_EQ(lastValue, "EOF");
    return entities;
}

Eigen::Vector3d placeOf(const Entity& entity) {
    return {std::stod(entity.codes.find(10)->second), std::stod(entity.codes.find(20)->second), std::stod(entity.codes.find(30)->second)};
}

std::vector<EdgeCell> cellsOf(const std::vector<std::string>& picture, float rangeMm = 1000) {
    std::vector<EdgeCell> cells;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        for (std::size_t j = 0; j < picture[i].size(); ++j) {
            if (picture[i][j] != '.')
                cells.push_back(
                    {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), picture[i][j] == '#' ? rangeMm : 2 * rangeMm});
        }
    }
    return cells;
}

std::multiset<std::size_t> lengthsOf(const std::vector<std::vector<std::size_t>>& chains) {
    std::multiset<std::size_t> lengths;
    for (const auto& chain : chains) lengths.insert(chain.size());
    return lengths;
}

} // namespace

TEST(EdgeChains, LinesLoopsAndJunctions) {
    const auto lengths = [](const std::vector<std::string>& picture) { return lengthsOf(chainsOf(cellsOf(picture))); };
    using Lengths = std::multiset<std::size_t>;
    EXPECT_EQ(lengths({"#####"}), (Lengths{5}));
    EXPECT_EQ(lengths({"#....", ".#...", "..###"}), (Lengths{5}));
    EXPECT_EQ(lengths({"##.", ".##"}), (Lengths{4}));                     // steps, no triangles
    EXPECT_EQ(lengths({"###", "#.#", "###"}), (Lengths{9}));              // a ring repeats its first cell
    EXPECT_EQ(lengths({"#.#", ".#.", ".#.", ".#."}), (Lengths{2, 2, 3})); // a fork
    EXPECT_EQ(lengths({"#.#"}), (Lengths{}));
    EXPECT_EQ(lengths({"####oooo"}), (Lengths{4, 4})); // broken where the range jumps
    EXPECT_TRUE(chainsOf({}).empty());
}

TEST(EdgeChains, EveryLinkIsWalkedOnce) {
    std::mt19937 random(2);
    for (int round = 0; round < 50; ++round) {
        std::vector<EdgeCell> cells;
        for (std::uint32_t i = 0; i < 20; ++i) {
            for (std::uint32_t j = 0; j < 20; ++j) {
                if (random() % 3 == 0) cells.push_back({i, j, static_cast<float>(1000 + random() % 100)});
            }
        }
        std::set<std::pair<std::size_t, std::size_t>> links;
        for (const auto& chain : chainsOf(cells)) {
            ASSERT_GE(chain.size(), 2U);
            for (std::size_t n = 1; n < chain.size(); ++n) {
                const EdgeCell& a = cells[chain[n - 1]];
                const EdgeCell& b = cells[chain[n]];
                EXPECT_LE(std::abs(int(a.line) - int(b.line)), 1);
                EXPECT_LE(std::abs(int(a.beam) - int(b.beam)), 1);
                EXPECT_LE(std::abs(a.rangeMm - b.rangeMm), 50.0F);
                EXPECT_TRUE(links.insert(std::minmax(chain[n - 1], chain[n])).second);
            }
        }
    }
}

TEST(Dxf, EdgesArePointsAndPolylines) {
    const Scan scan = makeScan({.noReturns = 0});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (int j = 5; j < 25; ++j) mask.at(10, j) = 255;
    const auto bytes = edgeBytes(scan, mask, "edges.dxf");
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    const auto entities = entitiesIn(*bytes);
    const CartesianTables tables(scan);
    std::size_t points = 0;
    std::size_t vertices = 0;
    for (const Entity& entity : entities) {
        if (entity.kind == "POINT") {
            EXPECT_EQ(entity.codes.find(8)->second, "EDGE_POINTS");
            EXPECT_LE((placeOf(entity) - tables.point(10, 5 + static_cast<int>(points))).cwiseAbs().maxCoeff(), 0.000051);
            ++points;
        }
        if (entity.kind == "VERTEX") {
            EXPECT_EQ(entity.codes.find(70)->second, "32");
            ++vertices;
        }
        if (entity.kind == "POLYLINE") {
            EXPECT_EQ(entity.codes.find(66)->second, "1");
        }
    }
    EXPECT_EQ(points, 20U);
    EXPECT_GT(vertices, 0U);
    EXPECT_NE(bytes->find("AC1009"), std::string::npos);
    EXPECT_EQ(bytes->find("nan"), std::string::npos);
}

TEST(Dxf, CloudsSeparateLayersAndLeaveOutWhatIsNoPoint) {
    const Scan scan = makeScan({});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < mask.size(); k += 7) mask[k] = 255;
    std::map<std::string, std::size_t> expected;
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (scan.state[k] == CellState::Valid) ++expected[mask[k] != 0 ? "EDGE_POINTS" : "CLOUD"];
    }
    std::map<std::string, std::size_t> found;
    for (const Entity& entity : entitiesIn(*cloudBytes(scan, "cloud.dxf", &mask))) {
        if (entity.kind == "POINT") ++found[entity.codes.find(8)->second];
    }
    EXPECT_EQ(found, expected);
    const Folder folder;
    EXPECT_TRUE(saveScan(scan, folder / "scan.dxf"));
}

TEST(Dxf, EachClassOfEdgesHasItsLayers) {
    const Scan scan = makeScan({.noReturns = 0});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    Grid<edges::DepthEdge> classes(scan.lines(), scan.beams());
    std::map<std::string, std::size_t> expected;
    for (int j = 3; j < 24; ++j) {
        mask.at(10, j) = 255;
        classes.at(10, j) = j < 10 ? edges::DepthEdge::Jump : j < 17 ? edges::DepthEdge::Convex : edges::DepthEdge::Concave;
        ++expected[j < 10 ? "EDGE_POINTS_JUMP" : j < 17 ? "EDGE_POINTS_CONVEX" : "EDGE_POINTS_CONCAVE"];
    }
    SaveOptions options;
    options.classes = &classes;
    const auto bytes = edgeBytes(scan, mask, "edges.dxf", options);
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    std::map<std::string, std::size_t> points, vertices, plainVertices;
    for (const Entity& entity : entitiesIn(*bytes)) {
        if (entity.kind == "POINT") ++points[entity.codes.find(8)->second];
        if (entity.kind == "VERTEX") ++vertices[entity.codes.find(8)->second];
    }
    EXPECT_EQ(points, expected);
    for (const Entity& entity : entitiesIn(*edgeBytes(scan, mask, "edges.dxf"))) {
        if (entity.kind == "VERTEX") ++plainVertices[entity.codes.find(8)->second];
    }
    // Where the class changes, a line ends and the next begins at the same point.
    EXPECT_EQ(vertices["EDGE_LINES_JUMP"] + vertices["EDGE_LINES_CONVEX"] + vertices["EDGE_LINES_CONCAVE"],
              plainVertices["EDGE_LINES"] + 2);
    EXPECT_EQ(bytes->find("BORDER"), std::string::npos) << "no layer of a class that the scan does not have";
}
