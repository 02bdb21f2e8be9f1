// ROS bags: ROS 1, and ROS 2 in MCAP and in SQLite. Read only.
#include "core/robots/opening/ros_bag.h"
#include "core/base/translated_text.h"

#include "core/base/held_file.h"
#include "core/base/inputs.h"
#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/bag_sweep.h"
#include "core/robots/sweeps/repeated_messages.h"
#include "core/robots/sweeps/turned_first.h"

#include <algorithm>
#include <list>

namespace edgescan::robots {
namespace {

namespace fs = std::filesystem;

std::function<bool()> goOnOf(const files::Source& source) {
    return [&source] { return source.goOn("reading", 0.0); };
}

Result<files::Reading> scanOfTopic(const RosBag& bag, const BagTopic& topic, const files::Source& source) {
    if (topic.gives == TopicGives::Clouds) {
        auto table = cloudOfBag(bag, topic, source);
        if (!table) return table.error();
        return files::Reading(std::move(*table));
    }
    auto scan = sweepOfBag(bag, topic, source);
    if (!scan) return scan.error();
    return files::Reading(std::move(*scan));
}

/// Fewer points are one line of a laser, and not a scan.
bool isWholeScan(const files::Reading& reading) {
    constexpr std::size_t kFewest = 2000;
    const auto* table = std::get_if<files::PointTable>(&reading.content);
    return table == nullptr || table->points.size() >= kFewest;
}

/// A laser that does not turn is not a scan: the first topic that gives one is taken. Each is tried with all transforms and joints.
Result<files::Reading> scanIn(const RosBag& bag, const files::Source& source) {
    constexpr std::size_t kMostTried = 30;
    auto topics = topicsToTry(bag, source.options->topic, source.path.string());
    if (!topics) return topics.error();
    turnedFirst(bag, source.options->joint, *topics, goOnOf(source));
    auto first = scanOfTopic(bag, topics->front(), source);
    for (std::size_t n = 1; n < std::min(topics->size(), kMostTried) && !first && first.error().what != source.cancelled().what; ++n) {
        auto other = scanOfTopic(bag, (*topics)[n], source);
        if (other && isWholeScan(*other)) return other;
    }
    return first;
}

bool looksLikeBag(const files::Source& source) {
    const ByteView bytes = source.octets();
    return looksLikeRosBag(bytes) || looksLikeSqlite(bytes);
}

/// What SQLite left of a database that was not closed; of a link it is in the folder of the file itself.
Result<std::vector<HeldFile>> logsOf(const files::Source& source, std::vector<DatabaseLog>& logs) {
    std::vector<HeldFile> held;
    for (const fs::path& name : source.inMemory ? std::vector<fs::path>() : namesOf(source.path)) {
        for (const char* ending : {"-wal", "-journal"}) {
            std::error_code problem;
            const fs::path log = name.string() + ending;
            if (!fs::is_regular_file(log, problem) || fs::file_size(log, problem) == 0) continue;
            claimInput(log);
            auto file = holdFile(log);
            if (!file) return file.error();
            held.push_back(std::move(*file));
            const std::span<const std::byte> bytes = held.back().bytes();
            logs.push_back({log.filename().string(), {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}});
        }
        if (!held.empty()) break;
    }
    return held;
}

Result<RosBag> bagIn(const files::Source& source) {
    const ByteView bytes = source.octets();
    const std::string where = source.path.string();
    if (!looksLikeSqlite(bytes)) return readRosBag(bytes, where, goOnOf(source));
    std::vector<DatabaseLog> logs;
    const auto held = logsOf(source, logs);
    if (!held) return held.error();
    return readRosDatabase(bytes, where, logs, goOnOf(source));
}

Result<files::Reading> readBag(const files::Source& source) {
    auto bag = bagIn(source);
    if (!bag) return bag.error();
    return scanIn(onceEach(std::move(*bag)), source);
}

/// A bag of several parts, with the content that its messages point into.
struct WholeBag {
    std::list<containers::McapContent> contents;
    RosBag bag;
};

Result<RosBag> bagOf(const BagPart& part, const ReadingOptions* options, std::list<containers::McapContent>& contents) {
    const files::Source source{part.path, part.bytes, options};
    const std::string name = part.path.filename().string();
    if (!containers::looksLikeMcap(source.octets())) {
        if (!looksLikeBag(source)) return source.refused("it is not a file of a bag", "copy it again");
        return bagIn(source);
    }
    auto content = containers::readMcap(source.octets(), name, goOnOf(source));
    if (!content) return content.error();
    return rosBagOf(contents.emplace_back(std::move(*content)), name, goOnOf(source));
}

/// Adds the messages of the next part.
void append(RosBag& whole, RosBag part, const std::string& name) {
    std::vector<std::uint32_t> numbers;
    for (RosTopic& topic : part.topics) {
        const auto same = std::ranges::find_if(whole.topics, [&](const RosTopic& known) {
            return known.name == topic.name && known.type == topic.type && known.definition == topic.definition &&
                   known.encoding == topic.encoding;
        });
        numbers.push_back(static_cast<std::uint32_t>(same - whole.topics.begin()));
        if (same == whole.topics.end()) whole.topics.push_back(std::move(topic));
    }
    for (const RosBagMessage& message : part.messages) whole.messages.push_back({numbers[message.topic], message.logNs, message.bytes});
    whole.unpacked.splice(whole.unpacked.end(), part.unpacked);
    for (const std::string& warning : part.warnings) whole.warnings.push_back(name + ": " + warning);
    if (whole.kind.empty()) whole.kind = part.kind;
}

Result<WholeBag> wholeBag(const std::vector<BagPart>& parts, const std::string& where, const ReadingOptions* options) {
    WholeBag whole;
    std::optional<Error> first;
    for (const BagPart& part : parts) {
        const std::string name = part.path.filename().string();
        auto bag = bagOf(part, options, whole.contents);
        if (bag) {
            append(whole.bag, std::move(*bag), name);
            continue;
        }
        if (bag.error().what == "cancelled") return bag.error();
        if (!first) first = Error{bag.error().what, where, bag.error().hint};
        whole.bag.warnings.push_back(
            withValues("The part %1 of the bag could not be read (%2): its messages are not in the scan.", {name, bag.error().what}));
    }
    if (whole.bag.topics.empty() && first) return *first;
    whole.bag = onceEach(std::move(whole.bag));
    return whole;
}

} // namespace

files::Format rosBagFormat() {
    return {
        .title = "ROS bag", .reads = {".bag", ".db3"}, .recognises = looksLikeBag, .read = readBag, .options = {"topic", "joint", "scan"}};
}

std::optional<Result<files::Reading>> readRosMcap(const files::Source& source) {
    const auto content = containers::readMcap(source.octets(), source.path.string(), goOnOf(source));
    if (!content || !hasRosTopics(*content)) return std::nullopt;
    auto bag = rosBagOf(*content, source.path.string(), goOnOf(source));
    if (!bag) return Result<files::Reading>(bag.error());
    return scanIn(onceEach(std::move(*bag)), source);
}

std::optional<Result<BagListing>> bagListing(const files::Source& source) {
    if (containers::looksLikeMcap(source.octets())) {
        const auto content = containers::readMcap(source.octets(), source.path.string(), goOnOf(source));
        if (!content || !hasRosTopics(*content)) return std::nullopt;
        auto bag = rosBagOf(*content, source.path.string(), goOnOf(source));
        return bag ? Result<BagListing>(listingOf(onceEach(std::move(*bag)))) : Result<BagListing>(bag.error());
    }
    if (!looksLikeBag(source)) return std::nullopt;
    auto bag = bagIn(source);
    return bag ? Result<BagListing>(listingOf(onceEach(std::move(*bag)))) : Result<BagListing>(bag.error());
}

Result<files::Reading> readBagParts(const std::vector<BagPart>& parts, const files::Source& whole) {
    const auto bag = wholeBag(parts, whole.path.string(), whole.options);
    if (!bag) return bag.error();
    return scanIn(bag->bag, whole);
}

Result<BagListing> listingOfParts(const std::vector<BagPart>& parts, const files::Source& whole) {
    const auto bag = wholeBag(parts, whole.path.string(), whole.options);
    if (!bag) return bag.error();
    return listingOf(bag->bag);
}

} // namespace edgescan::robots
