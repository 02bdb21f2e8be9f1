// The rims of visible surfaces: no depth jump along an outline, and no cell of something behind the rock.
#include "core/rocks/attributes/outlines.h"
#include "core/rocks/attributes/rock_columns.h"
#include "core/rocks/attributes/visible_surface.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace edgescan::rocks {
namespace {

struct Rims {
    std::size_t spikes = 0, vertices = 0, elsewhere = 0; // spikes: steps of more than 0.5 m; elsewhere: on another true object
    double longestStepM = 0;
};

Rims rimsOf(const Study& study, const Grid<std::uint32_t>& labels, const sim::SimulationTruth& truth) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const CartesianTables tables(scan);
    const Grid<std::uint32_t> all = rockLabels(*study.segmentation, study.map);
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> objects;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k] != 0) ++objects[all[k]][truth.object[k]];
    }
    Rims rims;
    const auto rings = outlinesOf(labels, study.map.rocks);
    for (std::uint32_t label = 1; label <= study.map.rocks; ++label) {
        const auto& counts = objects[label];
        const auto most = std::ranges::max_element(counts, {}, [](const auto& each) { return each.second; });
        for (const OutlineRing& ring : rings[label]) {
            std::vector<std::uint32_t> cells;
            std::ranges::copy_if(ring.inside, std::back_inserter(cells),
                                 [&](std::uint32_t k) { return scan.state[k] == CellState::Valid; });
            for (std::size_t n = 0; n < cells.size() && cells.size() > 2; ++n) {
                const double step = (tables.point(cells[n]) - tables.point(cells[(n + 1) % cells.size()])).norm();
                rims.longestStepM = std::max(rims.longestStepM, step);
                rims.spikes += step > 0.5 ? 1 : 0;
                rims.elsewhere += truth.object[cells[n]] != most->first ? 1 : 0;
                ++rims.vertices;
            }
        }
    }
    return rims;
}

TEST(VisibleSurfaces, OutlinesHaveNoVertexAcrossADepthJump) {
    for (const std::uint64_t seed : {77U, 78U}) {
        const test::RockScene scene = test::rockScene("hangup", seed, 240, 274);
        const Study study = studyRocks(rockInputs(*edges::detectEdges(scene.scan, edges::Settings{}, edges::KeepFor::Rocks)), {});
        ASSERT_GT(study.rocks.size(), 20U);
        const Grid<std::uint32_t> visible = visibleSurfaces(*study.segmentation, study.map);
        const Rims before = rimsOf(study, rockLabels(*study.segmentation, study.map), scene.truth);
        const Rims now = rimsOf(study, visible, scene.truth);
        EXPECT_GT(before.spikes, 10U) << "the scene has cells behind its rocks";
        EXPECT_EQ(now.spikes, 0U) << now.longestStepM << " m, before " << before.longestStepM << " m in " << before.spikes;
        EXPECT_LT(4 * now.elsewhere * before.vertices, before.elsewhere * now.vertices)
            << now.elsewhere << " of " << now.vertices << ", before " << before.elsewhere << " of " << before.vertices;
        std::map<std::uint32_t, std::size_t> left;
        for (std::size_t k = 0; k < visible.size(); ++k) left[visible[k]] += 1;
        for (const Rock& rock : study.rocks) EXPECT_GT(left[rock.label], rock.cells / 2) << "rock " << rock.label;
    }
}

TEST(RockColumns, KeysAreUniqueAndNameTheFrame) {
    for (const CoordinateFrame frame : {CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine}) {
        std::set<std::string> keys;
        for (const RockColumn& column : rockColumns(frame)) {
            EXPECT_TRUE(keys.insert(column.key).second) << column.key;
            EXPECT_EQ(column.title != nullptr, column.text != nullptr) << column.key;
            EXPECT_NE(column.value, nullptr) << column.key;
            EXPECT_FALSE(std::string(column.help).empty()) << column.key;
        }
        EXPECT_EQ(keys.contains("x_m"), frame == CoordinateFrame::Scanner);
        EXPECT_EQ(keys.contains("east_m"), frame == CoordinateFrame::MineLocal);
        EXPECT_EQ(keys.contains("easting_m"), frame == CoordinateFrame::Mine);
    }
}

} // namespace
} // namespace edgescan::rocks
