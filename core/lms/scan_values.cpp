// What the raw fields of a scan telegram mean: millimetres, degrees, hertz, warnings.
#include "core/lms/scan_telegram.h"

#include <algorithm>
#include <cmath>

namespace edgescan {

namespace {

constexpr std::uint16_t kFirstRange = 16; ///< raw values below are codes of the device

} // namespace

const ScanChannel* findChannel(const ScanTelegram& telegram, std::string_view content) {
    for (const auto* channels : {&telegram.channels16, &telegram.channels8}) {
        const auto found = std::find_if(channels->begin(), channels->end(), [&](const ScanChannel& c) { return c.content == content; });
        if (found != channels->end()) return &*found;
    }
    return nullptr;
}

ChannelRanges rangesMm(const ScanChannel& channel) {
    ChannelRanges ranges{std::vector<float>(channel.values.size(), 0.0F),
                         std::vector<CellState>(channel.values.size(), CellState::NoReturn)};
    for (std::size_t beam = 0; beam < channel.values.size(); ++beam) {
        const std::uint16_t raw = channel.values[beam];
        if (raw == 0) continue;
        const bool isRange = raw >= kFirstRange;
        const float mm = static_cast<float>(raw) * channel.scale + (isRange ? channel.offset : 0.0F);
        // A scale or an offset from a broken device must not put a range at infinity or behind the scanner.
        if (!std::isfinite(mm) || mm <= 0.0F) continue;
        ranges.rangeMm[beam] = mm;
        ranges.state[beam] = isRange ? CellState::Valid : CellState::DeviceStatus;
    }
    return ranges;
}

double snappedDeg(double degrees) {
    constexpr double kTolerance = 0.6e-4; // half of the last digit sent, and a little
    const double snapped = std::round(degrees * 24.0) / 24.0;
    return std::abs(snapped - degrees) <= kTolerance ? snapped : degrees;
}

BeamGrid beamGrid(const ScanChannel& channel) {
    return {snappedDeg(channel.startAngle / 1e4), snappedDeg(channel.step / 1e4), static_cast<int>(channel.values.size())};
}

std::vector<double> beamAnglesDeg(const BeamGrid& grid) {
    std::vector<double> angles;
    angles.reserve(static_cast<std::size_t>(std::max(grid.beams, 0)));
    for (int beam = 0; beam < grid.beams; ++beam) angles.push_back(grid.startDeg + beam * grid.stepDeg);
    return angles;
}

DeviceFlags deviceFlags(const ScanTelegram& telegram) {
    const unsigned bits = telegram.status[0];
    return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
}

double scanFrequencyHz(const ScanTelegram& telegram) { return telegram.scanFrequency / 100.0; }

double measurementFrequencyHz(const ScanTelegram& telegram) {
    const double raw = telegram.measurementFrequency;
    return 100.0 * (raw > 10000.0 ? raw / 100.0 : raw);
}

} // namespace edgescan
