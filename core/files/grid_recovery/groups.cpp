// Finds the grid of a list in any order, with points left out: its plane angles and tilts gather in groups with voids between them.
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/return_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace edgescan::files::recognition {
namespace {

/// A return and its place on a grid.
struct OnCell {
    std::uint32_t point = 0;
    double range = 0.0;
    double line = 0.0, beam = 0.0;           ///< in lines and beams
    double lineError = 0.0, beamError = 0.0; ///< the same; bounds
    bool turnsOver = false;                  ///< may lie on the other side of the axis just as well:
    double turnedLine = 0.0, turnedBeam = 0.0;
};

/// What became of the points.
struct Placed {
    std::size_t unplaced = 0; ///< no cell within the error was free
    std::size_t doubled = 0;  ///< different points in one cell
    std::size_t copied = 0;   ///< the same point again
};

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

/// Gives each point a cell of `pointOf`: sure ones theirs, where the nearer of two stays; all others, in the order of their angles, cells
/// that remain free within their errors. `points` serves to find equal points.
Placed placeOnCells(std::span<const OnCell> returns, std::span<const AxisPoint> points, Grid<std::uint32_t>& pointOf) {
    return Placer(returns, points, pointOf).place();
}

constexpr double kTelling = 1.0 / 12;  // of a step: a more precise angle shows whether it is on a group
constexpr double kLeastTelling = 0.05; // of the returns
constexpr double kSideSure = 0.6;      // error of the plane angle, radians

/// How well angles lie on the groups of a ring.
class OnRing {
public:
    explicit OnRing(const Ring& ring) : ring_(ring), least_(median(ring.voids()) * 0.5) {}

    struct Place {
        double at = 0.0;   ///< in groups
        double step = 0.0; ///< to the neighbour on that side
        std::size_t group = 0;
        bool telling = false, off = false;
    };
    [[nodiscard]] Place place(double angle, double error) const {
        const Ring::Nearest near = ring_.nearest(angle);
        const double side = std::remainder(angle - ring_.centres[near.group], ring_.period) < 0 ? -1 : 1;
        const double step = std::min(near.voidWidth, 8 * least_); // the void after the last group is not a step
        Place place{static_cast<double>(near.group) + side * near.distance / step, step, near.group, false, false};
        place.telling = error <= kTelling * step;
        place.off = near.distance > 0.25 * step + error;
        return place;
    }

private:
    const Ring& ring_;
    double least_;
};

/// Counts what is telling, and what of it is on the groups.
struct Share {
    std::size_t telling = 0, on = 0;
    void add(const OnRing::Place& place) {
        telling += place.telling ? 1 : 0;
        on += place.telling && !place.off ? 1 : 0;
    }
    /// 0 where too few are telling.
    [[nodiscard]] double of(std::size_t returns, std::size_t groups) const {
        const bool enough =
            static_cast<double>(telling) >= kLeastTelling * static_cast<double>(returns) && telling >= kPointsPerGroup * groups;
        return enough ? static_cast<double>(on) / static_cast<double>(telling) : 0.0;
    }
};

class GroupFitter {
public:
    GroupFitter(std::span<const AxisPoint> points, const std::vector<ReturnAngles>& seen, double period)
        : points_(points), seen_(seen), period_(period) {}

    std::optional<Fit> fit(NoFit& best) {
        std::vector<Angle> planes;
        planes.reserve(seen_.size());
        for (const ReturnAngles& s : seen_) {
            if (s.planeError < kPi) planes.push_back({s.plane, s.planeError});
        }
        for (Ring& lines : ringsAmong(planes, period_)) {
            const double onLines = placeOnLines(lines);
            remember(best, lines.centres.size(), 0, onLines);
            if (onLines < kShareOnGrid) continue;
            if (beginWhereFanTurnsOver(lines)) placeOnLines(lines);
            const std::vector<Angle> tilts = tiltsOn(lines);
            for (const Ring& beams : ringsAmong(tilts, 2 * kPi)) {
                if (seen_.size() < kPointsPerGroup * (lines.centres.size() + beams.centres.size())) continue;
                const OnRing onRing(beams);
                Share share;
                for (std::size_t n = 0; n < seen_.size(); ++n) {
                    if (sideKnown_[n]) share.add(onRing.place(signedTilt_[n], seen_[n].tiltError));
                }
                const double onBeams = share.of(seen_.size(), beams.centres.size());
                remember(best, lines.centres.size(), beams.centres.size(), onBeams);
                if (onBeams < kShareOnGrid) continue;
                if (auto found = filled(lines, beams)) return found;
            }
        }
        return std::nullopt;
    }
    /// How often the line changes from one point of the list to the next: few changes show that the file was written in this order.
    [[nodiscard]] std::size_t lineChanges() const {
        std::size_t changes = 0;
        for (std::size_t n = 1; n < line_.size(); ++n) changes += line_[n].group != line_[n - 1].group ? 1 : 0;
        return changes;
    }
    [[nodiscard]] std::size_t returns() const { return seen_.size(); }

private:
    static void remember(NoFit& seen, std::size_t lines, std::size_t beams, double share) {
        if (lines < 4 || (beams > 0 && beams < 4)) return; // a few groups hold most of any cloud
        if (share * (beams > 0 ? 2 : 1) <= seen.onGrid * (seen.beams > 0 ? 2 : 1)) return;
        seen = {lines, beams, share};
    }
    /// Planes all around the axis leave no void to begin after, and the fan is on the other side of the plane before the place where they
    /// begin. True when the ring was turned to begin there.
    bool beginWhereFanTurnsOver(Ring& lines) const {
        if (period_ > 1.5 * kPi || lines.centres.size() < 3) return false;
        std::vector<double> side(lines.centres.size(), 0.0); // sum of the sines of the tilts
        for (std::size_t n = 0; n < seen_.size(); ++n) {
            const double sine = std::sin(seen_[n].tilt);
            side[line_[n].group] += std::cos(seen_[n].plane - lines.centres[line_[n].group]) >= 0 ? sine : -sine;
        }
        double sum = 0;
        for (const double one : side) sum += one;
        double all = 0; // a fan that is even on both sides turns over nowhere
        for (const ReturnAngles& s : seen_) all += std::sin(s.tilt);
        double most = std::max(1.05 * std::abs(sum), 0.3 * all);
        std::size_t cut = 0;
        for (std::size_t i = 0; i + 1 < side.size(); ++i) {
            sum -= 2 * side[i];
            if (std::abs(sum) <= most) continue;
            most = std::abs(sum);
            cut = i + 1;
        }
        if (cut > 0) lines.beginAt(cut);
        return cut > 0;
    }
    double placeOnLines(const Ring& lines) {
        const OnRing onRing(lines);
        if (!seemsOn(onRing)) return 0.0;
        Share share;
        line_.clear();
        for (const ReturnAngles& s : seen_) {
            line_.push_back(onRing.place(s.plane, s.planeError));
            share.add(line_.back());
        }
        return share.of(seen_.size(), lines.centres.size());
    }
    /// A first look at some of the returns: most rings fail here.
    [[nodiscard]] bool seemsOn(const OnRing& onRing) const {
        constexpr std::size_t kSome = 20'000;
        Share share;
        const std::size_t stride = seen_.size() / kSome + 1;
        for (std::size_t n = 0; n < seen_.size(); n += stride) share.add(onRing.place(seen_[n].plane, seen_[n].planeError));
        return static_cast<double>(share.on) >= 0.9 * static_cast<double>(share.telling);
    }
    /// Tilts of the returns whose side of the axis is known: those on a line, and those so far from the first and the last one that all
    /// lines they may belong to give them the same side. On the axis there is but one side.
    std::vector<Angle> tiltsOn(const Ring& lines) {
        signedTilt_.assign(seen_.size(), 0.0);
        sideKnown_.assign(seen_.size(), false);
        std::vector<Angle> tilts;
        tilts.reserve(seen_.size());
        for (std::size_t n = 0; n < seen_.size(); ++n) {
            const ReturnAngles& s = seen_[n];
            const double centre = lines.centres[line_[n].group];
            const bool positive = period_ > 1.5 * kPi || std::cos(s.plane - centre) >= 0;
            signedTilt_[n] = positive ? s.tilt : -s.tilt;
            const double towardsFirst = centre - lines.centres.front() + 0.5 * line_[n].step;
            const double towardsLast = lines.centres.back() - centre + 0.5 * line_[n].step;
            const bool onLine = s.planeError <= 0.25 * line_[n].step;
            const bool inside = s.planeError <= kSideSure && std::min(towardsFirst, towardsLast) > s.planeError;
            const bool onAxis = s.planeError >= kPi && std::min(s.tilt, kPi - s.tilt) <= 2 * s.tiltError;
            sideKnown_[n] = onLine || inside || onAxis || period_ > 1.5 * kPi;
            if (sideKnown_[n] && !line_[n].off) tilts.push_back({signedTilt_[n], s.tiltError});
        }
        return tilts;
    }
    /// The same point at the other end of the lines, seen from the other side of its plane.
    static void turnOver(OnCell& cell, const OnRing::Place& beam, std::size_t lines) {
        cell.turnsOver = !beam.off;
        cell.turnedBeam = beam.at;
        cell.turnedLine = cell.line + (cell.line * 2 < static_cast<double>(lines) ? 1 : -1) * static_cast<double>(lines);
    }
    std::optional<Fit> filled(const Ring& lines, const Ring& beams) {
        const double cells = static_cast<double>(lines.centres.size()) * static_cast<double>(beams.centres.size());
        if (static_cast<double>(seen_.size()) < kLeastFilled * cells) return std::nullopt;
        Fit fit;
        fit.plane = lines.centres;
        fit.tilt = beams.centres;
        fit.pointOf = Grid<std::uint32_t>(static_cast<int>(lines.centres.size()), static_cast<int>(beams.centres.size()), kNone);
        const OnRing onBeams(beams);
        std::vector<OnCell> returns;
        returns.reserve(seen_.size());
        for (std::size_t n = 0; n < seen_.size(); ++n) {
            const ReturnAngles& s = seen_[n];
            const OnRing::Place beam = onBeams.place(signedTilt_[n], s.tiltError);
            if (line_[n].off || beam.off) {
                ++fit.unplaced;
                continue;
            }
            const double lineError = s.planeError >= kPi ? std::numeric_limits<double>::infinity() : s.planeError / line_[n].step;
            returns.push_back({s.point, points_[s.point].range(), line_[n].at, beam.at, lineError, s.tiltError / beam.step});
            if (period_ < 1.5 * kPi && lineError > 1)
                turnOver(returns.back(), onBeams.place(-signedTilt_[n], s.tiltError), lines.centres.size());
        }
        const Placed placed = placeOnCells(returns, points_, fit.pointOf);
        fit.unplaced += placed.unplaced;
        fit.doubled = placed.doubled;
        fit.copied = placed.copied;
        if (static_cast<double>(fit.doubled + fit.unplaced) > kMostDoubled * static_cast<double>(seen_.size()))
            return std::nullopt; // cells that are too large hold several different points
        return fit;
    }

    std::span<const AxisPoint> points_;
    const std::vector<ReturnAngles>& seen_;
    double period_;
    std::vector<OnRing::Place> line_;
    std::vector<double> signedTilt_;
    std::vector<bool> sideKnown_;
};

double fillOf(const Fit& fit) {
    const auto empty = static_cast<double>(std::count(fit.pointOf.cells.begin(), fit.pointOf.cells.end(), kNone));
    return 1.0 - empty / static_cast<double>(fit.pointOf.size());
}

} // namespace

std::optional<Fit> fitGroups(std::span<const AxisPoint> points, const Precision& precision, NoFit& best) {
    const std::vector<ReturnAngles> seen = returnsOf(points, precision);
    if (seen.size() < 12) return std::nullopt;
    GroupFitter wholePlanes(points, seen, kPi);
    GroupFitter halfPlanes(points, seen, 2 * kPi);
    auto whole = wholePlanes.fit(best);
    // A fan on both sides of the axis and a turn of 360 degrees can be the same points. The fuller grid wins; when both are
    // full, the one that the order of the list follows; a shuffled list is taken as a fan, which is our scanner.
    const bool inOrder = whole && wholePlanes.lineChanges() * 2 < wholePlanes.returns();
    if (whole && !inOrder && fillOf(*whole) > 1 / 1.3) return whole;
    auto half = halfPlanes.fit(best);
    if (!whole) return half;
    if (half) {
        const double ratio = fillOf(*half) / fillOf(*whole);
        const bool ordered = halfPlanes.lineChanges() * 2 < halfPlanes.returns();
        const bool halfInOrder = ordered && wholePlanes.lineChanges() * 4 > halfPlanes.lineChanges() * 3;
        if (ratio > 1.3 || (ratio > 1 / 1.3 && halfInOrder)) return half;
    }
    return whole;
}

} // namespace edgescan::files::recognition
