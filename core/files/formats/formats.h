// The table of formats.
#pragma once

#include "core/files/formats/format.h"

#include <span>

namespace edgescan::files {

/// All formats, as dialogs list them.
[[nodiscard]] std::span<const Format> formats();

/// The format of a file's content: what no other row recognises is a list of points, or is refused by its reader.
[[nodiscard]] const Format& formatOfContent(const Source& source);

/// The format that a file of this name is written in; null when the extension names none.
[[nodiscard]] const Format* writtenFormat(const std::filesystem::path& path);

/// ".pcd, .ply or .csv": the usual extensions of what can be written; of clouds only, or of whole scans too.
[[nodiscard]] std::string writtenExtensions(bool wholeScans);

} // namespace edgescan::files
