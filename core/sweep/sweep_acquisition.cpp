// Times of lines, and what the telegrams say of the scanner.
#include "core/sweep/sweep_acquisition.h"

#include "core/base/utc_time.h"

#include <algorithm>

namespace edgescan {
namespace {

/// Lines that did not arrive were measured between their neighbours.
std::vector<double> lineTimes(std::span<const LineFacts> rows) {
    std::vector<double> times(rows.size(), 0.0);
    std::size_t last = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].received) continue;
        times[i] = static_cast<double>(rows[i].stampNs) * 1e-9;
        const std::size_t from = last < rows.size() ? last : i;
        for (std::size_t lost = last < rows.size() ? last + 1 : 0; lost < i; ++lost) {
            const double share = from == i ? 1.0 : static_cast<double>(lost - from) / static_cast<double>(i - from);
            times[lost] = times[from] + (times[i] - times[from]) * share;
        }
        last = i;
    }
    if (last >= rows.size()) return {};
    std::fill(times.begin() + static_cast<std::ptrdiff_t>(last), times.end(), times[last]);
    return times;
}

} // namespace

std::shared_ptr<const Acquisition> sweepAcquisition(GrowingSweep& sweep, std::size_t rows, const SweepSettings& settings) {
    auto acquisition = std::make_shared<Acquisition>();
    Acquisition& a = *acquisition;
    a.vendor = "SICK";
    if (sweep.serialNumber() != 0) a.serial = std::to_string(sweep.serialNumber());
    a.lineTimesS = lineTimes(sweep.facts().first(rows));
    if (!a.lineTimesS.empty()) {
        a.startUtc = utcText(a.lineTimesS.front());
        a.endUtc = utcText(a.lineTimesS.back());
        a.clockSource = "the recording computer's clock, carried on by the scanner's";
    }
    const DeviceFlags& ever = sweep.deviceEver();
    const std::string from = " from line " + std::to_string(std::max(0, sweep.firstFlagged())) + " on";
    a.contamination = ever.contaminationError     ? "window too dirty to measure through" + from
                      : ever.contaminationWarning ? "dirty window" + from
                                                  : "none reported";
    a.echoFilter = settings.echo == Echo::First ? "first echo that the scanner sent" : "last echo that the scanner sent";
    a.linesExpected = settings.expectedLines;
    return acquisition;
}

} // namespace edgescan
