// Computes the true edges of a scan of meshes.
#include "app/lab/stones/stone_truth.h"

#include "app/lab/sim/sweep.h"
#include "app/lab/sim/truth/thin.h"
#include "app/lab/stones/creases.h"
#include "app/lab/stones/smooth_normals.h"
#include "core/base/angles.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::lab {
namespace {

using sim::EdgeClass;

constexpr float kJumpM = 0.05F, kWeakJumpM = 0.02F;
constexpr double kContactDeg = 15.0;
constexpr std::size_t kSmallestStone = 25; // cells
constexpr double kUsualCellDeg = 0.2;

/// Not a steep surface, whose steps are all alike.
bool isStep(const CellGap& gap, float least) { return gap.largestM > least && gap.largestM > 4 * gap.thirdM + 0.005F; }

TrueCells cellsOf(const sim::SimulationTruth& truth, const Scan& angles, int finer) {
    const int lines = truth.object.lines, beams = truth.object.beams;
    TrueCells cells{{lines, beams}, {lines, beams, Eigen::Vector3d::Zero().eval()}, radians(kUsualCellDeg / finer), finer};
    const CartesianTables tables(angles);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const std::size_t k = truth.object.index(i, j);
            if (truth.object[k] == 0) continue;
            cells.body[k] = 256U * truth.object[k] + truth.face[k];
            cells.pointM[k] = tables.direction(i, j) * (0.001 * static_cast<double>(truth.cleanMm[k]));
        }
    }
    return cells;
}

struct Marks {
    Grid<std::uint8_t> edgeClass; ///< EdgeClass, before it is thinned
    Grid<std::uint8_t> unsure;
    Grid<std::uint8_t> blocked; ///< next to an end of a surface

    void mark(std::size_t k, EdgeClass wanted) {
        constexpr std::array<int, 5> kRank{0, 4, 2, 1, 3};
        if (kRank[static_cast<std::size_t>(wanted)] > kRank[edgeClass[k]]) edgeClass[k] = static_cast<std::uint8_t>(wanted);
    }
};

void judgePairOfCells(std::size_t a, std::size_t b, const CellGap& gap, const TrueCells& cells, const Grid<float>& cleanMm,
                      const Grid<Eigen::Vector3f>& normals, Marks& marks) {
    const bool hitA = cells.body[a] != 0, hitB = cells.body[b] != 0;
    if (hitA != hitB) marks.mark(hitA ? a : b, EdgeClass::Void);
    const bool both = hitA && hitB;
    const bool jump = both && isStep(gap, kJumpM);
    const bool weak = both && !jump && isStep(gap, kWeakJumpM);
    const bool other = cells.body[a] != cells.body[b];
    if (jump || weak || other || gap.open) marks.blocked[a] = marks.blocked[b] = 1;
    if (!both) return;
    const std::size_t nearer = cleanMm[a] <= cleanMm[b] ? a : b;
    if (jump) return marks.mark(nearer, EdgeClass::Occluding);
    if (other) {
        const double cosine = std::clamp(static_cast<double>(normals[a].dot(normals[b])), -1.0, 1.0);
        if (weak || gap.open || degrees(std::acos(cosine)) > kContactDeg) return marks.mark(nearer, EdgeClass::Contact);
    }
    const bool steep = !weak && gap.largestM > kJumpM;
    if (other || weak || steep) marks.unsure[a] = marks.unsure[b] = 1;
}

Grid<std::uint8_t> smallStones(const Grid<std::uint16_t>& object) {
    std::vector<std::size_t> count(65536);
    for (const std::uint16_t number : object.cells) ++count[number];
    Grid<std::uint8_t> small(object.lines, object.beams);
    for (std::size_t k = 0; k < small.size(); ++k) small[k] = object[k] >= sim::kFirstRock && count[object[k]] < kSmallestStone ? 1 : 0;
    return small;
}

Marks marksOf(const TrueCells& cells, const Grid<float>& cleanMm, const Grid<Eigen::Vector3f>& normals, const CellGaps& gaps) {
    const int lines = cleanMm.lines, beams = cleanMm.beams;
    Marks marks{{lines, beams}, {lines, beams}, {lines, beams}};
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const std::size_t k = cleanMm.index(i, j), below = k + static_cast<std::size_t>(beams);
            if (cells.body[k] == 0) marks.blocked[k] = 1;
            if (j + 1 < beams) judgePairOfCells(k, k + 1, gaps.toNextBeam[k], cells, cleanMm, normals, marks);
            if (i + 1 < lines) judgePairOfCells(k, below, gaps.toNextLine[k], cells, cleanMm, normals, marks);
        }
    }
    return marks;
}

/// Thins the classes, and leaves out what is not scored.
sim::EdgeTruth finished(const Marks& marks, const Creases& creases, const sim::SimulationTruth& truth) {
    const int lines = marks.edgeClass.lines, beams = marks.edgeClass.beams;
    Grid<std::uint8_t> any(lines, beams), absorbed(lines, beams);
    for (std::size_t k = 0; k < any.size(); ++k) {
        any[k] = marks.edgeClass[k] != 0 ? 255 : 0;
        absorbed[k] = truth.absorbed[k] != 0 && truth.object[k] != 0 ? 1 : 0;
    }
    const Grid<std::uint8_t> thin = sim::thinned(any), besideEdges = grown(any, 2);
    const Grid<std::uint8_t> small = smallStones(truth.object), besideSmall = grown(small, 1), besideAbsorbed = grown(absorbed, 2);
    sim::EdgeTruth edges{{lines, beams}, {lines, beams}};
    Grid<std::uint8_t> unsure(lines, beams);
    for (std::size_t k = 0; k < any.size(); ++k) {
        const bool left = small[k] != 0 || absorbed[k] != 0;
        if (thin[k] != 0 && !left) edges.edgeClass[k] = marks.edgeClass[k];
        const bool weak = creases.weak[k] != 0 && besideEdges[k] == 0;
        unsure[k] = marks.unsure[k] != 0 || weak || besideSmall[k] != 0 || besideAbsorbed[k] != 0 ? 1 : 0;
    }
    // An edge within two cells may be that of the place that is not sure. A definite edge is scored even there.
    const Grid<std::uint8_t> besideUnsure = grown(unsure, 2);
    for (std::size_t k = 0; k < any.size(); ++k) edges.ignore[k] = besideUnsure[k] != 0 && edges.edgeClass[k] == 0 ? 255 : 0;
    return edges;
}

} // namespace

sim::TruthSet stoneTruth(const sim::Scene& scene, const sim::Simulation& simulation, const sim::SimulationSettings& settings, int finer) {
    const sim::SimulationTruth& truth = *simulation.truth;
    Scan angles;
    angles.geometry = sim::trueAngles(settings, std::get<PolarGeometry>(simulation.scan.geometry), false);
    const TrueCells cells = cellsOf(truth, angles, finer);
    const CellGaps gaps = cellGaps(scene, std::get<PolarGeometry>(angles.geometry), truth.cleanMm, settings);
    const Grid<Eigen::Vector3f> normals = smoothNormals(cells, settings.threads);
    Marks marks = marksOf(cells, truth.cleanMm, normals, gaps);
    const Creases creases = creasesOf(cells, normals, grown(marks.blocked, 1));
    for (std::size_t k = 0; k < marks.edgeClass.size(); ++k) {
        if (creases.sharp[k] != 0) marks.mark(k, EdgeClass::Crease);
    }
    return {finished(marks, creases, truth), truth.object, sim::wholeMm(truth.cleanMm)};
}

} // namespace edgescan::lab
