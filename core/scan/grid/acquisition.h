// The device and the time of a scan, for its records (docs/reference/rules.md, "S7"). Empty texts mean unknown.
#pragma once

#include <string>
#include <vector>

namespace edgescan {

/// Immutable after construction.
struct Acquisition {
    std::string vendor, model, serial, firmware;
    std::string startUtc, endUtc;     ///< of the first and the last line, ISO 8601
    std::string clockSource;          ///< the clock of these times
    std::string contamination;        ///< the state of the scanner's window, as the scanner reported it
    std::string echoFilter;           ///< which of several returns the scanner reports as the range
    int linesExpected = 0;            ///< lines of a whole sweep; 0: unknown
    std::vector<double> lineTimesS{}; ///< per line, seconds since 1970 UTC; empty if unknown; not saved with a scan
};

} // namespace edgescan
