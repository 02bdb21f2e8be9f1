// What a person probably meant by a name that is not known.
#pragma once

#include <string>
#include <vector>

namespace edgescan {

/// The known name that was probably meant; empty if all differ much.
[[nodiscard]] std::string nearestName(const std::string& typed, const std::vector<std::string>& known);

} // namespace edgescan
