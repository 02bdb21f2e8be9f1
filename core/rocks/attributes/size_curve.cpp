// Computes the size distribution by visible width.
#include "core/rocks/attributes/size_curve.h"

#include <algorithm>

namespace edgescan::rocks {

double SizeCurve::shareUpTo(double wideM) const {
    if (widthsM.empty()) return 0.0;
    const auto wider = std::upper_bound(widthsM.begin(), widthsM.end(), wideM);
    return static_cast<double>(wider - widthsM.begin()) / static_cast<double>(widthsM.size());
}

SizeCurve sizeCurve(const std::vector<Rock>& rocks, double oversizeM) {
    SizeCurve curve;
    curve.oversizeM = oversizeM;
    if (rocks.empty()) return curve;
    for (const Rock& rock : rocks) curve.widthsM.push_back(rock.shortestCaliperM);
    std::sort(curve.widthsM.begin(), curve.widthsM.end());
    const auto notWider = [&](std::size_t percent) { return curve.widthsM[(percent * curve.widthsM.size() + 99) / 100 - 1]; };
    curve.p20M = notWider(20);
    curve.p50M = notWider(50);
    curve.p80M = notWider(80);
    curve.topM = curve.widthsM.back();
    if (oversizeM > 0) curve.oversizeShare = 1.0 - curve.shareUpTo(oversizeM);
    return curve;
}

} // namespace edgescan::rocks
