// A placement as JSON, exact to the last bit: it stands in the description of a saved scan and in provenance.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace edgescan {

[[nodiscard]] nlohmann::ordered_json placementToJson(const Placement& placement);

/// Error: a key is missing or unknown, a rotation is none, there are neither one pose nor `lines` of them.
Result<std::shared_ptr<const Placement>> placementFromJson(const nlohmann::json& object, std::uint64_t lines, const std::string& where);

} // namespace edgescan
