// A picture of a report with numbers over it: of rocks and of targets.
#pragma once

#include <cstddef>
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

/// `caption`: markup.
[[nodiscard]] std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers,
                                         const std::string& caption);

} // namespace edgescan::exports
