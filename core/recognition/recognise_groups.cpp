// Finds the grid of a list in any order, with points left out: its plane angles and tilts gather in groups with voids between them.
#include "core/base/order_statistic.h"
#include "core/recognition/recognise_parts.h"
#include "core/recognition/recognise_rings.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace edgescan::recognition {
namespace {

constexpr double kLeastFilled = 0.05; // of the cells; below, any cloud would fit

/// One point that has a return.
struct Return {
    std::uint32_t point = 0;
    double plane = 0.0, planeError = 0.0, tiltError = 0.0;
    std::uint32_t line = kNone, beam = kNone;
    bool unsure = false; ///< its own angle does not give its line: it is too near the axis, or written too coarsely
    bool told = false;   ///< but its neighbours in the list do
    bool off = false;    ///< between the lines
};

class GroupFitter {
public:
    GroupFitter(std::span<const AxisPoint> points, const Precision& precision, double period) : points_(points), period_(period) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const AxisPoint& p = points[k];
            if (p.missing()) continue;
            const double range = p.range();
            const double eps = precision.absolute + precision.relative * range;
            const double radius = std::sqrt(p.squaredRadius());
            Return r;
            r.point = static_cast<std::uint32_t>(k);
            r.plane = p.plane();
            r.planeError = radius > 0 ? eps / radius : kPi;
            r.tiltError = eps / range;
            returns_.push_back(r);
        }
    }

    std::optional<Fit> fit(NoFit& seen) {
        if (returns_.size() < 12) return std::nullopt;
        const auto lineRings = ringsOf(
            &Return::planeError, [](const Return& r) { return r.plane; }, period_);
        for (Ring lines : lineRings) {
            double sure = placeInLines(lines);
            if (beginAsListed(lines)) sure = placeInLines(lines);
            remember(seen, lines.centres.size(), 0, sure);
            if (sure < kShareOnGrid) continue;
            const auto tilt = [&](const Return& r) { return tiltOf(r, lines); };
            takeLinesOfNeighbours();
            for (const Ring& beams : ringsOf(&Return::tiltError, tilt, 2 * kPi)) {
                const double placed = placeInBeams(lines, beams);
                remember(seen, lines.centres.size(), beams.centres.size(), placed);
                if (placed < kShareOnGrid || beams.centres.size() < 2) continue;
                if (returns_.size() < kPointsPerGroup * (lines.centres.size() + beams.centres.size())) continue;
                settleUnsure(lines, beams);
                if (auto found = filled(lines, beams)) return found;
            }
        }
        return std::nullopt;
    }
    /// How often the line changes from one point of the list to the next: few changes show that the file was written in this order.
    [[nodiscard]] std::size_t lineChanges() const {
        std::size_t changes = 0;
        for (std::size_t n = 1; n < returns_.size(); ++n) changes += returns_[n].line != returns_[n - 1].line ? 1 : 0;
        return changes;
    }
    [[nodiscard]] std::size_t returns() const { return returns_.size(); }

