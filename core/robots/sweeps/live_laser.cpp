// Gives the lines of a live laser their angles and counters.
#include "core/robots/sweeps/live_laser.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>

namespace edgescan::robots {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kWaitsNs = 2 * kSecond;    // a line for its angle, transforms before joints
constexpr std::int64_t kFindsNs = 20 * kSecond;   // lines and angles in which the motion is searched
constexpr std::int64_t kTriesNs = kSecond / 4;    // between two searches
constexpr std::int64_t kRestartNs = 10 * kSecond; // a clock that is set back by more was restarted
constexpr std::size_t kMostWaiting = 8192, kMostAngles = 4096, kPeriods = 8, kMoves = 64;
constexpr double kRestShare = 0.05; // of the median step from line to line
constexpr double kLost = 0.7;       // periods behind its time: a line before it is lost
constexpr double kOfNewLine = 0.2;  // share of a new line in the usual time
constexpr double kLongestGap = 30000;
constexpr double kSoon = 0.5; // periods: the same ranges once more are the same line, which a relay sent with another stamp

double middleOf(const std::deque<double>& numbers) { return median(std::vector<double>(numbers.begin(), numbers.end())); }

void keepLast(std::deque<double>& numbers, double newest, std::size_t most) {
    numbers.push_back(newest);
    if (numbers.size() > most) numbers.pop_front();
}

} // namespace

int LiveLaser::receive(const RosTopic& topic, ByteView bytes, scanner::SweepAssembler& to) {
    constexpr std::size_t kMostTopics = 100;
    auto known = definitions_.find(topic.name);
    if (known == definitions_.end()) {
        auto definition = rosDefinition(topic.type, topic.definition, topic.name);
        if (!definition || definitions_.size() >= kMostTopics) {
            leaveOut(definition ? "there are too many topics" : definition.error().what.c_str());
            return 0;
        }
        known = definitions_.emplace(topic.name, std::move(*definition)).first;
    }
    const auto message = rosMessage(known->second, topic.encoding, bytes, topic.name);
    const bool isLine = topic.type == "sensor_msgs/LaserScan" || topic.type == "sensor_msgs/MultiEchoLaserScan";
    if (!message) {
        if (isLine) leaveOut(message.error().what.c_str());
        return 0;
    }
    if (isLine)
        receiveLine(*message);
    else if (topic.type == "sensor_msgs/JointState")
        receiveJoints(*message);
    else
        receiveTransforms(*message);
    if (!motion_ && !bySteps_) findMotion();
    return push(to);
}

std::string LiveLaser::waitsFor() const { return lastNs_ || newestNs_ == 0 ? std::string() : whyNoMotion_; }

void LiveLaser::leaveOut(const char* why) {
    ++leftOut_;
    why_ = why;
}

void LiveLaser::receiveLine(const RosValue& message) {
    auto line = laserLine(message, asked_.echo);
    if (!line) return leaveOut(line.error().what.c_str());
    if (newestNs_ != 0 && line->stampNs < newestNs_ - kRestartNs) restart();
    const double sinceS = static_cast<double>(line->stampNs - newestNs_) / kSecond;
    const bool soon = !periodsS_.empty() && sinceS <= kSoon * *std::ranges::max_element(periodsS_);
    if (newestNs_ != 0 && (line->stampNs == newestNs_ || (soon && sinceS > 0 && line->line.ranges.rangeMm == newestMm_))) {
        ++repeated_;
        return;
    }
    if (newestNs_ != 0 && line->stampNs < newestNs_) return leaveOut("a line came out of order");
    if (newestNs_ != 0) keepLast(periodsS_, static_cast<double>(line->stampNs - newestNs_) / kSecond, kPeriods);
    newestNs_ = line->stampNs;
    newestMm_ = line->line.ranges.rangeMm;
    if (frame_.empty()) frame_ = frameNameOf(message.text("header.frame_id"));
    leaveOutNoReturns(*line);
    waiting_.push_back(std::move(*line));
    while (waiting_.size() > kMostWaiting || (!motion_ && waiting_.front().stampNs < newestNs_ - kFindsNs)) {
        waiting_.pop_front();
        leaveOut("the angle of a line is not known");
    }
}

/// What is found holds for the lines that wait, and for all that follow.
void LiveLaser::leaveOutNoReturns(LaserLine& line) {
    if (keepRepeated_) return;
    if (rule_.look({&line, 1})) {
        for (LaserLine& waiting : waiting_) noReturns_ += static_cast<std::int64_t>(rule_.leaveOut(waiting));
    }
    noReturns_ += static_cast<std::int64_t>(rule_.leaveOut(line));
}

void LiveLaser::receiveTransforms(const RosValue& message) {
    if (!motion_) return tree_.add(message);
    if (motion_->axisAssumed) return; // by a joint
    std::size_t unusable = 0;
    for (const NamedPose& found : posesIn(message, unusable)) {
        if (found.child != motion_->mover || found.parent != motion_->baseFrame) continue;
        addAngle({found.pose.ns, laterAngleDeg(*motion_, found.pose)});
    }
}

void LiveLaser::receiveJoints(const RosValue& message) {
    if (!motion_) return addJoints(joints_, message);
    if (!motion_->axisAssumed) return;
    JointAngles newest;
    addJoints(newest, message);
    for (TimedAngle angle : newest[motion_->mover]) {
        angle.deg += 360 * std::round((motion_->angles.back().deg - angle.deg) / 360);
        addAngle(angle);
    }
}

