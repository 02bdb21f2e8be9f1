// Makes synthetic scans and writes them as point lists, as different programs do.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace edgescan::test {

/// A temporary folder, removed at the end of the test.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "edgescan-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline void writeText(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}
inline std::string readText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct ScanShape {
    Axis axis = Axis::Sweep;
    int lines = 40, beams = 60;
    double beamStart = 0, beamStep = 0.5, lineStart = 30, lineStep = -0.5;
    double motorJitter = 0;  ///< share of the line step
    double noReturns = 0.05; ///< share of cells
    double fraction = 0;     ///< share of a millimetre in the ranges; 0 = whole millimetres
    double nearest = 1500;
    unsigned seed = 1;
};

inline Scan makeScan(const ScanShape& shape) {
    std::mt19937 random(shape.seed);
    std::uniform_real_distribution<double> unit(0, 1);
    PolarGeometry polar;
    polar.axis = shape.axis;
    for (int j = 0; j < shape.beams; ++j) polar.beamDeg.push_back(shape.beamStart + j * shape.beamStep);
    for (int i = 0; i < shape.lines; ++i)
        polar.lineDeg.push_back(shape.lineStart + (i + shape.motorJitter * (unit(random) - 0.5)) * shape.lineStep);
    Scan scan;
    scan.name = "synthetic";
    scan.rangeMm = Grid<float>(shape.lines, shape.beams);
    scan.state = Grid<CellState>(shape.lines, shape.beams, CellState::NoReturn);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (unit(random) < shape.noReturns) continue;
        const double i = static_cast<double>(k / static_cast<std::size_t>(shape.beams));
        const double j = static_cast<double>(k % static_cast<std::size_t>(shape.beams));
        double range =
            shape.nearest + 900 * std::sin(i * 0.2) * std::sin(j * 0.13) + (unit(random) < 0.2 ? 4000 : 0) + 20 * unit(random) + 1000;
        range = std::floor(range) + (shape.fraction > 0 ? shape.fraction * unit(random) : 0);
        scan.rangeMm[k] = static_cast<float>(range);
        scan.state[k] = CellState::Valid;
    }
    scan.geometry = polar;
    return scan;
}

struct ListStyle {
    double perMetre = 1;         ///< 1 metres, 100 centimetres, 1000 millimetres
    const char* format = "%.6g"; ///< of one number
    const char* separator = " ";
    const char* lineEnd = "\n";
    bool beamMajor = false;
    bool reverseLines = false, reverseBeams = false;
    bool shuffled = false;
    double dropped = 0;      ///< share of points left out
    bool keepMissing = true; ///< cells without return as 0 0 0
    bool doubledLines = false;
};

/// Points in the order and number format of the style; (0, 0, 0) for cells without a return.
inline std::vector<Eigen::Vector3d> listOf(const Scan& scan, const ListStyle& style, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const CartesianTables tables(scan);
    std::vector<Eigen::Vector3d> points;
    const int outer = style.beamMajor ? scan.beams() : scan.lines();
    const int inner = style.beamMajor ? scan.lines() : scan.beams();
    for (int a = 0; a < outer; ++a) {
        std::vector<Eigen::Vector3d> run;
        for (int b = 0; b < inner; ++b) {
            int line = style.beamMajor ? b : a;
            int beam = style.beamMajor ? a : b;
            if (style.reverseLines) line = scan.lines() - 1 - line;
            if (style.reverseBeams) beam = scan.beams() - 1 - beam;
            Eigen::Vector3d p = tables.point(line, beam) * style.perMetre;
            if (!p.allFinite()) p.setZero();
            if (p.isZero(0.0) && !style.keepMissing) continue;
            if (unit(random) >= style.dropped) run.push_back(p);
        }
        points.insert(points.end(), run.begin(), run.end());
        if (style.doubledLines) points.insert(points.end(), run.begin(), run.end());
    }
    if (style.shuffled) std::shuffle(points.begin(), points.end(), random);
    return points;
}

inline std::string numberText(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    // The tests also run with locales whose decimal point is a comma; a list always has a point.
    std::string number = text;
    std::replace(number.begin(), number.end(), ',', '.');
    return number;
}

inline std::string textOf(const std::vector<Eigen::Vector3d>& points, const ListStyle& style) {
    std::string text;
    for (const Eigen::Vector3d& p : points) {
        for (int axis = 0; axis < 3; ++axis) text += (axis > 0 ? style.separator : "") + numberText(style.format, p[axis]);
        text += style.lineEnd;
    }
    return text;
}

/// Largest distance, metres, from a point of `expected` to the point of the nearest cell of `found`. Both hold the same cells in some
/// order; they are compared through sorted coordinates rounded to `grain`.
inline double farthestFrom(const Scan& expected, const Scan& found) {
    const CartesianTables a(expected);
    const CartesianTables b(found);
    double farthest = 0;
    std::vector<Eigen::Vector3d> pa, pb;
    for (std::size_t k = 0; k < expected.cells(); ++k) {
        if (expected.state[k] == CellState::Valid) pa.push_back(a.point(k));
    }
    for (std::size_t k = 0; k < found.cells(); ++k) {
        if (found.state[k] == CellState::Valid) pb.push_back(b.point(k));
    }
    if (pa.size() != pb.size()) return 1e9;
    // Sorting along a direction in general position gives both lists the same order.
    const Eigen::Vector3d d(0.5377, 1.8339, -2.2588);
    const auto byD = [&](const Eigen::Vector3d& x, const Eigen::Vector3d& y) { return x.dot(d) < y.dot(d); };
    std::sort(pa.begin(), pa.end(), byD);
    std::sort(pb.begin(), pb.end(), byD);
    std::vector<double> distances;
    for (std::size_t k = 0; k < pa.size(); ++k) farthest = std::max(farthest, std::abs(pa[k].dot(d) - pb[k].dot(d)));
    return farthest;
}

} // namespace edgescan::test