private:
    static void remember(NoFit& seen, std::size_t lines, std::size_t beams, double share) {
        if (lines < 4 || (beams > 0 && beams < 4)) return; // a few groups hold most of any cloud
        if (share * (beams > 0 ? 2 : 1) <= seen.onGrid * (seen.beams > 0 ? 2 : 1)) return;
        seen = {lines, beams, share};
    }
    /// Rings that the angles suggest: of nearly all points, since a beam may hold few; then of the more precise half.
    template <class Angle>
    std::vector<Ring> ringsOf(double Return::*error, Angle angle, double period) const {
        std::vector<double> errors;
        for (const Return& r : returns_) errors.push_back(r.*error);
        const double usual = median(std::move(errors));
        std::vector<Ring> rings;
        for (const double limit : {4 * usual, 1.0000001 * usual}) {
            std::vector<double> angles;
            for (const Return& r : returns_) {
                if (r.*error <= limit && (error == &Return::planeError || tiltIsKnown(r))) angles.push_back(angle(r));
            }
            auto found = ringsIn(std::move(angles), period);
            std::move(found.begin(), found.end(), std::back_inserter(rings));
        }
        return rings;
    }
    /// The sign of the tilt is known only with the line, which gives the side of the axis; a point on the axis needs none.
    [[nodiscard]] bool tiltIsKnown(const Return& r) const {
        if (!r.unsure || r.told) return true;
        const AxisPoint& p = points_[r.point];
        return listedByLines_ && std::sqrt(p.squaredRadius()) <= 3 * r.tiltError * p.range();
    }
    [[nodiscard]] double tiltOf(const Return& r, const Ring& lines) const {
        const AxisPoint& p = points_[r.point];
        if (r.unsure && !r.told) return std::atan2(std::sqrt(p.squaredRadius()), p.u);
        const double plane = lines.centres[r.line];
        return std::atan2(p.radiusIn(std::cos(plane), std::sin(plane)), p.u);
    }
    /// Share of the sure points that lie on a line.
    double placeInLines(const Ring& lines) {
        std::size_t good = 0;
        std::size_t told = 0;
        for (Return& r : returns_) {
            const Ring::Nearest near = lines.nearest(r.plane);
            r.line = static_cast<std::uint32_t>(near.group);
            r.told = false;
            r.unsure = 3 * r.planeError > 0.25 * std::min(near.voidWidth, 0.5);
            r.off = !r.unsure && near.distance > 0.25 * near.voidWidth;
            told += r.unsure ? 0 : 1;
            good += r.unsure || r.off ? 0 : 1;
        }
        return told * 2 < returns_.size() ? 0.0 : static_cast<double>(good) / static_cast<double>(told);
    }
    /// Lines all around the axis leave no void to begin after. Then they begin where neighbouring lines lie far apart in the list, because
    /// the side of a plane changes there. False when nothing was changed.
    bool beginAsListed(Ring& lines) const {
        if (lines.centres.size() < 3) return false;
        std::vector<double> place(lines.centres.size(), 0.0);
        std::vector<double> count(lines.centres.size(), 0.0);
        for (std::size_t n = 0; n < returns_.size(); ++n) {
            place[returns_[n].line] += static_cast<double>(n);
            ++count[returns_[n].line];
        }
        std::size_t cut = 0;
        double farthest = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const std::size_t next = (i + 1) % place.size();
            const double apart = std::abs(place[next] / std::max(count[next], 1.0) - place[i] / std::max(count[i], 1.0));
            if (apart > farthest) {
                farthest = apart;
                cut = next;
            }
        }
        if (farthest < 0.5 * static_cast<double>(returns_.size()) || cut == 0) return false;
        lines.beginAt(cut);
        return true;
    }
    double placeInBeams(const Ring& lines, const Ring& beams) {
        std::size_t good = 0;
        std::size_t told = 0;
        for (Return& r : returns_) {
            const Ring::Nearest near = beams.nearest(tiltOf(r, lines));
            const bool coarse = 3 * r.tiltError > 0.25 * std::min(near.voidWidth, 0.5);
            const bool close = near.distance <= 0.25 * near.voidWidth;
            r.beam = close && !coarse ? static_cast<std::uint32_t>(near.group) : kNone;
            const bool telling = !coarse && (!r.unsure || r.told);
            told += telling ? 1 : 0;
            good += telling && close ? 1 : 0;
        }
        return told * 2 < returns_.size() ? 0.0 : static_cast<double>(good) / static_cast<double>(told);
    }
    /// In a list that runs along its lines, a point near the axis between two points of one line is on that line.
    void takeLinesOfNeighbours() {
        std::vector<std::size_t> sure;
        for (std::size_t n = 0; n < returns_.size(); ++n) {
            if (!returns_[n].unsure && !returns_[n].off) sure.push_back(n);
        }
        std::size_t sameLine = 0;
        for (std::size_t s = 1; s < sure.size(); ++s) sameLine += returns_[sure[s]].line == returns_[sure[s - 1]].line ? 1 : 0;
        listedByLines_ = sameLine * 2 >= sure.size();
        if (!listedByLines_) return;
        for (std::size_t s = 1; s < sure.size(); ++s) {
            if (returns_[sure[s]].line != returns_[sure[s - 1]].line) continue;
            for (std::size_t n = sure[s - 1] + 1; n < sure[s]; ++n) {
                if (!returns_[n].unsure) continue;
                returns_[n].line = returns_[sure[s]].line;
                returns_[n].told = true;
            }
        }
    }
    /// A point on the axis belongs to the line of its neighbours in the list, if the list is ordered.
    void settleUnsure(const Ring& lines, const Ring& beams) {
        const bool ascending = beamsAscend();
        std::vector<std::size_t> nextTold(returns_.size() + 1, returns_.size());
        for (std::size_t n = returns_.size(); n-- > 0;) nextTold[n] = returns_[n].unsure && !returns_[n].told ? nextTold[n + 1] : n;
        for (std::size_t n = 0; n < returns_.size(); ++n) {
            Return& r = returns_[n];
            if (!r.unsure || r.told || r.beam == kNone) continue;
            const auto fits = [&](std::size_t other, bool otherIsLater) {
                if (other >= returns_.size() || returns_[other].line == kNone || returns_[other].beam == kNone) return false;
                return otherIsLater == ascending ? r.beam < returns_[other].beam : r.beam > returns_[other].beam;
            };
            const std::size_t before = n == 0 ? returns_.size() : n - 1; // already settled
            const bool left = listedByLines_ && fits(before, false);
            const bool right = listedByLines_ && fits(nextTold[n], true);
            r.line = kNone;
            if (left && right && returns_[before].line != returns_[nextTold[n]].line) continue;
            if (!left && !right) continue;
            r.line = returns_[left ? before : nextTold[n]].line;
            const double plane = lines.centres[r.line]; // now the side of the axis is known
            const AxisPoint& p = points_[r.point];
            r.beam = static_cast<std::uint32_t>(beams.nearest(std::atan2(p.radiusIn(std::cos(plane), std::sin(plane)), p.u)).group);
        }
    }
    [[nodiscard]] bool beamsAscend() const {
        std::ptrdiff_t votes = 0;
        for (std::size_t n = 1; n < returns_.size(); ++n) {
            const Return& a = returns_[n - 1];
            const Return& b = returns_[n];
            if (a.unsure || b.unsure || a.line != b.line || a.beam == kNone || b.beam == kNone) continue;
            votes += b.beam > a.beam ? 1 : -1;
        }
        return votes >= 0;
    }
    std::optional<Fit> filled(const Ring& lines, const Ring& beams) {
        const double cells = static_cast<double>(lines.centres.size()) * static_cast<double>(beams.centres.size());
        if (static_cast<double>(returns_.size()) < kLeastFilled * cells) return std::nullopt;
        Fit fit;
        fit.plane = lines.centres;
        fit.tilt = beams.centres;
        fit.pointOf = Grid<std::uint32_t>(static_cast<int>(lines.centres.size()), static_cast<int>(beams.centres.size()), kNone);
        for (const Return& r : returns_) {
            if (r.off || r.line == kNone || r.beam == kNone) {
                ++fit.unplaced;
                continue;
            }
            std::uint32_t& cell = fit.pointOf.at(static_cast<int>(r.line), static_cast<int>(r.beam));
            if (cell != kNone) {
                const AxisPoint& other = points_[cell];
                const AxisPoint& p = points_[r.point];
                ++(p.u == other.u && p.v == other.v && p.w == other.w ? fit.copied : fit.doubled);
            }
            if (cell == kNone || points_[r.point].range() < points_[cell].range()) cell = r.point;
        }
        if (fit.doubled * 20 > returns_.size()) return std::nullopt; // cells that are too large hold several different points
        return fit;
    }

    std::span<const AxisPoint> points_;
    double period_;
    std::vector<Return> returns_;
    bool listedByLines_ = false;
};

