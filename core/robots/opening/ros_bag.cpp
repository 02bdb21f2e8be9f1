// ROS bags: ROS 1, and ROS 2 in MCAP and in SQLite. Read only.
#include "core/robots/opening/ros_bag.h"

#include "core/base/held_file.h"
#include "core/base/inputs.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/base/translated_text.h"
#include "core/base/utc_time.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/pose_sidecar.h"
#include "core/files/open_save/unpack.h"
#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/bag_sweep.h"
#include "core/robots/sweeps/bag_topics.h"
#include "core/robots/sweeps/live_laser.h"

#include <algorithm>
#include <list>
#include <map>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace edgescan::robots {
namespace {

namespace fs = std::filesystem;
using files::RecordedMessage;

/// The bag with each message of lines, clouds, transforms and joints once. A warning counts the others by topic, but for transforms that
/// never change: their topic (tf_static) is sent again and again.
RosBag onceEach(RosBag bag) {
    std::vector<bool> looked;
    for (const RosTopic& topic : bag.topics) looked.push_back(givenBy(topic.type) != TopicGives::Nothing || givesAngles(topic.type));
    std::map<std::string, std::pair<std::unordered_set<std::string_view>, std::size_t>> topics; // by name: bytes, and how many repeat
    std::erase_if(bag.messages, [&](const RosBagMessage& message) {
        if (!looked[message.topic]) return false;
        auto& [known, repeated] = topics[bag.topics[message.topic].name];
        const bool again = !known.insert({reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()}).second;
        repeated += again ? 1 : 0;
        return again;
    });
    for (const auto& [name, messages] : topics) {
        if (messages.second > 0 && !name.ends_with("tf_static"))
            bag.warnings.push_back(
                withValues("%1 messages of the topic %2 are in the bag twice: each was read once.", {messages.second, name}));
    }
    return bag;
}

class RecordedBag final : public files::RecordedSource {
public:
    explicit RecordedBag(RosBag bag) : bag_(std::move(bag)) {}

