// The highest threshold at which each cell is an edge.
#include "core/edges/pipeline/threshold_map.h"

#include "core/base/simd.h"
#include "core/edges/gray/log_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace edgescan::edges {
namespace {

constexpr double kNever = -1.0;
constexpr double kAlways = std::numeric_limits<double>::infinity();
constexpr float kFloatBeyondAll = std::numeric_limits<float>::infinity();
constexpr double kBeyondAll = 1e9;   // larger than every maximum of the parameter table
constexpr double kGuessError = 1e-6; // relative

EDGESCAN_INLINE void markEdgesAt(const double* highest, std::size_t cells, double threshold, std::uint8_t* __restrict mask) {
    for (std::size_t k = 0; k < cells; ++k) mask[k] = threshold <= highest[k] ? 255 : 0;
}

// Converts a swept threshold to a threshold of the gradient, and approximately back.
struct Sweep {
    std::function<double(double)> toGradient;
    std::function<double(double)> fromGradient;
};

// Both conditions of cv::Canny, as the highest swept threshold at which a suppressed magnitude meets them.
class Limits {
public:
    Limits(double scale, const Settings& settings, Sweep sweep)
        : scale_(scale), ratio_(settings.ratio), norm_(settings.norm), sweep_(std::move(sweep)) {}

    struct Pair {
        double weak = kNever;
        double strong = kNever;
    };
    [[nodiscard]] Pair of(std::int32_t magnitude) {
        const auto [place, isNew] = known_.try_emplace(magnitude);
        if (isNew) place->second = {highest(magnitude, 1.0), highest(magnitude, ratio_)};
        return place->second;
    }

private:
    [[nodiscard]] double highest(std::int32_t magnitude, double ratio) const {
        const auto holds = [&](double threshold) {
            return magnitude > magnitudeLimit(ratio * sweep_.toGradient(threshold), scale_, norm_);
        };
        const double size = norm_ == Norm::L2 ? std::sqrt(static_cast<double>(magnitude)) : magnitude;
        return largestThreshold(holds, sweep_.fromGradient(size / scale_ / ratio));
    }

    double scale_, ratio_;
    Norm norm_;
    Sweep sweep_;
    std::unordered_map<std::int32_t, Pair> known_;
};

ThresholdMap mapOf(const Grid<std::int32_t>& suppressed, double scale, const Settings& settings, Sweep sweep) {
    Grid<double> weak(suppressed.lines, suppressed.beams, kNever);
    Grid<double> strong = weak;
    Limits limits(scale, settings, std::move(sweep));
    for (std::size_t k = 0; k < suppressed.size(); ++k) {
        if (suppressed[k] == 0) continue;
        const Limits::Pair pair = limits.of(suppressed[k]);
        weak[k] = pair.weak;
        strong[k] = std::min(pair.strong, pair.weak);
    }
    return {reconstructed(std::move(strong), weak)};
}

struct Offset {
    int line, beam;
};
constexpr std::array<Offset, 4> kBefore{{{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}}};

template <class Visit>
void forNeighbours(int lines, int beams, std::size_t k, Visit visit) {
    const auto width = static_cast<std::size_t>(beams);
    const int line = static_cast<int>(k / width), beam = static_cast<int>(k % width);
    for (int i = std::max(line - 1, 0); i <= std::min(line + 1, lines - 1); ++i) {
        for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, beams - 1); ++j) {
            if (i != line || j != beam) visit(static_cast<std::size_t>(i) * width + static_cast<std::size_t>(j));
        }
    }
}

Sweep cannySweep() {
    const auto same = [](double threshold) { return threshold; };
    return {same, same};
}

Sweep logRangeSweep(const Settings& settings) {
    return {[&](double percent) { return logRangeGradientOfStep(percent, settings); },
            [&](double gradient) { return logRangeStepOfGradient(gradient, settings); }};
}

