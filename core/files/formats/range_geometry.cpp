// Angles from the options, or those of an LMS511; the unit from the numbers.
#include "core/files/formats/range_geometry.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/grid_recovery/unit.h"
#include "core/files/point_tables/repeated_values.h"

#include <algorithm>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr std::size_t kLms511Beams = 1141;

struct NotRanges {
    std::size_t infinite = 0, negative = 0, absurd = 0;

    void addTo(std::vector<std::string>& warnings) const {
        const auto warn = [&](std::size_t count, const std::string& what) {
            if (count > 0) warnings.push_back(std::to_string(count) + what);
        };
        warn(infinite, " infinite ranges were taken as no return.");
        warn(negative, " ranges below 0, all the same number, were taken as no return.");
        warn(absurd, " ranges longer than any scanner reaches were taken as no return.");
    }
};

/// Numbers that are not ranges become 0.
Result<NotRanges> clearNoRanges(BareRanges& ranges, const Source& source, const std::function<std::string(std::size_t, std::size_t)>& at) {
    NotRanges found;
    double marker = 0.0;
    for (std::size_t k = 0; k < ranges.values.size(); ++k) {
        double& value = ranges.values[k];
        found.infinite += std::isinf(value) ? 1 : 0;
        if (value < 0 && std::isfinite(value)) {
            if (!isNoRangeMark(value) || (marker < 0 && value != marker)) {
                return source.refused(
                    withValues("%1 holds %2, which is not a range", {at(k / ranges.beams, k % ranges.beams), shortestText(value)}),
                    "check that these are ranges; points need columns x, y and z");
            }
            marker = value;
            ++found.negative;
        }
        if (!std::isfinite(value) || value < 0) value = 0;
    }
    return found;
}

Eigen::Vector3d directionOf(const PolarGeometry& polar, std::size_t line, std::size_t beam) {
    const double a = radians(polar.beamDeg[beam]), p = radians(polar.lineDeg[line]);
    if (polar.axis == Axis::Spin) return {std::cos(a) * std::cos(p), std::cos(a) * std::sin(p), std::sin(a)};
    return {std::cos(a), std::sin(a) * std::cos(p), std::sin(a) * std::sin(p)};
}

/// The largest ranges become 0 where they mean "no return"; a sentence then.
std::string clearRepeated(BareRanges& ranges, const PolarGeometry& polar, const Source& source) {
    if (source.options->keepRepeated) return {};
    const auto direction = [&](std::size_t k) { return directionOf(polar, k / ranges.beams, k % ranges.beams); };
    std::string sentence;
    constexpr int kMostCodes = 3;
    for (int code = 0; code < kMostCodes; ++code) {
        const auto found = repeatedRange({ranges.values, 0, 0, direction, ranges.stated});
        if (!found) break;
        if (!sentence.empty()) sentence += ' ';
        sentence += repeatedSentence(found->count, withValues("cells hold %1 in the numbers of the file", {shortestText(found->least)}));
        for (double& value : ranges.values) value = value >= found->least ? 0 : value;
    }
    return sentence;
}

} // namespace

Result<Scan> scanFromRanges(BareRanges ranges, const WithoutAngles& what, const Source& source,
                            const std::function<std::string(std::size_t, std::size_t)>& at) {
    auto notRanges = clearNoRanges(ranges, source, at);
    if (!notRanges) return notRanges.error();
    auto angles = assumedAngles(ranges.lines, ranges.beams, what, source);
    if (!angles) return angles.error();
    const std::string repeated = clearRepeated(ranges, angles->polar, source);
    std::vector<double> returns;
    std::ranges::copy_if(ranges.values, std::back_inserter(returns), [](double range) { return range > 0; });
    const RangeUnit unit = findUnit(returns, ranges.precision, source.options->unitMm);
    Scan scan;
    const auto lines = static_cast<int>(ranges.lines);
    const auto beams = static_cast<int>(ranges.beams);
    scan.rangeMm = Grid<float>(lines, beams);
    scan.state = Grid<CellState>(lines, beams, CellState::NoReturn);
    for (std::size_t k = 0; k < ranges.values.size(); ++k) {
        const double mm = ranges.values[k] * unit.mmPerUnit;
        if (!(mm > 0)) continue;
        if (!physical::kRangeMm.hold(mm)) {
            ++notRanges->absurd;
            continue;
        }
        scan.rangeMm[k] = static_cast<float>(unit.wholeMm ? std::round(mm) : mm);
        scan.state[k] = CellState::Valid;
    }
    scan.geometry = std::move(angles->polar);
    if (!angles->warning.empty()) scan.warnings.push_back(angles->warning);
    if (!unit.remark.empty()) scan.warnings.push_back(unit.remark);
    notRanges->addTo(scan.warnings);
    if (!repeated.empty()) scan.warnings.push_back(repeated);
    return scan;
}

