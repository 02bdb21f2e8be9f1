// Beams of the far side are those of the near side with their tilt negated.
#include "core/files/grid_recovery/halves.h"

#include <algorithm>

namespace edgescan::files::recognition {
namespace {

constexpr double kSameBeam = 0.25;      // steps
constexpr double kClearOfAxis = 2.0;    // steps
constexpr double kMostUnpaired = 0.1;   // of the beams, seen on one side only
constexpr double kCoversHalfTurn = 0.9; // of the lines of a half turn

/// A beam of either side, at its tilt on the near side, 0..pi.
struct SideBeam {
    double tilt = 0.0;
    int column = 0;
    bool far = false;
};

std::vector<SideBeam> sideBeams(const std::vector<double>& tilts) {
    std::vector<SideBeam> beams;
    for (std::size_t j = 0; j < tilts.size(); ++j) {
        const double tilt = std::remainder(tilts[j], 2 * kPi);
        beams.push_back({std::abs(tilt), static_cast<int>(j), tilt < 0});
    }
    std::ranges::sort(beams, {}, &SideBeam::tilt);
    return beams;
}

/// Beams of both sides that are one; -1 where a side has none.
struct BeamPair {
    double tilt = 0.0;
    int near = -1, far = -1;
};

std::vector<BeamPair> pairsOf(const std::vector<SideBeam>& beams, double step) {
    std::vector<BeamPair> pairs;
    for (const SideBeam& beam : beams) {
        const bool joins =
            !pairs.empty() && beam.tilt - pairs.back().tilt <= kSameBeam * step && (beam.far ? pairs.back().far : pairs.back().near) < 0;
        if (!joins) pairs.push_back({beam.tilt});
        (beam.far ? pairs.back().far : pairs.back().near) = beam.column;
        if (joins) pairs.back().tilt = (pairs.back().tilt + beam.tilt) / 2;
    }
    return pairs;
}

} // namespace

bool unfoldHalves(Fit& fit) {
    if (fit.plane.size() < 2 || fit.tilt.size() < 2) return false;
    const double beamStep = medianStep(fit.tilt);
    const double lineStep = medianStep(fit.plane);
    const std::vector<SideBeam> beams = sideBeams(fit.tilt);
    if (beams.front().tilt < kClearOfAxis * beamStep || kPi - beams.back().tilt < kClearOfAxis * beamStep) return false;
    if (std::abs(fit.plane.back() - fit.plane.front()) + lineStep < kCoversHalfTurn * kPi) return false;
    const std::vector<BeamPair> pairs = pairsOf(beams, beamStep);
    const auto unpaired = std::ranges::count_if(pairs, [](const BeamPair& pair) { return pair.near < 0 || pair.far < 0; });
    if (static_cast<double>(unpaired) > kMostUnpaired * static_cast<double>(pairs.size())) return false;

    const int lines = fit.pointOf.lines;
    Grid<std::uint32_t> pointOf(2 * lines, static_cast<int>(pairs.size()), kNone);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < pointOf.beams; ++j) {
            const BeamPair& pair = pairs[static_cast<std::size_t>(j)];
            if (pair.near >= 0) pointOf.at(i, j) = fit.pointOf.at(i, pair.near);
            if (pair.far >= 0) pointOf.at(lines + i, j) = fit.pointOf.at(i, pair.far);
        }
    }
    const double halfTurn = fit.plane.back() > fit.plane.front() ? kPi : -kPi;
    for (int i = 0; i < lines; ++i) fit.plane.push_back(fit.plane[static_cast<std::size_t>(i)] + halfTurn);
    fit.tilt.clear();
    for (const BeamPair& pair : pairs) fit.tilt.push_back(pair.tilt);
    fit.pointOf = std::move(pointOf);
    return true;
}

} // namespace edgescan::files::recognition
