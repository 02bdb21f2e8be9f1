// Sliding lower envelope of host minus device time.
#include "core/lms/device_clock.h"

#include <algorithm>

namespace edgescan {
namespace {

constexpr std::int64_t kWindowLines = 250; // 10 s at 25 Hz
constexpr std::int64_t kNsPerUs = 1000;
constexpr std::int64_t kLatestNs = std::int64_t{1} << 61; // 73 years; beyond, differences would overflow

std::int64_t bounded(std::int64_t ns) { return std::clamp(ns, -kLatestNs, kLatestNs); }
std::int64_t nsOf(std::int64_t us) { return bounded(std::clamp(us, -kLatestNs / kNsPerUs, kLatestNs / kNsPerUs) * kNsPerUs); }

} // namespace

void DeviceClock::line(std::int64_t transmittedUs, std::int64_t hostNs) {
    const std::int64_t ns = bounded(hostNs) - nsOf(transmittedUs);
    while (!delays_.empty() && delays_.back().ns >= ns) delays_.pop_back();
    delays_.push_back({ns, lines_++});
    while (delays_.front().line + kWindowLines < lines_) delays_.pop_front();
}

std::int64_t DeviceClock::hostNs(std::int64_t deviceUs) const { return nsOf(deviceUs) + (delays_.empty() ? 0 : delays_.front().ns); }

} // namespace edgescan
