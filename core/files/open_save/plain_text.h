// Text as all readers expect it: bytes of UTF-8 that begin with the first letter and end with the last row.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/source.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// A text that was written in another way.
struct PlainText {
    std::vector<std::byte> converted;  ///< the text as UTF-8; empty where a part of the bytes of the file is the text
    std::span<const std::byte> bytes;  ///< the text: `converted`, or a part of the file
    std::vector<std::string> warnings; ///< sentences about what was done
};

/// Leaves out a mark of byte order before the text and zeros behind its last row; converts UTF-16, with or without such a mark, and line
/// ends of a CR alone. Empty: nothing is to be done, as for all that is not text. Error: not enough memory.
[[nodiscard]] Result<std::optional<PlainText>> plainText(const Source& source);

} // namespace edgescan::files
