// What the window shows of one detection: the detection itself and the images made of it off the GUI thread.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/edge_cells.h"

#include <QColor>
#include <QImage>

#include <memory>
#include <optional>

namespace edgescan::ui {

/// Ranges shown from black to white; only the display, never what the method sees.
struct RangeSpan {
    double nearM = 0.0;
    double farM = 1.0; ///< above nearM
    bool operator==(const RangeSpan&) const = default;
};

/// How far the sweep is that a scan was taken from.
struct Growth {
    int sweep = -1;        ///< SweepProgress::number; -1: a whole file
    bool growing = false;  ///< more lines are to come
    int expectedLines = 0; ///< of the whole sweep; 0: not known

    bool operator==(const Growth&) const = default;
};

/// Where a picture comes from.
struct PictureSource {
    std::uint64_t stream = 0; ///< alike in pictures of one file, one scanner or one recording: the views keep their place
    Growth growth;

    bool operator==(const PictureSource&) const = default;
};

/// Never changed after it is made. All members change together in the window.
struct Picture {
    PictureSource source;
    Settings asked; ///< what the detection was wanted with; the detection's own settings fix what must stay while a scan grows
    std::shared_ptr<const Detection> detection;
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const QImage>
        gray; ///< beams x shownLines() pixels; missing data hatched violet, lost lines hatched blue, filled cells striped green
    std::shared_ptr<const QImage> edges;   ///< white edges on black; missing data hatched violet
    std::shared_ptr<const QImage> overlay; ///< green edges, transparent elsewhere
    EdgeCells edgeCells;
};

/// Rows of the images: a growing scan has room for the lines to come, so that the picture does not shrink with every line.
[[nodiscard]] int shownLines(const Scan& scan, const Growth& growth);

// beams x `rows` pixels; rows that the scan does not have yet are plain dark. Without a span: the gray levels of the method.
[[nodiscard]] QImage grayPicture(const Detection& detection, const std::optional<RangeSpan>& span, int rows);
[[nodiscard]] QImage edgePicture(const Detection& detection, int rows);
/// The picture's edge map with the colours of the classes, where the method tells classes apart; else the map as it is.
[[nodiscard]] QImage classPicture(const Picture& picture, const EdgeColours& colours);
/// Edges on transparent ground; `byClass`: each in the colour of its class, where the method tells classes apart.
[[nodiscard]] QImage edgeOverlay(const Detection& detection, const EdgeColours& colours, bool byClass, int rows);

/// Images of `detection`; what did not change since `last` (may be null) is taken from it.
[[nodiscard]] std::shared_ptr<const Picture> makePicture(const std::shared_ptr<const Detection>& detection, const PictureSource& source,
                                                         const Settings& asked, const std::shared_ptr<const CloudGeometry>& cloud,
                                                         const std::shared_ptr<const Picture>& last);

} // namespace edgescan::ui
