// Writes the account of telegrams as JSON.
#include "app/cli/live_report.h"

namespace edgescan::cli {

nlohmann::ordered_json irregularReport(const scanner::Irregularities& irregular) {
    auto report = nlohmann::ordered_json::object();
    for (int k = 0; k < scanner::kIrregularities; ++k) {
        const auto kind = static_cast<scanner::Irregularity>(k);
        if (irregular.count(kind) > 0) report[scanner::irregularityKey(kind)] = irregular.count(kind);
    }
    return report;
}

nlohmann::ordered_json accountReport(const scanner::TelegramAccount& account) {
    return {{"received", account.telegrams}, {"placed", account.placed}, {"duplicates", account.duplicates},
            {"unusable", account.unusable},  {"lost", account.lost},     {"accounted_for", account.addsUp()}};
}

} // namespace edgescan::cli
