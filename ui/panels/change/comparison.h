// The pictures of a comparison of two scans, made off the GUI thread.
#pragma once

#include "core/base/result.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/inspect/registration/point_index.h"
#include "core/scan/grid/reading_options.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QImage>
#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// Rows of the legend; each row can be switched off.
enum class ChangeRow : std::uint8_t { Gained, Lost, Unchanged, Unseen, Nearer, Farther };
inline constexpr int kChangeRows = 6;
using ChangeRows = std::array<bool, kChangeRows>;

struct ComparisonAsked {
    std::shared_ptr<const Picture> before, now;
    ChangeRows rows{true, true, true, true, true, true};
    bool onePlace = false;   ///< the scanner did not move between the two scans; else their poses or surfaces decide
    bool bySurfaces = false; ///< if only one of them has a place in the mine, their surfaces decide
    bool byDistance = false; ///< points are coloured by their distance from the surfaces of A
};

/// Distances of the points of the current scan from those of A, for a legend.
struct SurfaceDistances {
    std::vector<float> metres; ///< per cell; NaN where a cell has no point
    inspect::DistanceHistogram histogram;
    double scaleM = 0.0; ///< the end of the colour scale
};

/// Immutable after construction.
struct Comparison {
    ComparisonAsked asked;
    inspect::SceneChange change;
    ///< A; if it is another scan, with the settings of the current picture: a changed slider must not look like a change of the rock
    std::shared_ptr<const Picture> earlier;
    std::shared_ptr<const Picture> before;                     ///< on the grid of the current picture: shown while the two are flipped
    EdgeCells edges;                                           ///< by class: gained, lost, unchanged, unseen
    std::shared_ptr<const QImage> map;                         ///< beams x lines: edges by their change on black
    std::shared_ptr<const QImage> overlay;                     ///< the same with the changed surfaces, transparent elsewhere
    std::shared_ptr<const SurfaceDistances> distances;         ///< null: not asked for, or one scan
    std::shared_ptr<const std::vector<std::uint32_t>> points;  ///< per cell, bytes red, green, blue, 255; unchanged points are dimmed
    std::shared_ptr<const std::vector<std::uint32_t>> changed; ///< the same of changed points, 0 elsewhere

    [[nodiscard]] std::size_t count(ChangeRow row) const;
    [[nodiscard]] bool isOfTwoScans() const { return change.earlier.how.by != inspect::RegistrationBasis::OneScan; }
};

/// For EdgeCells::byClass above.
[[nodiscard]] const EdgeColours& changeColours();
[[nodiscard]] QColor changeColour(ChangeRow row);

/// Whether only one of the two scans has a place in the mine, so that nothing but their surfaces can line them up.
[[nodiscard]] bool onlyOneIsPlaced(const ComparisonAsked& asked);

/// `last` may be null; parts that it has in common with the new comparison are reused. Error: see sceneChange().
[[nodiscard]] Result<std::shared_ptr<const Comparison>> compared(const ComparisonAsked& asked, const Comparison* last);

/// Opens a scan and finds its edges with these settings, for a comparison. Error: opening failed, or too little memory.
[[nodiscard]] Result<std::shared_ptr<const Picture>> earlierPicture(const QString& path, const ReadingOptions& reading,
                                                                    const edges::Settings& settings);
[[nodiscard]] Result<std::shared_ptr<const Picture>> earlierDemo(bool afterBlast, const edges::Settings& settings);
[[nodiscard]] Result<std::shared_ptr<const Picture>> pictureOf(const std::shared_ptr<const Scan>& scan, const edges::Settings& settings);

} // namespace edgescan::ui
