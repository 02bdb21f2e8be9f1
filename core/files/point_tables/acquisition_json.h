// Who measured a scan and when, as JSON, for the description of a saved scan.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/acquisition.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>

namespace edgescan::files {

/// Only what is known; without the times of the lines.
[[nodiscard]] nlohmann::ordered_json acquisitionToJson(const Acquisition& acquisition);

/// Error: an unknown key, or no text where text is needed. `where` goes into it.
Result<std::shared_ptr<const Acquisition>> acquisitionFromJson(const nlohmann::json& object, const std::string& where);

} // namespace edgescan::files
