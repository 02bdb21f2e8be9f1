// Why a cell is an edge or not, as JSON (docs/reference/command-line.md, "JSON of why").
#pragma once

#include "core/edges/explain/why.h"

#include <nlohmann/json_fwd.hpp>

namespace edgescan::exports {

[[nodiscard]] nlohmann::ordered_json whyReport(const edges::Detection& detection, const edges::Why& why);

} // namespace edgescan::exports
