// Sliding lower envelope of host minus device time.
#include "core/live/device_clock.h"

namespace edgescan {
namespace {

constexpr std::int64_t kWindowLines = 250; // 10 s at 25 Hz
constexpr std::int64_t kNsPerUs = 1000;

} // namespace

void DeviceClock::line(std::int64_t transmittedUs, std::int64_t hostNs) {
    const std::int64_t ns = hostNs - transmittedUs * kNsPerUs;
    while (!delays_.empty() && delays_.back().ns >= ns) delays_.pop_back();
    delays_.push_back({ns, lines_++});
    while (delays_.front().line + kWindowLines < lines_) delays_.pop_front();
}

std::int64_t DeviceClock::hostNs(std::int64_t deviceUs) const { return deviceUs * kNsPerUs + (delays_.empty() ? 0 : delays_.front().ns); }

} // namespace edgescan
