// Angles that gather in groups with voids between them, around a circle: the lines or beams of a grid.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

namespace edgescan::files::recognition {

inline constexpr std::size_t kPointsPerGroup = 3; // on average, at least

/// Group centres on a circle, ascending and continuous.
struct Ring {
    double period = 2 * std::numbers::pi;
    std::vector<double> centres;

    struct Nearest {
        std::size_t group = 0;
        double distance = 0.0;
        double voidWidth = 0.0; ///< to the neighbour on that side
    };
    [[nodiscard]] Nearest nearest(double angle) const;
    [[nodiscard]] std::vector<double> voids() const;
    void beginAt(std::size_t first);
    /// Begins after the widest void; false when no void is distinct, and then at the group nearest to 0.
    bool cutAtWidestVoid();
};

/// The rings that the voids between the angles suggest, the clearest first.
[[nodiscard]] std::vector<Ring> ringsIn(std::vector<double> angles, double period);

} // namespace edgescan::files::recognition
