// Lines of a laser with their angles, assembled to sweeps.
#include "core/robots/sweeps/bag_sweep.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/robots/sweeps/laser_lines.h"
#include "core/robots/sweeps/laser_motion.h"
#include "core/scan/grid/acquisition.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <algorithm>
#include <cmath>

namespace edgescan::robots {
namespace {

constexpr double kStillShare = 0.05; // of the median step from line to line
constexpr double kWorthSayingDeg = 0.5, kWorthSayingM = 0.002;

/// How the laser was turned; empty: only the step from line to line is known.
Result<std::optional<LaserMotion>> motionOf(const RosBag& bag, const FrameTree& tree, const LaserLines& lines,
                                            const files::Source& source) {
    const std::string where = source.path.string();
    const std::int64_t from = lines.lines.front().stampNs, to = lines.lines.back().stampNs;
    const std::string& joint = source.options->joint;
    const auto goOn = [&] { return source.goOn("reading", 1.0); };
    if (joint.empty()) {
        auto byFrames = motionByFrames(tree, lines.frame, middleOf(lines.lines.front()), from, to, where);
        if (byFrames) return std::optional(std::move(*byFrames));
        auto byJoint = motionByJoint(bag, joint, from, to, where, goOn);
        if (byJoint) return std::optional(std::move(*byJoint));
        if (byJoint.error().what == source.cancelled().what) return byJoint.error();
        if (source.options->lineStepDeg) return std::optional<LaserMotion>();
        return byFrames.error();
    }
    auto byJoint = motionByJoint(bag, joint, from, to, where, goOn);
    if (!byJoint) return byJoint.error();
    return std::optional(std::move(*byJoint));
}

/// The error, and what was left out of the transforms, which may be its cause.
Error withWarning(Error error, const FrameTree& tree) {
    if (!tree.warnings().empty()) error.what += "; " + tree.warnings().front().substr(0, tree.warnings().front().rfind('.'));
    return error;
}

class Sweeps {
public:
    Sweeps(const RosBag& bag, const BagTopic& topic, const files::Source& source)
        : bag_(bag), topic_(topic), source_(source), where_(source.path.string()) {}

    Result<Scan> assemble() {
        auto lines = laserLines(bag_, topic_.topic, scanner::Echo::First, where_, source_.options->keepRepeated,
                                [&] { return source_.goOn("reading", 1.0); });
        if (!lines) return lines.error();
        lines_ = std::move(*lines);
        std::vector<std::string> said;
        auto tree = transformsIn(bag_, where_, [&] { return source_.goOn("reading", 1.0); });
        if (!tree) return tree.error();
        addPoses(*tree, bag_, lines_.frame, said);
        tree->finish();
        auto motion = motionOf(bag_, *tree, lines_, source_);
        if (!motion) return withWarning(motion.error(), *tree);
        motion_ = std::move(*motion);
        tree_ = std::move(*tree);
        warnings_ = bag_.warnings;
        warnings_.insert(warnings_.end(), said.begin(), said.end());
        warnings_.insert(warnings_.end(), tree_.warnings().begin(), tree_.warnings().end());
        addWarnings();
        giveAngles();
        return chosen();
    }

private:
    void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

