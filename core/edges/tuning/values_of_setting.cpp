// Runs the method at many values of one setting.
#include "core/edges/tuning/values_of_setting.h"

#include "core/edges/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr double kSpread = 4.0;     // from a fourth of the value to four times the value
constexpr double kSteadyLoss = 0.2; // share of the edge cells, over a whole run of values

} // namespace

std::vector<double> sheetValues(const Parameter& p, double now, std::size_t most) {
    std::vector<double> values;
    if (most == 0) return values;
    if (!p.choices.empty()) {
        for (const Choice& choice : p.choices) values.push_back(choice.value);
        std::ranges::sort(values);
        if (values.size() > most) values.resize(most);
        return values;
    }
    const double from = p.minimum, to = p.sliderMaximum;
    const auto count = static_cast<double>(most);
    for (std::size_t n = 0; n < most; ++n) {
        const double share = most == 1 ? 0.5 : static_cast<double>(n) / (count - 1.0);
        const double value = now > 0.0 && !std::isnan(now) ? now * std::pow(kSpread, 2.0 * share - 1.0) : from + share * (to - from);
        values.push_back(snapped(p, std::clamp(value, from, to)));
    }
    if (!std::isnan(now)) { // the current value replaces the nearest one
        const auto nearest = std::ranges::min_element(values, {}, [now](double value) { return std::abs(value - now); });
        *nearest = now;
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

void markSteady(std::vector<SheetEntry>& entries) {
    std::size_t bestFrom = 0, bestTo = 0;
    for (std::size_t from = 0; from < entries.size(); ++from) {
        std::size_t most = 0, least = entries[from].edges;
        for (std::size_t to = from; to < entries.size(); ++to) {
            most = std::max(most, entries[to].edges);
            least = std::min(least, entries[to].edges);
            if (least == 0 || static_cast<double>(least) < (1.0 - kSteadyLoss) * static_cast<double>(most)) break;
            if (to - from > bestTo - bestFrom) {
                bestFrom = from;
                bestTo = to;
            }
        }
    }
    for (std::size_t n = 0; n < entries.size(); ++n) entries[n].steady = bestTo > bestFrom && n >= bestFrom && n <= bestTo;
}

std::vector<SheetEntry> contactSheet(const std::shared_ptr<const Scan>& scan, const Settings& settings, const Parameter& parameter,
                                     const std::vector<double>& values,
                                     const std::function<bool(const SheetEntry&, const Detection&)>& made) {
    std::vector<SheetEntry> entries;
    Pipeline pipeline;
    for (const double value : values) {
        Settings with = settings;
        parameter.set(with, value);
        const auto detection = pipeline.run(scan, with);
        entries.push_back({value, detection->edges->size()});
        if (!made(entries.back(), *detection)) return entries;
    }
    markSteady(entries);
    return entries;
}

} // namespace edgescan::edges
