// Compressed chunks of recordings and bags: zstd, lz4 frames, bz2.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace edgescan::containers {

/// `compression` as in the chunk: "zstd", "lz4" (frame format) or "bz2". Allocates as bytes come out, never on the promise alone and never
/// more than `size`. `goOn` is called many times a second; false cancels. Error: damaged, another size than promised, cancelled, or this
/// build cannot read it.
Result<Bytes> unpackChunk(const std::string& compression, ByteView packed, std::uint64_t size, const std::string& where,
                          const std::function<bool()>& goOn = {});

[[nodiscard]] bool isZstd(ByteView packed);
/// The size that a zstd frame promises; empty: it does not say, or this build cannot read zstd.
[[nodiscard]] std::optional<std::uint64_t> zstdSize(ByteView packed);

} // namespace edgescan::containers
