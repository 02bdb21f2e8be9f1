// Laser messages as scan lines.
#include "core/robots/sweeps/laser_lines.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/base/physical_limits.h"
#include "core/robots/sweeps/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace edgescan::robots {
namespace {

constexpr double kMmPerM = 1000.0;
constexpr double kNsPerS = 1e9;
constexpr std::size_t kMostBeams = 1'000'000;
constexpr double kLongestLineS = 1000;   // from the first beam to the last
constexpr double kOfNew = 0.05;          // share of a new line in the usual lateness
constexpr std::size_t kAhead = 8;        // lines that must be late, too, until a late line shows that others were lost
constexpr double kMostLostLines = 30000; // by one gap: a longer one begins another sweep anyway

/// Millimetres of a range in metres of 4 bytes: the whole number whose nearest float it is, if there is one.
float millimetresOf(double metres) {
    const double mm = metres * kMmPerM, whole = std::round(mm);
    return static_cast<float>(static_cast<float>(whole / kMmPerM) == static_cast<float>(metres) ? whole : mm);
}

/// The echoes of each beam: one number, or the first or last of several.
std::vector<double> echoesOf(const RosValue& message, const char* name, scanner::Echo echo) {
    const RosValue* values = message.at(name);
    if (values == nullptr || values->field == nullptr) return {};
    if (values->field->scalar != RosScalar::Message) return message.numbers(name);
    std::vector<double> all;
    for (const RosValue& beam : values->inside) {
        const std::vector<double> echoes = beam.numbers("echoes");
        all.push_back(echoes.empty()                 ? std::numeric_limits<double>::quiet_NaN()
                      : echo == scanner::Echo::First ? echoes.front()
                                                     : echoes.back());
    }
    return all;
}

void storeRanges(scanner::SweepLine& line, const std::vector<double>& rangesM, double leastM, double mostM) {
    for (const double metres : rangesM) {
        const bool isRange = std::isfinite(metres) && metres > 0 && metres >= leastM && metres <= mostM &&
                             physical::kRangeMm.hold(static_cast<float>(metres * kMmPerM));
        line.ranges.rangeMm.push_back(isRange ? millimetresOf(metres) : 0.0F);
        line.ranges.state.push_back(isRange ? CellState::Valid : CellState::NoReturn);
    }
}

double secondsBetween(const LaserLine& a, const LaserLine& b) { return static_cast<double>(b.stampNs - a.stampNs) / kNsPerS; }

/// The times from each line to the one that follows it after so many, by one of them.
std::vector<double> periodsOver(const std::vector<LaserLine>& lines, std::size_t after) {
    std::vector<double> periods;
    for (std::size_t n = after; n < lines.size(); ++n) {
        if (const double s = secondsBetween(lines[n - after], lines[n]); s > 0) periods.push_back(s / static_cast<double>(after));
    }
    return periods;
}

/// Lines that are missing before each line. Stamps of a computer jitter by more than a half of a period: a line is late because others are
/// missing if all lines behind it are as late.
struct Missing {
    std::vector<std::uint32_t> before; // by line
    double doubt = 0;                  // how far lines are from where the period puts them, with the lines that it finds missing

