// Colours for the points of a cloud by a measured value: range, height, line, strength of the return.
#pragma once

#include "core/scan/grid/scan.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <QRgb>

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace edgescan::ui {

enum class ColourBy : std::uint8_t { Nothing, Range, Height, Line, Intensity };

/// The key in files: "gray", "range", "height", "line", "intensity".
[[nodiscard]] const char* colourKey(ColourBy by);
/// Empty: unknown key.
[[nodiscard]] std::optional<ColourBy> colourOfKey(std::string_view key);

/// The colour at `share` (0 .. 1) of the scale, from blue to ochre. All have the same luminance, so that brightness still shows the shape
/// and edges have the same contrast as on gray. The scale is readable with blue-yellow vision alone.
[[nodiscard]] QRgb colourAt(double share);

struct CloudColours {
    ColourBy by = ColourBy::Nothing;
    std::shared_ptr<const CloudGeometry> of;
    std::shared_ptr<const std::vector<std::uint32_t>> points; ///< per cell, as CloudView::setFaces takes them
    double low = 0.0, high = 1.0; ///< the values at the ends of the scale, metres, lines, or the file's own numbers; values beyond have the
                                  ///< colour of the end
    bool mine = false;            ///< true: heights are elevations of the mine grid; false: heights above the scanner
};

/// Returns no colours for ColourBy::Nothing, a cloud without points, or intensities that the scan does not have. The scale covers the
/// middle 98 % of the points; for lines it covers all. For the worker.
[[nodiscard]] CloudColours cloudColours(const Scan& scan, const std::shared_ptr<const CloudGeometry>& cloud, ColourBy by);

} // namespace edgescan::ui