void LiveLaser::addAngle(TimedAngle angle) {
    std::vector<TimedAngle>& angles = motion_->angles;
    if (angle.ns <= angles.back().ns) return; // the same once more
    angles.push_back(angle);
    if (angles.size() > 2 * kMostAngles) angles.erase(angles.begin(), angles.end() - static_cast<std::ptrdiff_t>(kMostAngles));
}

/// Transforms go before joints, as in a bag.
void LiveLaser::findMotion() {
    if (waiting_.size() < kPeriods || newestNs_ < triedNs_ + kTriesNs) return;
    triedNs_ = newestNs_;
    const std::int64_t first = waiting_.front().stampNs;
    const bool late = newestNs_ - first > kWaitsNs;
    tree_.forgetBefore(newestNs_ - kFindsNs);
    for (auto& [name, angles] : joints_) std::erase_if(angles, [&](const TimedAngle& angle) { return angle.ns < newestNs_ - kFindsNs; });
    tree_.sortPoses();
    auto found = joint_.empty() ? motionByFrames(tree_, frame_, middleOf(waiting_.front()), first, newestNs_, "")
                                : motionOfJoints(joints_, joint_, "");
    if (!found && joint_.empty() && late) {
        if (auto byJoint = motionOfJoints(joints_, joint_, "")) found = std::move(byJoint);
    }
    if (found && found->angles.size() >= 2) {
        motion_ = std::move(*found);
        tree_ = FrameTree(kMostPoses);
        joints_.clear();
        return;
    }
    whyNoMotion_ = found ? "the laser did not turn yet" : found.error().what;
    bySteps_ = late && !asked_.stepAssumed && asked_.degPerLine.has_value();
}

/// The robot's clock begins again.
void LiveLaser::restart() {
    waiting_.clear();
    periodsS_.clear();
    tree_.forgetBefore(INT64_MAX);
    joints_.clear();
    if (motion_) motion_->angles.erase(motion_->angles.begin(), std::prev(motion_->angles.end()));
    if (motion_) motion_->angles.back().ns = INT64_MIN / 2;
    newestNs_ = triedNs_ = 0;
    lastDeg_.reset();
    lastNs_.reset();
}

int LiveLaser::push(scanner::SweepAssembler& to) {
    int pushed = 0;
    if ((!motion_ && !bySteps_) || periodsS_.size() < kPeriods - 1) return pushed;
    while (!waiting_.empty()) {
        const std::int64_t ns = waiting_.front().stampNs;
        if (motion_) {
            const AngleAt angle = angleAt(motion_->angles, ns);
            if (!angle.inside && ns > motion_->angles.back().ns && newestNs_ - ns < kWaitsNs) break; // its angle may still come
            scanner::LineTiming& facts = waiting_.front().line.facts;
            facts.stepperDeg = angle.deg;
            facts.degPerSecond = angle.degPerS;
            facts.stepperSettled = true;
            if (!angle.inside) leaveOut("the angle of a line is not known");
            if (!angle.inside || rests(angle.deg)) {
                waiting_.pop_front();
                continue;
            }
        }
        LaserLine line = std::move(waiting_.front());
        waiting_.pop_front();
        pushLine(std::move(line), to);
        ++pushed;
    }
    return pushed;
}

/// A line at rest repeats the one before it.
bool LiveLaser::rests(double deg) {
    const double moved = lastDeg_ ? std::abs(deg - *lastDeg_) : 0.0;
    const double usual = middleOf(movesDeg_);
    const bool resting = lastDeg_ && moved <= kRestShare * usual;
    if (moved > 0 && !resting) keepLast(movesDeg_, moved, kMoves);
    if (!resting) lastDeg_ = deg;
    return resting;
}

void LiveLaser::pushLine(LaserLine line, scanner::SweepAssembler& to) {
    placeBeams(line, motion_ && !motion_->axisAssumed ? motion_->beamShiftDeg : forwardShiftDeg(middleOf(line)));
    const auto ns = static_cast<double>(line.stampNs);
    if (!lastNs_) {
        periodS_ = middleOf(periodsS_);
        idealNs_ = ns;
        if (!firstNs_) {
            scanner::SweepSettings settings = sweepOfLaser(asked_, line);
            if (motion_ && (settings.axisAssumed || !motion_->axisAssumed)) { // transforms say more than who asks
                settings.axis = motion_->axis;
                settings.axisAssumed = motion_->axisAssumed;
            }
            if (motion_) settings.stepAssumed = false;
            to = scanner::SweepAssembler(settings);
        }
        firstNs_ = firstNs_.value_or(line.stampNs);
        number_ += firstNs_ == line.stampNs ? 0 : 1;
    } else {
        const double periodNs = periodS_ * kSecond;
        const double behind = (ns - idealNs_) / periodNs - 1.0;
        const double missing = std::clamp(std::floor(behind + 1.0 - kLost), 0.0, kLongestGap);
        idealNs_ += (1.0 + missing) * periodNs;
        idealNs_ += kOfNewLine * (ns - idealNs_);
        number_ += 1 + static_cast<std::uint64_t>(missing);
    }
    lastNs_ = line.stampNs;
    scanner::SweepLine& made = line.line;
    const auto us = static_cast<std::uint32_t>((line.stampNs - *firstNs_) / 1000);
    made.count = {static_cast<std::uint16_t>(number_), static_cast<std::uint16_t>(number_), us, us, periodS_};
    made.facts.hostNs = made.facts.stampNs = line.stampNs;
    to.push(std::move(made), line.stampNs);
}

} // namespace edgescan::robots
