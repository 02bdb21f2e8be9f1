// Computes line angles from the available sources.
#include "core/scanner/sweep_assembly/line_angles.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {
namespace {

constexpr std::size_t kReadings = 64; // readings stored for later lines
constexpr std::size_t kLines = 256;   // number of earlier lines that a reading can change

double rateOf(const StepperReading& reading) { return reading.moving ? reading.degPerSecond : 0.0; }

void setStepperAngle(LineTiming& line, double deg, double rate, bool settled) {
    line.stepperDeg = deg;
    line.degPerSecond = rate;
    line.stepperSettled = settled;
}

/// Interpolates between known angles, and extrapolates outside of them by `step`.
void fill(std::vector<double>& lineDeg, const std::vector<int>& known, double step) {
    const auto at = [&](int row) -> double& { return lineDeg[static_cast<std::size_t>(row)]; };
    const int last = static_cast<int>(lineDeg.size()) - 1;
    for (int row = known.front() - 1; row >= 0; --row) at(row) = at(known.front()) - step * (known.front() - row);
    for (int row = known.back() + 1; row <= last; ++row) at(row) = at(known.back()) + step * (row - known.back());
    for (std::size_t i = 0; i + 1 < known.size(); ++i) {
        const int a = known[i];
        const int b = known[i + 1];
        for (int row = a + 1; row < b; ++row) at(row) = at(a) + (at(b) - at(a)) * (row - a) / (b - a);
    }
}

/// Degrees per second between the first and the last line with a known angle.
double meanRate(std::span<const LineTiming> lines, const LineAngles& angles, const std::vector<int>& known) {
    if (known.size() < 2) return 0.0;
    const auto a = static_cast<std::size_t>(known.front());
    const auto b = static_cast<std::size_t>(known.back());
    const double seconds = lines[b].seconds - lines[a].seconds;
    return seconds > 0 ? (angles.lineDeg[b] - angles.lineDeg[a]) / seconds : 0.0;
}

/// The mean speed that the stepper reported, over the lines with a report.
double reportedRate(std::span<const LineTiming> lines) {
    double sum = 0.0;
    int count = 0;
    for (const LineTiming& line : lines) {
        if (!line.received || !line.stepperDeg) continue;
        sum += line.degPerSecond;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

double secondsPerTurn(std::span<const LineTiming> lines) {
    for (const LineTiming& line : lines) {
        if (line.received) return line.secondsPerTurn;
    }
    return 0.0;
}

/// The angle of a received line by a source that may be computed instead of measured.
std::optional<double> angleOf(std::span<const LineTiming> lines, std::size_t row, AngleSource source, const SweepSettings& settings) {
    const LineTiming& line = lines[row];
    switch (source) {
    case AngleSource::Encoder:
        if (line.encoder) return settings.firstLineDeg + static_cast<double>(*line.encoder) / *settings.ticksPerDeg;
        return std::nullopt;
    case AngleSource::Stepper:
        return line.stepperDeg;
    case AngleSource::Steps:
        return settings.firstLineDeg + static_cast<double>(row) * *settings.degPerLine;
    case AngleSource::Time: {
        const auto first = std::find_if(lines.begin(), lines.end(), [](const LineTiming& l) { return l.received; });
        return settings.firstLineDeg + settings.degPerSecond * (line.seconds - first->seconds);
    }
    }
    return std::nullopt;
}

} // namespace

void StepperTrack::line(LineTiming& line) const {
    if (last_.empty()) return;
    const auto latched = std::find_if(last_.rbegin(), last_.rend(), [&](const StepperReading& r) { return r.hostNs == line.hostNs; });
    if (latched != last_.rend()) return setStepperAngle(line, latched->phiDeg, rateOf(*latched), true);
    const StepperReading& newest = last_.back();
    setStepperAngle(line, newest.phiDeg + rateOf(newest) * secondsBetween(newest.hostNs, line.stampNs), rateOf(newest), false);
}

void StepperTrack::reading(const StepperReading& reading, std::span<LineTiming> lines) {
    const std::size_t first = lines.size() > kLines ? lines.size() - kLines : 0;
    for (std::size_t row = lines.size(); row-- > first;) {
        LineTiming& line = lines[row];
        if (!line.received) continue;
        if (line.hostNs == reading.hostNs) {
            setStepperAngle(line, reading.phiDeg, rateOf(reading), true);
        } else if (!line.stepperSettled && line.stampNs > reading.hostNs) {
            setStepperAngle(line, reading.phiDeg + rateOf(reading) * secondsBetween(reading.hostNs, line.stampNs), rateOf(reading), false);
        } else if (!line.stepperSettled && !last_.empty() && line.stampNs >= last_.back().hostNs && line.stampNs <= reading.hostNs) {
            const StepperReading& before = last_.back();
            const double whole = secondsBetween(before.hostNs, reading.hostNs);
            const double share = whole > 0 ? secondsBetween(before.hostNs, line.stampNs) / whole : 0.0;
            setStepperAngle(line, before.phiDeg + (reading.phiDeg - before.phiDeg) * share, rateOf(reading), true);
        }
    }
    last_.push_back(reading);
    if (last_.size() > kReadings) last_.pop_front();
}

AngleSource angleSourceOf(std::span<const LineTiming> lines, const SweepSettings& settings) {
    if (settings.ticksPerDeg && std::any_of(lines.begin(), lines.end(), [](const LineTiming& l) { return l.encoder.has_value(); }))
        return AngleSource::Encoder;
    if (std::any_of(lines.begin(), lines.end(), [](const LineTiming& l) { return l.stepperDeg.has_value(); })) return AngleSource::Stepper;
    return settings.degPerLine ? AngleSource::Steps : AngleSource::Time;
}

std::optional<double> measuredDeg(const LineTiming& line, AngleSource source, const SweepSettings& settings) {
    if (!line.received) return std::nullopt;
    if (source == AngleSource::Encoder && line.encoder)
        return settings.firstLineDeg + static_cast<double>(*line.encoder) / *settings.ticksPerDeg;
    if (source == AngleSource::Stepper && line.stepperSettled) return line.stepperDeg;
    return std::nullopt;
}

LineAngles lineAngles(std::span<const LineTiming> lines, const SweepSettings& settings) {
    LineAngles angles{angleSourceOf(lines, settings), std::vector<double>(lines.size(), settings.firstLineDeg), 0.0};
    std::vector<int> known;
    for (std::size_t row = 0; row < lines.size(); ++row) {
        if (!lines[row].received && angles.source != AngleSource::Steps) continue; // steps are counted for lost lines too
        const auto deg = angleOf(lines, row, angles.source, settings);
        if (!deg) continue;
        angles.lineDeg[row] = *deg;
        known.push_back(static_cast<int>(row));
    }
    if (known.empty()) return angles;
    if (settings.continuous) {
        const double rate = angles.source == AngleSource::Stepper ? reportedRate(lines) : meanRate(lines, angles, known);
        angles.degPerTurn = rate * secondsPerTurn(lines);
    }
    // If only a later part of a line arrived, the line started that much earlier.
    if (angles.source == AngleSource::Encoder || angles.source == AngleSource::Stepper) {
        for (const int row : known) {
            const auto k = static_cast<std::size_t>(row);
            if (lines[k].turns != 0) angles.lineDeg[k] -= lines[k].turns * angles.degPerTurn;
        }
    }
    const double span = known.back() - known.front();
    const double measured =
        span > 0 ? (angles.lineDeg[static_cast<std::size_t>(known.back())] - angles.lineDeg[static_cast<std::size_t>(known.front())]) / span
                 : settings.degPerLine.value_or(0.0);
    fill(angles.lineDeg, known, measured);
    return angles;
}

std::vector<double> lineSkewDeg(std::span<const double> beamDeg, std::span<const int> turnsOf, double degPerTurn, double indexDeg) {
    std::vector<double> skew;
    if (degPerTurn == 0.0) return skew;
    skew.reserve(beamDeg.size());
    for (std::size_t j = 0; j < beamDeg.size(); ++j)
        skew.push_back(degPerTurn * (turnsOf[j % turnsOf.size()] + (beamDeg[j] - indexDeg) / 360.0));
    return skew;
}

} // namespace edgescan::scanner