    [[nodiscard]] double all() const { return static_cast<double>(std::accumulate(before.begin(), before.end(), std::uint64_t{0})); }
};

Missing missingWith(const std::vector<LaserLine>& lines, double periodS) {
    const std::size_t count = lines.size();
    std::vector<double> late(count, 0.0); // periods behind the first line, without those of the lines between
    for (std::size_t n = 0; n < count; ++n) late[n] = secondsBetween(lines.front(), lines[n]) / periodS - static_cast<double>(n);
    Missing missing{std::vector<std::uint32_t>(count, 0), 0};
    double usual = 0;
    for (std::size_t n = 1; n < count; ++n) {
        const auto from = late.begin() + static_cast<std::ptrdiff_t>(n);
        const double least = *std::min_element(from, late.begin() + static_cast<std::ptrdiff_t>(std::min(n + kAhead, count)));
        const double gap = std::max(0.0, std::round(least - usual));
        missing.before[n] = static_cast<std::uint32_t>(std::min(gap, kMostLostLines));
        usual += gap;
        missing.doubt += std::abs(least - usual) + gap;
        usual += kOfNew * (least - usual);
    }
    return missing;
}

/// From line to line: the mean of those near the median. Where most are not near it the stamps jitter: of the periods over many lines, some
/// of which have lines missing, the one is taken that explains the stamps best.
double usualPeriodS(const std::vector<LaserLine>& lines) {
    constexpr double kNear = 0.1;
    std::vector<double> periods = periodsOver(lines, 1);
    if (periods.empty()) return scanner::LineCount{}.periodS;
    const double middle = median(periods);
    const std::size_t all = periods.size();
    std::erase_if(periods, [&](double s) { return std::abs(s - middle) > kNear * middle; });
    if (2 * periods.size() < all && lines.size() > 2 * kAhead) {
        double best = middle, least = std::numeric_limits<double>::infinity();
        const auto judge = [&](double periodS) {
            const Missing missing = missingWith(lines, periodS);
            if (missing.doubt < least) {
                least = missing.doubt;
                best = periodS;
            }
            return secondsBetween(lines.front(), lines.back()) / (static_cast<double>(lines.size() - 1) + missing.all());
        };
        for (const std::size_t after : {2 * kAhead, kAhead}) {
            std::vector<double> over = periodsOver(lines, after);
            std::ranges::sort(over);
            for (std::size_t tenth = 1; tenth < 8 && !over.empty(); ++tenth) judge(judge(over[over.size() * tenth / 10]));
        }
        return best;
    }
    double sum = 0;
    for (const double s : periods) sum += s;
    return sum / static_cast<double>(periods.size());
}

void count(LaserLines& all) {
    const std::vector<std::uint32_t> missing = missingWith(all.lines, all.periodS).before;
    std::uint64_t number = 0;
    for (std::size_t n = 0; n < all.lines.size(); ++n) {
        scanner::SweepLine& line = all.lines[n].line;
        if (n > 0) number += 1 + missing[n];
        const auto us = static_cast<std::uint32_t>((all.lines[n].stampNs - all.lines.front().stampNs) / 1000);
        line.count = {static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(number), us, us, all.periodS};
        line.facts.hostNs = line.facts.stampNs = all.lines[n].stampNs;
    }
}

/// The time between lines with other ranges than the one before, the median.
double periodOfOtherRangesS(const std::vector<LaserLine>& lines) {
    std::vector<double> periods;
    const LaserLine* before = nullptr;
    for (const LaserLine& line : lines) {
        if (before != nullptr && line.line.ranges.rangeMm == before->line.ranges.rangeMm) continue;
        if (before != nullptr) periods.push_back(secondsBetween(*before, line));
        before = &line;
    }
    return periods.empty() ? 0 : median(periods);
}

/// Messages that a bag holds twice, as where two recorders or a relay wrote them, each with a clock of its own. No laser measures a whole
/// line again with the same noise, and none within half of its period. Lines are in order of their stamps.
void leaveOutRepeated(LaserLines& all) {
    constexpr double kSoon = 0.5; // periods
    const double soonS = kSoon * periodOfOtherRangesS(all.lines);
    std::vector<LaserLine> once;
    once.reserve(all.lines.size());
    for (LaserLine& line : all.lines) {
        bool again = false;
        constexpr std::size_t kLookedBack = 8; // others may have the same stamp
        for (std::size_t n = once.size(), looked = 0; n > 0 && looked < kLookedBack && !again; --n, ++looked)
            again = secondsBetween(once[n - 1], line) <= soonS && once[n - 1].line.ranges.rangeMm == line.line.ranges.rangeMm;
        if (!again) once.push_back(std::move(line));
    }
    all.repeated = all.lines.size() - once.size();
    all.lines = std::move(once);
}

/// A range in millimetres that is far apart from the rest, as range_max is where it repeats.
std::optional<files::RepeatedRange> farApartIn(std::span<const LaserLine> lines) {
    std::vector<double> ranges;
    std::vector<double> beamDeg;
    double mostM = lines.empty() ? 0 : lines.front().mostM;
    for (const LaserLine& line : lines) {
        mostM = line.mostM == mostM ? mostM : 0;
        const auto& mm = line.line.ranges.rangeMm;
        ranges.insert(ranges.end(), mm.begin(), mm.end());
        for (std::size_t j = 0; j < mm.size(); ++j)
            beamDeg.push_back(line.line.beams.startDeg + line.line.beams.stepDeg * static_cast<double>(j));
    }
    files::RangesToJudge given{ranges};
    given.direction = [&](std::size_t n) { return Eigen::Vector3d(std::cos(radians(beamDeg[n])), std::sin(radians(beamDeg[n])), 0); };
    if (mostM > 0) given.stated = static_cast<double>(millimetresOf(mostM));
    return files::repeatedRange(given);
}

bool isLeast(const LaserLine& line, float mm) { return line.leastM > 0 && mm == millimetresOf(line.leastM); }

void markNoReturns(LaserLines& all) {
    NoReturns found;
    if (!found.look(all.lines)) return;
    for (LaserLine& line : all.lines) found.leaveOut(line);
    const auto add = [&](std::size_t count, const char* what, double metres) {
        all.noReturns += all.noReturns.empty() ? "" : " ";
        all.noReturns += files::repeatedSentence(count, withValues(what, {significantText(metres, 6)}));
    };
    if (found.least() > 0) add(found.least(), "ranges of the topic are %1 m, the range_min of their messages", all.lines.front().leastM);
    if (found.most()) add(found.most()->count, "ranges of the topic are %1 m", found.most()->least / kMmPerM);
}

} // namespace

