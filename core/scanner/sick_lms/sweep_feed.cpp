// Decodes received frames for the sweep.
#include "core/scanner/sick_lms/sweep_feed.h"

#include <limits>
#include <string_view>

namespace edgescan::scanner {
namespace {

bool isRange(const ScanChannel& channel) { return std::string_view(channel.content).starts_with("DIST"); }

/// The RSSI of the same echo and beams; null if the telegram has no such channel.
const ScanChannel* rssiOf(const ScanTelegram& telegram, const ScanChannel& range) {
    if (range.content.size() != 5) return nullptr;
    const ScanChannel* rssi = findChannel(telegram, "RSSI" + range.content.substr(4));
    return rssi != nullptr && beamGrid(*rssi) == beamGrid(range) ? rssi : nullptr;
}

float intensityIn(const ScanChannel* rssi, std::size_t beam) {
    return rssi != nullptr ? static_cast<float>(rssi->values[beam]) : std::numeric_limits<float>::quiet_NaN();
}

/// Takes the farthest return of each beam over all echoes.
void storeLastEcho(SweepLine& line, const ScanTelegram& telegram, const ScanChannel& first) {
    for (const ScanChannel& channel : telegram.channels16) {
        if (&channel == &first || !isRange(channel) || beamGrid(channel) != line.beams) continue;
        const LineRanges other = rangesMm(channel);
        const ScanChannel* rssi = rssiOf(telegram, channel);
        for (std::size_t i = 0; i < other.state.size(); ++i) {
            if (other.state[i] != CellState::Valid) continue;
            if (line.ranges.state[i] == CellState::Valid && line.ranges.rangeMm[i] >= other.rangeMm[i]) continue;
            line.ranges.state[i] = CellState::Valid;
            line.ranges.rangeMm[i] = other.rangeMm[i];
            if (!line.intensity.empty()) line.intensity[i] = intensityIn(rssi, i);
        }
    }
}

} // namespace

LineCount countOf(const ScanTelegram& telegram) {
    return {telegram.telegramCounter, telegram.scanCounter, telegram.sinceStartUs, telegram.transmittedUs, linePeriodS(telegram)};
}

SweepLine sweepLine(const ScanTelegram& telegram, Echo echo) {
    SweepLine line;
    line.count = countOf(telegram);
    line.otherLayer = telegram.layer != 0;
    if (!telegram.encoders.empty()) line.encoderPosition = telegram.encoders.front().position;
    line.device = deviceFlags(telegram);
    line.serialNumber = telegram.serialNumber;
    line.facts.secondsPerTurn = linePeriodS(telegram);
    const ScanChannel* channel = findChannel(telegram, "DIST1");
    for (const ScanChannel& other : telegram.channels16) {
        if (channel == nullptr && isRange(other)) channel = &other;
    }
    if (channel == nullptr) return line;
    line.beams = beamGrid(*channel);
    line.echoes = channel->content;
    for (const ScanChannel& other : telegram.channels16) {
        if (&other == channel || !isRange(other)) continue;
        line.echoes += beamGrid(other) == line.beams ? ' ' + other.content : " (" + other.content + ')';
    }
    line.ranges = rangesMm(*channel);
    line.unitMm = channel->scale > 0.0F ? static_cast<double>(channel->scale) : 1.0;
    if (const ScanChannel* rssi = rssiOf(telegram, *channel)) line.intensity.assign(rssi->values.begin(), rssi->values.end());
    if (echo == Echo::Last) storeLastEcho(line, telegram, *channel);
    return line;
}

bool SweepFeed::frame(const ColaFrame& frame, std::int64_t hostNs) {
    if (!isScanTelegram(frame.payload())) return false;
    const auto telegram = decodeScanTelegram(frame);
    if (!telegram) {
        if (++undecodable_ == 1) whyUndecodable_ = telegram.error().what;
        return false;
    }
    assembler_.push(sweepLine(*telegram, assembler_.settings().echo), hostNs);
    return true;
}

bool SweepFeed::frames(ByteView bytes, std::int64_t hostNs) {
    bool line = false;
    const std::uint64_t skipped = stream_.counts().skipped;
    for (const ColaFrame& received : stream_.push(bytes)) line = frame(received, hostNs) || line;
    if (stream_.waiting() > 0 || stream_.counts().skipped > skipped) ++torn_;
    if (stream_.waiting() > 0) stream_ = ColaStream(); // the bytes should be whole frames: the rest of them is damaged
    return line;
}

} // namespace edgescan::scanner