    void addWarnings() {
        if (auto guess = guessText(bag_, topic_, source_.options->topic)) warn(std::move(*guess));
        if (bag_.topics[topic_.topic].assumed)
            warn("The bag holds no definition of its messages: that of the ROS 2 release of 2022 was ASSUMED.");
        if (lines_.unreadable > 0)
            warn(
                withValues(counted(lines_.unreadable, "message of the topic was left out: %1.", "messages of the topic were left out: %1."),
                           {lines_.whyUnreadable}));
        if (lines_.timesUnknown > 0)
            warn(counted(lines_.timesUnknown, "message has a time_increment that cannot be: the beams of a line count as measured at once.",
                         "messages have a time_increment that cannot be: the beams of a line count as measured at once."));
        if (lines_.disordered > 0)
            warn(counted(lines_.disordered, "line came out of order and was put in the order of its stamp",
                         "lines came out of order and were put in the order of their stamps") +
                 ".");
        if (lines_.repeated > 0)
            warn(counted(lines_.repeated, "message of the topic is in the bag twice, with the same stamp and ranges: it was read once.",
                         "messages of the topic are in the bag twice, with the same stamp and ranges: each was read once."));
        if (lines_.contradicting > 0)
            warn(withValues("In %1 angle_max is not where angle_min and angle_increment put the last beam: angle_increment was used, and "
                            "the beams may be mirrored or turned.",
                            {counted(lines_.contradicting, "message")}));
        if (!lines_.noReturns.empty()) warn(lines_.noReturns);
        if (!motion_) return;
        if (motion_->damagedMessages > 0)
            warn(counted(motion_->damagedMessages, "message of joints is damaged and was left out.",
                         "messages of joints are damaged and were left out."));
        if (source_.options->joint.empty()) warn(withValues("GUESS: the angle of each line comes from %1.", {motion_->source}));
        if (motion_->axisAssumed && !source_.options->axis)
            warn(withValues("A joint does not say how the laser is mounted on it. ASSUMED: the axis (%1). Give --axis where that is wrong.",
                            {motion_->axis == Axis::Spin ? "spin" : "sweep, by the name of the joint"}));
        if (motion_->outOfPlaneDeg > kWorthSayingDeg)
            warn(withValues("The axis is %1 degrees out of the plane of the fan: points are that far off.",
                            {significantText(motion_->outOfPlaneDeg, 2)}));
        if (motion_->offAxisM > kWorthSayingM)
            warn(withValues("The laser is %1 mm off its axis: ranges are as measured, and points are as if it were on the axis.",
                            {significantText(motion_->offAxisM * 1000, 3)}));
    }

    /// Lines get their angles. Lines before the first and after the last angle, and lines of a laser at rest, are left out.
    void giveAngles() {
        std::vector<LaserLine>& all = lines_.lines;
        const double shift = motion_ && !motion_->axisAssumed ? motion_->beamShiftDeg : forwardShiftDeg(middleOf(all.front()));
        for (LaserLine& line : all) placeBeams(line, shift);
        if (!motion_) return;
        std::size_t outside = 0;
        std::vector<double> steps;
        for (LaserLine& line : all) {
            const AngleAt angle = angleAt(motion_->angles, line.stampNs);
            outside += angle.inside ? 0 : 1;
            scanner::LineTiming& facts = line.line.facts;
            facts.stepperDeg = angle.deg;
            facts.degPerSecond = angle.degPerS;
            facts.stepperSettled = angle.inside;
        }
        std::erase_if(all, [](const LaserLine& line) { return !line.line.facts.stepperSettled; });
        if (outside > 0)
            warn(counted(outside, "line was measured before the first or after the last angle and was left out.",
                         "lines were measured before the first or after the last angle and were left out."));
        const auto angleOf = [](const LaserLine& line) { return *line.line.facts.stepperDeg; };
        const auto [low, high] = std::ranges::minmax_element(all, {}, angleOf);
        if (all.empty() || angleOf(*high) - angleOf(*low) < kLeastTurnDeg) return all.clear();
        const auto moved = [&](std::size_t n) { return std::abs(*all[n].line.facts.stepperDeg - *all[n - 1].line.facts.stepperDeg); };
        for (std::size_t n = 1; n < all.size(); ++n) {
            if (moved(n) > 0) steps.push_back(moved(n));
        }
        if (steps.empty()) return;
        const double least = kStillShare * median(std::move(steps));
        std::vector<LaserLine> turning;
        for (std::size_t n = 0; n < all.size(); ++n) {
            if ((n > 0 && moved(n) > least) || (n == 0 && all.size() > 1 && moved(1) > least)) turning.push_back(std::move(all[n]));
        }
        if (turning.size() < all.size())
            warn(counted(all.size() - turning.size(), "line was measured while the laser did not turn and was left out.",
                         "lines were measured while the laser did not turn and were left out."));
        all = std::move(turning);
    }

