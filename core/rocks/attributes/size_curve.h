// The size distribution of the visible rocks, by number.
#pragma once

#include "core/rocks/attributes/attributes.h"

#include <cstdint>
#include <vector>

namespace edgescan::rocks {

/// This caveat must accompany every size curve.
inline constexpr const char* kSizeCurveCaveat = "by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more";

/// The distribution of the visible width b over the displayed rocks, by number of rocks.
struct SizeCurve {
    std::vector<double> widthsM;               ///< visible b of all rocks, ascending
    double p20M = 0.0, p50M = 0.0, p80M = 0.0; ///< the least b of a rock such that 20, 50 and 80 % of them are not wider
    double topM = 0.0;
    double oversizeM = 0.0;     ///< the site's oversize limit; 0: not given
    double oversizeShare = 0.0; ///< 0..1: share of the rocks with b above it; 0 if it was not given

    [[nodiscard]] std::size_t rocks() const { return widthsM.size(); }
    /// 0..1: share of the rocks with this width or less; 0 without rocks.
    [[nodiscard]] double shareUpTo(double wideM) const;
};
/// `oversizeM`: metres, 0 = not given.
[[nodiscard]] SizeCurve sizeCurve(const std::vector<Rock>& rocks, double oversizeM = 0.0);

} // namespace edgescan::rocks
