// Flat: the share of cells that fold. Quiet: the noise, with relief counted as noise.
#include "core/edges/tuning/flat_scan.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/method_traits.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr double kFlatShare = 0.01; // of the cells fold
constexpr float kFolds = 0.35F;     // of the threshold
constexpr double kQuietMm = 8.0;    // sigma at 5 m, relief included; 6.75 mm for an LMS511

// Share of the cells with a surface whose fold is the strongest around.
double foldingShare(const Grid<float>& crease, const Grid<Support>& support) {
    std::size_t folds = 0, cells = 0;
    for (std::size_t k = 0; k < crease.size(); ++k) {
        cells += support[k] != Support::Void ? 1 : 0;
        folds += std::abs(crease[k]) > kFolds ? 1 : 0;
    }
    return static_cast<double>(folds) / static_cast<double>(std::max<std::size_t>(cells, 1));
}

} // namespace

bool isFlatAndQuiet(const Detection& detection) {
    if (!detection.responses || !reads(detection.settings.method, kReadsCreases)) return false;
    const DepthSurface& surface = *detection.surface;
    const Grid<float>& unweighed = detection.responses->unweighed;
    const Grid<float>& folds = unweighed.size() > 0 ? unweighed : detection.responses->crease;
    return !detection.responses->neighboursAlike && surface.ofRange.at(5.0) > 0 && surface.ofRange.at(5.0) <= kQuietMm &&
           foldingShare(folds, surface.inverse.support) <= kFlatShare;
}

} // namespace edgescan::edges
