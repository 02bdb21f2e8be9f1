// The surest points first, then those between them.
#include "core/files/grid_recovery/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace edgescan::files::recognition {
namespace {

constexpr double kOnCell = 0.45;                              // of a step
constexpr double kOneMore = 1.5;                              // steps that a point may be moved beyond its error, to make room
constexpr std::array<double, 4> kLevels{1.0, 4.0, 16.0, 1e9}; // steps of error: the more certain ones choose first
constexpr double kMostSearched = 1 << 16;

class Placer {
public:
    Placer(std::span<const OnCell> returns, std::span<const AxisPoint> points, Grid<std::uint32_t>& pointOf)
        : returns_(returns), points_(points), pointOf_(pointOf) {}

    Placed place() {
        std::vector<std::uint32_t> ofLine, ofBeam;
        for (std::uint32_t n = 0; n < returns_.size(); ++n) {
            const OnCell& r = returns_[n];
            const bool line = r.lineError <= kOnCell;
            const bool beam = r.beamError <= kOnCell;
            if (line && beam)
                putSure(r);
            else if (line)
                ofLine.push_back(n);
            else if (beam)
                ofBeam.push_back(n);
            else
                left_.push_back(n);
        }
        spreadGroups(ofLine, true);
        spreadGroups(ofBeam, false);
        for (const std::uint32_t n : left_) putNearest(returns_[n]);
        return placed_;
    }

private:
    [[nodiscard]] int nearest(double place, int count) const { return std::clamp(static_cast<int>(std::lround(place)), 0, count - 1); }
    [[nodiscard]] bool same(std::uint32_t a, std::uint32_t b) const {
        return points_[a].u == points_[b].u && points_[a].v == points_[b].v && points_[a].w == points_[b].w;
    }
    void putSure(const OnCell& r) {
        std::uint32_t& cell = pointOf_.at(nearest(r.line, pointOf_.lines), nearest(r.beam, pointOf_.beams));
        if (cell != kNone) ++(same(cell, r.point) ? placed_.copied : placed_.doubled);
        if (cell == kNone || r.range < points_[cell].range()) cell = r.point;
    }
    /// Points whose line (or beam) is sure, one line after the other.
    void spreadGroups(std::vector<std::uint32_t>& group, bool onLines) {
        const auto fixed = [&](std::uint32_t n) {
            return onLines ? nearest(returns_[n].line, pointOf_.lines) : nearest(returns_[n].beam, pointOf_.beams);
        };
        const auto error = [&](std::uint32_t n) { return onLines ? returns_[n].beamError : returns_[n].lineError; };
        const auto place = [&](std::uint32_t n) { return onLines ? returns_[n].beam : returns_[n].line; };
        const auto level = [&](std::uint32_t n) {
            return std::find_if(kLevels.begin(), kLevels.end(), [&](double most) { return error(n) <= most; }) - kLevels.begin();
        };
        std::vector<std::array<double, 4>> keys(group.size()); // line or beam, level, place, index
        for (std::size_t g = 0; g < group.size(); ++g) {
            const auto itsLevel = static_cast<std::size_t>(level(group[g]));
            // Where nothing else gives the place, the order of the list does.
            const bool unknown = itsLevel + 1 >= kLevels.size();
            keys[g] = {static_cast<double>(fixed(group[g])), static_cast<double>(itsLevel), unknown ? 0.0 : place(group[g]),
                       static_cast<double>(group[g])};
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t from = 0; from < keys.size();) {
            std::size_t to = from;
            std::vector<std::uint32_t> some;
            while (to < keys.size() && keys[to][0] == keys[from][0] && keys[to][1] == keys[from][1])
                some.push_back(static_cast<std::uint32_t>(keys[to++][3]));
            spread(static_cast<int>(keys[from][0]), some, onLines);
            from = to;
        }
    }
    /// Points of one line (or beam), in the order of their places, onto its free cells.
    void spread(int fixed, std::vector<std::uint32_t>& some, bool onLine) {
        std::vector<double> free;
        const int count = onLine ? pointOf_.beams : pointOf_.lines;
        const auto cell = [&](int place) -> std::uint32_t& { return onLine ? pointOf_.at(fixed, place) : pointOf_.at(place, fixed); };
        for (int place = 0; place < count; ++place) {
            if (cell(place) == kNone) free.push_back(place);
        }
        const auto error = [&](std::uint32_t n) { return onLine ? returns_[n].beamError : returns_[n].lineError; };
        const auto place = [&](std::uint32_t n) { return onLine ? returns_[n].beam : returns_[n].line; };
        if (some.size() > free.size()) { // the surest stay
            std::vector<std::uint32_t> bySurety = some;
            std::stable_sort(bySurety.begin(), bySurety.end(), [&](auto a, auto b) { return error(a) < error(b); });
            std::vector<bool> stays(some.size(), false);
            bySurety.resize(free.size());
            std::sort(bySurety.begin(), bySurety.end());
            std::erase_if(some, [&](std::uint32_t n) {
                if (std::binary_search(bySurety.begin(), bySurety.end(), n)) return false;
                left_.push_back(n);
                return true;
            });
        }
        std::vector<double> wanted, weights;
        for (std::size_t k = 0; k < some.size(); ++k) {
            const bool unknown = error(some[k]) >= kLevels[2];
            wanted.push_back(unknown ? static_cast<double>(k) : placeAmong(free, place(some[k])));
            weights.push_back(1 / (error(some[k]) * error(some[k]) + 1e-12));
        }
        const auto taken = spreadInOrder(wanted, weights, free.size());
        for (std::size_t k = 0; k < some.size(); ++k) {
            const double to = free[taken[k]];
            if (std::abs(to - place(some[k])) > error(some[k]) + kOneMore)
                left_.push_back(some[k]);
            else
                cell(static_cast<int>(to)) = returns_[some[k]].point;
        }
    }
    /// The nearest free cell within the point's errors, or a little beyond where others took these.
    void putNearest(const OnCell& r) {
        OnCell turned = r;
        turned.line = r.turnedLine;
        turned.beam = r.turnedBeam;
        for (const double widened : {1.0, 2.0, 4.0, 16.0, 256.0}) {
            if (putWithin(r, widened) || (r.turnsOver && putWithin(turned, widened))) return;
        }
        ++placed_.unplaced;
    }
    bool putWithin(const OnCell& r, double widened) {
        const auto window = [widened](double place, double error, int count) {
            const double reach = std::min(error, 1e6) * widened + 0.5;
            return std::pair(std::clamp(static_cast<int>(std::ceil(place - reach)), 0, count),
                             std::clamp(static_cast<int>(std::floor(place + reach)) + 1, 0, count));
        };
        const auto [fromLine, toLine] = window(r.line, r.lineError, pointOf_.lines);
        const auto [fromBeam, toBeam] = window(r.beam, r.beamError, pointOf_.beams);
        std::uint32_t* best = nullptr;
        double least = 0;
        if (static_cast<double>(toLine - fromLine) * static_cast<double>(toBeam - fromBeam) <= kMostSearched) {
            for (int i = fromLine; i < toLine; ++i) {
                for (int j = fromBeam; j < toBeam; ++j) {
                    if (pointOf_.at(i, j) != kNone) continue;
                    const double distance = std::hypot((i - r.line) / (r.lineError + 0.1), (j - r.beam) / (r.beamError + 0.1));
                    if (best != nullptr && distance >= least) continue;
                    best = &pointOf_.at(i, j);
                    least = distance;
                }
            }
        }
        if (best != nullptr) *best = r.point;
        return best != nullptr;
    }

    std::span<const OnCell> returns_;
    std::span<const AxisPoint> points_;
    Grid<std::uint32_t>& pointOf_;
    std::vector<std::uint32_t> left_;
    Placed placed_;
};

} // namespace

Placed placeOnCells(std::span<const OnCell> returns, std::span<const AxisPoint> points, Grid<std::uint32_t>& pointOf) {
    return Placer(returns, points, pointOf).place();
}

} // namespace edgescan::files::recognition
