// What the operator can turn: one plain value per parameter. The table in parameters.h gives each its name, unit and limits.
#pragma once

#include <cstdint>
#include <limits>

namespace edgescan {

/// A number that is worked out from the scan unless somebody types one.
inline constexpr double kAutomatic = std::numeric_limits<double>::quiet_NaN();

/// How a range becomes a gray level (CLI.md, "Gray, no-return and thresholds").
enum class Scaling : std::uint8_t {
    Thesis, ///< clamp(rint(S * 255 / (Smax - Smin))), saturating when Smin > 0; thesis as printed
    Window, ///< clamp(rint((S - near) * 255 / (far - near))), near/far = Smin/Smax unless typed
    Log,    ///< clamp(rint(ln(S / near) * 255 / ln(far / near))), near/far = 1 % and 99 % of the ranges, a factor 5 apart at least
};

enum class Norm : std::uint8_t {
    L1, ///< |gx| + |gy|
    L2, ///< sqrt(gx^2 + gy^2)
};

struct Settings {
    Scaling scaling = Scaling::Log;
    double nearMm = kAutomatic; ///< range drawn as gray 0, mm
    double farMm = kAutomatic;  ///< range drawn as gray 255, mm
    bool maskMissing = true;    ///< cells without a range take no part in smoothing and gradient
    bool maskIsolated = true;   ///< with maskMissing: cells that few neighbours agree with (dust) count as missing
    int kernel = 3;             ///< Gaussian kernel size, cells: 1 (off), 3, 5, 7, 9, 11
    double sigma = kAutomatic;  ///< Gaussian sigma, cells; automatic = OpenCV's 0.3 ((k - 1) / 2 - 1) + 0.8
    double lower = 6.0;         ///< lower hysteresis threshold, gradient of gray levels
    double ratio = 3.0;         ///< upper = ratio x lower (thesis 1:3)
    int aperture = 3;           ///< Sobel aperture, cells: 3, 5, 7
    Norm norm = Norm::L1;

    [[nodiscard]] double upper() const { return ratio * lower; }
};

/// Equal, counting automatic as equal to automatic.
[[nodiscard]] bool operator==(const Settings& a, const Settings& b);

} // namespace edgescan
