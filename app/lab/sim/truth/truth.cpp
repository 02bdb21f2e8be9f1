// Computes the ground truth of edges.
#include "app/lab/sim/truth/truth.h"

#include "app/lab/sim/scene.h"
#include "app/lab/sim/seam.h"
#include "app/lab/sim/truth/thin.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan::sim {
namespace {

constexpr double kJumpMm = 50.0; // from here on an occluding edge
constexpr double kContactDeg = 15.0;
constexpr double kCreaseDeg = 30.0;
constexpr std::size_t kSmallestRock = 25; // cells; smaller rocks are not scored
constexpr int kRoundPatches = 2;          // cells around an absorbing patch that are not scored
constexpr int kReach = 2;                 // cells between a detection and its edge; a wider fold has no definite position

enum class PairKind : std::uint8_t { Nothing, Occluding, Contact, Crease, Unsure };

double foldDeg(const SimulationTruth& truth, std::size_t a, std::size_t b) {
    const double cosine = std::clamp(static_cast<double>(truth.normal[a].dot(truth.normal[b])), -1.0, 1.0);
    return std::acos(cosine) * 180.0 / std::numbers::pi;
}

PairKind kindOf(const sim::Seam& seam, bool otherObject, bool round) {
    if (seam.tearMm > kJumpMm) return PairKind::Occluding;
    if (seam.tearMm > sim::kLeastTearMm) return PairKind::Unsure;
    if (otherObject) return seam.foldDeg > kContactDeg ? PairKind::Contact : PairKind::Nothing;
    if (seam.foldDeg > kCreaseDeg) return PairKind::Crease;
    if (round) return PairKind::Nothing; // see spreadFolds
    return seam.foldDeg > sim::kLeastFoldDeg ? PairKind::Unsure : PairKind::Nothing;
}

void dilate(Grid<std::uint8_t>& mask, int reach) {
    const Grid<std::uint8_t> before = mask;
    for (int i = 0; i < mask.lines; ++i) {
        for (int j = 0; j < mask.beams; ++j) {
            if (before.at(i, j) == 0) continue;
            for (int di = -reach; di <= reach; ++di) {
                for (int dj = -reach; dj <= reach; ++dj) {
                    if (mask.contains(i + di, j + dj)) mask.at(i + di, j + dj) = 255;
                }
            }
        }
    }
}

// Rocks too small to be visible, and the surroundings of absorbing patches.
Grid<std::uint8_t> notScored(const SimulationTruth& truth) {
    Grid<std::uint8_t> ignore(truth.object.lines, truth.object.beams);
    for (std::size_t k = 0; k < ignore.size(); ++k) ignore[k] = truth.absorbed[k] != 0 ? 255 : 0;
    dilate(ignore, kRoundPatches);
    std::vector<std::size_t> cells(65536);
    for (const std::uint16_t object : truth.object.cells) ++cells[object];
    Grid<std::uint8_t> small(ignore.lines, ignore.beams);
    for (std::size_t k = 0; k < small.size(); ++k) {
        if (truth.object[k] >= sim::kFirstRock && cells[truth.object[k]] < kSmallestRock) small[k] = 255;
    }
    dilate(small, 1);
    for (std::size_t k = 0; k < ignore.size(); ++k) ignore[k] |= small[k];
    return ignore;
}

struct MarkedCells {
    Grid<std::uint8_t> edgeClass;
    Grid<std::uint8_t> unsure;

