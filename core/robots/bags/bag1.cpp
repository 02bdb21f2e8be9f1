// Bags of ROS 1: records of header fields and data.
#include "core/base/checked_size.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/robots/bags/bag.h"

#include <algorithm>
#include <map>
#include <optional>

namespace edgescan::robots {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::string_view kAnyMagic = "#ROSBAG V";
constexpr std::size_t kMostTopics = 10'000;

enum Opcode : std::uint8_t { kMessage = 0x02, kBagHeader = 0x03, kIndex = 0x04, kChunk = 0x05, kChunkInfo = 0x06, kConnection = 0x07 };

std::string_view textOf(ByteView bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// Takes a piece with its length in front off the bytes; nothing: the bytes end before.
std::optional<ByteView> pieceOff(ByteView& bytes) {
    if (bytes.size() < 4) return std::nullopt;
    const std::uint64_t length = littleEndian(bytes.first(4));
    if (length > bytes.size() - 4) return std::nullopt;
    const ByteView piece = bytes.subspan(4, static_cast<std::size_t>(length));
    bytes = bytes.subspan(4 + piece.size());
    return piece;
}

/// "name=value" of a header; empty: there is none.
ByteView fieldOf(ByteView header, std::string_view name) {
    while (const auto field = pieceOff(header)) {
        const std::size_t sign = textOf(*field).find('=');
        if (sign != std::string_view::npos && textOf(*field).substr(0, sign) == name) return field->subspan(sign + 1);
    }
    return {};
}

class BagReader {
public:
    BagReader(ByteView bytes, const std::string& where, const std::function<bool()>& goOn) : bytes_(bytes), where_(where), goOn_(goOn) {
        bag_.kind = "ROS 1 bag";
        bag_.mayUnpack = mostUnpackedBytes(bytes.size());
    }

    Result<RosBag> read() {
        ByteView rest = bytes_.subspan(kMagic.size());
        const std::size_t used = records(rest, true);
        if (isCancelled()) return Error{"cancelled", where_, ""};
        if (std::ranges::any_of(rest.subspan(used), [](std::uint8_t byte) { return byte != 0; }))
            bag_.warnings.push_back(
                withValues("The bag is cut off or damaged at byte %1: the last %2.",
                           {kMagic.size() + used, counted(rest.size() - used, "byte was not read", "bytes were not read")}));
        nameTopics();
        if (badChunks_ > 0)
            bag_.warnings.push_back(withValues(
                counted(badChunks_, "chunk is damaged and was left out (%1).", "chunks are damaged and were left out (%1)."), {whyBad_}));
        if (strangers_ > 0)
            bag_.warnings.push_back(counted(strangers_, "message belongs to no topic of the bag and was left out.",
                                            "messages belong to no topic of the bag and were left out."));
        return std::move(bag_);
    }

private:
    [[nodiscard]] bool isCancelled() const { return goOn_ && !goOn_(); }

    /// Reads records from the front; the number of bytes of whole records.
    std::size_t records(ByteView bytes, bool mayHoldChunks) {
        constexpr std::size_t kBetweenLooks = 64; // at the wish to stop
        ByteView rest = bytes;
        for (std::size_t n = 0; !rest.empty() && (n % kBetweenLooks != 0 || !isCancelled()); ++n) {
            ByteView next = rest;
            const auto header = pieceOff(next);
            const auto data = header ? pieceOff(next) : std::nullopt;
            if (!data) {
                if (header && mayHoldChunks && opcodeOf(*header) == kChunk && next.size() > 4) salvage(*header, next.subspan(4));
                break;
            }
            rest = next;
            record(*header, *data, mayHoldChunks);
        }
        return bytes.size() - rest.size();
    }

    static std::uint8_t opcodeOf(ByteView header) {
        const ByteView op = fieldOf(header, "op");
        return op.empty() ? std::uint8_t{0} : op[0];
    }

    void record(ByteView header, ByteView data, bool mayHoldChunks) {
        switch (opcodeOf(header)) {
        case kConnection:
            return connection(header, data);
        case kMessage:
            return message(header, data);
        case kChunk:
            if (mayHoldChunks) chunk(header, data);
            return;
        default:
            return;
        }
    }

    void connection(ByteView header, ByteView data) {
        const auto id = static_cast<std::uint32_t>(littleEndian(fieldOf(header, "conn")));
        if (topics_.contains(id) || bag_.topics.size() >= kMostTopics) return;
        RosTopic topic{std::string(textOf(fieldOf(header, "topic"))), rosTypeName(textOf(fieldOf(data, "type"))),
                       std::string(textOf(fieldOf(data, "message_definition"))), RosEncoding::Ros1, false};
        // Each program that sends on a topic has a connection of its own.
        const auto same = std::ranges::find_if(bag_.topics, [&](const RosTopic& known) {
            return known.name == topic.name && known.type == topic.type && known.definition == topic.definition;
        });
        topics_[id] = static_cast<std::uint32_t>(same - bag_.topics.begin());
        if (same == bag_.topics.end()) bag_.topics.push_back(std::move(topic));
    }

    void message(ByteView header, ByteView data) {
        const ByteView time = fieldOf(header, "time");
        if (time.size() != 8) {
            ++strangers_;
            return;
        }
        const auto ns = static_cast<std::int64_t>(littleEndian(time.first(4)) * 1'000'000'000 + littleEndian(time.subspan(4)));
        bag_.messages.push_back({static_cast<std::uint32_t>(littleEndian(fieldOf(header, "conn"))), ns, data});
    }

    /// Puts topics in the place of connections. A connection in a damaged chunk comes again at the end of the bag, behind its messages.
    void nameTopics() {
        std::size_t held = 0;
        for (RosBagMessage& message : bag_.messages) {
            const auto topic = topics_.find(message.topic);
            if (topic == topics_.end()) continue;
            bag_.messages[held++] = {topic->second, message.logNs, message.bytes};
        }
        strangers_ += bag_.messages.size() - held;
        bag_.messages.resize(held);
    }

    void chunk(ByteView header, ByteView data) {
        const std::string compression(textOf(fieldOf(header, "compression")));
        if (compression == "none") {
            if (records(data, false) < data.size()) bad("its records do not end with it");
            return;
        }
        const auto unpacked = unpackedInto(bag_, compression, data, littleEndian(fieldOf(header, "size")), where_, goOn_);
        if (!unpacked) return bad(unpacked.error().what);
        if (records(*unpacked, false) < unpacked->size()) bad("its records do not end with it");
    }

    /// The records at the front of a chunk that was cut off.
    void salvage(ByteView header, ByteView data) {
        if (textOf(fieldOf(header, "compression")) == "none") records(data, false);
    }

    void bad(const std::string& why) {
        if (badChunks_++ == 0) whyBad_ = why;
    }

    ByteView bytes_;
    const std::string& where_;
    const std::function<bool()>& goOn_;
    RosBag bag_;
    std::map<std::uint32_t, std::uint32_t> topics_; // connection -> topic
    std::size_t badChunks_ = 0, strangers_ = 0;
    std::string whyBad_;
};

} // namespace

bool looksLikeRosBag(ByteView bytes) { return textOf(bytes).starts_with(kAnyMagic); }

Result<RosBag> readRosBag(ByteView bytes, const std::string& where, const std::function<bool()>& goOn) {
    if (!textOf(bytes).starts_with(kMagic))
        return Error{"it is a ROS bag of another version than 2.0", where, "convert it with \"rosbag migrate\""};
    return BagReader(bytes, where, goOn).read();
}

} // namespace edgescan::robots
