// Merges the beams of interlaced lines: two lines of 571 and 570 beams become one of 1141 (docs/developer/protocol.md, "Interlaced lines").
#pragma once

#include "core/scanner/scan_line/scan_line.h"

#include <optional>
#include <span>
#include <vector>

namespace edgescan::scanner {

/// The beams of a grid line that arrive in `parts` telegrams: beam p + parts * i of the line is beam i of part p.
struct InterlacedBeams {
    double startDeg = 0.0; ///< of part 0, the part with the smallest angle
    double stepDeg = 0.0;  ///< between beams of one part
    int parts = 1;
    int beams = 0; ///< of the whole line

    /// The part to which these beams belong; empty if they do not fit.
    [[nodiscard]] std::optional<int> partOf(const BeamGrid& grid) const;
    /// Number of beams of a part.
    [[nodiscard]] int beamsOf(int part) const { return part < beams ? (beams - part + parts - 1) / parts : 0; }
    [[nodiscard]] std::vector<double> beamDeg() const;

    bool operator==(const InterlacedBeams&) const = default;
};

/// The smallest number of parts that contains all these beams; empty if they cannot belong together.
[[nodiscard]] std::optional<InterlacedBeams> interlacedBeams(std::span<const BeamGrid> grids);

} // namespace edgescan::scanner
