// Sums of bodies, and the quadric through their surface.
#include "core/rocks/segmentation/bodies.h"

#include "core/rocks/segmentation/borders.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace edgescan::rocks {
namespace {

constexpr double kDeviations = 4.0;     // a size is this many standard deviations
constexpr double kFewestForQuadric = 8; // cells
constexpr double kRidge = 1e-4;         // of the cells, against quadrics of narrow bodies
constexpr double kMostFill = 1.2;
constexpr double kLeastLongM = 0.01;

// Powers of x and y of BodySums::angles.
constexpr std::array<int, 15> kPowerX{0, 1, 0, 2, 1, 0, 3, 2, 1, 0, 4, 3, 2, 1, 0};
constexpr std::array<int, 15> kPowerY{0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 4};
constexpr std::size_t placeOf(int x, int y) { return static_cast<std::size_t>((x + y) * (x + y + 1) / 2 + y); }

std::int64_t crossOf(const HullCorner& o, const HullCorner& a, const HullCorner& b) {
    return static_cast<std::int64_t>(a.beam - o.beam) * (b.line - o.line) - static_cast<std::int64_t>(a.line - o.line) * (b.beam - o.beam);
}

// Replaces `points` by the corners of their hull.
void keepHull(std::vector<HullCorner>& points) {
    std::ranges::sort(points,
                      [](const HullCorner& a, const HullCorner& b) { return a.beam < b.beam || (a.beam == b.beam && a.line < b.line); });
    if (points.size() < 3) return;
    thread_local std::vector<HullCorner> hull;
    hull.resize(2 * points.size());
    std::size_t count = 0;
    const auto push = [&](const HullCorner& point, std::size_t fewest) {
        while (count >= fewest && crossOf(hull[count - 2], hull[count - 1], point) <= 0) --count;
        hull[count++] = point;
    };
    for (const HullCorner& point : points) push(point, 2);
    const std::size_t lower = count + 1;
    for (std::size_t n = points.size() - 1; n-- > 0;) push(points[n], lower);
    points.assign(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(count > 1 ? count - 1 : count));
}

// Cells of the hull, whose corners are the centres of cells.
double cellsOfHull(const std::vector<HullCorner>& hull) {
    std::int64_t twice = 0;
    for (std::size_t n = 0; n < hull.size(); ++n) {
        const HullCorner& a = hull[n];
        const HullCorner& b = hull[(n + 1) % hull.size()];
        twice += static_cast<std::int64_t>(a.beam) * b.line - static_cast<std::int64_t>(a.line) * b.beam;
    }
    return 0.5 * std::abs(static_cast<double>(twice)) + 0.5 * static_cast<double>(hull.size()) + 1;
}

// The sums about another origin: Pascal's triangle.
template <std::size_t Count>
std::array<double, Count> movedSums(const std::array<double, Count>& sums, double x, double y) {
    constexpr std::array<std::array<double, 5>, 5> kPascal{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
    std::array<double, 5> px{1}, py{1};
    for (std::size_t n = 1; n < px.size(); ++n) {
        px[n] = -x * px[n - 1];
        py[n] = -y * py[n - 1];
    }
    std::array<double, Count> moved{};
    for (std::size_t k = 0; k < Count; ++k) {
        for (int i = 0; i <= kPowerX[k]; ++i) {
            for (int j = 0; j <= kPowerY[k]; ++j) {
                moved[k] += kPascal[static_cast<std::size_t>(kPowerX[k])][static_cast<std::size_t>(i)] *
                            kPascal[static_cast<std::size_t>(kPowerY[k])][static_cast<std::size_t>(j)] *
                            px[static_cast<std::size_t>(kPowerX[k] - i)] * py[static_cast<std::size_t>(kPowerY[k] - j)] *
                            sums[placeOf(i, j)];
            }
        }
    }
    return moved;
}

// u as a quadric of the angles: its deviation and its curvature.
void fitQuadric(const BodySums& sums, double noiseMm, BodyShape& shape) {
    const double cells = sums.angles[0];
    if (cells < kFewestForQuadric) return;
    const double x = sums.angles[1] / cells, y = sums.angles[2] / cells, mean = sums.inverses[0] / cells;
    if (mean <= 0) return;
    const std::array<double, 15> about = movedSums(sums.angles, x, y);
    const std::array<double, 6> inverse = movedSums(sums.inverses, x, y);
    const double size = std::sqrt(std::max(1e-12, (about[3] + about[5]) / cells));
    const std::array<double, 3> unit{1, size, size * size};
    const auto unitOf = [&](std::size_t p) { return unit[static_cast<std::size_t>(kPowerX[p] + kPowerY[p])]; };
    Eigen::Matrix<double, 6, 6> normal;
    Eigen::Matrix<double, 6, 1> right;
    for (std::size_t p = 0; p < 6; ++p) {
        const auto row = static_cast<Eigen::Index>(p);
        for (std::size_t q = 0; q < 6; ++q)
            normal(row, static_cast<Eigen::Index>(q)) =
                about[placeOf(kPowerX[p] + kPowerX[q], kPowerY[p] + kPowerY[q])] / unitOf(p) / unitOf(q);
        right(row) = (inverse[p] - mean * about[p]) / unitOf(p);
        if (p > 0) normal(row, row) += kRidge * cells;
    }
    const Eigen::Matrix<double, 6, 1> quadric = normal.ldlt().solve(right);
    const double left = std::max(0.0, sums.sumU2 - sums.inverses[0] * mean - quadric.dot(right));
    shape.roughness = 1000 * std::sqrt(left / cells) / (mean * mean) / std::max(0.1, noiseMm);
    shape.bulge = -(quadric(3) + quadric(5)) / (mean * mean) / std::max(kLeastLongM, shape.longM);
}

} // namespace

void BodySums::add(const BodySums& other) {
    addNumbers(other);
    hull.insert(hull.end(), other.hull.begin(), other.hull.end());
    keepHull(hull);
}

void BodySums::addNumbers(const BodySums& other) {
    points.add(other.points);
    cells += other.cells;
    for (std::size_t n = 0; n < angles.size(); ++n) angles[n] += other.angles[n];
    for (std::size_t n = 0; n < inverses.size(); ++n) inverses[n] += other.inverses[n];
    sumU2 += other.sumU2;
    outerLength += other.outerLength;
}

std::vector<BodySums> segmentBodies(const Segmentation& segments) {
    std::vector<BodySums> bodies(segments.sums.size());
    const Grid<float>& u = segments.inputs.cracks->smoothed;
    const AngularSteps& steps = segments.inputs.surface->steps;
    std::vector<double> beamAngle(static_cast<std::size_t>(u.beams)), lineAngle(static_cast<std::size_t>(u.lines));
    for (std::size_t j = 1; j < beamAngle.size(); ++j) beamAngle[j] = beamAngle[j - 1] + static_cast<double>(steps.beam[j - 1]);
    const int middle = u.beams / 2;
    for (std::size_t i = 1; i < lineAngle.size(); ++i)
        lineAngle[i] = lineAngle[i - 1] + static_cast<double>(steps.lineAt(static_cast<int>(i) - 1, middle));
    for (const SegmentRun& run : segments.beamRuns) {
        BodySums& body = bodies[run.segment];
        const float* const line = u.line(static_cast<int>(run.row));
        std::array<double, 5> sums{};
        std::array<double, 3> inverse{};
        double squares = 0;
        for (std::uint32_t j = run.begin; j < run.end; ++j) {
            const double x = beamAngle[j] - beamAngle[static_cast<std::size_t>(middle)], value = static_cast<double>(line[j]), x2 = x * x;
            sums[0] += 1;
            sums[1] += x;
            sums[2] += x2;
            sums[3] += x2 * x;
            sums[4] += x2 * x2;
            inverse[0] += value;
            inverse[1] += value * x;
            inverse[2] += value * x2;
            squares += value * value;
        }
        const double y = lineAngle[run.row] - lineAngle[lineAngle.size() / 2];
        const std::array<double, 5> power{1, y, y * y, y * y * y, y * y * y * y};
        for (std::size_t k = 0; k < body.angles.size(); ++k)
            body.angles[k] += sums[static_cast<std::size_t>(kPowerX[k])] * power[static_cast<std::size_t>(kPowerY[k])];
        for (std::size_t k = 0; k < body.inverses.size(); ++k)
            body.inverses[k] += inverse[static_cast<std::size_t>(kPowerX[k])] * power[static_cast<std::size_t>(kPowerY[k])];
        body.sumU2 += squares;
        body.cells += run.end - run.begin;
        body.hull.push_back({static_cast<std::int32_t>(run.begin), static_cast<std::int32_t>(run.row)});
        if (run.end > run.begin + 1) body.hull.push_back({static_cast<std::int32_t>(run.end) - 1, static_cast<std::int32_t>(run.row)});
    }
    for (std::size_t n = 1; n < bodies.size(); ++n) {
        bodies[n].points = segments.sums[n];
        bodies[n].outerLength = segments.outer[n];
        keepHull(bodies[n].hull);
    }
    return bodies;
}

BodyShape shapeOf(const BodySums& sums, const RangeNoise& noise) {
    BodyShape shape;
    if (sums.points.cells == 0) return shape;
    const double n = sums.points.cells;
    shape.centreM = sums.points.sumM / n;
    const Eigen::Matrix3d spread = sums.points.sumM2 / n - shape.centreM * shape.centreM.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const Eigen::Vector3d deviations = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt(); // ascending
    shape.normal = axes.eigenvectors().col(0);
    if (shape.normal.dot(shape.centreM) > 0) shape.normal = -shape.normal;
    shape.longM = kDeviations * deviations[2];
    if (deviations[2] > 0) {
        shape.depthRatio = deviations[0] / deviations[2];
        shape.middleRatio = deviations[1] / deviations[2];
    }
    shape.fill = std::min(kMostFill, static_cast<double>(sums.cells) / cellsOfHull(sums.hull));
    fitQuadric(sums, noise.at(shape.centreM.norm()), shape);
    return shape;
}

BodyShape shapeOfBoth(const BodySums& a, const BodySums& b, const RangeNoise& noise) {
    thread_local BodySums both; // keeps the memory of its hull
    std::vector<HullCorner> hull = std::move(both.hull);
    hull.assign(a.hull.begin(), a.hull.end());
    hull.insert(hull.end(), b.hull.begin(), b.hull.end());
    keepHull(hull);
    both = {};
    both.hull = std::move(hull);
    both.addNumbers(a);
    both.addNumbers(b);
    return shapeOf(both, noise);
}

} // namespace edgescan::rocks
