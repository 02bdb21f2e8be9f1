// Finds seams between cells: on planes by their tangent planes, on meshes by rays in between.
#include "app/lab/sim/cell_seams.h"

namespace edgescan::sim {
namespace {

struct Cell {
    int line, beam;
};

TangentPlane planeOf(const SeamSources& sources, const SimulationTruth& truth, Cell cell, std::size_t k) {
    return {sources.aim[static_cast<std::size_t>(cell.beam % 2)]->direction(cell.line, cell.beam), static_cast<double>(truth.cleanMm[k]),
            truth.normal[k].cast<double>()};
}

// Without relief, because relief does not cause edges.
std::optional<TangentPlane> onFace(const SeamSources& sources, const Eigen::Vector3d& ray, std::uint16_t object, std::uint16_t face) {
    const RayBundle bundle = bundleAlong(ray, {});
    const BundleHits hits = sources.caster.cast(bundle);
    if (hits.surface[0] < 0) return std::nullopt;
    const Surface surface = surfaceOf(sources.scene, bundle, hits, 0);
    if (surface.object != object || surface.face != face) return std::nullopt;
    return TangentPlane{ray, 1000.0 * static_cast<double>(hits.distanceM[0]), surface.normal.cast<double>()};
}

Seam between(const SeamSources& sources, const SimulationTruth& truth, Cell cellA, Cell cellB) {
    const std::size_t a = truth.object.index(cellA.line, cellA.beam);
    const std::size_t b = truth.object.index(cellB.line, cellB.beam);
    const std::uint16_t object = truth.object[a];
    const std::uint16_t face = truth.face[a];
    if (object == 0 || truth.object[b] == 0) return {};
    const bool sameFace = object == truth.object[b] && face == truth.face[b];
    const bool rock = object >= kFirstRock;
    const bool round = truth.rounded[a] != 0 || truth.rounded[b] != 0;
    if (sameFace && rock && !round) return {};
    const TangentPlane planeA = planeOf(sources, truth, cellA, a);
    const TangentPlane planeB = planeOf(sources, truth, cellB, b);
    const Seam seam = seamBetween(planeA, planeB);
    if (!sameFace || rock || (seam.tearMm <= kLeastTearMm && seam.foldDeg <= kLeastFoldDeg)) return seam;
    const auto cast = [&](const Eigen::Vector3d& ray) { return onFace(sources, ray, object, face); };
    const std::optional<TangentPlane> bareA = cast(planeA.ray);
    const std::optional<TangentPlane> bareB = cast(planeB.ray);
    Seam onMesh = bareA && bareB ? seamOnMesh(*bareA, *bareB, cast) : seam;
    if (sources.measured) onMesh.foldDeg = 0;
    return onMesh;
}

} // namespace

void findSeams(const SeamSources& sources, int line, SimulationTruth& truth) {
    for (int beam = 0; beam < truth.object.beams; ++beam) {
        const std::size_t k = truth.object.index(line, beam);
        if (beam + 1 < truth.object.beams) truth.toNextBeam[k] = between(sources, truth, {line, beam}, {line, beam + 1});
        if (line + 1 < truth.object.lines) truth.toNextLine[k] = between(sources, truth, {line, beam}, {line + 1, beam});
    }
}

} // namespace edgescan::sim
