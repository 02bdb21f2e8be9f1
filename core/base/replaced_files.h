// The files that had content before this program wrote to them.
#pragma once

#include <filesystem>

namespace edgescan {

/// Call before `target` gets its new content.
void noteWriting(const std::filesystem::path& target);

/// True once of a file that this program replaced: who asks says it.
[[nodiscard]] bool popReplaced(const std::filesystem::path& path);

} // namespace edgescan
