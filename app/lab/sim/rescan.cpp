// Scans a measured surface again: the points of a cloud as a relief above the scanner.
#include "app/lab/sim/bell.h"
#include "app/lab/sim/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace edgescan::sim {
namespace {

constexpr double kPointsPerCell = 2.0;
constexpr int kMostNodes = 1200; // along the longer side
constexpr int kLargestGap = 6;   // largest gap between points that is filled, nodes
constexpr double kBehindM = 0.5; // distance from the lowest point to the surface that fills large gaps
constexpr double kDomeDeg = 100; // angle of the dome around the surface, from its top down

struct Relief {
    int rows = 0, columns = 0;
    double step = 0; // metres
    std::vector<float> height;

    float& at(int row, int column) {
        return height[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
    }
};

constexpr float kUnknown = -std::numeric_limits<float>::infinity();

// Nodes without a point get the mean of their neighbours, from the known nodes outwards. Nodes too far from any point are placed behind the
// whole surface.
void fillUnknown(Relief& relief, float ground) {
    for (int round = 0; round < kLargestGap / 2; ++round) {
        Relief next = relief;
        for (int r = 0; r < relief.rows; ++r) {
            for (int c = 0; c < relief.columns; ++c) {
                if (relief.at(r, c) != kUnknown) continue;
                float sum = 0;
                int known = 0;
                for (int i = std::max(0, r - 1); i <= std::min(relief.rows - 1, r + 1); ++i) {
                    for (int j = std::max(0, c - 1); j <= std::min(relief.columns - 1, c + 1); ++j) {
                        if (relief.at(i, j) == kUnknown) continue;
                        sum += relief.at(i, j);
                        ++known;
                    }
                }
                if (known == 0) continue;
                next.at(r, c) = sum / static_cast<float>(known);
            }
        }
        relief = std::move(next);
    }
    for (float& height : relief.height) height = height == kUnknown ? ground : height;
}

// The highest point of each cell, because a scanner above sees it first.
Relief reliefOf(const std::vector<Eigen::Vector3f>& points, const Eigen::AlignedBox3f& box) {
    const Eigen::Vector3d size = box.sizes().cast<double>();
    Relief relief;
    relief.step = std::max({std::sqrt(size.x() * size.y() * kPointsPerCell / static_cast<double>(points.size())),
                            std::max(size.x(), size.y()) / kMostNodes, 1e-4});
    relief.rows = std::max(2, static_cast<int>(size.y() / relief.step) + 1);
    relief.columns = std::max(2, static_cast<int>(size.x() / relief.step) + 1);
    relief.height.assign(static_cast<std::size_t>(relief.rows) * static_cast<std::size_t>(relief.columns), kUnknown);
    for (const Eigen::Vector3f& p : points) {
        const auto place = [&](int axis, int most) {
            return std::min(most - 1, static_cast<int>(static_cast<double>(p[axis] - box.min()[axis]) / relief.step));
        };
        float& height = relief.at(place(1, relief.rows), place(0, relief.columns));
        height = std::max(height, p.z());
    }
    fillUnknown(relief, box.min().z() - static_cast<float>(kBehindM));
    return relief;
}

} // namespace

Scene rescanScene(const std::vector<Eigen::Vector3f>& points, double distanceM) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : points) box.extend(p);
    Relief relief = reliefOf(points, box);
    // The surface below the surveyor is flipped and placed above the scanner; its highest point is the nearest.
    const Eigen::Vector3f centre = box.center();
    const auto place = [&](int row, int column) {
        return Eigen::Vector3d(static_cast<double>(box.min().x() - centre.x()) + column * relief.step,
                               static_cast<double>(box.min().y() - centre.y()) + row * relief.step,
                               distanceM + static_cast<double>(box.max().z() - relief.at(row, column)));
    };
    Scene scene;
    addLattice(scene, scene.solids, {relief.rows, relief.columns, false, place}, {.texture = Texture::Smooth});
    // A dome around the surface: every beam ends on something, so that every border is a border of the surface.
    constexpr int kRings = 48;
    const std::vector<Eigen::Vector2d> around = compass(144);
    const Eigen::Vector3d half = 0.5 * box.sizes().cast<double>();
    const double radius = 1.1 * Eigen::Vector3d(half.x(), half.y(), distanceM + 2 * half.z() + kBehindM).norm();
    const auto dome = [&](int ring, int column) {
        const double down = kDomeDeg * std::numbers::pi / 180.0 * ring / (kRings - 1);
        const Eigen::Vector2d flat = around[static_cast<std::size_t>(column)] * std::sin(down);
        return Eigen::Vector3d(radius * flat.x(), radius * flat.y(), radius * std::cos(down));
    };
    addLattice(scene, scene.solids, {kRings, static_cast<int>(around.size()), true, dome}, {.texture = Texture::Smooth});
    return scene;
}

} // namespace edgescan::sim
