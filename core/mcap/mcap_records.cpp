// Little-endian bytes.
#include "core/mcap/mcap_records.h"

#include <cstring>

namespace edgescan {

void McapBytes::append(std::uint64_t v, unsigned count) {
    for (unsigned i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(v >> (8 * i)));
}

void McapBytes::put(const void* from, std::size_t count) {
    if (count == 0) return;
    const std::size_t start = bytes_.size();
    bytes_.resize(start + count);
    std::memcpy(bytes_.data() + start, from, count);
}

} // namespace edgescan
