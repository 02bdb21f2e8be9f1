// The settings of a method: one plain value per parameter. The table in parameters.h gives each a name, a unit and limits.
#pragma once

#include <cstdint>
#include <limits>

namespace edgescan::edges {

/// A number that is computed from the scan unless the user gives one.
inline constexpr double kAutomatic = std::numeric_limits<double>::quiet_NaN();

/// The conversion of a range to a gray level (docs/method/edges.md, "Gray levels and presets").
enum class Scaling : std::uint8_t {
    Thesis, ///< clamp(rint(S * 255 / (Smax - Smin))), saturated if Smin > 0; as printed in the thesis
    Window, ///< clamp(rint((S - near) * 255 / (far - near))), near/far = Smin/Smax unless given
    Log,    ///< clamp(rint(ln(S / near) * 255 / ln(far / near))), near/far = 1 % and 99 % of the ranges, at least a factor 5 apart
};

enum class Norm : std::uint8_t {
    L1, ///< |gx| + |gy|
    L2, ///< sqrt(gx^2 + gy^2)
};

/// The method that finds edges. The numbers are not stored in files; the names are (parameters.cpp).
enum class Method : std::uint8_t {
    EdgeScanPlus, ///< jumps and creases of the surface in inverse range (docs/method/edges.md, "EdgeScan+")
    Outlines,     ///< only the edges around rocks: jumps and concave creases
    Jumps,        ///< only the jumps
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

/// Masks of the Laplacian of Gaussian, as in text books.
enum class LogMask : std::uint8_t {
    FourNeighbours,  ///< 0 -1 0 / -1 4 -1 / 0 -1 0
    EightNeighbours, ///< -1 -1 -1 / -1 8 -1 / -1 -1 -1
    FiveByFive,      ///< 0 0 -1 0 0 / 0 -1 -2 -1 0 / -1 -2 16 -2 -1 / 0 -1 -2 -1 0 / 0 0 -1 0 0
};

/// The classes of edges that EdgeScan+ distinguishes.
enum class DepthEdge : std::uint8_t { None = 0, Jump = 1, Convex = 2, Concave = 3, Border = 4, Silhouette = 5, VoidRim = 6 };
inline constexpr int kDepthEdges = 7; // including None

/// The same as bits of Settings::classes.
enum EdgeClassBits : std::uint8_t {
    kClassJump = 1,
    kClassConvex = 2,
    kClassConcave = 4,
    kClassBorder = 8,
    kClassSilhouette = 16,
    kClassVoidRim = 32,
    kClassRock = kClassJump | kClassConvex | kClassConcave | kClassSilhouette,
};

/// The assumed kind of range noise.
enum class NoiseKind : int {
    Measured, ///< determined from the scan
    Laser,    ///< the errors of cells are independent
    Camera,   ///< the errors of neighbours are correlated: depth in steps that span cells
};

struct Settings {
    Method method = Method::EdgeScanPlus;

    // EdgeScan+ and its parts (docs/method/edges.md, "Sliders")
    double sensitivity = 1.0;                 ///< high threshold of the hysteresis, as a factor
    double jumpMm = kAutomatic;               ///< J0: smallest jump, mm; automatic: from the noise
    double growthPercent = 1.0;               ///< p: added to J0, % of the range
    double creaseDeg = 30.0;                  ///< C0: smallest fold, degrees
    int minimumLength = 4;                    ///< cells of the shortest chain
    int classes = kClassRock | kClassVoidRim; ///< EdgeClassBits
    double hysteresisPercent = 70.0;          ///< low threshold, % of the high one
    double grazing = 0.1;                     ///< g: displacement, in index steps, that is tolerated on a grazing surface
    bool straighten = true;                   ///< correct interlaced beams and slipped lines
    double noiseMm = kAutomatic;              ///< range noise sigma at 5 m, mm; automatic = measured
    NoiseKind noiseKind = NoiseKind::Measured;
    bool turns = true;      ///< allow for a stepper that turns at the ends of the sweep
    int rules = 5;          ///< 4: noise, rims of voids and rough scans as in default set 4; 5: as now
    bool roughScans = true; ///< rules 4 only: on a scan of rough surfaces folds must exceed their surroundings

    // Which of the edges are shown (docs/method/edges.md, "Rock border or fold")
    bool rockBorders = false;  ///< only those that are likely the border of a rock
    double borderPercent = 50; ///< ... with this probability, %, and more

    // Gaps (docs/method/edges.md, "Gaps")
    int fillCells = 0;      ///< shorter side of the gaps to fill, cells; 0: no filling
    bool fillEdges = false; ///< EdgeScan+ uses filled cells like measured ones, and they may be edges

    // Gray levels, Canny and the other detectors
    Scaling scaling = Scaling::Log;
    double nearMm = kAutomatic; ///< range drawn as gray 0, mm
    double farMm = kAutomatic;  ///< range drawn as gray 255, mm
    bool maskMissing = true;    ///< smoothing and gradient ignore cells without a range
    bool maskIsolated = true;   ///< with maskMissing: isolated cells (dust) count as missing
    int kernel = 3;             ///< Gaussian kernel size, cells: 1 (off), 3, 5, 7, 9, 11
    double sigma = kAutomatic;  ///< Gaussian sigma, cells; automatic = OpenCV's 0.3 ((k - 1) / 2 - 1) + 0.8
    double lower = 6.0; ///< lower hysteresis threshold of Canny, or the threshold of a detector with one threshold: gradient of gray levels
    double ratio = 3.0; ///< upper = ratio x lower (thesis 1:3)
    int aperture = 3;   ///< Sobel aperture, cells: 3, 5, 7
    Norm norm = Norm::L1;
    LogMask logMask = LogMask::FourNeighbours;
    double stepPercent = 3.0; ///< log range: a straight step of this percentage of the range is a weak edge

    [[nodiscard]] double upper() const { return ratio * lower; }
};

/// Compares all values; automatic equals automatic.
[[nodiscard]] bool operator==(const Settings& a, const Settings& b);

} // namespace edgescan::edges