bool NoReturns::look(std::span<const LaserLine> lines) {
    constexpr std::size_t kFewest = 5, kOftener = 3, kMostNear = 4096;
    constexpr float kNear = 1.1F;
    constexpr double kAtMostM = 0.001; // as near to range_max is range_max
    const bool knewLeast = leastRepeats_, knewMost = most_.has_value();
    for (const LaserLine& line : knewLeast ? std::span<const LaserLine>() : lines) {
        const auto mostMm = kNear * millimetresOf(line.leastM);
        for (const float mm : line.line.ranges.rangeMm) {
            const bool near = mm > 0 && mm <= mostMm && !isLeast(line, mm);
            least_ += isLeast(line, mm) ? 1 : 0;
            if (near && nearLeast_.size() < kMostNear) mostNear_ = std::max(mostNear_, ++nearLeast_[mm]);
        }
    }
    leastRepeats_ = knewLeast || (least_ >= kFewest && least_ >= kOftener * mostNear_);
    if (!knewMost) most_ = farApartIn(lines);
    if (!knewMost && most_ && lines.size() == 1 && most_->least < (lines[0].mostM - kAtMostM) * kMmPerM) most_.reset();
    return leastRepeats_ != knewLeast || most_.has_value() != knewMost;
}

std::size_t NoReturns::leaveOut(LaserLine& line) const {
    std::size_t count = 0;
    auto& [mm, state] = line.line.ranges;
    for (std::size_t j = 0; j < mm.size(); ++j) {
        if (!(most_ && static_cast<double>(mm[j]) >= most_->least) && !(leastRepeats_ && isLeast(line, mm[j]))) continue;
        mm[j] = 0;
        state[j] = CellState::NoReturn;
        ++count;
    }
    return count;
}

