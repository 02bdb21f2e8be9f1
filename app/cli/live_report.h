// What a live scanner or a recording sent, as JSON: where every telegram went, and what was not as it should be.
#pragma once

#include "core/scanner/sweep_assembly/irregularities.h"

#include <nlohmann/json.hpp>

namespace edgescan::cli {

/// {"counter_jumps": n, ...}: the kinds that occurred.
[[nodiscard]] nlohmann::ordered_json irregularReport(const Irregularities& irregular);

/// {"received": n, "placed": n, "duplicates": n, "unusable": n, "lost": n, "accounted_for": true}
[[nodiscard]] nlohmann::ordered_json accountReport(const TelegramAccount& account);

} // namespace edgescan::cli
