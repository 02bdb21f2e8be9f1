// How large the visible rocks are, by their number.
#pragma once

#include "core/rocks/attributes/attributes.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// To be said with every size curve.
inline constexpr const char* kSizeCurveCaveat = "by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more";

/// Of the rocks shown, by number of rocks and by their visible b.
struct SizeCurve {
    std::vector<double> widthsM;               ///< visible b of all, ascending
    double p20M = 0.0, p50M = 0.0, p80M = 0.0; ///< so many per cent of the rocks are smaller
    double topM = 0.0;
    double oversizeM = 0.0;     ///< the site's; 0: not said
    double oversizeShare = 0.0; ///< 0..1: rocks with b over it; 0 where none was given

    [[nodiscard]] std::size_t rocks() const { return widthsM.size(); }
    /// 0..1: share of the rocks that are no wider; 0 without rocks.
    [[nodiscard]] double shareUpTo(double wideM) const;
};
/// `oversizeM`: 0 = none.
[[nodiscard]] SizeCurve sizeCurve(const std::vector<Rock>& rocks, double oversizeM = 0.0);

} // namespace edgescan
