// Addresses of files as desktops and browsers write them.
#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// The path of "file:///home/a%20b.pcd"; any other text as it is. Error: a file of another computer, a path that is not
/// absolute, or a % without two digits behind it.
Result<std::string> pathOfAddress(std::string_view text);

/// What to do about "https://host/a.pcd" and "sftp://host/a.pcd", given as the path of a file. Empty for any other text.
std::optional<Error> addressElsewhere(std::string_view text);

} // namespace edgescan
