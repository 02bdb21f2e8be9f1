// From telegram to sweep line.
#include "core/sweep/growing_sweep.h"

#include <string_view>

namespace edgescan {
namespace {

bool isRange(const ScanChannel& channel) { return std::string_view(channel.content).starts_with("DIST"); }

/// The farthest return of each beam over all echoes.
void takeLastEcho(SweepLine& line, const std::vector<ScanChannel>& channels, const ScanChannel& first) {
    for (const ScanChannel& channel : channels) {
        if (&channel == &first || !isRange(channel) || beamGrid(channel) != line.beams) continue;
        const ChannelRanges other = rangesMm(channel);
        for (std::size_t i = 0; i < other.state.size(); ++i) {
            if (other.state[i] != CellState::Valid) continue;
            if (line.ranges.state[i] == CellState::Valid && line.ranges.rangeMm[i] >= other.rangeMm[i]) continue;
            line.ranges.state[i] = CellState::Valid;
            line.ranges.rangeMm[i] = other.rangeMm[i];
        }
    }
}

} // namespace

SweepLine sweepLine(const ScanTelegram& telegram, Echo echo) {
    SweepLine line;
    line.device = deviceFlags(telegram);
    line.serialNumber = telegram.serialNumber;
    const double frequency = scanFrequencyHz(telegram);
    line.facts.secondsPerTurn = frequency > 0 ? 1.0 / frequency : 0.04;
    const ScanChannel* channel = findChannel(telegram, "DIST1");
    for (const ScanChannel& other : telegram.channels16) {
        if (channel == nullptr && isRange(other)) channel = &other;
    }
    if (channel == nullptr) return line;
    line.beams = beamGrid(*channel);
    line.ranges = rangesMm(*channel);
    line.unitMm = channel->scale > 0.0F ? static_cast<double>(channel->scale) : 1.0;
    if (echo == Echo::Last) takeLastEcho(line, telegram.channels16, *channel);
    return line;
}

} // namespace edgescan
