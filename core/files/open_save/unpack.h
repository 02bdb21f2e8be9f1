// The bytes of a file without its packing.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/source.h"

#include <memory>
#include <vector>

namespace edgescan::files {

/// A source, and the memory of its bytes where they are not those of the file.
struct UnpackedSource {
    Source source;
    std::shared_ptr<const std::vector<std::byte>> bytes; ///< null where they are those of the file
    bool packed = false;
    std::vector<std::string> warnings{}; ///< what was done to a text (plain_text.h)

    /// An error about a place in bytes that were packed: such a place is marked "(unpacked)".
    [[nodiscard]] Error refused(const Error& error) const;
};

/// Recognises gzip and zstd by content, and brings text to the form that all readers expect. Error: damaged, too large for the memory,
/// cancelled, or nothing is in it.
Result<UnpackedSource> unpack(const Source& packed);

} // namespace edgescan::files
