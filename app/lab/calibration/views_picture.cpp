// Draws the picture for the check of the self-calibration.
#include "app/lab/calibration/views_picture.h"

#include "app/lab/calibration/axis_ends.h"
#include "app/lab/calibration/self_calibration.h"
#include "app/lab/calibration/twice_seen.h"

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr float kFullMm = 50;
constexpr int kGapRows = 8;
constexpr Rgb kNothing{160, 160, 160};

Rgb colourOf(float apartMm) {
    if (std::isnan(apartMm)) return kNothing;
    const float share = std::clamp(apartMm / kFullMm, -1.0F, 1.0F);
    const auto faded = static_cast<std::uint8_t>(std::lround(255.0F * (1.0F - std::abs(share))));
    return share > 0 ? Rgb{faded, faded, 255} : Rgb{255, faded, faded};
}

} // namespace

Grid<Rgb> viewsPicture(const Scan& scan, const AssemblyErrors& errors) {
    const Grid<float> apart = viewDistanceMm(scan, errors);
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    const LineSpan late = polar == nullptr ? LineSpan{} : lateLines(*polar);
    const std::vector<int> beams = polar == nullptr ? std::vector<int>{} : beamsSeenTwice(*polar);
    Grid<Rgb> picture(std::max(1, late.count), std::max(1, static_cast<int>(beams.size())), kNothing);
    for (int i = 0; i < late.count; ++i) {
        const float* line = apart.line(late.first + i);
        std::ranges::transform(beams, picture.line(i), [&](int beam) { return colourOf(line[beam]); });
    }
    return picture;
}

Grid<Rgb> oneOverTheOther(const Grid<Rgb>& above, const Grid<Rgb>& below) {
    Grid<Rgb> both(above.lines + kGapRows + below.lines, std::max(above.beams, below.beams), kNothing);
    for (int i = 0; i < above.lines; ++i) std::copy_n(above.line(i), above.beams, both.line(i));
    for (int i = 0; i < below.lines; ++i) std::copy_n(below.line(i), below.beams, both.line(above.lines + kGapRows + i));
    return both;
}

} // namespace edgescan::inspect
