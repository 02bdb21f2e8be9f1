// From displacements in index steps to angles.
#include "core/edges/straighten_scan.h"

#include "core/edges/interlace.h"

#include <algorithm>
#include <cstdio>

namespace edgescan {
namespace {

// Median of the lines that tell of a displacement, index steps; 0 when none does.
double medianParity(const std::vector<float>& parity) {
    std::vector<float> told;
    std::copy_if(parity.begin(), parity.end(), std::back_inserter(told), [](float steps) { return steps != 0; });
    if (told.empty()) return 0;
    const auto middle = told.begin() + static_cast<std::ptrdiff_t>(told.size() / 2);
    std::nth_element(told.begin(), middle, told.end());
    return static_cast<double>(*middle);
}

void moveBeams(PolarGeometry& polar, double displacementDeg) {
    polar.lineSkewDeg.resize(polar.beamDeg.size());
    for (std::size_t j = 0; j < polar.lineSkewDeg.size(); ++j) polar.lineSkewDeg[j] += (j % 2 == 1 ? 0.5 : -0.5) * displacementDeg;
}

struct Moved {
    int slips = 0; // moved
    int left = 0;  // seen in every second beam only
};

Moved moveLines(PolarGeometry& polar, const SweepSlips& slips, double stepDeg) {
    Moved moved;
    double shiftDeg = 0;
    for (std::size_t i = 0; i + 1 < polar.lineDeg.size(); ++i) {
        const double even = static_cast<double>(slips.measured[0][i]);
        const double odd = static_cast<double>(slips.measured[1][i]);
        if (even != 0 && odd != 0) {
            shiftDeg += 0.5 * (even + odd) * stepDeg;
            ++moved.slips;
        } else if (even != 0 || odd != 0) {
            ++moved.left;
        }
        polar.lineDeg[i + 1] += shiftDeg;
    }
    return moved;
}

} // namespace

Scan straightened(Scan scan) {
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->lineDeg.size() < 2) {
        scan.warnings.emplace_back("Not straightened: the scan has no lines with angles.");
        return scan;
    }
    InverseRange inverse = inverseRange(scan);
    const SweepSlips slips = straighten(inverse);
    const double stepDeg = (polar->lineDeg.back() - polar->lineDeg.front()) / static_cast<double>(polar->lineDeg.size() - 1);
    const double displacementDeg = slips.interlaced ? medianParity(slips.parity) * stepDeg : 0.0;
    if (displacementDeg != 0) moveBeams(*polar, displacementDeg);
    const Moved moved = moveLines(*polar, slips, stepDeg);
    if (displacementDeg == 0 && moved.slips + moved.left == 0) {
        scan.warnings.emplace_back("Straightened: no interlaced beams and no slips were found; the angles stay.");
        return scan;
    }
    char text[200];
    std::snprintf(text, sizeof text, "Straightened: odd beams lie %.3f degrees ahead of even ones; the stepper slipped at %d lines.",
                  displacementDeg, moved.slips);
    scan.warnings.emplace_back(text);
    if (moved.left > 0)
        scan.warnings.push_back(std::to_string(moved.left) + " slips were seen in every second beam only, and are left as they are.");
    return scan;
}

} // namespace edgescan
