// Compressed parts of bags.
#include "core/base/memory.h"
#include "core/containers/compression/chunks.h"
#include "core/robots/bags/bag.h"

namespace edgescan::robots {
namespace {

constexpr std::uint64_t kAskFrom = 1 << 20; // of the machine's memory: less is always there

} // namespace

Result<ByteView> unpackedInto(RosBag& bag, const std::string& compression, ByteView packed, std::uint64_t size, const std::string& where,
                              const std::function<bool()>& goOn) {
    if (size > bag.mayUnpack) return Error{"it promises to unpack to more than a bag of this size holds", where, ""};
    if (size >= kAskFrom) {
        if (auto enough = checkMemory(size, where); !enough) return enough.error();
    }
    auto unpacked = containers::unpackChunk(compression, packed, size, where, goOn);
    if (!unpacked) return unpacked.error();
    bag.mayUnpack -= size;
    return ByteView(bag.unpacked.emplace_back(std::move(*unpacked)));
}

std::optional<ByteView> plainMessage(RosBag& bag, ByteView message, const std::string& where, const std::function<bool()>& goOn) {
    if (!containers::isZstd(message)) return message;
    const auto size = containers::zstdSize(message);
    const auto unpacked = size ? unpackedInto(bag, "zstd", message, *size, where, goOn) : Result<ByteView>(Error{"", where, ""});
    return unpacked ? std::optional(*unpacked) : std::nullopt;
}

} // namespace edgescan::robots
