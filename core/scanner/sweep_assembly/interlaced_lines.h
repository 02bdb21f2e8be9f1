// Puts the beams of interlaced lines side by side: two lines of 571 and 570 beams make one of 1141 (docs/protocol.md, "Interlaced lines").
#pragma once

#include "core/scanner/sick_lms/scan_telegram.h"

#include <optional>
#include <span>
#include <vector>

namespace edgescan {

/// A grid line's beams as `parts` telegrams bring them: beam p + parts * i of the line is beam i of part p.
struct InterlacedBeams {
    double startDeg = 0.0; ///< of part 0, the one with the smallest angle
    double stepDeg = 0.0;  ///< between beams of one part
    int parts = 1;
    int beams = 0; ///< of the whole line

    /// The part that these beams are, or nothing when they do not fit in.
    [[nodiscard]] std::optional<int> partOf(const BeamGrid& grid) const;
    /// Beams of a part.
    [[nodiscard]] int beamsOf(int part) const { return part < beams ? (beams - part + parts - 1) / parts : 0; }
    [[nodiscard]] std::vector<double> beamDeg() const;

    bool operator==(const InterlacedBeams&) const = default;
};

/// The fewest parts that hold all these beams; nothing when they cannot belong together.
[[nodiscard]] std::optional<InterlacedBeams> interlacedBeams(std::span<const BeamGrid> grids);

} // namespace edgescan
