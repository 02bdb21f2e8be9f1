// Units by whole millimetres, then by size; status codes of the LMS2xx.
#include "core/files/grid_recovery/unit.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace edgescan::files {
namespace {

constexpr double kLongestInMetres = 1000.0; // no scanner of rocks sees farther; larger numbers are millimetres

/// True when ranges * factor are whole numbers within the rounding of the file, and the rounding is fine enough to show it.
bool wholeAt(std::span<const double> ranges, const Precision& precision, double factor) {
    std::size_t telling = 0;
    std::size_t whole = 0;
    for (const double range : ranges) {
        // Each coordinate is off by at most absolute + relative * |v|, so the range by at most sqrt(3) times the first.
        const double error = (precision.absolute * std::numbers::sqrt3 + precision.relative * range) * factor + 1e-6;
        if (error > 0.2) continue;
        ++telling;
        const double value = range * factor;
        whole += std::abs(value - std::round(value)) <= error ? 1 : 0;
    }
    return telling >= 12 && telling * 2 >= ranges.size() && static_cast<double>(whole) >= 0.995 * static_cast<double>(telling);
}

std::string unitTaken(double mmPerUnit) {
    return mmPerUnit == 1.0 ? "Unit taken as millimetres" : mmPerUnit == 10.0 ? "Unit taken as centimetres" : "Unit taken as metres";
}

} // namespace

RangeUnit findUnit(std::span<const double> ranges, const Precision& precision, std::optional<double> known) {
    RangeUnit unit;
    std::vector<double> sorted(ranges.begin(), ranges.end());
    const double far = sorted.empty() ? 0.0 : quantile(sorted, 0.95);
    if (known) {
        unit = {*known, wholeAt(ranges, precision, *known), {}};
        if (far * *known > 1000.0 * kLongestInMetres) unit.remark = "Ranges beyond 1,000 m: if the file is in millimetres, give --unit mm.";
        return unit;
    }
    // Whole millimetres are also whole tenths of a centimetre: the coarsest unit that fits is the one it was written in.
    for (const double factor : {1.0, 10.0, 1000.0}) {
        if (!wholeAt(ranges, precision, factor)) continue;
        unit = {factor, true, unitTaken(factor) + ", in which every range is a whole number of millimetres."};
        return unit;
    }
    if (sorted.empty()) return unit;
    unit.mmPerUnit = far > kLongestInMetres ? 1.0 : 1000.0;
    unit.remark = unitTaken(unit.mmPerUnit) + ", from the size of the numbers.";
    return unit;
}

std::optional<double> unitOfWarning(const std::string& warning) {
    for (const double mm : {1.0, 10.0, 1000.0}) {
        if (warning.starts_with(unitTaken(mm) + ",")) return mm;
    }
    return std::nullopt;
}

std::vector<std::uint32_t> lms2xxStatusCodes(const Grid<float>& rangeMm, const Grid<CellState>& state, const PolarGeometry& geometry) {
    // LMS2xx: fans of 100 or 180 degrees by 0.25, 0.5 or 1 degree; 13, 14 or 15 bits with the codes at their top.
    const auto [least, most] = std::minmax_element(geometry.beamDeg.begin(), geometry.beamDeg.end());
    const double step = geometry.beamDeg.size() > 1 ? std::abs(geometry.beamDeg[1] - geometry.beamDeg[0]) : 0.0;
    static constexpr std::array<double, 3> kSteps{0.25, 0.5, 1.0};
    const bool lms2xx = std::any_of(kSteps.begin(), kSteps.end(), [&](double known) { return std::abs(step - known) < 1e-6; });
    if (!lms2xx || *most - *least > 180.01) return {};
    static constexpr std::array<std::uint32_t, 5> kBelowTop{8, 4, 2, 1, 0};
    for (const std::uint32_t top : {8191U, 16383U, 32767U}) {
        std::map<std::uint32_t, std::size_t> found;
        bool other = false;
        for (std::size_t k = 0; k < rangeMm.size() && !other; ++k) {
            if (state[k] != CellState::Valid || rangeMm[k] < static_cast<float>(top - 8)) continue;
            const auto value = static_cast<std::uint32_t>(rangeMm[k]);
            if (value > top || std::none_of(kBelowTop.begin(), kBelowTop.end(), [&](auto below) { return value == top - below; }))
                other = true;
            ++found[value];
        }
        std::size_t cells = 0;
        std::vector<std::uint32_t> codes;
        for (const auto& [code, count] : found) {
            codes.push_back(code);
            cells += count;
        }
        if (!other && cells >= 3 * codes.size() && !codes.empty()) return codes;
    }
    return {};
}

} // namespace edgescan::files
