// One row per method.
#include "core/edges/settings/method_traits.h"

#include <array>
#include <cstddef>

namespace edgescan::edges {
namespace {

constexpr unsigned kGradient = kReadsTwoThresholds | kReadsKernel | kReadsNorm;
constexpr unsigned kDetector = kReadsGray | kReadsKernel;

constexpr std::array kMethods{
    MethodTraits{Method::EdgeScanPlus, "edgescan+", "EdgeScan+", kReadsSurface | kReadsCreases | kReadsClasses, 0},
    MethodTraits{Method::Outlines, "outlines", "Rock outlines", kReadsSurface | kReadsCreases,
                 kClassJump | kClassConcave | kClassSilhouette},
    MethodTraits{Method::Jumps, "jumps", "Jumps", kReadsSurface, kClassJump | kClassSilhouette},
    MethodTraits{Method::Canny, "canny", "Canny (thesis)", kReadsGray | kGradient, 0},
    MethodTraits{Method::LogRange, "log-range", "Canny on log range", kReadsRangeStep | kGradient, 0},
    MethodTraits{Method::Roberts, "roberts", "Roberts", kDetector | kReadsNorm, 0},
    MethodTraits{Method::Sobel, "sobel", "Sobel", kDetector | kReadsNorm, 0},
    MethodTraits{Method::Prewitt, "prewitt", "Prewitt", kDetector | kReadsNorm, 0},
    MethodTraits{Method::Kirsch, "kirsch", "Kirsch", kDetector, 0},
    MethodTraits{Method::Robinson, "robinson", "Robinson", kDetector, 0},
    MethodTraits{Method::MarrHildreth, "marr-hildreth", "Marr-Hildreth", kReadsGray | kReadsSigma, 0},
    MethodTraits{Method::Log, "log", "Laplacian (LoG)", kDetector | kReadsLaplacianMask, 0},
};

constexpr bool inOrder() {
    for (std::size_t n = 0; n < kMethods.size(); ++n) {
        if (static_cast<std::size_t>(kMethods[n].method) != n) return false;
    }
    return true;
}
static_assert(inOrder(), "a row per method, in the order of the enumeration");

} // namespace

std::span<const MethodTraits> methodTraits() { return kMethods; }

const MethodTraits& traitsOf(Method method) { return kMethods[static_cast<std::size_t>(method)]; }

bool wants(const Settings& settings, int edgeClass) {
    const int classes = reads(settings.method, kReadsClasses) ? settings.classes : traitsOf(settings.method).classes;
    return (classes & edgeClass) != 0;
}

double automaticSigma(const Settings& settings) {
    constexpr double kMarrHildreth = 1.4;
    return reads(settings.method, kReadsSigma) ? kMarrHildreth : 0.3 * ((settings.kernel - 1) * 0.5 - 1) + 0.8;
}

} // namespace edgescan::edges