Result<Done> checkAnglesKnown(std::size_t beams, const WithoutAngles& what, const Source& source) {
    if (beams == kLms511Beams) return Done{};
    const ReadingOptions& options = *source.options;
    std::string missing;
    const auto need = [&](bool given, const char* flag) {
        if (!given) missing += std::string(missing.empty() ? "" : " ") + flag;
    };
    need(options.beamStartDeg.has_value(), "--beam-start");
    need(options.beamStepDeg.has_value(), "--beam-step");
    need(options.lineStartDeg.has_value(), "--line-start");
    need(options.lineStepDeg.has_value(), "--line-step");
    need(options.axis.has_value(), "--axis");
    if (missing.empty()) return Done{};
    return source.refused(withValues(what.refusal, {counted(beams, "range")}), withValues("give %1", {missing}));
}

Result<AssumedAngles> assumedAngles(std::size_t lines, std::size_t beams, const WithoutAngles& what, const Source& source) {
    if (auto known = checkAnglesKnown(beams, what, source); !known) return known.error();
    const ReadingOptions& options = *source.options;
    AssumedAngles angles;
    const double beamStart = options.beamStartDeg.value_or(-5.0);
    const double beamStep = options.beamStepDeg.value_or(1.0 / 6.0);
    const double lineStart = options.lineStartDeg.value_or(0.0);
    const double lineStep = options.lineStepDeg.value_or(0.18);
    for (std::size_t j = 0; j < beams; ++j) angles.polar.beamDeg.push_back(beamStart + static_cast<double>(j) * beamStep);
    for (std::size_t i = 0; i < lines; ++i) angles.polar.lineDeg.push_back(lineStart + static_cast<double>(i) * lineStep);
    angles.polar.axis = options.axis.value_or(Axis::Spin);
    if (options.beamStartDeg && options.beamStepDeg && options.lineStartDeg && options.lineStepDeg && options.axis) return angles;
    angles.warning = std::string(what.warning) +
                     ": those of an LMS511 were taken where none were given (beams from -5 degrees by 1/6 degree, lines from 0 by 0.18 "
                     "degree, axis spin).";
    return angles;
}

std::vector<std::string> seldomMeasured(const Scan& scan, const std::string& unit) {
    constexpr float kFarMm = 1e6F, kNearMm = 100;
    std::vector<std::string> doubts;
    const RangeLimits limits = rangeLimits(scan);
    if (limits.maxMm > kFarMm)
        doubts.push_back(withValues("The ranges reach %1 km: check %2.", {fixedText(limits.maxMm / kFarMm, 1), unit}));
    else if (limits.maxMm > 0 && limits.maxMm < kNearMm)
        doubts.push_back(withValues("All ranges are below 100 mm, so they may be metres: check %1.", {unit}));
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->lineDeg.size() < 2) return doubts;
    if (const auto [least, most] = std::ranges::minmax(polar->lineDeg); least == most)
        doubts.push_back(withValues("All %1 lines are at one angle: check the step from line to line.", {polar->lineDeg.size()}));
    return doubts;
}

} // namespace edgescan::files
