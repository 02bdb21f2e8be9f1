// A placement as JSON, exact to the last bit. It is part of the description of a saved scan and of provenance records.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace edgescan {

[[nodiscard]] nlohmann::ordered_json placementToJson(const Placement& placement);

/// Error: a key is missing or unknown, a matrix is not a rotation, or there is neither one pose nor one per line.
Result<std::shared_ptr<const Placement>> placementFromJson(const nlohmann::json& object, std::uint64_t lines, const std::string& where);

} // namespace edgescan
