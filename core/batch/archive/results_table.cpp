// Writes rows as NDJSON and CSV.
#include "core/batch/archive/results_table.h"

#include "core/base/bounded_json.h"
#include "core/base/csv_text.h"
#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <array>

namespace edgescan::batch {
namespace {

using Json = nlohmann::ordered_json;

struct Column {
    const char* name;
    const char* pointer; ///< JSON pointer into a row
};

constexpr std::array kColumns{Column{"input", "/input"},
                              Column{"outcome", "/outcome"},
                              Column{"results", "/results"},
                              Column{"format", "/format"},
                              Column{"bytes", "/bytes"},
                              Column{"sha256", "/sha256"},
                              Column{"settings_sha256", "/settings_sha256"},
                              Column{"program", "/program"},
                              Column{"method", "/method"},
                              Column{"scanned_utc", "/scanned_utc"},
                              Column{"serial", "/serial"},
                              Column{"frame", "/frame"},
                              Column{"lines", "/lines"},
                              Column{"beams", "/beams"},
                              Column{"valid", "/cells/valid"},
                              Column{"no_return", "/cells/no_return"},
                              Column{"status", "/cells/status"},
                              Column{"out_of_window", "/cells/out_of_window"},
                              Column{"masked", "/cells/masked"},
                              Column{"lost", "/cells/lost"},
                              Column{"range_min_mm", "/range_mm/min"},
                              Column{"range_max_mm", "/range_mm/max"},
                              Column{"noise_mm_at_5_m", "/noise_mm_at_5_m"},
                              Column{"edges", "/edges"},
                              Column{"jump", "/classes/jump"},
                              Column{"convex", "/classes/convex"},
                              Column{"concave", "/classes/concave"},
                              Column{"border", "/classes/border"},
                              Column{"silhouette", "/classes/silhouette"},
                              Column{"rim", "/classes/rim"},
                              Column{"edge_mask_sha256", "/edge_mask_sha256"},
                              Column{"rocks", "/rocks/rock_count"},
                              Column{"rocks_visible_wide_p20_m", "/rocks/size_curve/visible_wide_p20_m"},
                              Column{"rocks_visible_wide_p50_m", "/rocks/size_curve/visible_wide_p50_m"},
                              Column{"rocks_visible_wide_p80_m", "/rocks/size_curve/visible_wide_p80_m"},
                              Column{"rocks_visible_wide_top_m", "/rocks/size_curve/visible_wide_top_m"},
                              Column{"rocks_oversize_share", "/rocks/size_curve/oversize_share"},
                              Column{"rocks_fines_m2", "/rocks/fines/visible_area_m2"},
                              Column{"rock_labels_sha256", "/rocks/labels_sha256"},
                              Column{"warnings", "/warnings"},
                              Column{"error", "/error"},
                              Column{"time_load_ms", "/times/load_ms"},
                              Column{"time_detect_ms", "/times/detect_ms"},
                              Column{"time_rocks_ms", "/times/rocks_ms"},
                              Column{"time_total_ms", "/times/total_ms"},
                              Column{"time_cpu_ms", "/times/cpu_ms"},
                              Column{"time_finished_utc", "/times/finished_utc"}};

std::string cell(const Json& value) {
    if (value.is_null()) return {};
    if (value.is_string()) return csvCell(value.get<std::string>());
    if (!value.is_array()) return jsonText(value);
    std::string all;
    for (const Json& one : value) all += (all.empty() ? "" : " | ") + (one.is_string() ? one.get<std::string>() : jsonText(one));
    return csvCell(all);
}

} // namespace

std::string ndjsonTable(const std::vector<std::string>& rows) {
    std::string table;
    for (const std::string& text : rows) {
        auto row = parseOrderedJson(text, "");
        if (!row) continue; // never here: the journal's reader parsed the same line before
        row->erase("picture");
        table += jsonText(*row) + "\n";
    }
    return table;
}

std::string csvTable(const std::vector<std::string>& rows) {
    std::string table;
    for (const Column& column : kColumns) table += (table.empty() ? "" : ",") + std::string(column.name);
    table += "\r\n";
    for (const std::string& text : rows) {
        const auto row = parseOrderedJson(text, "");
        if (!row) continue;
        std::string line;
        for (const Column& column : kColumns) {
            const Json::json_pointer pointer(column.pointer);
            line += (&column == kColumns.data() ? "" : ",") + (row->contains(pointer) ? cell(row->at(pointer)) : std::string());
        }
        table += line + "\r\n";
    }
    return table;
}

} // namespace edgescan::batch