    scanner::SweepSettings settings() const {
        scanner::SweepSettings settings;
        const ReadingOptions& options = *source_.options;
        settings.axis = options.axis ? *options.axis : motion_ ? motion_->axis : Axis::Spin;
        settings.axisAssumed = !options.axis && !motion_;
        settings.degPerLine = options.lineStepDeg;
        if (options.lineStartDeg) settings.firstLineDeg = *options.lineStartDeg;
        settings.firstAssumed = !options.lineStartDeg && scanner::guessesFirst(settings);
        return sweepOfLaser(settings, lines_.lines.front());
    }

    Result<Scan> chosen() {
        if (lines_.lines.empty())
            return Error{"the laser did not turn while it measured", where_, "choose another topic, or give the joint that turns it"};
        scanner::SweepAssembler assembler(settings());
        const std::optional<std::size_t> wanted = source_.options->scanIndex;
        scanner::FinishedSweep best;
        std::size_t sweeps = 0, number = 0;
        const auto collect = [&] {
            for (scanner::FinishedSweep& sweep : assembler.popFinished()) {
                if (wanted ? *wanted == sweeps : !best.scan || sweep.progress.received > best.progress.received) {
                    best = std::move(sweep);
                    number = sweeps;
                }
                ++sweeps;
            }
        };
        const std::int64_t first = lines_.lines.front().stampNs;
        for (std::size_t n = 0; n < lines_.lines.size(); ++n) {
            LaserLine& line = lines_.lines[n];
            const auto done = static_cast<double>(line.stampNs - first);
            if (!source_.goOn("assembling lines", done / std::max(1.0, static_cast<double>(lines_.lines.back().stampNs - first))))
                return source_.cancelled();
            assembler.push(std::move(line.line), line.stampNs);
            const std::int64_t nextNs = n + 1 < lines_.lines.size() ? lines_.lines[n + 1].stampNs : 0;
            if (source_.played) source_.played({static_cast<int>(n), line.stampNs, nextNs, assembler.progress()});
            collect();
        }
        assembler.finish();
        collect();
        if (sweeps == 0)
            return Error{withValues("no line of the topic %1 could be placed", {bag_.topics[topic_.topic].name}), where_,
                         "choose another topic"};
        if (!best.scan)
            return noSuchScan(source_.options->scanIndex.value_or(0), static_cast<std::size_t>(sweeps),
                              withValues("the topic %1", {bag_.topics[topic_.topic].name}), "one sweep", "%1 sweeps");
        Scan scan = *best.scan;
        if (sweeps > 1)
            warn(withValues("The topic holds %1 sweeps; sweep %2, counted from 0, was opened. --scan chooses another.", {sweeps, number}));
        if (motion_ && source_.options->pose.empty()) placeByFrames(scan, tree_, *motion_, warnings_);
        scan.warnings.insert(scan.warnings.begin(), warnings_.begin(), warnings_.end());
        scan.format = bag_.kind;
        if (scan.acquisition) {
            Acquisition device = *scan.acquisition;
            device.vendor.clear();
            device.clockSource = "the stamps of the messages";
            device.contamination.clear();
            scan.acquisition = std::make_shared<const Acquisition>(std::move(device));
        }
        return scan;
    }

    const RosBag& bag_;
    const BagTopic& topic_;
    const files::Source& source_;
    const std::string where_;
    LaserLines lines_;
    FrameTree tree_;
    std::optional<LaserMotion> motion_;
    std::vector<std::string> warnings_;
};

} // namespace

Result<Scan> sweepOfBag(const RosBag& bag, const BagTopic& topic, const files::Source& source) {
    return Sweeps(bag, topic, source).assemble();
}

} // namespace edgescan::robots