Result<LaserLine> laserLine(const RosValue& message, scanner::Echo echo) {
    const auto number = [&](const char* name, double otherwise) {
        const double value = message.number(name).value_or(otherwise);
        return std::isfinite(value) ? value : otherwise;
    };
    const auto refused = [](const char* what) { return Error{what, "", ""}; };
    const auto stamp = stampNs(message, "header.stamp");
    std::vector<double> rangesM = echoesOf(message, "ranges", echo);
    if (!stamp || rangesM.empty() || rangesM.size() > kMostBeams) return refused("it has no beams or no stamp");
    LaserLine found;
    found.stampNs = *stamp;
    scanner::SweepLine& line = found.line;
    const auto count = static_cast<int>(rangesM.size());
    const double from = degrees(message.number("angle_min").value_or(0)), step = degrees(message.number("angle_increment").value_or(0));
    const double last = from + step * (count - 1), most = degrees(number("angle_max", 0));
    if (!std::isfinite(step) || step == 0) return refused("its angle_increment does not give the step between beams");
    if (!physical::kBeamDeg.hold(scanner::snappedDeg(from)) || !physical::kBeamDeg.hold(scanner::snappedDeg(last)))
        return refused("its angle_min or angle_increment puts beams outside of one turn");
    constexpr double kStepsOff = 2; // drivers count the beams or the steps between them
    found.contradicts = most != 0 && std::abs(most - last) > kStepsOff * std::abs(step);
    line.beams = {scanner::snappedDeg(from), scanner::snappedDeg(step), count};
    found.beamS = message.number("time_increment").value_or(0);
    found.timeUnknown = !(std::abs(found.beamS) * count <= kLongestLineS);
    if (found.timeUnknown) found.beamS = 0;
    const double farthestM = number("range_max", 0);
    found.mostM = farthestM > 0 ? farthestM : std::numeric_limits<double>::max();
    found.leastM = number("range_min", 0);
    storeRanges(line, rangesM, found.leastM, found.mostM);
    const std::vector<double> strengths = echoesOf(message, "intensities", echo);
    if (strengths.size() == rangesM.size()) line.intensity.assign(strengths.begin(), strengths.end());
    found.reversed = step < 0;
    if (found.reversed) {
        found.beamS = -found.beamS;
        line.beams.startDeg += line.beams.stepDeg * (count - 1);
        line.beams.stepDeg = -line.beams.stepDeg;
        std::ranges::reverse(line.ranges.rangeMm);
        std::ranges::reverse(line.ranges.state);
        std::ranges::reverse(line.intensity);
    }
    if (const double turn = number("scan_time", 0); turn > 0) line.facts.secondsPerTurn = turn;
    line.echoes = "ranges";
    return found;
}

double middleOf(const LaserLine& line) {
    const scanner::BeamGrid& beams = line.line.beams;
    return beams.startDeg + beams.stepDeg * (beams.beams - 1) / 2;
}

void placeBeams(LaserLine& line, double shiftDeg) {
    scanner::SweepLine& to = line.line;
    to.beams.startDeg -= shiftDeg;
    if (line.beamS != 0) to.facts.secondsPerTurn = line.beamS * 360.0 / to.beams.stepDeg;
}

scanner::SweepSettings sweepOfLaser(scanner::SweepSettings asked, const LaserLine& line) {
    const scanner::BeamGrid& beams = line.line.beams;
    asked.continuous = line.beamS != 0;
    asked.outputInterval = 1;
    asked.indexDeg = line.reversed ? beams.startDeg + beams.stepDeg * (beams.beams - 1) : beams.startDeg;
    return asked;
}

Result<LaserLines> laserLines(const RosBag& bag, std::uint32_t topic, scanner::Echo echo, const std::string& where, bool keepRepeated,
                              const std::function<bool()>& goOn) {
    const RosTopic& of = bag.topics[topic];
    const auto definition = rosDefinition(of.type, of.definition, where);
    if (!definition) return definition.error();
    LaserLines all;
    const auto unreadable = [&](const std::string& why) {
        if (all.unreadable++ == 0) all.whyUnreadable = why;
    };
    for (const RosBagMessage& stored : bag.messages) {
        if (stored.topic != topic) continue;
        if (!goOn()) return Error{"cancelled", where, ""};
        const auto message = rosMessage(*definition, of.encoding, stored.bytes, where);
        if (!message) {
            unreadable(message.error().what);
            continue;
        }
        auto line = laserLine(*message, echo);
        if (!line) {
            unreadable(line.error().what);
            continue;
        }
        all.timesUnknown += line->timeUnknown ? 1 : 0;
        if (all.frame.empty()) all.frame = frameNameOf(message->text("header.frame_id"));
        all.contradicting += line->contradicts ? 1 : 0;
        if (!all.lines.empty() && line->stampNs < all.lines.back().stampNs) ++all.disordered;
        all.lines.push_back(std::move(*line));
    }
    if (all.lines.empty())
        return Error{
            withValues("no message of the topic %1 is a line of ranges%2", {of.name, all.unreadable > 0 ? ": " + all.whyUnreadable : ""}),
            where, "choose another topic"};
    std::ranges::stable_sort(all.lines, {}, &LaserLine::stampNs);
    leaveOutRepeated(all);
    if (!keepRepeated) markNoReturns(all);
    all.periodS = usualPeriodS(all.lines);
    count(all);
    return all;
}

} // namespace edgescan::robots
