// gzip: members one behind the other.
#include "core/containers/compression/gunzip.h"
#include "core/base/translated_text.h"

#include "core/base/checked_size.h"

#include <algorithm>

namespace edgescan::containers {

bool isGzip(std::span<const std::byte> bytes) { return bytes.size() >= 2 && bytes[0] == std::byte{0x1F} && bytes[1] == std::byte{0x8B}; }

Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes, const std::string& where, const std::function<bool(double)>& goOn) {
    std::vector<std::byte> unpacked;
    // What comes out may be text, of which a byte costs far more than one of a picture: little is let through anyway.
    constexpr std::uint64_t kAlways = 1U << 20U;
    const std::uint64_t most = sumOf({kAlways, mostUnpackedBytes(bytes.size()) - mostUnpackedBytes(0)});
    for (std::size_t at = 0; at < bytes.size();) {
        const auto rest = bytes.subspan(at);
        const bool padding = at > 0 && std::ranges::all_of(rest, [](std::byte byte) { return byte == std::byte{0}; });
        if (padding) break;
        if (!isGzip(rest))
            return Error{"other bytes follow the packed data", withValues("%1: byte %2", {where, at}), "copy the file again"};
        const auto used = inflateOne(rest, Packing::Gzip, most, unpacked, where, [&](double part) {
            return goOn((static_cast<double>(at) + part * static_cast<double>(rest.size())) / static_cast<double>(bytes.size()));
        });
        if (!used) return used.error();
        at += *used;
    }
    return unpacked;
}

} // namespace edgescan::containers
