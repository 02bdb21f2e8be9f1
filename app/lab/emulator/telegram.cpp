// Converts a scan to the telegrams that an LMS511 would have sent while measuring it.
#include "app/lab/emulator/telegram.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {

namespace {

constexpr float kGreatestRaw = 65535.0F;
constexpr float kFirstRange = 16.0F; ///< smaller counts are codes

struct Fan {
    std::int32_t startAngle = 0;
    std::uint16_t step = 0;
};

/// The beams as a start and a step of 1/10000 degree, rounded like the scanner's values.
Result<Fan> fanOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->beamDeg.size() < 2)
        return Error{"a scan without beam angles cannot be sent as telegrams", scan.path, "take a scan of a line scanner"};
    const auto& beams = polar->beamDeg;
    const double step = (beams.back() - beams.front()) / static_cast<double>(beams.size() - 1);
    for (std::size_t i = 0; i < beams.size(); ++i) {
        if (std::abs(beams.front() + static_cast<double>(i) * step - beams[i]) > 1e-3)
            return Error{"unevenly spaced beams cannot be sent as telegrams", scan.path, "take a scan with even beams"};
    }
    const double counts = std::round(step * 1e4);
    if (counts < 1.0 || counts > 65535.0 || std::abs(beams.front()) > 360.0 || beams.size() > 65535)
        return Error{"beams that turn backwards or too far cannot be sent as telegrams", scan.path, "take a scan with rising beam angles"};
    return Fan{static_cast<std::int32_t>(std::lround(beams.front() * 1e4)), static_cast<std::uint16_t>(counts)};
}

std::uint16_t rawOf(const Scan& scan, std::size_t cell, float scale) {
    const CellState state = scan.state[cell];
    const float mm = scan.rangeMm[cell];
    if (state == CellState::NoReturn || state == CellState::Lost || !(mm > 0.0F)) return 0;
    if (state == CellState::DeviceStatus)
        return static_cast<std::uint16_t>(std::clamp(std::round(mm / static_cast<float>(scan.unitMm)), 1.0F, kFirstRange - 1.0F));
    const float raw = std::round(mm / scale);
    // A range that the scanner cannot represent is sent as no return.
    return raw < kFirstRange || raw > kGreatestRaw ? std::uint16_t{0} : static_cast<std::uint16_t>(raw);
}

/// Decreases with the range, 0 without a return: for display, not a measurement.
std::uint16_t remissionOf(std::uint16_t raw, float scale) {
    return raw < 16 ? std::uint16_t{0}
                    : static_cast<std::uint16_t>(std::clamp(254.0F - static_cast<float>(raw) * scale / 200.0F, 1.0F, 254.0F));
}

ScanTelegram lineOf(const Scan& scan, int line, const Fan& fan, float scale, const TelegramStyle& style) {
    const double periodUs = 1e8 / std::max<std::uint32_t>(style.scanFrequency, 1);
    ScanTelegram telegram;
    telegram.deviceNumber = 1;
    telegram.serialNumber = style.serialNumber;
    telegram.telegramCounter = static_cast<std::uint16_t>(style.firstTelegram + line);
    telegram.scanCounter = static_cast<std::uint16_t>(style.firstScan + line);
    telegram.sinceStartUs = static_cast<std::uint32_t>(style.firstUs + static_cast<std::int64_t>(std::llround(line * periodUs)));
    telegram.scanFrequency = style.scanFrequency;
    telegram.measurementFrequency = static_cast<std::uint32_t>(std::lround(style.scanFrequency * 36000.0 / fan.step / 100.0));
    ScanChannel dist{"DIST1", scale, 0.0F, fan.startAngle, fan.step, {}};
    ScanChannel rssi{"RSSI1", 1.0F, 0.0F, fan.startAngle, fan.step, {}};
    for (int beam = 0; beam < scan.beams(); ++beam) {
        const std::uint16_t raw = rawOf(scan, scan.rangeMm.index(line, beam), scale);
        dist.values.push_back(raw);
        if (style.remission) rssi.values.push_back(remissionOf(raw, scale));
    }
    // The angle of the last beam determines when the line is complete (docs/developer/protocol.md, "Time of a beam").
    const double lastDeg = (fan.startAngle + static_cast<double>(fan.step) * scan.beams()) / 1e4;
    telegram.transmittedUs = telegram.sinceStartUs + static_cast<std::uint32_t>(std::lround((lastDeg + 144.0) / 360.0 * periodUs + 4050.0));
    telegram.channels16.push_back(std::move(dist));
    if (style.remission) telegram.channels8.push_back(std::move(rssi));
    if (style.encoder) telegram.encoders.push_back({static_cast<std::uint32_t>(line), 0});
    return telegram;
}

bool lineLost(const Scan& scan, int line) {
    const CellState* cells = scan.state.line(line);
    return scan.beams() > 0 && std::all_of(cells, cells + scan.beams(), [](CellState state) { return state == CellState::Lost; });
}

/// 1, or 2 if a range does not fit into 16 bits of millimetres.
float telegramScale(const Scan& scan) {
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const bool hasRange =
            scan.state[k] != CellState::NoReturn && scan.state[k] != CellState::Lost && scan.state[k] != CellState::DeviceStatus;
        if (hasRange && scan.rangeMm[k] > kGreatestRaw) return 2.0F;
    }
    return 1.0F;
}

} // namespace

Result<std::vector<ScanTelegram>> telegramsOf(const Scan& scan, const TelegramStyle& style) {
    const auto fan = fanOf(scan);
    if (!fan) return fan.error();
    const float scale = telegramScale(scan);
    std::vector<ScanTelegram> telegrams;
    for (int line = 0; line < scan.lines(); ++line) {
        if (!lineLost(scan, line)) telegrams.push_back(lineOf(scan, line, *fan, scale, style));
    }
    return telegrams;
}

} // namespace edgescan::scanner
