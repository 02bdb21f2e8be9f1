// ROS bags: ROS 1, and ROS 2 in MCAP and in SQLite. Read only.
#include "core/files/formats/ros_bag.h"

#include "core/containers/ros/bag.h"
#include "core/files/formats/format.h"
#include "core/files/ros/bag_sweep.h"

namespace edgescan::files {
namespace {

ByteView bytesOf(const Source& source) { return {reinterpret_cast<const std::uint8_t*>(source.bytes.data()), source.bytes.size()}; }

Result<Reading> scanOfTopic(const containers::RosBag& bag, const BagTopic& topic, const Source& source) {
    if (topic.gives == TopicGives::Clouds) {
        auto table = cloudOfBag(bag, topic, source);
        if (!table) return table.error();
        return Reading(std::move(*table));
    }
    auto scan = sweepOfBag(bag, topic, source);
    if (!scan) return scan.error();
    return Reading(std::move(*scan));
}

/// Fewer points are one line of a laser, and not a scan.
bool isWholeScan(const Reading& reading) {
    constexpr std::size_t kFewest = 2000;
    const auto* table = std::get_if<PointTable>(&reading.content);
    return table == nullptr || table->points.size() >= kFewest;
}

/// A laser that does not turn is not a scan: the first topic that gives one is taken.
Result<Reading> scanIn(const containers::RosBag& bag, const Source& source) {
    const auto topics = topicsToTry(bag, source.options->topic, source.path.string());
    if (!topics) return topics.error();
    auto first = scanOfTopic(bag, topics->front(), source);
    for (std::size_t n = 1; n < topics->size() && !first && first.error().what != source.cancelled().what; ++n) {
        auto other = scanOfTopic(bag, (*topics)[n], source);
        if (other && isWholeScan(*other)) return other;
    }
    return first;
}

bool looksLikeBag(const Source& source) {
    const ByteView bytes = bytesOf(source);
    return containers::looksLikeRosBag(bytes) || containers::looksLikeSqlite(bytes);
}

Result<containers::RosBag> bagIn(const Source& source) {
    const ByteView bytes = bytesOf(source);
    const std::string where = source.path.string();
    return containers::looksLikeSqlite(bytes) ? containers::readRosDatabase(bytes, where) : containers::readRosBag(bytes, where);
}

Result<Reading> readBag(const Source& source) {
    const auto bag = bagIn(source);
    if (!bag) return bag.error();
    return scanIn(*bag, source);
}

} // namespace

Format rosBagFormat() { return {.title = "ROS bag", .reads = {".bag", ".db3"}, .recognises = looksLikeBag, .read = readBag}; }

Result<Reading> readRosMcap(const containers::McapContent& content, const Source& source) {
    return scanIn(containers::rosBagOf(content, source.path.string()), source);
}

std::optional<Result<BagListing>> bagListing(const Source& source) {
    if (containers::looksLikeMcap(bytesOf(source))) {
        const auto content = containers::readMcap(bytesOf(source), source.path.string());
        if (!content || !containers::hasRosTopics(*content)) return std::nullopt;
        return Result<BagListing>(listingOf(containers::rosBagOf(*content, source.path.string())));
    }
    if (!looksLikeBag(source)) return std::nullopt;
    const auto bag = bagIn(source);
    return bag ? Result<BagListing>(listingOf(*bag)) : Result<BagListing>(bag.error());
}

} // namespace edgescan::files
