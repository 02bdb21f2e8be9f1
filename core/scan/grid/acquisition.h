// Who measured a scan, with what, and when: what a record of it needs (docs/operator.md, "S7"). Empty texts are not known.
#pragma once

#include <string>
#include <vector>

namespace edgescan {

/// Made once, never changed.
struct Acquisition {
    std::string vendor, model, serial, firmware;
    std::string startUtc, endUtc;     ///< of the first and the last line, ISO 8601
    std::string clockSource;          ///< whose clock these times are
    std::string contamination;        ///< what the scanner said of its window
    std::string echoFilter;           ///< which of several returns is the range
    int linesExpected = 0;            ///< lines of a whole sweep; 0: not known
    std::vector<double> lineTimesS{}; ///< per line, seconds since 1970 UTC; empty when not known; not saved with a scan
};

} // namespace edgescan
