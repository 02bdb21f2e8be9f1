// One run for each nearby setting. The innermost loop changes the threshold, because that needs only comparisons.
#include "core/edges/tuning/confidence.h"

#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace edgescan::edges {
namespace {

constexpr std::string_view kOfGaps = "fill"; // changes the cells themselves, not the decision which of them are edges

/// The parameters that are varied: numbers that change smoothing, responses or edges, and sizes (choices with a unit).
bool isVaried(const Parameter& parameter, const Settings& settings) {
    const Stage feeds = parameter.feeds;
    const bool shapes = feeds == Stage::Smoothing || feeds == Stage::Responses || feeds == Stage::Edges;
    const bool ordered = !parameter.several && (parameter.choices.empty() || *parameter.unit != '\0');
    return shapes && ordered && !parameter.advanced && parameter.key != kOfGaps && parameter.usedBy(settings);
}

/// One value below and one above; values that the parameter cannot take are left out.
std::vector<double> variedValues(const Parameter& parameter, const Settings& settings, const Measured& measured) {
    double now = parameter.get(settings);
    if (std::isnan(now) && parameter.automatic != nullptr) now = parameter.automatic(settings, measured);
    if (std::isnan(now)) return {};
    const bool isNumber = parameter.choices.empty();
    const double down = isNumber ? std::min(now / kVariationFactor, now - parameter.step) : now - parameter.step;
    const double up = isNumber ? std::max(now * kVariationFactor, now + parameter.step) : now + parameter.step;
    std::vector<double> values;
    for (const double value : {down, up}) {
        const double taken = snapped(parameter, std::clamp(value, parameter.minimum, parameter.maximum));
        if (taken != now) values.push_back(taken);
    }
    return values;
}

Settings with(Settings settings, const Parameter& parameter, double value) {
    parameter.set(settings, value);
    return settings;
}

/// 255 where the mask has an edge in the cell or in one of its eight neighbours.
void addNear(const Grid<std::uint8_t>& mask, const std::vector<std::uint32_t>& edges, std::vector<std::uint16_t>& times) {
    for (std::size_t n = 0; n < edges.size(); ++n) {
        const int line = static_cast<int>(edges[n]) / mask.beams, beam = static_cast<int>(edges[n]) % mask.beams;
        bool found = false;
        for (int i = std::max(0, line - 1); i <= std::min(mask.lines - 1, line + 1) && !found; ++i) {
            for (int j = std::max(0, beam - 1); j <= std::min(mask.beams - 1, beam + 1) && !found; ++j) found = mask.at(i, j) != 0;
        }
        times[n] = static_cast<std::uint16_t>(times[n] + (found ? 1 : 0));
    }
}

} // namespace

std::vector<Settings> nearbySettings(const Detection& detection) {
    const Settings& now = detection.settings;
    const Measured measured = measuredOf(detection);
    std::vector<Settings> shaped{now};
    for (const Parameter& parameter : parameters()) {
        if (!isVaried(parameter, now)) continue;
        for (const double value : variedValues(parameter, now, measured)) shaped.push_back(with(now, parameter, value));
    }
    const Parameter& threshold = sweptParameter(now.method);
    std::vector<Settings> all;
    for (const Settings& one : shaped) {
        all.push_back(one);
        for (const double value : variedValues(threshold, now, measured)) all.push_back(with(one, threshold, value));
    }
    return all;
}

std::optional<EdgeConfidence> edgeConfidence(const Detection& detection, const std::function<bool(double done)>& goOn) {
    const std::vector<Settings> tried = nearbySettings(detection);
    const std::vector<std::uint32_t>& edges = *detection.edges;
    std::vector<std::uint16_t> times(edges.size(), 0);
    Pipeline pipeline;
    for (std::size_t n = 0; n < tried.size(); ++n) {
        if (goOn && !goOn(static_cast<double>(n) / static_cast<double>(tried.size()))) return std::nullopt;
        addNear(*pipeline.run(detection.scan, tried[n])->mask, edges, times);
    }
    EdgeConfidence made{Grid<std::uint8_t>(detection.mask->lines, detection.mask->beams), static_cast<int>(tried.size())};
    for (std::size_t n = 0; n < edges.size(); ++n)
        made.percent[edges[n]] = static_cast<std::uint8_t>(100U * times[n] / static_cast<unsigned>(tried.size()));
    return made;
}

std::size_t confidenceBand(int percent) {
    std::size_t band = 0;
    while (percent < kConfidenceBands[band]) ++band;
    return band;
}

} // namespace edgescan::edges
