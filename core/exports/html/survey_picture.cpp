// Draws gray levels and edges at a reduced size.
#include "core/exports/html/survey_picture.h"

#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"

#include <algorithm>
#include <cmath>

namespace edgescan::exports {

std::string surveyPicture(const edges::Detection& detection) {
    constexpr int kSide = 96;
    constexpr int kBrightestGround = 150;
    const Grid<std::uint8_t>& gray = detection.gray->levels;
    if (gray.lines <= 0 || gray.beams <= 0) return {};
    const double ratio = std::max({1.0, static_cast<double>(gray.beams) / kSide, static_cast<double>(gray.lines) / kSide});
    Grid<std::uint8_t> small(std::max(1, static_cast<int>(gray.lines / ratio)), std::max(1, static_cast<int>(gray.beams / ratio)));
    for (int y = 0; y < small.lines; ++y) {
        const int firstLine = static_cast<int>(static_cast<std::int64_t>(y) * gray.lines / small.lines);
        const int lastLine = std::max(firstLine + 1, static_cast<int>(static_cast<std::int64_t>(y + 1) * gray.lines / small.lines));
        for (int x = 0; x < small.beams; ++x) {
            const int firstBeam = static_cast<int>(static_cast<std::int64_t>(x) * gray.beams / small.beams);
            const int lastBeam = std::max(firstBeam + 1, static_cast<int>(static_cast<std::int64_t>(x + 1) * gray.beams / small.beams));
            int sum = 0, edges = 0;
            const int cells = (lastLine - firstLine) * (lastBeam - firstBeam);
            for (int i = firstLine; i < lastLine; ++i) {
                for (int j = firstBeam; j < lastBeam; ++j) {
                    sum += gray.at(i, j);
                    edges += detection.mask->at(i, j) != 0 ? 1 : 0;
                }
            }
            const int ground = sum / cells * kBrightestGround / 255;
            const double share = std::sqrt(static_cast<double>(edges) / cells); // so that a line one cell wide remains visible
            small.at(y, x) = static_cast<std::uint8_t>(ground + (255 - ground) * share);
        }
    }
    const auto bytes = containers::png8Bytes(small, "survey");
    return bytes ? *bytes : std::string();
}

} // namespace edgescan::exports