/// The highest threshold of cell `k` alone. `limitsOf(cell)` gives its Limits::Pair. The cells around it are taken in descending order of
/// their weak limits: all taken cells are one chain at the lowest weak limit among them, an edge up to the highest strong one.
template <class LimitsOf>
double highestAt(int lines, int beams, std::size_t k, std::size_t minimumLength, LimitsOf limitsOf) {
    struct Waiting {
        Limits::Pair limits;
        std::size_t cell;
        bool operator<(const Waiting& other) const { return limits.weak < other.limits.weak; }
    };
    std::priority_queue<Waiting> waiting;
    std::vector<bool> seen(static_cast<std::size_t>(lines) * static_cast<std::size_t>(beams), false);
    const auto look = [&](std::size_t cell) {
        if (seen[cell]) return;
        seen[cell] = true;
        if (const Limits::Pair limits = limitsOf(cell); limits.weak >= 0) waiting.push({limits, cell});
    };
    look(k);
    double level = kAlways, strong = kNever, highest = kNever;
    for (std::size_t length = 1; !waiting.empty() && highest < level; ++length) {
        const Waiting next = waiting.top();
        waiting.pop();
        level = std::min(level, next.limits.weak);
        strong = std::max(strong, next.limits.strong);
        if (length >= minimumLength) highest = std::max(highest, std::min(level, strong));
        forNeighbours(lines, beams, next.cell, look);
    }
    return highest;
}

/// For Canny on a gradient.
double gradientThresholdAt(const Gradient& gradient, const Settings& settings, Sweep sweep, std::size_t k) {
    Limits limits(gradient.scale, settings, std::move(sweep));
    const auto limitsOf = [&](std::size_t cell) {
        const std::int32_t magnitude = suppressedMagnitudeAt(gradient, settings.norm, cell);
        return magnitude > 0 ? limits.of(magnitude) : Limits::Pair{};
    };
    return highestAt(gradient.alongBeams.lines, gradient.alongBeams.beams, k, 1, limitsOf);
}

} // namespace

double largestThreshold(const std::function<bool(double)>& holds, double guess) {
    if (!holds(0.0)) return kNever;
    if (holds(kBeyondAll)) return kAlways;
    double low = 0.0;
    double high = kBeyondAll;
    const double below = guess * (1.0 - kGuessError);
    const double above = guess * (1.0 + kGuessError);
    if (below > low && below < high && holds(below)) low = below;
    if (above > low && above < high && !holds(above)) high = above;
    for (double middle = low + (high - low) / 2; middle > low && middle < high; middle = low + (high - low) / 2)
        (holds(middle) ? low : high) = middle;
    return low;
}

Grid<double> reconstructed(Grid<double> marker, const Grid<double>& mask) {
    const int lines = marker.lines;
    const int beams = marker.beams;
    const auto raise = [&](int i, int j, int sign) {
        const std::size_t k = marker.index(i, j);
        if (mask[k] < 0) return;
        double value = marker[k];
        for (const Offset& o : kBefore) {
            if (marker.contains(i + sign * o.line, j + sign * o.beam))
                value = std::max(value, marker.at(i + sign * o.line, j + sign * o.beam));
        }
        marker[k] = std::min(value, mask[k]);
    };
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) raise(i, j, 1);
    }
    std::vector<std::size_t> waiting; // the cells that remain after one pass in each direction are processed by a queue
    for (int i = lines - 1; i >= 0; --i) {
        for (int j = beams - 1; j >= 0; --j) {
            raise(i, j, -1);
            const std::size_t k = marker.index(i, j);
            if (mask[k] < 0) continue;
            for (const Offset& o : kBefore) {
                if (!marker.contains(i - o.line, j - o.beam)) continue;
                const std::size_t n = marker.index(i - o.line, j - o.beam);
                if (marker[n] >= marker[k] || marker[n] >= mask[n]) continue;
                waiting.push_back(k);
                break;
            }
        }
    }
    for (std::size_t at = 0; at < waiting.size(); ++at) {
        const std::size_t k = waiting[at];
        forNeighbours(lines, beams, k, [&](std::size_t n) {
            if (marker[n] >= marker[k] || marker[n] >= mask[n]) return;
            marker[n] = std::min(marker[k], mask[n]);
            waiting.push_back(n);
        });
    }
    return marker;
}

