// What the operator can turn: one plain value per parameter. The table in parameters.h gives each its name, unit and limits.
#pragma once

#include <cstdint>
#include <limits>

namespace edgescan::edges {

/// A number that is worked out from the scan unless somebody types one.
inline constexpr double kAutomatic = std::numeric_limits<double>::quiet_NaN();

/// How a range becomes a gray level (docs/method.md, "Gray levels and presets").
enum class Scaling : std::uint8_t {
    Thesis, ///< clamp(rint(S * 255 / (Smax - Smin))), saturating when Smin > 0; thesis as printed
    Window, ///< clamp(rint((S - near) * 255 / (far - near))), near/far = Smin/Smax unless typed
    Log,    ///< clamp(rint(ln(S / near) * 255 / ln(far / near))), near/far = 1 % and 99 % of the ranges, a factor 5 apart at least
};

enum class Norm : std::uint8_t {
    L1, ///< |gx| + |gy|
    L2, ///< sqrt(gx^2 + gy^2)
};

/// How edges are found. The numbers are kept in no file; names are (parameters.cpp).
enum class Method : std::uint8_t {
    EdgeScanPlus, ///< jumps and creases of the surface in inverse range (docs/method.md, "EdgeScan+")
    Outlines,     ///< of these, what runs round a rock: jumps and concave creases
    Jumps,        ///< of these, the jumps
    Canny,        ///< Canny on gray levels, the method of the thesis
    LogRange,     ///< Canny on the logarithm of the range, without gray levels
    Roberts,      ///< from here on the other detectors of the thesis's chapter 3, on gray levels
    Sobel,
    Prewitt,
    Kirsch,
    Robinson,
    MarrHildreth,
    Log,
};

/// Masks of the Laplacian of Gaussian that text books print.
enum class LogMask : std::uint8_t {
    FourNeighbours,  ///< 0 -1 0 / -1 4 -1 / 0 -1 0
    EightNeighbours, ///< -1 -1 -1 / -1 8 -1 / -1 -1 -1
    FiveByFive,      ///< 0 0 -1 0 0 / 0 -1 -2 -1 0 / -1 -2 16 -2 -1 / 0 -1 -2 -1 0 / 0 0 -1 0 0
};

/// The classes of edges that EdgeScan+ tells apart, as bits of Settings::classes.
enum EdgeClassBits : std::uint8_t {
    kClassJump = 1,
    kClassConvex = 2,
    kClassConcave = 4,
    kClassBorder = 8,
    kClassSilhouette = 16,
    kClassRock = kClassJump | kClassConvex | kClassConcave | kClassSilhouette,
};

/// What is taken for granted about the noise of the ranges.
enum class NoiseKind : int {
    Measured, ///< told by the scan
    Laser,    ///< each cell errs for itself
    Camera,   ///< neighbours err alike: depth in steps that span cells
};

struct Settings {
    Method method = Method::EdgeScanPlus;

    // EdgeScan+ and its parts (docs/method.md, "Sliders")
    double sensitivity = 1.0;        ///< high threshold of the hysteresis, x
    double jumpMm = kAutomatic;      ///< J0: smallest jump, mm; automatic follows the noise
    double growthPercent = 1.0;      ///< p: what is added to it, % of the range
    double creaseDeg = 30.0;         ///< C0: smallest fold, degrees
    int minimumLength = 5;           ///< cells of the shortest chain
    int classes = kClassRock;        ///< EdgeClassBits
    double hysteresisPercent = 70.0; ///< low threshold, % of the high one
    double grazing = 0.1;            ///< g: index steps that a grazing surface may be out of place
    bool straighten = true;          ///< take interlaced beams and slipped lines into account
    double noiseMm = kAutomatic;     ///< range noise sigma at 5 m, mm; automatic = measured
    NoiseKind noiseKind = NoiseKind::Measured;

    // Gaps (docs/method.md, "Gaps")
    int fillCells = 0;      ///< shorter side of the gaps that are filled, cells; 0: none is
    bool fillEdges = false; ///< filled cells take part in EdgeScan+'s edges and may be edges themselves

    // Gray levels, Canny and the other detectors
    Scaling scaling = Scaling::Log;
    double nearMm = kAutomatic; ///< range drawn as gray 0, mm
    double farMm = kAutomatic;  ///< range drawn as gray 255, mm
    bool maskMissing = true;    ///< cells without a range take no part in smoothing and gradient
    bool maskIsolated = true;   ///< with maskMissing: cells that few neighbours agree with (dust) count as missing
    int kernel = 3;             ///< Gaussian kernel size, cells: 1 (off), 3, 5, 7, 9, 11
    double sigma = kAutomatic;  ///< Gaussian sigma, cells; automatic = OpenCV's 0.3 ((k - 1) / 2 - 1) + 0.8
    double lower = 6.0; ///< lower hysteresis threshold of Canny, or the threshold of a detector that has one: gradient of gray levels
    double ratio = 3.0; ///< upper = ratio x lower (thesis 1:3)
    int aperture = 3;   ///< Sobel aperture, cells: 3, 5, 7
    Norm norm = Norm::L1;
    LogMask logMask = LogMask::FourNeighbours;
    double stepPercent = 3.0; ///< log range: a straight step of this share of the range is a weak edge

    [[nodiscard]] double upper() const { return ratio * lower; }
};

/// Equal, counting automatic as equal to automatic.
[[nodiscard]] bool operator==(const Settings& a, const Settings& b);

} // namespace edgescan::edges
