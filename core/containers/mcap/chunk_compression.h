// Compressed MCAP chunks.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/records.h"

#include <string>

namespace edgescan::containers {

/// `compression` as in the chunk: "zstd" or "lz4" (frame format). Allocates as bytes come out, never on the promise alone and never
/// more than `size`. Error: damaged, another size than promised, or this build cannot read it.
Result<Bytes> unpackChunk(const std::string& compression, ByteView packed, std::uint64_t size, const std::string& where);

} // namespace edgescan::containers