ThresholdMap cannyThresholdMap(const Gradient& gradient, const Settings& settings) {
    return mapOf(suppressedMagnitude(gradient, settings.norm), gradient.scale, settings, cannySweep());
}

double cannyThresholdAt(const Gradient& gradient, const Settings& settings, std::size_t k) {
    return gradientThresholdAt(gradient, settings, cannySweep(), k);
}

double logRangeThresholdAt(const Scan& scan, const Settings& settings, std::size_t k) {
    if (withoutOwnRange(scan)[k] != 0) return kNever;
    return gradientThresholdAt(logRangeGradient(scan, settings), settings, logRangeSweep(settings), k);
}

ThresholdMap logRangeThresholdMap(const Scan& scan, const Settings& settings) {
    const Gradient gradient = logRangeGradient(scan, settings);
    ThresholdMap map = mapOf(suppressedMagnitude(gradient, settings.norm), gradient.scale, settings, logRangeSweep(settings));
    const Grid<std::uint8_t> without = withoutOwnRange(scan);
    for (std::size_t k = 0; k < without.size(); ++k) {
        if (without[k] != 0) map.highest[k] = kNever;
    }
    return map;
}

namespace {

// Chains that grow while cells join them. The cells of a chain that is too short for an edge are in a ring, until they are taken out.
class Chains {
public:
    explicit Chains(std::size_t cells) : parent_(cells, kNone), size_(cells, 1), next_(cells), last_(cells) {}

    [[nodiscard]] bool has(std::size_t k) const { return parent_[k] != kNone; }
    void add(std::uint32_t k) { parent_[k] = next_[k] = last_[k] = k; }
    [[nodiscard]] std::uint32_t root(std::uint32_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    [[nodiscard]] std::uint32_t size(std::uint32_t rootCell) const { return size_[rootCell]; }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return;
        if (size_[a] < size_[b]) std::swap(a, b);
        parent_[b] = a;
        size_[a] += size_[b];
        if (last_[b] == kNone) return;
        if (last_[a] != kNone) std::swap(next_[last_[a]], next_[last_[b]]); // merges two rings
        last_[a] = last_[b];
    }
    // Calls visit(cell) for each cell in the ring of this root's chain.
    template <class Visit>
    void popChain(std::uint32_t rootCell, Visit visit) {
        const std::uint32_t last = last_[rootCell];
        if (last == kNone) return;
        std::uint32_t k = last;
        do visit(k = next_[k]);
        while (k != last);
        last_[rootCell] = kNone;
    }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    std::vector<std::uint32_t> parent_, size_, next_, last_; // by cell; the last two: the next cell in the ring, and the ring's end by root
};

// Area opening: if a cell's chain is too short, its threshold is lowered until enough cells have joined the chain.
void putOffShortChains(ThresholdMap& map, int minimumLength) {
    Grid<double>& highest = map.highest;
    struct Placed {
        double level;
        std::uint32_t cell;
    };
    std::vector<Placed> order;
    order.reserve(static_cast<std::size_t>(std::ranges::count_if(highest.cells, [](double level) { return level >= 0; })));
    for (std::size_t k = 0; k < highest.size(); ++k) {
        if (highest[k] >= 0) order.push_back({highest[k], static_cast<std::uint32_t>(k)});
    }
    std::ranges::sort(order, [](const Placed& a, const Placed& b) { return a.level != b.level ? a.level > b.level : a.cell < b.cell; });
    std::ranges::fill(highest.cells, kNever);
    Chains chains(highest.size());
    const auto wanted = static_cast<std::uint32_t>(minimumLength);
    for (std::size_t at = 0; at < order.size();) {
        const double level = order[at].level;
        const std::size_t from = at;
        for (; at < order.size() && order[at].level == level; ++at) {
            const std::uint32_t k = order[at].cell;
            chains.add(k);
            forNeighbours(highest.lines, highest.beams, k, [&](std::size_t n) {
                if (chains.has(n)) chains.join(k, static_cast<std::uint32_t>(n));
            });
        }
        for (std::size_t n = from; n < at; ++n) {
            const std::uint32_t root = chains.root(order[n].cell);
            if (chains.size(root) >= wanted) chains.popChain(root, [&](std::uint32_t member) { highest[member] = level; });
        }
    }
}

// The largest threshold that is rounded to this float and not to the next: their middle if that is rounded to the even one, otherwise the
// number below it.
double largestRoundedTo(float value) {
    const double middle = 0.5 * (static_cast<double>(value) + static_cast<double>(std::nextafter(value, kFloatBeyondAll)));
    return static_cast<float>(middle) == value ? middle : std::nextafter(middle, 0.0);
}

// largestThreshold() of here > float(threshold) x share, for here > 0 and share >= 0, without a search.
double largestLinked(float here, float share) {
    if (here > static_cast<float>(kBeyondAll) * share) return kAlways;
    float highest = here / share; // wrong by a few floats at most
    while (highest > 0 && !(here > highest * share)) highest = std::nextafter(highest, 0.0F);
    for (float next = std::nextafter(highest, kFloatBeyondAll); here > next * share; next = std::nextafter(next, kFloatBeyondAll))
        highest = next;
    return largestRoundedTo(highest);
}

// Of a strength above 0.
Limits::Pair linkedLimits(float strength, float share) { return {largestLinked(strength, share), largestLinked(strength, 1.0F)}; }

} // namespace

