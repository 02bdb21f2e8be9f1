// The window's picture of one detection: the detection itself, and its images, made off the GUI thread.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/edge_cells.h"

#include <QColor>
#include <QImage>
#include <QRect>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::ui {

/// The ranges drawn from black to white; only for display, the method does not use it.
struct RangeSpan {
    double nearM = 0.0;
    double farM = 1.0; ///< above nearM
    bool operator==(const RangeSpan&) const = default;
};

/// The progress of the sweep from which a scan was taken.
struct Growth {
    int sweep = -1;        ///< SweepProgress::number; -1: a whole file
    bool growing = false;  ///< more lines will follow
    int expectedLines = 0; ///< of the whole sweep; 0: unknown

    bool operator==(const Growth&) const = default;
};

/// The source of a picture.
struct PictureSource {
    std::uint64_t stream = 0; ///< the same for all pictures of one file, scanner or recording: the views keep their place
    Growth growth;

    bool operator==(const PictureSource&) const = default;
};

/// Immutable after construction. In the window all members are replaced together.
struct Picture {
    PictureSource source;
    edges::Settings asked; ///< the requested settings; the detection's own settings fix values that must not change while a scan grows
    std::shared_ptr<const edges::Detection> detection;
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const QImage>
        gray; ///< beams x shownLines() pixels; missing data hatched violet, lost cells dark, filled cells striped green
    std::shared_ptr<const QImage> edges; ///< a byte per cell and a table of colours: white edges and blue rims of voids on black, the less
                                         ///< likely borders of rocks dimmer and dotted; missing data hatched violet
    std::shared_ptr<const QImage> overlay; ///< likewise: green edges and rims of voids, transparent elsewhere
    EdgeCells edgeCells;
    EdgeCells borderCells;   ///< by strength; null: all are drawn alike
    std::vector<QRect> lost; ///< areas of lost cells, x = beam, y = line: views draw dashes over them
};

/// The same for all pictures of one scan, also after its file was read again; of a scanner or a growing scan: of one stream. Empty: of
/// none.
[[nodiscard]] std::string scanKey(const Picture* picture);

/// Rows of the images: a sweep has rows for all lines that it should have, so that the picture does not shrink with every line, and a sweep
/// that was stopped early does not look whole.
[[nodiscard]] int shownLines(const Scan& scan, const Growth& growth);

// beams x `rows` pixels; rows that the scan does not have yet are plain dark. Without `span`: the gray levels of the method.
[[nodiscard]] QImage grayPicture(const edges::Detection& detection, const std::optional<RangeSpan>& span, int rows);
/// The picture's edge map in the colours of the classes; for methods without classes the plain map.
[[nodiscard]] QImage classPicture(const Picture& picture, const EdgeColours& colours);
/// The picture's edges on a transparent background, in drawnColours(); methods without classes in the first one.
[[nodiscard]] QImage edgeOverlay(const Picture& picture, const EdgeColours& colours, bool byClass);

/// Probabilities that were worked out for another picture of the same sweep.
struct KnownBorders {
    PictureSource source;
    int beams = 0;
    std::shared_ptr<const std::vector<std::uint32_t>> edges;
    MadeWhenRead<std::vector<edges::BorderPercent>> percents; ///< made, in the order of `edges`
};
[[nodiscard]] KnownBorders knownBordersOf(const Picture& picture);

/// The same picture with its edges as strong as they are likely to be borders of rocks: computes the probabilities. Any thread.
[[nodiscard]] std::shared_ptr<const Picture> withBorders(const std::shared_ptr<const Picture>& picture);

/// Rectangles that together are the lost cells, from the first line on; at most a few thousand.
[[nodiscard]] std::vector<QRect> lostAreas(const Scan& scan);

/// Rows of the images for lines that a sweep does not have, or not yet; empty for a file.
[[nodiscard]] QRect linesToCome(const Picture& picture);

/// Images of `detection`; unchanged parts are reused from `last` (may be null). Edges that `known` has too are as strong as there, so that
/// nothing flickers until the probabilities are there.
[[nodiscard]] std::shared_ptr<const Picture> makePicture(const std::shared_ptr<const edges::Detection>& detection,
                                                         const PictureSource& source, const edges::Settings& asked,
                                                         const std::shared_ptr<const CloudGeometry>& cloud,
                                                         const std::shared_ptr<const Picture>& last, const KnownBorders& known = {});

} // namespace edgescan::ui
