// One row per method.
#include "core/edges/pipeline/methods.h"

#include "core/edges/gray/zero_crossings.h"

#include <array>
#include <cstddef>

namespace edgescan::edges {
namespace {

constexpr std::array kRows{
    MethodRow{Method::EdgeScanPlus, kSurfaceDecision, nullptr, nullptr},
    MethodRow{Method::Outlines, kSurfaceDecision, nullptr, nullptr},
    MethodRow{Method::Jumps, kSurfaceDecision, nullptr, nullptr},
    MethodRow{Method::Canny, kCannyDecision, cannyResponse, nullptr},
    MethodRow{Method::LogRange, kLogRangeDecision, nullptr, nullptr},
    MethodRow{Method::Roberts, kDetectorDecision, robertsResponse, robertsDirection},
    MethodRow{Method::Sobel, kDetectorDecision, threeByThreeResponse<1, 2>, threeByThreeDirection<1, 2>},
    MethodRow{Method::Prewitt, kDetectorDecision, threeByThreeResponse<1, 1>, threeByThreeDirection<1, 1>},
    MethodRow{Method::Kirsch, kDetectorDecision, kirschResponse, kirschDirection},
    MethodRow{Method::Robinson, kDetectorDecision, robinsonResponse, robinsonDirection},
    MethodRow{Method::MarrHildreth, kDetectorDecision, marrHildrethResponse, nullptr},
    MethodRow{Method::Log, kDetectorDecision, logResponse, nullptr},
};

constexpr bool inOrder() {
    for (std::size_t n = 0; n < kRows.size(); ++n) {
        if (static_cast<std::size_t>(kRows[n].method) != n) return false;
    }
    return true;
}
static_assert(inOrder(), "a row per method, in the order of the enumeration");

} // namespace

const MethodRow& rowOf(Method method) { return kRows[static_cast<std::size_t>(method)]; }

} // namespace edgescan::edges