double fillOf(const Fit& fit) {
    const auto empty = static_cast<double>(std::count(fit.pointOf.cells.begin(), fit.pointOf.cells.end(), kNone));
    return 1.0 - empty / static_cast<double>(fit.pointOf.size());
}

} // namespace

std::optional<Fit> fitGroups(std::span<const AxisPoint> points, const Precision& precision, NoFit& seen) {
    GroupFitter wholePlanes(points, precision, kPi);
    GroupFitter halfPlanes(points, precision, 2 * kPi);
    auto whole = wholePlanes.fit(seen);
    auto half = halfPlanes.fit(seen);
    if (!whole) return half;
    if (half) {
        // A fan on both sides of the axis and a turn of 360 degrees can be the same points. The fuller grid wins; when both are
        // full, the one that the order of the list follows; a shuffled list is taken as a fan, which is our scanner.
        const double ratio = fillOf(*half) / fillOf(*whole);
        const bool ordered = halfPlanes.lineChanges() * 2 < halfPlanes.returns();
        const bool halfInOrder = ordered && wholePlanes.lineChanges() * 4 > halfPlanes.lineChanges() * 3;
        if (ratio > 1.3 || (ratio > 1 / 1.3 && halfInOrder)) return half;
    }
    return whole;
}

} // namespace edgescan::recognition