    // The stronger class of a cell is used: jump, then contact, then crease.
    void mark(std::size_t k, EdgeClass wanted) {
        const auto rank = [](std::uint8_t c) { return c == 0 ? 0 : c == 4 ? 4 : 4 - c; };
        if (rank(static_cast<std::uint8_t>(wanted)) > rank(edgeClass[k])) edgeClass[k] = static_cast<std::uint8_t>(wanted);
    }
};

void judgePair(const SimulationTruth& truth, MarkedCells& marked, std::size_t a, std::size_t b, const sim::Seam& seam) {
    const bool hitA = truth.object[a] != 0;
    const bool hitB = truth.object[b] != 0;
    if (!hitA && !hitB) return;
    if (hitA != hitB) {
        marked.mark(hitA ? a : b, EdgeClass::Void);
        return;
    }
    const std::size_t nearer = truth.cleanMm[a] <= truth.cleanMm[b] ? a : b;
    switch (kindOf(seam, truth.object[a] != truth.object[b], truth.rounded[a] != 0 || truth.rounded[b] != 0)) {
    case PairKind::Nothing:
        return;
    case PairKind::Occluding:
        marked.mark(nearer, EdgeClass::Occluding);
        return;
    case PairKind::Contact:
        marked.mark(nearer, EdgeClass::Contact);
        return;
    case PairKind::Crease:
        marked.mark(nearer, EdgeClass::Crease);
        return;
    case PairKind::Unsure:
        marked.unsure[a] = marked.unsure[b] = 255;
        return;
    }
}

// Searches one row of cells of one rock for a rounded fold: it bends by a crease's angle over several cells, but by less from one cell to
// the next. Whether it is an edge, and at which cell, is undefined.
void markSpreadFolds(const SimulationTruth& truth, Grid<std::uint8_t>& spread, int line, int beam, int lineStep, int beamStep) {
    const std::size_t first = spread.index(line, beam);
    if (truth.object[first] < sim::kFirstRock) return;
    bool round = false;
    for (int n = 0; n <= 2 * kReach && spread.contains(line + n * lineStep, beam + n * beamStep); ++n) {
        const std::size_t k = spread.index(line + n * lineStep, beam + n * beamStep);
        if (truth.object[k] != truth.object[first]) return;
        round = round || truth.rounded[k] != 0;
        if (!round || n == 0 || foldDeg(truth, first, k) <= (n == 1 ? sim::kLeastFoldDeg : kCreaseDeg)) continue;
        for (int m = 0; m <= n; ++m) spread.at(line + m * lineStep, beam + m * beamStep) = 255;
        return;
    }
}

// Cells that are not scored because of rounded folds. Definite edges are scored, and so are cells next to an outline, because every round
// rock bends away from the scanner there.
Grid<std::uint8_t> spreadFolds(const SimulationTruth& truth, const Grid<std::uint8_t>& edgeClass) {
    Grid<std::uint8_t> spread(edgeClass.lines, edgeClass.beams);
    for (int i = 0; i < spread.lines; ++i) {
        for (int j = 0; j < spread.beams; ++j) {
            markSpreadFolds(truth, spread, i, j, 0, 1);
            markSpreadFolds(truth, spread, i, j, 1, 0);
        }
    }
    Grid<std::uint8_t> outline(spread.lines, spread.beams);
    for (std::size_t k = 0; k < spread.size(); ++k)
        outline[k] = edgeClass[k] != 0 && edgeClass[k] != static_cast<std::uint8_t>(EdgeClass::Crease) ? 255 : 0;
    dilate(outline, kReach);
    for (std::size_t k = 0; k < spread.size(); ++k) {
        if (edgeClass[k] != 0 || outline[k] != 0) spread[k] = 0;
    }
    return spread;
}

} // namespace

EdgeTruth edgeTruth(const SimulationTruth& truth) {
    const int lines = truth.object.lines;
    const int beams = truth.object.beams;
    MarkedCells marked{Grid<std::uint8_t>(lines, beams), Grid<std::uint8_t>(lines, beams)};
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const std::size_t k = truth.object.index(i, j);
            const auto next = static_cast<std::size_t>(beams);
            if (j + 1 < beams) judgePair(truth, marked, k, k + 1, truth.toNextBeam[k]);
            if (i + 1 < lines) judgePair(truth, marked, k, k + next, truth.toNextLine[k]);
        }
    }
    EdgeTruth result{std::move(marked.edgeClass), notScored(truth)};
    Grid<std::uint8_t> all(lines, beams);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = result.edgeClass[k] != 0 ? 255 : 0;
    const Grid<std::uint8_t> thin = thinned(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (thin[k] == 0) result.edgeClass[k] = 0;
    }
    const Grid<std::uint8_t> spread = spreadFolds(truth, result.edgeClass);
    for (std::size_t k = 0; k < all.size(); ++k) result.ignore[k] |= spread[k];
    // A definite edge is scored even next to an undefined one.
    dilate(marked.unsure, kReach);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (result.edgeClass[k] == 0) result.ignore[k] |= marked.unsure[k];
    }
    return result;
}

} // namespace edgescan::sim
