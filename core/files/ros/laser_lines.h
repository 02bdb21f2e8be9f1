// sensor_msgs/LaserScan and MultiEchoLaserScan as scan lines: one message is one line.
#pragma once

#include "core/base/result.h"
#include "core/containers/ros/bag.h"
#include "core/scanner/scan_line/scan_line.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <string>
#include <vector>

namespace edgescan::files {

/// One line with its own time.
struct LaserLine {
    std::int64_t stampNs = 0; ///< of its first beam in time
    double beamS = 0;         ///< from beam to the next in the line, negative where they were reversed; 0: the message does not say
    scanner::SweepLine line;
};

/// All lines of a topic, in order of their stamps, and what had to be noted of them.
struct LaserLines {
    std::string frame; ///< of the fan, as frameNameOf()
    std::vector<LaserLine> lines;
    bool reversed = false;      ///< the beams run clockwise; they were put into ascending order
    double periodS = 0.04;      ///< from line to line, the median
    std::size_t disordered = 0; ///< messages that came before one with an earlier stamp
    std::size_t unreadable = 0; ///< messages that do not fit their definition, or hold no beams
    std::string whyUnreadable;
};

/// Angles become degrees, metres millimetres: whole ones where the message's number is the nearest to one. inf, NaN, 0 and what is outside
/// range_min..range_max is a missing return. The counters of a line count the periods since the line before, so that a gap is lost lines.
Result<LaserLines> laserLines(const containers::RosBag& bag, std::uint32_t topic, scanner::Echo echo, const std::string& where);

} // namespace edgescan::files
