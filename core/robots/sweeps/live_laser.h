// A laser of a robot with ROS, live: messages go in one by one, scan lines with their angles come out.
#pragma once

#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/laser_lines.h"
#include "core/robots/sweeps/laser_motion.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <deque>
#include <map>
#include <optional>
#include <string>

namespace edgescan::robots {

/// A line is pushed as soon as an angle at or after its time is known. Memory is bounded: lines wait for seconds, and so do angles.
class LiveLaser {
public:
    /// `asked` goes before what is found: a given axis, and a given step where no transform and no joint turns the laser. `joint`: empty:
    /// the one that is found. `keepRepeated`: NoReturns are measured.
    LiveLaser(const scanner::SweepSettings& asked, std::string joint, bool keepRepeated = false)
        : asked_(asked), joint_(std::move(joint)), keepRepeated_(keepRepeated) {}

    /// A message of the laser, of transforms or of joints. Pushes the lines that it makes known, their number is returned. The assembler is
    /// made again with what the laser needs before its first line.
    int receive(const RosTopic& topic, ByteView bytes, scanner::SweepAssembler& to);

    /// Lines that were left out, and why the last one was.
    [[nodiscard]] std::int64_t leftOut() const { return leftOut_; }
    [[nodiscard]] const std::string& whyLeftOut() const { return why_; }
    /// Lines that came twice: with the stamp of the newest, or with its ranges within half a period.
    [[nodiscard]] std::int64_t repeated() const { return repeated_; }
    /// Ranges that are range_min or range_max of their message and repeat, so that they mean "no return".
    [[nodiscard]] std::int64_t noReturns() const { return noReturns_; }
    /// Why no line was pushed so far; empty: a line was pushed, or did not come yet.
    [[nodiscard]] std::string waitsFor() const;

private:
    void receiveLine(const RosValue& message);
    void receiveTransforms(const RosValue& message);
    void receiveJoints(const RosValue& message);
    void addAngle(TimedAngle angle);
    void findMotion();
    void restart();
    int push(scanner::SweepAssembler& to);
    void pushLine(LaserLine line, scanner::SweepAssembler& to);
    bool rests(double deg);
    void leaveOutNoReturns(LaserLine& line);
    void leaveOut(const char* why);

    scanner::SweepSettings asked_;
    std::string joint_;
    bool keepRepeated_;
    std::map<std::string, RosDefinition> definitions_; // by topic

    std::deque<LaserLine> waiting_;
    std::string frame_;
    std::deque<double> periodsS_;                      // of the last lines, by their stamps
    std::int64_t newestNs_ = 0;                        // stamp of the newest line
    std::vector<float> newestMm_;                      // its ranges, as they came
    static constexpr std::size_t kMostPoses = 200'000; // that wait for the motion: 20 s of a robot have some thousand
    FrameTree tree_{kMostPoses};
    JointAngles joints_;
    std::optional<LaserMotion> motion_;
    bool bySteps_ = false; // no angle is known, only the step from line to line
    std::int64_t triedNs_ = 0;
    std::string whyNoMotion_;

    std::deque<double> movesDeg_; // from line to line, those that moved
    std::optional<double> lastDeg_;
    std::optional<std::int64_t> firstNs_, lastNs_; // of the lines that were pushed
    double idealNs_ = 0;                           // when the last one would have come without jitter
    double periodS_ = 0;
    std::uint64_t number_ = 0;
    std::int64_t leftOut_ = 0, repeated_ = 0, noReturns_ = 0;
    NoReturns rule_;
    std::string why_;
};

} // namespace edgescan::robots
