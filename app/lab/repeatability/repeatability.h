// Repeatability: of the edges that both scans could see, the share that both have.
#pragma once

#include "app/lab/peers/comparison.h"
#include "core/inspect/registration/placed_scan.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::lab {

struct RepeatCount {
    std::size_t edges = 0;   ///< in both scans
    std::size_t visible = 0; ///< number of these at a place that the other scan saw: measured in that direction, without an object in front
    std::size_t found = 0;   ///< number of these with an edge of the other scan within the radius
    [[nodiscard]] double share() const { return visible == 0 ? 0.0 : static_cast<double>(found) / static_cast<double>(visible); }
};

/// Masks: lines x beams of their scans, not 0 = edge. Counts the edges of both scans; each is searched in the other scan.
class RepeatCounter {
public:
    RepeatCounter(const inspect::PlacedScan& a, const inspect::PlacedScan& b, double radiusM);
    [[nodiscard]] RepeatCount count(const Grid<std::uint8_t>& maskA, const Grid<std::uint8_t>& maskB) const;

private:
    const inspect::PlacedScan &a_, &b_;
    double radiusM_;
    std::vector<std::uint8_t> aSeenByB_, bSeenByA_; // by cell
};

struct MethodRepeatability {
    std::string name, key;
    RepeatCount withFixedSettings;      ///< with its fixed settings
    std::optional<RepeatCount> atEqual; ///< with the threshold that gives, in each scan, as many edges as the reference method has there
    /// Thinned to lines one cell wide, with the threshold at which the thinned mask has as many cells as that of the reference method. So a
    /// band of several cells along one edge counts as one place.
    std::optional<RepeatCount> atEqualPlaces;
    std::string note; ///< why there is no result
};

/// Every method on both scans. The reference for equal numbers is EdgeScan+ with its fixed settings.
[[nodiscard]] std::vector<MethodRepeatability> methodRepeatability(const inspect::PlacedScan& a, const inspect::PlacedScan& b,
                                                                   double radiusM, const ComparisonSettings& settings,
                                                                   const ComparisonProgress& progress = {});

} // namespace edgescan::lab
