// Runs of two builds of edgescan-cli, alternating.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace edgescan {
struct Scan;
}

namespace edgescan::bench {

struct ProgramRow {
    std::string what;
    std::optional<double> atLeast; ///< the goal for cpuRatio
    double cpuRatio = 0;           ///< previous / present; medians of processor time, system calls included
    double wallRatio = 0;
    double presentMs = 0; ///< processor time
};

/// Runs each command `rounds` times with either program, in a new folder that holds the scan as grid, text and PCD. Empty if one of them
/// fails.
[[nodiscard]] std::vector<ProgramRow> programRows(const std::string& previous, const std::string& present, const Scan& scan, int rounds);

} // namespace edgescan::bench
