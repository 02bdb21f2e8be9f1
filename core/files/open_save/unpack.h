// The bytes of a file without its packing.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/source.h"

#include <memory>
#include <vector>

namespace edgescan::files {

/// A source, and the memory of its bytes where they were packed.
struct UnpackedSource {
    Source source;
    std::shared_ptr<const std::vector<std::byte>> bytes; ///< null where the file was not packed

    /// An error about a place in these bytes: such a place is marked "(unpacked)".
    [[nodiscard]] Error refused(const Error& error) const;
};

/// Recognises gzip and zstd by content. Error: damaged, too large for the memory, cancelled, or nothing is in it.
Result<UnpackedSource> unpack(const Source& packed);

} // namespace edgescan::files