ThresholdMap linkedThresholdMap(const Grid<float>& strength, double lowShare, int minimumLength) {
    const auto share = static_cast<float>(lowShare);
    Grid<double> weak(strength.lines, strength.beams, kNever);
    Grid<double> strong = weak;
    for (std::size_t k = 0; k < strength.size(); ++k) {
        if (!(strength[k] > 0)) continue;
        const Limits::Pair limits = linkedLimits(strength[k], share);
        weak[k] = limits.weak;
        strong[k] = std::min(limits.weak, limits.strong);
    }
    ThresholdMap map{reconstructed(std::move(strong), weak)};
    if (minimumLength > 1) {
        weak = {}; // frees its memory
        putOffShortChains(map, minimumLength);
    }
    return map;
}

double linkedThresholdAt(int lines, int beams, const std::function<float(std::size_t)>& strengthOf, double lowShare, int minimumLength,
                         std::size_t k) {
    const auto share = static_cast<float>(lowShare);
    const auto limitsOf = [&](std::size_t cell) {
        const float strength = strengthOf(cell);
        return strength > 0 ? linkedLimits(strength, share) : Limits::Pair{};
    };
    return highestAt(lines, beams, k, static_cast<std::size_t>(std::max(minimumLength, 1)), limitsOf);
}

ThresholdMap responseThresholdMap(const Grid<float>& response) {
    ThresholdMap map{Grid<double>(response.lines, response.beams)};
    for (std::size_t k = 0; k < response.size(); ++k) map.highest[k] = responseThresholdAt(response, k);
    return map;
}

double responseThresholdAt(const Grid<float>& response, std::size_t k) {
    return response[k] > 0 ? std::nextafter(static_cast<double>(response[k]), 0.0) : kNever;
}

Grid<std::uint8_t> edgesAt(const ThresholdMap& map, double threshold) {
    Grid<std::uint8_t> mask(map.highest.lines, map.highest.beams);
    vectorised<markEdgesAt>(map.highest.cells.data(), mask.size(), threshold, mask.cells.data());
    return mask;
}

} // namespace edgescan::edges
