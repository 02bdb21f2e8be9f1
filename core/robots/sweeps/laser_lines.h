// sensor_msgs/LaserScan and MultiEchoLaserScan as scan lines: one message is one line.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/repeated_values.h"
#include "core/robots/bags/bag.h"
#include "core/scanner/scan_line/scan_line.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::robots {

/// One line with its own time.
struct LaserLine {
    std::int64_t stampNs = 0; ///< of its first beam in time
    double beamS = 0;         ///< from beam to the next in the line, negative where they were reversed; 0: the message does not say
    bool reversed = false;    ///< the beams run clockwise; they were put into ascending order
    bool contradicts = false; ///< angle_max is not where angle_min and angle_increment put the last beam
    bool timeUnknown = false; ///< time_increment is not a number, or far too long: the beams count as measured at once
    double leastM = 0;        ///< range_min of the message
    double mostM = 0;         ///< range_max of the message
    scanner::SweepLine line;
};

/// All lines of a topic, in order of their stamps, and what had to be noted of them.
struct LaserLines {
    std::string frame; ///< of the fan, as frameNameOf()
    std::vector<LaserLine> lines;
    double periodS = 0.04;         ///< from line to line, the median
    std::size_t disordered = 0;    ///< messages that came before one with an earlier stamp
    std::size_t contradicting = 0; ///< messages whose angle_max contradicts their other angles
    std::size_t repeated = 0;      ///< messages with the ranges and nearly the stamp of one before, which were left out
    std::size_t unreadable = 0;    ///< messages that do not fit their definition, or hold no beams
    std::string whyUnreadable;
    std::size_t timesUnknown = 0; ///< lines, as LaserLine says
    std::string noReturns;        ///< a sentence where one range stood for "no return"; empty otherwise
};

/// The line in a message; its counters are set by others. Error, of which only `what` is set: no beams, no stamp, or angles that no laser
/// has. Numbers that are not finite are never replaced by others.
[[nodiscard]] Result<LaserLine> laserLine(const RosValue& message, scanner::Echo echo);
/// Ranges of a laser that mean "no return": range_min where it repeats more often than any range near it, and one that is far apart, as
/// range_max is where it repeats (repeated_values.h).
class NoReturns {
public:
    /// Looks at lines that follow those before; of a single one, only range_max can be far apart. True: it found what it did not know.
    bool look(std::span<const LaserLine> lines);
    /// Makes missing returns of what was found; returns how many.
    std::size_t leaveOut(LaserLine& line) const;
    [[nodiscard]] std::size_t least() const { return leastRepeats_ ? least_ : 0; } ///< how many are range_min; 0: it is measured
    [[nodiscard]] const std::optional<files::RepeatedRange>& most() const { return most_; }

private:
    std::map<float, std::size_t> nearLeast_; // other ranges near range_min, and how many have each
    std::size_t least_ = 0, mostNear_ = 0;
    bool leastRepeats_ = false;
    std::optional<files::RepeatedRange> most_;
};
/// Of the fan, degrees.
[[nodiscard]] double middleOf(const LaserLine& line);
/// Its beams in the scan's own frame (LaserMotion::beamShiftDeg), and the time from beam to beam, if the message says it.
void placeBeams(LaserLine& line, double shiftDeg);
/// What lines of such beams need of the assembly, besides the axis.
[[nodiscard]] scanner::SweepSettings sweepOfLaser(scanner::SweepSettings asked, const LaserLine& line);

/// Angles become degrees, metres millimetres: whole ones where the message's number is the nearest to one. inf, NaN, 0 and what is outside
/// range_min..range_max is a missing return, and so is a range that means one (repeated_values.h) unless `keepRepeated`. A message
/// that is there twice counts once. The counters of a line count the periods since the line before, so that a gap is lost lines.
Result<LaserLines> laserLines(const RosBag& bag, std::uint32_t topic, scanner::Echo echo, const std::string& where, bool keepRepeated,
                              const std::function<bool()>& goOn);

} // namespace edgescan::robots
