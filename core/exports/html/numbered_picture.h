// A picture of a report with numbers over it: of rocks and of targets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::exports {

/// The place of a number, in pixels of the picture.
struct PictureNumber {
    std::uint32_t number = 0;
    double x = 0.0, y = 0.0;
    bool always = false; ///< also where it covers others, and on narrow screens
};

/// An SVG element to be laid over a picture of width x height pixels. Those that are not `always` are left out where they would cover an
/// earlier number; `leftOut` counts them.
[[nodiscard]] std::string pictureNumbers(int width, int height, const std::vector<PictureNumber>& numbers, std::size_t& leftOut);

/// `caption`: markup.
[[nodiscard]] std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers,
                                         const std::string& caption);

} // namespace edgescan::exports
