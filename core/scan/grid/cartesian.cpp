// From cell to 3D point.
#include "core/scan/grid/cartesian.h"

#include "core/base/portable_math.h"
#include "core/base/simd.h"

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

namespace edgescan {
namespace {

constexpr double kMetresPerMm = 0.001;

// Multiples of 90 degrees give exact zeros and ones, so that a beam at 90 degrees has x = 0 and not 6e-17.
double sineDeg(double deg) {
    const double turn = std::remainder(deg, 360.0);
    if (turn == 0.0 || std::abs(turn) == 180.0) return 0.0;
    return portable::sin(turn * std::numbers::pi / 180.0);
}
double cosineDeg(double deg) {
    const double turn = std::remainder(deg, 360.0);
    if (std::abs(turn) == 90.0) return 0.0;
    return portable::cos(turn * std::numbers::pi / 180.0);
}

// Unit direction of a beam, from the cosine and sine of its two angles.
Eigen::Vector3d beamDirection(Axis axis, double cosBeam, double sinBeam, double cosLine, double sinLine) {
    if (axis == Axis::Spin) return {cosBeam * cosLine, cosBeam * sinLine, sinBeam};
    return {cosBeam, -sinBeam * sinLine, sinBeam * cosLine};
}

Eigen::Vector3d missing() { return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()); }

// The factors for a line of cells: x = range * alongX, and so on. These are the products of beamDirection() in the same order.
struct LineTables {
    const double *cosBeam, *sinBeam; // per beam
    const double *cosLine, *sinLine; // one value per beam if kSkewed, otherwise one
    const float* rangeMm;
    const CellState* states;
    int beams;
};

template <bool kSpin, bool kSkewed, class Number>
EDGESCAN_INLINE void multiplyLine(const LineTables& of, Number* __restrict x, Number* __restrict y, Number* __restrict z) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    // Copied before the loop, so that the writes in the loop cannot change these pointers.
    const double *const cosBeam = of.cosBeam, *const sinBeam = of.sinBeam, *const cosLines = of.cosLine, *const sinLines = of.sinLine;
    const double oneCosLine = *cosLines, oneSinLine = *sinLines;
    const float* const rangeMm = of.rangeMm;
    const CellState* const states = of.states;
    const int beams = of.beams;
    for (int j = 0; j < beams; ++j) {
        const double cosLine = kSkewed ? cosLines[j] : oneCosLine;
        const double sinLine = kSkewed ? sinLines[j] : oneSinLine;
        const double measured = static_cast<double>(rangeMm[j]) * kMetresPerMm;
        const double range = states[j] == CellState::Valid ? measured : kNone; // a product with NaN is NaN
        x[j] = static_cast<Number>((kSpin ? cosBeam[j] * cosLine : cosBeam[j]) * range);
        y[j] = static_cast<Number>((kSpin ? cosBeam[j] * sinLine : -sinBeam[j] * sinLine) * range);
        z[j] = static_cast<Number>((kSpin ? sinBeam[j] : sinBeam[j] * cosLine) * range);
    }
}

template <class Number>
EDGESCAN_INLINE void multiply(Axis axis, bool skewed, const LineTables& of, Number* x, Number* y, Number* z) {
    if (axis == Axis::Spin) return skewed ? multiplyLine<true, true>(of, x, y, z) : multiplyLine<true, false>(of, x, y, z);
    return skewed ? multiplyLine<false, true>(of, x, y, z) : multiplyLine<false, false>(of, x, y, z);
}

struct Tables {
    std::vector<double> beamDeg, lineDeg, skewDeg; // the angles that they are of
    double direction;
    std::vector<double> cosBeam, sinBeam, cosLine, sinLine, cosSkew, sinSkew;

    explicit Tables(const PolarGeometry& polar)
        : beamDeg(polar.beamDeg), lineDeg(polar.lineDeg), skewDeg(polar.lineSkewDeg), direction(polar.lineDirection) {
        for (const double a : beamDeg) {
            cosBeam.push_back(cosineDeg(a));
            sinBeam.push_back(sineDeg(a));
        }
        for (const double p : lineDeg) {
            cosLine.push_back(cosineDeg(p));
            sinLine.push_back(sineDeg(p) * direction);
        }
        for (const double skew : skewDeg) {
            cosSkew.push_back(cosineDeg(skew));
            sinSkew.push_back(sineDeg(skew) * direction);
        }
    }
    [[nodiscard]] bool areOf(const PolarGeometry& polar) const {
        return direction == polar.lineDirection && beamDeg == polar.beamDeg && lineDeg == polar.lineDeg && skewDeg == polar.lineSkewDeg;
    }
};

// Those of the last angles are stored: an export needs the tables of one scan several times.
std::shared_ptr<const Tables> tablesOf(const PolarGeometry& polar) {
    static std::mutex mutex;
    static std::shared_ptr<const Tables> last;
    {
        const std::lock_guard lock(mutex);
        if (last && last->areOf(polar)) return last;
    }
    auto made = std::make_shared<const Tables>(polar);
    const std::lock_guard lock(mutex);
    return last = std::move(made);
}

} // namespace

