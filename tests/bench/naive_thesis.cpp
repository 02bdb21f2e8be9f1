// Written for reading, not for speed: this is its purpose.
#include "tests/bench/naive_thesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::bench {
namespace {

using Image = std::vector<std::vector<double>>;

Image imageLike(const Image& other) { return Image(other.size(), std::vector<double>(other.front().size())); }

Image grayLevels(const Scan& scan) {
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (scan.state.at(i, j) != CellState::Valid) continue;
            least = std::min(least, static_cast<double>(scan.rangeMm.at(i, j)));
            most = std::max(most, static_cast<double>(scan.rangeMm.at(i, j)));
        }
    }
    Image gray;
    for (int i = 0; i < scan.lines(); ++i) {
        std::vector<double> row;
        for (int j = 0; j < scan.beams(); ++j) {
            const bool valid = scan.state.at(i, j) == CellState::Valid;
            row.push_back(valid ? std::min(255.0, std::round(static_cast<double>(scan.rangeMm.at(i, j)) * 255.0 / (most - least))) : 0.0);
        }
        gray.push_back(row);
    }
    return gray;
}

Image convolved(const Image& image, const std::vector<std::vector<double>>& mask) {
    Image result = imageLike(image);
    for (std::size_t i = 1; i + 1 < image.size(); ++i) {
        for (std::size_t j = 1; j + 1 < image[i].size(); ++j) {
            double sum = 0;
            for (std::size_t di = 0; di < 3; ++di) {
                for (std::size_t dj = 0; dj < 3; ++dj) sum += mask[di][dj] * image[i + di - 1][j + dj - 1];
            }
            result[i][j] = sum;
        }
    }
    return result;
}

Image suppressed(const Image& dx, const Image& dy) {
    Image magnitude = imageLike(dx);
    for (std::size_t i = 0; i < dx.size(); ++i) {
        for (std::size_t j = 0; j < dx[i].size(); ++j) magnitude[i][j] = std::sqrt(dx[i][j] * dx[i][j] + dy[i][j] * dy[i][j]);
    }
    Image thin = imageLike(dx);
    for (std::size_t i = 1; i + 1 < dx.size(); ++i) {
        for (std::size_t j = 1; j + 1 < dx[i].size(); ++j) {
            const double deg = std::fmod(std::atan2(dy[i][j], dx[i][j]) * 180.0 / std::numbers::pi + 180.0, 180.0);
            const int di = deg < 22.5 || deg >= 157.5 ? 0 : 1;
            const int dj = deg < 67.5 || deg >= 157.5 ? 1 : deg < 112.5 ? 0 : -1;
            const double here = magnitude[i][j];
            const auto at = [&](int sign) {
                return magnitude[i + static_cast<std::size_t>(sign * di)][j + static_cast<std::size_t>(sign * dj)];
            };
            if (here > at(-1) && here >= at(1)) thin[i][j] = here;
        }
    }
    return thin;
}

Image linked(const Image& thin, double lower) {
    Image edges = imageLike(thin);
    std::vector<std::pair<std::size_t, std::size_t>> grown;
    for (std::size_t i = 1; i + 1 < thin.size(); ++i) {
        for (std::size_t j = 1; j + 1 < thin[i].size(); ++j) {
            if (thin[i][j] > 3 * lower && edges[i][j] == 0) grown.push_back({i, j});
            while (!grown.empty()) {
                const auto [line, beam] = grown.back();
                grown.pop_back();
                edges[line][beam] = 1;
                for (std::size_t n = line - 1; n <= line + 1; ++n) {
                    for (std::size_t m = beam - 1; m <= beam + 1; ++m) {
                        if (thin[n][m] > lower && edges[n][m] == 0) grown.push_back({n, m});
                    }
                }
            }
        }
    }
    return edges;
}

} // namespace

std::vector<NaivePoint> naiveThesis(const Scan& scan, int lower) {
    const double a = 1.0 / 16;
    const Image smooth = convolved(grayLevels(scan), {{a, 2 * a, a}, {2 * a, 4 * a, 2 * a}, {a, 2 * a, a}});
    const Image dx = convolved(smooth, {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}});
    const Image dy = convolved(smooth, {{-1, -2, -1}, {0, 0, 0}, {1, 2, 1}});
    const Image edges = linked(suppressed(dx, dy), lower);
    const auto& polar = std::get<PolarGeometry>(scan.geometry);
    std::vector<NaivePoint> cloud;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (scan.state.at(i, j) != CellState::Valid) continue;
            const double range = static_cast<double>(scan.rangeMm.at(i, j)) / 1000.0;
            const double beam = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180.0;
            const double line = polar.lineDeg[static_cast<std::size_t>(i)] * std::numbers::pi / 180.0;
            cloud.push_back({range * std::cos(beam), -range * std::sin(beam) * std::sin(line), range * std::sin(beam) * std::cos(line),
                             scan.rangeMm.index(i, j), edges[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] > 0 ? 1 : 0});
        }
    }
    return cloud;
}

} // namespace edgescan::bench
