// zlib, step by step.
#include "core/containers/compression/inflate.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace edgescan::containers {
namespace {

constexpr std::size_t kOffered = 1U << 20U; // packed bytes at a time

struct Inflater {
    z_stream stream{};
    bool ready = false;
    explicit Inflater(Packing packing) {
        constexpr int kLargestWindow = 15, kWithGzipHeader = 16;
        ready = inflateInit2(&stream, packing == Packing::Gzip ? kLargestWindow + kWithGzipHeader : -kLargestWindow) == Z_OK;
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() {
        if (ready) inflateEnd(&stream);
    }
};

Error tooMuch(std::uint64_t most, const std::string& where) {
    return {withValues("unpacked this is more than %1, far more than a scan of its size can be", {sizeText(most)}), where,
            "unpack it by hand and look at it"};
}

} // namespace

Result<std::size_t> inflateOne(std::span<const std::byte> packed, Packing packing, std::uint64_t most, std::vector<std::byte>& to,
                               const std::string& where, const std::function<bool(double)>& goOn) {
    Inflater inflater(packing);
    if (!inflater.ready) return Error{"there is not enough memory for this file", where, "close other programs or open a smaller file"};
    z_stream& stream = inflater.stream;
    std::size_t used = 0;
    std::array<std::byte, 65536> step; // not filled: an archive may hold many small streams
    for (int code = Z_OK; code != Z_STREAM_END;) {
        const std::size_t offered = std::min(kOffered, packed.size() - used);
        stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data() + used)); // read only
        stream.avail_in = static_cast<uInt>(offered);
        stream.next_out = reinterpret_cast<Bytef*>(step.data());
        stream.avail_out = static_cast<uInt>(step.size());
        code = inflate(&stream, Z_NO_FLUSH);
        used += offered - stream.avail_in;
        const std::size_t made = step.size() - stream.avail_out;
        if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) {
            return Error{
                withValues("the packed data are damaged%1", {stream.msg != nullptr ? " (" + std::string(stream.msg) + ")" : std::string()}),
                withValues("%1: byte %2", {where, used}), "copy the file again"};
        }
        if (to.size() + made > most) return tooMuch(most, where);
        if (to.size() + made > to.capacity()) {
            if (auto enough = checkMemory(2 * (to.size() + made), where); !enough) return enough.error();
        }
        to.insert(to.end(), step.begin(), step.begin() + static_cast<std::ptrdiff_t>(made));
        if (code != Z_STREAM_END && made == 0 && used == packed.size())
            return Error{"the packed data end too early", where, "copy the file again, it may be cut off"};
        if (!goOn(static_cast<double>(used) / static_cast<double>(packed.size()))) return Error{"cancelled", where, ""};
    }
    return used;
}

} // namespace edgescan::containers
