// Runs of whole programs: edgescan-cli, what the system copies and hashes, and an older edgescan-cli.
#pragma once

#include <string>
#include <vector>

namespace edgescan {
struct Scan;
}

namespace edgescan::bench {

/// One run of edgescan-cli in another one, or in sha256sum and cp of the same file; medians of processor time, system calls included.
struct WholeRatios {
    double thesisToVersion = 0, pcdWritten = 0, pcdRead = 0, textRead = 0, e57Read = 0; ///< 0: it could not be measured
};

struct ProgramRow {
    std::string what;
    double cpuRatio = 0; ///< previous / present; medians of processor time, system calls included
    double wallRatio = 0;
    double presentMs = 0; ///< processor time
};

/// Runs each command `rounds` times, in turn, in a new folder that holds the scan as grid, text, PCD and E57.
[[nodiscard]] WholeRatios wholeRatios(const std::string& present, const Scan& scan, int rounds);

/// The same with two programs. What one of them cannot do has no row.
[[nodiscard]] std::vector<ProgramRow> programRows(const std::string& previous, const std::string& present, const Scan& scan, int rounds);

} // namespace edgescan::bench