CartesianTables::CartesianTables(const Scan& scan) : scan_(&scan), polar_(std::get_if<PolarGeometry>(&scan.geometry)) {
    if (polar_ == nullptr) return;
    const std::shared_ptr<const Tables> of = tablesOf(*polar_);
    cosBeam_ = of->cosBeam;
    sinBeam_ = of->sinBeam;
    cosLine_ = of->cosLine;
    sinLine_ = of->sinLine;
    cosSkew_ = of->cosSkew;
    sinSkew_ = of->sinSkew;
}

Eigen::Vector3d CartesianTables::direction(int line, int beam) const {
    if (polar_ == nullptr) {
        const auto& points = std::get<PointGeometry>(scan_->geometry);
        return (points.pointsM.at(line, beam) - points.sensorM).normalized();
    }
    const auto i = static_cast<std::size_t>(line);
    const auto j = static_cast<std::size_t>(beam);
    if (cosSkew_.empty()) return beamDirection(polar_->axis, cosBeam_[j], sinBeam_[j], cosLine_[i], sinLine_[i]);
    const double cosine = cosLine_[i] * cosSkew_[j] - sinLine_[i] * sinSkew_[j];
    const double sine = sinLine_[i] * cosSkew_[j] + cosLine_[i] * sinSkew_[j];
    return beamDirection(polar_->axis, cosBeam_[j], sinBeam_[j], cosine, sine);
}

Eigen::Vector3d CartesianTables::point(int line, int beam) const {
    const std::size_t k = scan_->rangeMm.index(line, beam);
    if (scan_->state[k] != CellState::Valid) return missing();
    if (polar_ == nullptr) return std::get<PointGeometry>(scan_->geometry).pointsM[k];
    return direction(line, beam) * (static_cast<double>(scan_->rangeMm[k]) * kMetresPerMm);
}

Eigen::Vector3d CartesianTables::point(std::size_t k) const {
    const auto beams = static_cast<std::size_t>(scan_->beams());
    return point(static_cast<int>(k / beams), static_cast<int>(k % beams));
}

template <class Number>
void CartesianTables::fillLine(int line, Number* x, Number* y, Number* z) const {
    const auto beams = static_cast<std::size_t>(scan_->beams());
    if (polar_ == nullptr) {
        for (std::size_t j = 0; j < beams; ++j) {
            const Eigen::Vector3d p = point(line, static_cast<int>(j));
            x[j] = static_cast<Number>(p.x());
            y[j] = static_cast<Number>(p.y());
            z[j] = static_cast<Number>(p.z());
        }
        return;
    }
    const auto i = static_cast<std::size_t>(line);
    LineTables of{cosBeam_.data(),           sinBeam_.data(),         &cosLine_[i],  &sinLine_[i],
                  scan_->rangeMm.line(line), scan_->state.line(line), scan_->beams()};
    std::vector<double> cosLine, sinLine;
    if (!cosSkew_.empty()) {
        cosLine.reserve(beams);
        sinLine.reserve(beams);
        for (std::size_t j = 0; j < beams; ++j) {
            cosLine.push_back(cosLine_[i] * cosSkew_[j] - sinLine_[i] * sinSkew_[j]);
            sinLine.push_back(sinLine_[i] * cosSkew_[j] + cosLine_[i] * sinSkew_[j]);
        }
        of.cosLine = cosLine.data();
        of.sinLine = sinLine.data();
    }
    vectorised<multiply<Number>>(polar_->axis, !cosSkew_.empty(), of, x, y, z);
}

void CartesianTables::pointsOfLine(int line, double* x, double* y, double* z) const { fillLine(line, x, y, z); }
void CartesianTables::pointsOfLine(int line, float* x, float* y, float* z) const { fillLine(line, x, y, z); }

Eigen::Vector3d CartesianTables::sensor() const {
    if (polar_ != nullptr) return Eigen::Vector3d::Zero();
    return std::get<PointGeometry>(scan_->geometry).sensorM;
}

Eigen::Vector3d pointOfCell(const Scan& scan, std::size_t k) {
    if (scan.state[k] != CellState::Valid) return missing();
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return std::get<PointGeometry>(scan.geometry).pointsM[k];
    const double beam = polar->beamDeg[k % static_cast<std::size_t>(scan.beams())];
    const double skew = polar->lineSkewDeg.empty() ? 0.0 : polar->lineSkewDeg[k % static_cast<std::size_t>(scan.beams())];
    const double line = polar->lineDeg[k / static_cast<std::size_t>(scan.beams())] + skew;
    const double range = static_cast<double>(scan.rangeMm[k]) * kMetresPerMm;
    return beamDirection(polar->axis, cosineDeg(beam), sineDeg(beam), cosineDeg(line), sineDeg(line) * polar->lineDirection) * range;
}

} // namespace edgescan
