// The data from a live scanner or a recording as JSON: what became of every telegram, and which irregularities occurred.
#pragma once

#include "core/scanner/sweep_assembly/irregularities.h"

#include <nlohmann/json.hpp>

namespace edgescan::cli {

/// {"counter_jumps": n, ...}: the kinds of irregularity that occurred.
[[nodiscard]] nlohmann::ordered_json irregularReport(const scanner::Irregularities& irregular);

/// {"received": n, "placed": n, "duplicates": n, "unusable": n, "lost": n, "accounted_for": true}
[[nodiscard]] nlohmann::ordered_json accountReport(const scanner::TelegramAccount& account);

} // namespace edgescan::cli
