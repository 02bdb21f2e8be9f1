// The table of columns: a new column is a row here, and also a row of kWritingChoices if it is written on request only.
#include "core/exports/cell_columns.h"

#include "core/edges/rock_borders/rock_borders.h"
#include "core/edges/tuning/confidence.h"
#include "core/files/point_tables/source.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/gap_filling/gap_filling.h"

#include <algorithm>
#include <limits>

namespace edgescan::exports {
namespace {

namespace fs = std::filesystem;

Result<files::CellValues> rockOfCells(const edges::Detection& /*detection*/, const fs::path& /*path*/, const ExportOptions& options) {
    return files::CellValues(rocks::rockLabels(*options.rocks->segmentation, options.rocks->map));
}

/// Filled cells are written only to files that can mark them.
Result<files::CellValues> filledSdMm(const edges::Detection& detection, const fs::path& path, const ExportOptions& /*options*/) {
    if (detection.filled) return files::CellValues(withFilled(*detection.scan, *detection.filled).sdMm);
    return Error{"no gap was filled that could be written", path.string(), "give --fill and how many cells, or leave --with-filled out"};
}

Result<files::CellValues> confidencePercent(const edges::Detection& detection, const fs::path& /*path*/, const ExportOptions& /*options*/) {
    return files::CellValues(std::move(edges::edgeConfidence(detection)->percent)); // nothing cancels it
}

Result<files::CellValues> borderPercent(const edges::Detection& detection, const fs::path& path, const ExportOptions& /*options*/) {
    if (!detection.borders)
        return Error{"this method does not distinguish borders of rocks", path.string(), "use EdgeScan+, or leave --with-borders out"};
    Grid<float> percent(detection.mask->lines, detection.mask->beams, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t n = 0; n < detection.edges->size(); ++n) {
        const edges::BorderPercent border = (*detection.borders)[n];
        if (border != edges::kUnknownBorder) percent[(*detection.edges)[n]] = border;
    }
    return files::CellValues(std::move(percent));
}

struct ColumnRow {
    const char* name;                    ///< of the field
    const char* what;                    ///< in errors
    bool files::WritingChoices::*choice; ///< null: of all clouds of rocks
    Result<files::CellValues> (*values)(const edges::Detection& detection, const fs::path& path, const ExportOptions& options);
};
constexpr ColumnRow kColumns[]{
    {"rock", nullptr, nullptr, rockOfCells},
    {"filled_sd_mm", "the mark of filled cells", &files::WritingChoices::filled, filledSdMm},
    {"confidence", "a field of confidence", &files::WritingChoices::confidence, confidencePercent},
    {"border", "a field of borders of rocks", &files::WritingChoices::borders, borderPercent},
};

/// Whether the file names its fields, so that it can hold any of them.
bool hasNamedFields(const fs::path& path) {
    const std::string extension = files::Source::lowerCase(path.extension());
    return path == "-" || extension == ".pcd" || extension == ".ply" || extension == ".csv";
}

Error noRoom(const ColumnRow& row, const fs::path& path) {
    const auto* choice = std::ranges::find(files::kWritingChoices, row.choice, &files::WritingChoice::member);
    return {"this format has no room for " + std::string(row.what), path.string(),
            "choose .pcd, .ply or .csv, or leave --" + std::string(choice->key) + " out"};
}

} // namespace

Result<std::vector<files::CellColumn>> cellColumns(const ExportKind& kind, const edges::Detection& detection, const fs::path& path,
                                                   const ExportOptions& options) {
    std::vector<files::CellColumn> columns;
    if (kind.holds != ExportKind::Holds::Points) return columns;
    for (const ColumnRow& row : kColumns) {
        if (row.choice == nullptr ? kind.needs != ExportKind::Needs::Rocks : !(options.choices.*row.choice)) continue;
        if (row.choice != nullptr && !hasNamedFields(path)) return noRoom(row, path);
        auto values = row.values(detection, path, options);
        if (!values) return values.error();
        columns.push_back({row.name, std::move(*values)});
    }
    return columns;
}

} // namespace edgescan::exports
