// Converts the raw fields of a scan telegram to millimetres, degrees, hertz and warnings.
#include "core/scanner/sick_lms/scan_telegram.h"

#include "core/base/physical_limits.h"

#include <algorithm>

namespace edgescan::scanner {

namespace {

constexpr std::uint16_t kFirstRange = 16; ///< smaller raw values are codes of the device

} // namespace

const ScanChannel* findChannel(const ScanTelegram& telegram, std::string_view content) {
    for (const auto* channels : {&telegram.channels16, &telegram.channels8}) {
        const auto found = std::find_if(channels->begin(), channels->end(), [&](const ScanChannel& c) { return c.content == content; });
        if (found != channels->end()) return &*found;
    }
    return nullptr;
}

LineRanges rangesMm(const ScanChannel& channel) {
    LineRanges ranges{std::vector<float>(channel.values.size(), 0.0F), std::vector<CellState>(channel.values.size(), CellState::NoReturn)};
    for (std::size_t beam = 0; beam < channel.values.size(); ++beam) {
        const std::uint16_t raw = channel.values[beam];
        if (raw == 0) continue;
        const bool isRange = raw >= kFirstRange;
        const float mm = static_cast<float>(raw) * channel.scale + (isRange ? channel.offset : 0.0F);
        // An offset from a broken device must not put a range behind the scanner or beyond the largest possible range.
        if (mm == 0.0F || !physical::kRangeMm.hold(mm)) continue;
        ranges.rangeMm[beam] = mm;
        ranges.state[beam] = isRange ? CellState::Valid : CellState::DeviceStatus;
    }
    return ranges;
}

BeamGrid beamGrid(const ScanChannel& channel) {
    return {snappedDeg(channel.startAngle / 1e4), snappedDeg(channel.step / 1e4), static_cast<int>(channel.values.size())};
}

DeviceFlags deviceFlags(const ScanTelegram& telegram) {
    const unsigned bits = telegram.status[0];
    return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
}

double scanFrequencyHz(const ScanTelegram& telegram) { return telegram.scanFrequency / 100.0; }

double linePeriodS(const ScanTelegram& telegram) {
    constexpr double kUsualHz = 25.0, kSlowestHz = 1.0, kFastestHz = 1000.0;
    const double hz = scanFrequencyHz(telegram);
    return 1.0 / (hz >= kSlowestHz && hz <= kFastestHz ? hz : kUsualHz);
}

} // namespace edgescan::scanner
