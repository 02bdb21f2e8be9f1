// The pictures of a report.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/rocks/attributes/faces.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::exports {

/// The place of a number, or of another short text, in pixels of the picture.
struct PictureNumber {
    std::string text;
    double x = 0.0, y = 0.0;
    bool always = false; ///< also where it covers others, and on narrow screens
    bool dot = false;    ///< a dot is at the place, and the text above it
};

/// A straight line, in pixels of the picture.
struct PictureLine {
    double fromX = 0.0, fromY = 0.0, toX = 0.0, toY = 0.0;
};

/// An SVG element to be laid over a picture of width x height pixels. Those that are not `always` are left out where they would cover an
/// earlier number; `leftOut` counts them.
[[nodiscard]] std::string pictureNumbers(int width, int height, const std::vector<PictureNumber>& numbers, std::size_t& leftOut,
                                         const std::vector<PictureLine>& lines = {});

/// `caption`: markup. `kind` "picture second": one that shows the same in another way, which paper has without numbers.
[[nodiscard]] std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers,
                                         const std::string& caption, const char* kind = "picture");

/// PNG bytes, rows = lines from the first one down, columns = beams; at most `mostPixels` along a side.
[[nodiscard]] std::string grayPicture(const edges::Detection& detection, int mostPixels);

/// The same with the edges in the colours of their classes on darkened gray levels.
[[nodiscard]] std::string edgePicture(const edges::Detection& detection, int mostPixels);

/// The same with the rocks as coloured faces.
[[nodiscard]] std::string rockPicture(const edges::Detection& detection, const rocks::Faces& faces, int mostPixels);

/// The points as seen from behind the scanner, in perspective, with the edges in their colours, or with the rocks if there are any: PNG of
/// width x height pixels.
struct CloudPicture {
    std::string png;
    double metrePixels = 0;                             ///< length of a metre, in pixels, at the distance of the cloud's middle
    std::vector<std::optional<Eigen::Vector2d>> places; ///< of `cells`, pixels; empty: outside the picture
};
[[nodiscard]] CloudPicture cloudPicture(const edges::Detection& detection, int width, int height, const rocks::Faces* faces = nullptr,
                                        const std::vector<std::size_t>& cells = {});

/// The cloud's points in metres for the rotating view, and the values that the page shows for each: little endian, one array after the
/// other.
struct ViewPoints {
    std::size_t count = 0;
    std::string positions;                 ///< count x 3 floats, from the origin
    std::string ranges;                    ///< count floats, mm
    std::string cells;                     ///< count 32 bit indices
    std::string classes;                   ///< count bytes: 0 not an edge, otherwise 1 + DepthEdge
    std::string levels;                    ///< count bytes, gray
    std::string rocks;                     ///< count 16-bit labels, 0 = not a rock; empty without rocks
    double originM[3]{};                   ///< in the frame of the page: mine grid if the scan has a placement, otherwise the scanner's
    double sensorM[3]{};                   ///< from the origin
    std::size_t pointsOf = 0, edgesOf = 0; ///< numbers in the scan
    std::size_t points = 0, edges = 0;     ///< numbers shown
};
[[nodiscard]] ViewPoints viewPoints(const edges::Detection& detection, std::size_t mostPoints, std::size_t mostEdges,
                                    const rocks::Faces* faces = nullptr);

} // namespace edgescan::exports
