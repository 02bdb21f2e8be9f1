// The scene of a picture.
#include "ui/engine/linked_views/scene.h"

#include <algorithm>
#include <ranges>

namespace edgescan::ui {
namespace {

bool sameEdgeLook(const SceneState& a, const SceneState& b) {
    return a.byClass == b.byClass && a.colours == b.colours && a.bordered == b.bordered;
}

std::shared_ptr<const QImage> grayOf(const SceneState& state, const Picture& picture, const Scene* last) {
    if (!state.window) return picture.gray;
    if (last != nullptr && last->state.window == state.window) return last->gray;
    return std::make_shared<const QImage>(grayPicture(*picture.detection, state.window, picture.gray->height()));
}

std::shared_ptr<const QImage> edgeMapOf(const SceneState& state, const Picture& picture, const OverlayEdges* instead, const Scene* last) {
    if (instead != nullptr) return instead->map;
    if (!state.byClass || !picture.detection->classes) return picture.edges;
    if (last != nullptr && last->insteadNow() == nullptr && sameEdgeLook(last->state, state)) return last->edgeMap;
    return std::make_shared<const QImage>(classPicture(picture, state.colours));
}

std::shared_ptr<const QImage> overGrayOf(const SceneState& state, const Picture& picture, const OverlayEdges* instead, const Scene* last) {
    if (instead != nullptr) return state.edgesOverImage || !instead->overImageAsAsked ? instead->overImage : nullptr;
    if (!state.edgesOverImage) return nullptr;
    if (!state.byClass && state.colours == kUsualColours) return picture.overlay;
    if (last != nullptr && last->insteadNow() == nullptr && last->overGray && sameEdgeLook(last->state, state)) return last->overGray;
    return std::make_shared<const QImage>(edgeOverlay(picture, state.colours, state.byClass));
}

/// Lines may have come or gone since the overlay was made: the cells of both are the same ones.
void fitPoints(Scene& scene, const OverlayPoints& points, const Scene* last) {
    const CloudGeometry& cloud = *scene.picture->cloud;
    if (!points.colours || points.beams != cloud.beams) return;
    scene.edgesOverPoints = points.belowEdges;
    scene.pointsFrom = points.colours;
    if (points.colours->size() == cloud.cells()) {
        scene.points = points.colours;
    } else if (last != nullptr && last->pointsFrom == points.colours && last->pointsOver == nullptr) {
        scene.points = last->points;
    } else {
        auto fitted = std::make_shared<std::vector<std::uint32_t>>(*points.colours);
        fitted->resize(cloud.cells(), points.others);
        scene.points = std::move(fitted);
    }
}

/// `below`: of a less important overlay, some of whose colours stay; null: there is no other.
void colourPoints(Scene& scene, const OverlayPoints& points, const OverlayPoints* below, const Scene* last) {
    fitPoints(scene, points, last);
    if (!scene.points || below == nullptr || below->beams != points.beams || !below->staying) return;
    scene.edgesOverPoints = scene.edgesOverPoints || below->belowEdges;
    scene.pointsOver = below->staying;
    if (last != nullptr && last->pointsFrom == scene.pointsFrom && last->pointsOver == scene.pointsOver &&
        last->points->size() == scene.points->size()) {
        scene.points = last->points;
        return;
    }
    auto both = std::make_shared<std::vector<std::uint32_t>>(*scene.points);
    for (std::size_t k = 0; k < std::min(both->size(), below->staying->size()); ++k) {
        if ((*below->staying)[k] != 0) (*both)[k] = (*below->staying)[k];
    }
    scene.points = std::move(both);
}

} // namespace

Scene sceneOf(const SceneState& state, const std::shared_ptr<const Picture>& picture, const Overlays& overlays, const Scene& last) {
    Scene scene;
    scene.state = state;
    scene.picture = state.flippedTo ? state.flippedTo : picture;
    const OverlayPoints *points = nullptr, *below = nullptr;
    for (const auto& overlay : overlays | std::views::reverse) {
        if (!overlay) continue;
        if (overlay->legend && !scene.legend && !scene.instead) scene.legend = overlay->name;
        if (!picture || (overlay->scan && overlay->scan != picture->detection->scan)) continue;
        const bool onGrid = overlay->edges && overlay->edges->map->size() == picture->edges->size();
        if (!scene.instead && onGrid) scene.instead = overlay->edges;
        if (overlay->points) (points == nullptr ? points : below) = &*overlay->points;
        if (scene.faces || !overlay->faces || scene.flipped()) continue;
        scene.faces = overlay->faces;
        scene.facesFaded = overlay->facesFaded;
    }
    if (!scene.picture) return scene;
    const Scene* same = last.picture == scene.picture ? &last : nullptr;
    const OverlayEdges* instead = scene.insteadNow();
    const Picture& edges = state.bordered && !scene.flipped() ? *state.bordered : *scene.picture;
    scene.gray = grayOf(state, *scene.picture, same);
    scene.edgeMap = edgeMapOf(state, edges, instead, same);
    scene.overGray = overGrayOf(state, edges, instead, same);
    scene.byStrength = instead == nullptr && !state.byClass && edges.borderCells.all != nullptr;
    scene.cells = instead != nullptr ? instead->cells : scene.byStrength ? edges.borderCells : edges.edgeCells;
    scene.colours = instead != nullptr ? instead->colours : scene.byStrength ? strengthColours(state.colours) : state.colours;
    scene.byClass = instead != nullptr || state.byClass || scene.byStrength;
    if (points != nullptr && !scene.flipped()) colourPoints(scene, *points, below, same);
    return scene;
}

} // namespace edgescan::ui
