// What the two images and the cloud show: a value, made by a pure function of the state, the picture and the overlays.
#pragma once

#include "ui/engine/worker_bridge/picture.h"

#include <QString>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// What the operator chose for the views.
struct SceneState {
    std::optional<RangeSpan> window{}; ///< ranges from black to white in the range image; empty: as the method scales them
    bool edgesOverImage = false;       ///< edges over the range image
    bool byClass = false;              ///< edges in the colours of their classes
    EdgeColours colours = kUsualColours;
    std::shared_ptr<const Picture> bordered{};  ///< the picture with its edges as likely borders of rocks; null: not known yet
    std::shared_ptr<const Picture> flippedTo{}; ///< shown instead of the picture for a moment; null: none

    bool operator==(const SceneState&) const = default;
};

/// What may lie over a picture, the more important last: it is shown where two draw the same.
enum class OverlayName : std::uint8_t { Confidence, Comparison, Rocks };
inline constexpr std::size_t kOverlays = 3;

/// Drawn instead of the picture's edges, on the picture's grid.
struct OverlayEdges {
    EdgeCells cells; ///< by class, in these colours
    EdgeColours colours;
    std::shared_ptr<const QImage> map, overImage; ///< of the edge map, and over the range image
    bool overImageAsAsked = false;                ///< over the range image only if edges are shown there
    QString words{};                              ///< the meaning of the colours, appended to the title of the edge map
};

/// Colours of the points of the cloud, by cell.
struct OverlayPoints {
    std::shared_ptr<const std::vector<std::uint32_t>> colours; ///< null: the points stay as they are
    int beams = 0;                                             ///< of their grid
    std::uint32_t others = 0;                                  ///< of cells that the colours do not reach
    bool belowEdges = false;                                   ///< edges are drawn over them even if they are not wanted over faces
    std::shared_ptr<const std::vector<std::uint32_t>>
        staying{}; ///< colours that stay over a more important overlay's, 0 elsewhere; or null
};

/// Never changed once it is given to the views.
struct Overlay {
    OverlayName name{};
    std::shared_ptr<const Scan> scan{};          ///< it is not drawn on a picture of another scan; null: on all with as many beams
    std::shared_ptr<const OverlayEdges> edges{}; ///< null: the picture keeps its edges
    std::optional<OverlayPoints> points{};       ///< empty: it does not colour the points
    std::shared_ptr<const QImage> faces{};       ///< over both images; null: none
    bool facesFaded = false;                     ///< they belong to an older picture
    bool legend = false;                         ///< it has a legend
};

/// By name.
using Overlays = std::array<std::optional<Overlay>, kOverlays>;

/// A view draws only what has a new pointer.
struct Scene {
    // Made of:
    SceneState state;
    std::shared_ptr<const Picture> picture; ///< the one that is shown; null: none yet
    // In the images:
    std::shared_ptr<const QImage> gray, edgeMap;
    std::shared_ptr<const QImage> overGray; ///< edges over the range image; null: none
    std::shared_ptr<const QImage> faces;    ///< over both
    bool facesFaded = false;
    // In the cloud:
    EdgeCells cells;
    EdgeColours colours = kUsualColours;
    bool byClass = false;                                                 ///< the lists of `cells` are drawn, each in its colour
    bool byStrength = false;                                              ///< these lists are those of EdgeStrength
    std::shared_ptr<const std::vector<std::uint32_t>> points, pointsFrom; ///< null: as they are; from: as the overlay has them
    std::shared_ptr<const std::vector<std::uint32_t>> pointsOver;         ///< some of another overlay are over these; null: no others
    bool edgesOverPoints = false;
    // In all:
    std::shared_ptr<const OverlayEdges> instead; ///< replaces the edges of the picture, though not of one that is flipped to; null: none
    std::optional<OverlayName> legend;           ///< whose legend is shown; empty: none

    [[nodiscard]] bool flipped() const { return state.flippedTo != nullptr; }
    /// What replaces the edges now.
    [[nodiscard]] const OverlayEdges* insteadNow() const { return flipped() ? nullptr : instead.get(); }
};

/// What did not change since `last` is taken from it, so that its pointers stay.
[[nodiscard]] Scene sceneOf(const SceneState& state, const std::shared_ptr<const Picture>& picture, const Overlays& overlays,
                            const Scene& last = {});

} // namespace edgescan::ui
