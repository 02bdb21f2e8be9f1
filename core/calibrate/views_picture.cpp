// The picture of the check.
#include "core/calibrate/views_picture.h"

#include "core/calibrate/self_calibration.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
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
    const Grid<float> before = viewsApartMm(scan, {});
    const Grid<float> after = viewsApartMm(scan, errors);
    int first = scan.lines(), last = -1;
    for (int i = 0; i < scan.lines(); ++i) {
        const bool any = std::any_of(after.line(i), after.line(i) + scan.beams(), [](float value) { return !std::isnan(value); });
        if (!any) continue;
        first = std::min(first, i);
        last = i;
    }
    const int rows = std::max(1, last - first + 1);
    Grid<Rgb> picture(2 * rows + kGapRows, std::max(1, scan.beams()), Rgb{});
    for (int i = first; i <= last; ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            picture.at(i - first, j) = colourOf(before.at(i, j));
            picture.at(rows + kGapRows + i - first, j) = colourOf(after.at(i, j));
        }
    }
    return picture;
}

} // namespace edgescan
