// Topics, sweeps and joints of a bag as readings to choose.
#include "core/base/number_text.h"
#include "core/files/plausibility/opening_check.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace edgescan::files {
namespace {

using Source = OpeningPoint::Source;

constexpr std::size_t kMostOthers = 30;

constexpr const char* kLinesOfTopic = "%1: lines of %2 beams; messages: %3, per second: %4";
constexpr const char* kCloudsOfTopic = "%1: clouds of %2 points; messages: %3, per second: %4";
constexpr const char* kAngleTaken = "from %1";
constexpr const char* kAngleOfJoint = "from the joint %1";
constexpr const char* kAngleFound = "from the transforms, or from the joint that turned furthest";
constexpr const char* kSweepTaken = "sweep %1 of the topic, counted from 0; the topic holds %2";
constexpr const char* kOtherSweep = "sweep %1, counted from 0";

Sentence wordsOf(const ListedTopic& topic) {
    const bool lines = topic.type != "sensor_msgs/PointCloud2";
    return {lines ? kLinesOfTopic : kCloudsOfTopic,
            {topic.name, std::to_string(topic.size), std::to_string(topic.messages),
             topic.hertz > 0 ? significantText(topic.hertz, 3) : std::string("?")}};
}

/// What follows `head` in a warning of the scan, up to `tail`.
std::optional<std::string> warningTextBetween(const Scan& scan, std::string_view head, std::string_view tail) {
    for (const std::string& warning : scan.warnings) {
        const std::size_t at = warning.find(head);
        const std::size_t end = at == std::string::npos ? at : warning.find(tail, at + head.size());
        if (end != std::string::npos) return warning.substr(at + head.size(), end - at - head.size());
    }
    return std::nullopt;
}

std::size_t wholeOf(const std::string& text) {
    std::size_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

const ListedTopic* openedTopic(const BagListing& listing, const Scan& scan, const ReadingOptions& options) {
    const auto said = warningTextBetween(scan, "GUESS: the topic ", " (");
    const std::string name = !options.topic.empty() ? options.topic : said.value_or("");
    const auto found = std::ranges::find_if(listing.topics,
                                            [&](const ListedTopic& topic) { return topic.isScan && (name.empty() || topic.name == name); });
    return found != listing.topics.end() ? &*found : nullptr;
}

OpeningPoint topicOf(const BagListing& listing, const ListedTopic& taken, const ReadingOptions& options) {
    OpeningPoint point{"Topic"};
    point.taken = wordsOf(taken);
    for (const ListedTopic& topic : listing.topics) {
        if (!topic.isScan || &topic == &taken || point.others.size() >= kMostOthers) continue;
        ReadingOptions other = options;
        other.topic = topic.name;
        other.joint.clear();
        other.scanIndex.reset();
        point.others.push_back({wordsOf(topic), std::move(other)});
    }
    point.source = !options.topic.empty() ? Source::Typed : point.others.empty() ? Source::Stated : Source::Guessed;
    return point;
}

std::optional<OpeningPoint> sweepOf(const Scan& scan, const ReadingOptions& options) {
    const auto count = warningTextBetween(scan, "The topic holds ", " sweeps; sweep "),
               number = warningTextBetween(scan, " sweeps; sweep ", ", counted");
    if (!count || !number) return std::nullopt;
    OpeningPoint point{"Sweep"};
    point.source = options.scanIndex ? Source::Typed : Source::Guessed;
    point.taken = {kSweepTaken, {*number, *count}};
    for (std::size_t n = 0; n < std::min(wholeOf(*count), kMostOthers); ++n) {
        if (n == wholeOf(*number)) continue;
        ReadingOptions other = options;
        other.scanIndex = n;
        point.others.push_back({{kOtherSweep, {std::to_string(n)}}, std::move(other)});
    }
    return point;
}

OpeningPoint angleOf(const BagListing& listing, const Scan& scan, const ReadingOptions& options) {
    OpeningPoint point{"Angle of each line"};
    point.source = options.joint.empty() ? Source::Guessed : Source::Typed;
    const std::string source =
        options.joint.empty() ? warningTextBetween(scan, "the angle of each line comes from ", ".").value_or("--line-step") : options.joint;
    point.taken = {options.joint.empty() ? kAngleTaken : kAngleOfJoint, {source}};
    if (!options.joint.empty()) {
        ReadingOptions other = options;
        other.joint.clear();
        point.others.push_back({{kAngleFound}, std::move(other)});
    }
    for (const ListedTopic& topic : listing.topics) {
        for (const std::string& joint : topic.joints) {
            if (joint == options.joint || source == "the joint " + joint || point.others.size() >= kMostOthers) continue;
            ReadingOptions other = options;
            other.joint = joint;
            point.others.push_back({{kAngleOfJoint, {joint}}, std::move(other)});
        }
    }
    return point;
}

} // namespace

std::vector<OpeningPoint> bagCheck(const BagListing& listing, const Scan& scan, const ReadingOptions& options) {
    std::vector<OpeningPoint> points;
    const ListedTopic* taken = openedTopic(listing, scan, options);
    if (taken == nullptr) return points;
    points.push_back(topicOf(listing, *taken, options));
    if (taken->type == "sensor_msgs/PointCloud2") return points;
    if (auto sweep = sweepOf(scan, options)) points.push_back(std::move(*sweep));
    points.push_back(angleOf(listing, scan, options));
    return points;
}

} // namespace edgescan::files
