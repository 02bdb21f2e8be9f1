// Interpolation and averages of readings.
#include "core/scan/georef/place_scan.h"

#include "core/scan/georef/chain.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

using Eigen::Quaterniond;

/// Two neighbouring readings, and the position between them (0 to 1).
struct Between {
    std::size_t before = 0;
    std::size_t after = 0;
    double fraction = 0.0;
};

template <class Reading>
Between between(std::span<const Reading> readings, double timeS) {
    const auto later = std::upper_bound(readings.begin(), readings.end(), timeS, [](double t, const Reading& r) { return t < r.timeS; });
    const auto after = static_cast<std::size_t>(later - readings.begin());
    if (after == 0) return {0, 0, 0.0};
    if (after == readings.size() || !std::isfinite(timeS)) return {readings.size() - 1, readings.size() - 1, 0.0};
    const double span = readings[after].timeS - readings[after - 1].timeS;
    return {after - 1, after, span > 0 ? (timeS - readings[after - 1].timeS) / span : 0.0};
}

double blend(double a, double b, double fraction) { return a + (b - a) * fraction; }

Quaterniond attitudeOf(const TalinReading& r) { return Quaterniond(nedFromVehicle(r.headingDeg, r.pitchDeg, r.rollDeg)); }

/// Sets heading, pitch and roll from an attitude.
TalinReading withAttitude(TalinReading reading, const Quaterniond& attitude) {
    const Eigen::Matrix3d m = attitude.normalized().toRotationMatrix();
    reading.headingDeg = degrees(std::atan2(m(1, 0), m(0, 0)));
    if (reading.headingDeg < 0) reading.headingDeg += 360.0;
    reading.pitchDeg = degrees(std::asin(std::clamp(-m(2, 0), -1.0, 1.0)));
    reading.rollDeg = degrees(std::atan2(m(2, 1), m(2, 2)));
    return reading;
}

} // namespace

InclinometerReading inclinometerAt(std::span<const InclinometerReading> readings, double timeS) {
    const Between b = between(readings, timeS);
    const InclinometerReading& from = readings[b.before];
    if (b.before == b.after) return from;
    const InclinometerReading& to = readings[b.after];
    return {timeS, blend(from.tiltXDeg, to.tiltXDeg, b.fraction), blend(from.tiltYDeg, to.tiltYDeg, b.fraction)};
}

TalinReading talinAt(std::span<const TalinReading> readings, double timeS) {
    const Between b = between(readings, timeS);
    TalinReading reading = readings[b.before];
    if (b.before == b.after) return reading;
    const TalinReading& to = readings[b.after];
    const Quaterniond attitude = attitudeOf(reading).slerp(b.fraction, attitudeOf(to));
    reading.timeS = timeS;
    reading.enhM += (to.enhM - reading.enhM) * b.fraction;
    return withAttitude(reading, attitude);
}

InclinometerReading averageInclinometer(std::span<const InclinometerReading> readings) {
    InclinometerReading mean = readings.back();
    if (readings.size() == 1) return mean;
    mean.tiltXDeg = mean.tiltYDeg = 0;
    for (const InclinometerReading& r : readings) {
        mean.tiltXDeg += r.tiltXDeg / static_cast<double>(readings.size());
        mean.tiltYDeg += r.tiltYDeg / static_cast<double>(readings.size());
    }
    return mean;
}

TalinReading averageTalin(std::span<const TalinReading> readings) {
    TalinReading mean = readings.back();
    if (readings.size() == 1) return mean;
    // Relative to the first reading, so that a sum of numbers in the millions loses no digits.
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    const Quaterniond first = attitudeOf(readings.front());
    for (const TalinReading& r : readings) {
        offset += (r.enhM - readings.front().enhM) / static_cast<double>(readings.size());
        const Quaterniond attitude = attitudeOf(r);
        sum += attitude.coeffs() * (attitude.dot(first) < 0 ? -1.0 : 1.0); // q and -q are the same attitude
    }
    mean.enhM = readings.front().enhM + offset;
    return withAttitude(mean, Quaterniond(Eigen::Vector4d(sum.normalized())));
}

} // namespace edgescan
