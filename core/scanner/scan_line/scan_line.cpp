// Angles without a scanner's rounding.
#include "core/scanner/scan_line/scan_line.h"

#include <cmath>

namespace edgescan::scanner {

double snappedDeg(double degrees) {
    constexpr double kTolerance = 0.6e-4; // half of the last digit sent, plus a margin
    const double snapped = std::round(degrees * 24.0) / 24.0;
    return std::abs(snapped - degrees) <= kTolerance ? snapped : degrees;
}

} // namespace edgescan::scanner
