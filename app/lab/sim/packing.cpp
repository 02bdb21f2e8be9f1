// Position-based relaxation, one ball after the other, always in the same order, so that the result depends only on the input.
#include "app/lab/sim/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::sim {
namespace {

void pushApart(Ball& a, Ball& b, double touch) {
    const double reach = touch * (a.radius + b.radius);
    const Eigen::Vector3d gap = b.centre - a.centre;
    const double squared = gap.squaredNorm();
    if (squared >= reach * reach || squared < 1e-12) return;
    const double distance = std::sqrt(squared);
    const double weightA = a.radius * a.radius * a.radius;
    const double weightB = b.radius * b.radius * b.radius;
    const Eigen::Vector3d push = gap * (0.8 * (reach - distance) / (distance * (weightA + weightB)));
    a.centre -= push * weightB;
    b.centre += push * weightA;
}

} // namespace

std::vector<Ball> relaxed(std::vector<Ball> balls, const Confine& confine, double touch, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < balls.size(); ++i)
            for (std::size_t j = i + 1; j < balls.size(); ++j) pushApart(balls[i], balls[j], touch);
        for (std::size_t i = 0; i < balls.size(); ++i) confine(i, balls[i]);
    }
    return balls;
}

std::vector<Ball> scattered(const std::vector<double>& radii, const std::function<Eigen::Vector3d(RandomSequence&)>& place,
                            RandomSequence& dice) {
    constexpr int kCandidates = 12;
    std::vector<Ball> balls;
    for (const double radius : radii) {
        Ball ball{.radius = radius};
        double most = -std::numeric_limits<double>::infinity();
        for (int candidate = 0; candidate < kCandidates; ++candidate) {
            const Eigen::Vector3d p = place(dice);
            double clear = std::numeric_limits<double>::max();
            for (const Ball& other : balls) clear = std::min(clear, (p - other.centre).norm() - other.radius);
            if (clear <= most) continue;
            most = clear;
            ball.centre = p;
        }
        balls.push_back(ball);
    }
    return balls;
}

} // namespace edgescan::sim