    [[nodiscard]] const std::string& kind() const override { return bag_.kind; }
    [[nodiscard]] std::vector<RecordedMessage> messages() const override {
        std::vector<RecordedMessage> messages;
        for (const RosBagMessage& message : bag_.messages) {
            const std::int64_t ns = std::clamp(message.logNs, std::int64_t{0}, kLatestNs);
            messages.push_back({files::RecordingTopic::Bridge, ns, ns, message.bytes, message.topic});
        }
        std::ranges::stable_sort(messages, {}, &RecordedMessage::logNs); // some bags are by topic
        return messages;
    }
    [[nodiscard]] std::optional<files::LinePlayer> player(const scanner::SweepSettings& settings,
                                                          const ReadingOptions& options) const override {
        auto topics = topicsToTry(bag_, options.topic, "");
        if (!topics) return std::nullopt;
        turnedFirst(bag_, options.joint, *topics, [&] { return !options.progress || options.progress("reading", 1.0); });
        if (topics->front().gives != TopicGives::Lines) return std::nullopt;
        const std::uint32_t lines = topics->front().topic;
        return files::LinePlayer{[lines](const RecordedMessage& message) { return message.sourceTopic == lines; },
                                 [this, lines, laser = LiveLaser(settings, options.joint, options.keepRepeated)](
                                     const RecordedMessage& message, scanner::SweepAssembler& to) mutable {
                                     const RosTopic& topic = bag_.topics[message.sourceTopic];
                                     if (message.sourceTopic == lines || givesAngles(topic.type)) laser.receive(topic, message.payload, to);
                                 }};
    }

private:
    const RosBag bag_;
};

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

/// A part of a bag that was split.
struct BagPart {
    fs::path path;                    // of its file
    std::span<const std::byte> bytes; // not packed
};

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

/// A part that cannot be read is left out with a warning that names it. Error: there is nothing in them.
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

/// A bag that was split into several files, in memory.
struct SplitBag {
    std::vector<BagPart> parts;             // those that could be read; they point into the rest
    std::list<HeldFile> files;              // as they are on the disk
    std::list<files::UnpackedSource> plain; // without their packing
    std::vector<std::string> warnings;      // parts that are missing or damaged, by name
    std::string sha256;                     // of the files in their order, one behind the other
};

/// Error: no part can be read.
Result<SplitBag> holdSplitBag(const BagFiles& bag, const ReadingOptions& options) {
    SplitBag all;
    Sha256 sha256;
    std::optional<Error> first;
    const auto leaveOut = [&](const std::filesystem::path& part, const Error& error) {
        all.warnings.push_back(withValues("The part %1 of the bag could not be read (%2): its messages are not in the scan.",
                                          {part.filename().string(), error.what}));
        if (!first) first = error;
    };
    for (const std::string& name : bag.missing)
        all.warnings.push_back(withValues("The part %1 of the bag is missing: its messages are not in the scan.", {name}));
    for (const std::string& name : bag.unnamed)
        all.warnings.push_back(
            withValues("metadata.yaml does not name %1, a part of the bag by its name: its messages are not in the scan.", {name}));
    for (const std::string& name : bag.others)
        all.warnings.push_back(withValues(
            "metadata.yaml names %1, whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.", {name}));
    for (const std::filesystem::path& part : bag.parts) {
        if (options.progress && !options.progress("reading", 0.0)) return Error{"cancelled", bag.path.string(), ""};
        claimInput(part);
        auto file = holdFile(part);
        if (!file) {
            leaveOut(part, file.error());
            continue;
        }
        const HeldFile& held = all.files.emplace_back(std::move(*file));
        sha256.add(held.bytes());
        auto plain = files::unpack({part, held.bytes(), &options});
        if (!plain) {
            leaveOut(part, plain.error());
            continue;
        }
        all.plain.push_back(std::move(*plain));
        all.parts.push_back({part, all.plain.back().source.bytes});
    }
    if (all.parts.empty()) return first.value_or(Error{"no part of the bag is there", bag.path.string(), "copy it again"});
    all.sha256 = sha256.hex();
    return all;
}

/// It has the name of the folder.
Result<Scan> scanOf(const BagFiles& bag, const ReadingOptions& options, const files::LinePlayed& played) {
    const std::filesystem::path folder = std::filesystem::absolute(bag.parts.front()).parent_path();
    auto held = holdSplitBag(bag, options);
    if (!held) return held.error();
    const ReadingOptions withPose = files::withPoseSidecar(options, folder);
    const files::Source source{folder, held->parts.front().bytes, &withPose, false, played};
    const auto whole = wholeBag(held->parts, folder.string(), &withPose);
    if (!whole) return whole.error();
    auto reading = scanIn(whole->bag, source);
    if (!reading) return reading.error();
    auto scan = files::scanOfReading(std::move(*reading), source, false);
    if (!scan) return scan;
    scan->warnings.insert(scan->warnings.begin(), held->warnings.begin(), held->warnings.end());
    scan->name = folder.filename().string();
    scan->sha256 = held->sha256;
    scan->path = bag.path.string();
    if (!source.goOn("opened", 1.0)) return source.cancelled();
    return scan;
}

/// The topics of a bag. Empty: it is none. Error: it cannot be read.
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

} // namespace

std::optional<Result<Scan>> openSplitBag(std::filesystem::path& path, const ReadingOptions& options, const files::LinePlayed& played) {
    const auto bag = filesOfBag(path);
    if (!bag) return Result<Scan>(bag.error());
    if (bag->isSplit()) return scanOf(*bag, options, played);
    path = bag->parts.front();
    return std::nullopt;
}

std::optional<Result<files::BagListing>> topicsOfBag(const std::filesystem::path& path, const ReadingOptions& options) {
    const auto bag = filesOfBag(path);
    if (bag && bag->isSplit()) {
        const auto held = holdSplitBag(*bag, options);
        if (!held) return Result<files::BagListing>(held.error());
        const auto whole = wholeBag(held->parts, bag->path.string(), &options);
        if (!whole) return Result<BagListing>(whole.error());
        BagListing listing = listingOf(whole->bag);
        listing.warnings.insert(listing.warnings.begin(), held->warnings.begin(), held->warnings.end());
        return Result<BagListing>(std::move(listing));
    }
    if (!bag || isPipe(bag->parts.front())) return std::nullopt;
    const auto bytes = holdFile(bag->parts.front());
    if (!bytes) return std::nullopt;
    const auto plain = files::unpack({bag->parts.front(), bytes->bytes(), &options});
    if (!plain) return std::nullopt;
    return bagListing(plain->source);
}

Result<std::unique_ptr<files::RecordedSource>> recordedBag(const containers::McapContent& content, const std::string& where,
                                                           const std::function<bool()>& goOn) {
    auto bag = rosBagOf(content, where, goOn);
    if (!bag) return bag.error();
    if (bag->topics.empty()) return std::unique_ptr<files::RecordedSource>();
    return std::unique_ptr<files::RecordedSource>(std::make_unique<RecordedBag>(std::move(*bag)));
}

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

} // namespace edgescan::robots
