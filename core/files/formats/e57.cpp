// E57: scans as lists of points or as grids by row and column, with the pose of each.
#include "core/base/angles.h"
#include "core/base/bytes_behind.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/containers/e57/columns.h"
#include "core/files/formats/format.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace edgescan::files {
namespace {

const Eigen::Vector3d kNoPoint = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

/// Which columns of a scan are read.
struct E57Columns {
    std::array<std::size_t, 3> place{}; ///< x y z, or range, azimuth, elevation
    bool spherical = false;
    std::optional<std::size_t> invalid, row, column, intensity, returnIndex;

    [[nodiscard]] std::vector<std::size_t> all() const {
        std::vector<std::size_t> list(place.begin(), place.end());
        for (const auto& more : {invalid, row, column, intensity, returnIndex}) {
            if (more) list.push_back(*more);
        }
        return list;
    }
};

std::optional<std::size_t> wholeField(const containers::E57Scan& scan, const char* name) {
    const auto field = scan.field(name);
    return field && scan.fields[*field].kind == containers::E57Field::Kind::Integer ? field : std::nullopt;
}

std::optional<E57Columns> columnsOf(const containers::E57Scan& scan) {
    struct Names {
        std::array<const char*, 3> place;
        const char* invalid;
    };
    static constexpr std::array<Names, 2> kNames{{
        {{"cartesianX", "cartesianY", "cartesianZ"}, "cartesianInvalidState"},
        {{"sphericalRange", "sphericalAzimuth", "sphericalElevation"}, "sphericalInvalidState"},
    }};
    for (const Names& names : kNames) {
        std::array<std::optional<std::size_t>, 3> found;
        for (std::size_t i = 0; i < 3; ++i) found[i] = scan.field(names.place[i]);
        if (!std::ranges::all_of(found, [](const auto& column) { return column.has_value(); })) continue;
        E57Columns columns;
        columns.place = {*found[0], *found[1], *found[2]};
        columns.spherical = &names == &kNames[1];
        columns.invalid = scan.field(names.invalid);
        columns.row = wholeField(scan, "rowIndex");
        columns.column = wholeField(scan, "columnIndex");
        columns.intensity = scan.field("intensity");
        columns.returnIndex = scan.field("returnIndex");
        if (!columns.row || !columns.column) columns.row = columns.column = std::nullopt;
        return columns;
    }
    return std::nullopt;
}

std::string fieldNames(const containers::E57Scan& scan, const E57Columns* read) {
    const std::vector<std::size_t> known = read != nullptr ? read->all() : std::vector<std::size_t>{};
    std::string names;
    for (std::size_t i = 0; i < scan.fields.size(); ++i) {
        if (std::ranges::find(known, i) == known.end()) names += (names.empty() ? "" : ", ") + scan.fields[i].name;
    }
    return names;
}

/// How exactly x y z are written. What angles are written with grows with the range.
Precision precisionOf(const containers::E57Scan& scan, const E57Columns& columns) {
    constexpr double kLargestAngle = 3.15;
    Precision precision{0.0, kFloatError};
    for (std::size_t i = 0; i < 3; ++i) {
        const containers::E57Field& field = scan.fields[columns.place[i]];
        const bool angle = columns.spherical && i > 0;
        double& shared = angle ? precision.relative : precision.absolute;
        shared = std::max(shared, field.absoluteError());
        precision.relative = std::max(precision.relative, field.relativeError() * (angle ? 2 * kLargestAngle : 2.0));
    }
    return precision;
}

/// The numbers of a scan's points, one list per column.
struct E57Numbers {
    std::vector<std::vector<double>> lists;
    std::vector<double>*invalid = nullptr, *row = nullptr, *column = nullptr, *intensity = nullptr, *returnIndex = nullptr;
};

Result<E57Numbers> numbersOf(containers::E57File& file, const containers::E57Scan& scan, const E57Columns& columns, const Source& source) {
    auto lists =
        containers::readE57Columns(file, scan, columns.all(), [&](double done) { return source.goOn("reading points", 0.4 * done); });
    if (!lists) return lists.error();
    E57Numbers numbers;
    numbers.lists = std::move(*lists);
    std::size_t next = 3;
    if (columns.invalid) numbers.invalid = &numbers.lists[next++];
    if (columns.row) numbers.row = &numbers.lists[next++];
    if (columns.column) numbers.column = &numbers.lists[next++];
    if (columns.intensity) numbers.intensity = &numbers.lists[next++];
    if (columns.returnIndex) numbers.returnIndex = &numbers.lists[next++];
    return numbers;
}

/// Points that were not measured.
struct Unmeasured {
    std::size_t invalid = 0, negative = 0; ///< marked as invalid; with a range below 0
};

/// Some programs write degrees where the standard has radians: no elevation in radians is so large.
bool areDegrees(const E57Numbers& numbers) {
    constexpr double kMostRad = 1.6, kMostDeg = 90.5;
    double most = 0;
    for (std::size_t n = 0; n < numbers.lists[2].size(); ++n) {
        const bool measured = numbers.lists[0][n] > 0 && (numbers.invalid == nullptr || (*numbers.invalid)[n] == 0.0);
        if (measured && std::isfinite(numbers.lists[2][n])) most = std::max(most, std::abs(numbers.lists[2][n]));
    }
    return most > kMostRad && most <= kMostDeg;
}

/// x y z of each point, not finite where it was not measured. Counts these.
std::vector<Eigen::Vector3d> pointsOf(const E57Numbers& numbers, bool spherical, bool inDegrees, Unmeasured& unmeasured) {
    const auto& [a, b, c] = std::tie(numbers.lists[0], numbers.lists[1], numbers.lists[2]);
    const double unitRad = inDegrees ? radians(1.0) : 1.0;
    std::vector<Eigen::Vector3d> points(a.size());
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (numbers.invalid != nullptr && (*numbers.invalid)[n] != 0.0) { // 1: a direction only, 2: nothing
            points[n] = kNoPoint;
            ++unmeasured.invalid;
            continue;
        }
        points[n] = {a[n], b[n], c[n]};
        if (!spherical) continue;
        if (a[n] < 0) {
            points[n] = kNoPoint;
            ++unmeasured.negative;
            continue;
        }
        const double azimuth = b[n] * unitRad, elevation = c[n] * unitRad, flat = a[n] * std::cos(elevation);
        points[n] = {flat * std::cos(azimuth), flat * std::sin(azimuth), a[n] * std::sin(elevation)};
    }
    return points;
}

/// Rows and columns of a grid that the file itself gives.
struct E57Grid {
    std::int64_t firstLine = 0, firstBeam = 0;
    std::uint64_t lines = 0, beams = 0;
};

struct IndexExtent {
    double least = 0.0, most = 0.0;
};
IndexExtent extentOf(const std::vector<double>& numbers) {
    const auto [least, most] = std::ranges::minmax(numbers);
    return {least, most};
}

/// The cells of the points: empty when the indexes do not make a grid, or one that is nearly all holes.
std::optional<E57Grid> gridOf(const containers::E57Scan& scan, const E57Numbers& numbers, bool linesAreRows, std::uint64_t fileBytes) {
    constexpr double kMostAlongOneSide = 1U << 30U;
    constexpr std::uint64_t kCellsPerByte = 4, kCellsAnyway = 500'000;
    if (numbers.row == nullptr || numbers.row->empty()) return std::nullopt;
    const auto within = [](IndexExtent indexes, std::int64_t first, std::int64_t last) {
        return static_cast<double>(first) <= indexes.least && static_cast<double>(last) >= indexes.most
                   ? IndexExtent{static_cast<double>(first), static_cast<double>(last)}
                   : indexes;
    };
    IndexExtent rows = extentOf(*numbers.row);
    IndexExtent columns = extentOf(*numbers.column);
    if (scan.bounds) { // rows and columns at the rim may hold no point
        rows = within(rows, scan.bounds->firstRow, scan.bounds->lastRow);
        columns = within(columns, scan.bounds->firstColumn, scan.bounds->lastColumn);
    }
    const IndexExtent& lines = linesAreRows ? rows : columns;
    const IndexExtent& beams = linesAreRows ? columns : rows;
    if (!(lines.most - lines.least < kMostAlongOneSide) || !(beams.most - beams.least < kMostAlongOneSide)) return std::nullopt;
    if (!(std::abs(lines.least) < 1e15) || !(std::abs(beams.least) < 1e15)) return std::nullopt;
    const E57Grid grid{static_cast<std::int64_t>(lines.least), static_cast<std::int64_t>(beams.least),
                       static_cast<std::uint64_t>(lines.most - lines.least) + 1, static_cast<std::uint64_t>(beams.most - beams.least) + 1};
    const bool reasonable = grid.lines * grid.beams <= kCellsPerByte * fileBytes + kCellsAnyway;
    if (!reasonable || grid.lines < 2 || grid.beams < 2) return std::nullopt;
    return grid;
}

bool hasRange(const Eigen::Vector3d& p) { return p.allFinite() && !p.isZero(0.0); }

/// The points in their cells. Where several share one the nearest stays.
void spread(PointTable& table, const E57Grid& grid, const E57Numbers& numbers, bool linesAreRows) {
    std::vector<Eigen::Vector3d> cells(grid.lines * grid.beams, kNoPoint);
    std::vector<float> intensities(table.intensity.empty() ? 0 : cells.size(), std::numeric_limits<float>::quiet_NaN());
    const std::vector<double>& line = linesAreRows ? *numbers.row : *numbers.column;
    const std::vector<double>& beam = linesAreRows ? *numbers.column : *numbers.row;
    std::size_t behind = 0;
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!hasRange(table.points[n])) continue;
        const auto i = static_cast<std::uint64_t>(static_cast<std::int64_t>(line[n]) - grid.firstLine);
        const auto j = static_cast<std::uint64_t>(static_cast<std::int64_t>(beam[n]) - grid.firstBeam);
        const std::uint64_t k = i * grid.beams + j;
        Eigen::Vector3d& cell = cells[k];
        const bool taken = hasRange(cell);
        behind += taken ? 1 : 0;
        if (taken && table.points[n].squaredNorm() >= cell.squaredNorm()) continue;
        cell = table.points[n];
        if (!intensities.empty()) intensities[k] = table.intensity[n];
    }
    table.intensity = std::move(intensities);
    table.points = std::move(cells);
    table.width = grid.beams;
    table.height = grid.lines;
    table.gridIsGiven = true;
    if (behind > 0) {
        table.remarks.push_back(
            counted(behind, "point shares its row and column with a nearer one, which was taken (several returns of one beam).",
                    "points share their row and column with a nearer one, which was taken (several returns of one beam)."));
    }
}

/// The scan that the options ask for, its columns and its points in their own frame.
struct E57Choice {
    containers::E57Scan scan;
    PointTable table;
    std::size_t index = 0; ///< of the scan in the file
};

/// Where the options name no scan: the first one from `from` on that holds points.
Result<E57Choice> chosenScan(const containers::E57File& file, const Source& source, std::size_t from) {
    const auto withPoints = std::find_if(file.scans.begin() + static_cast<std::ptrdiff_t>(from), file.scans.end(),
                                         [](const containers::E57Scan& scan) { return scan.points > 0; });
    const auto first = withPoints == file.scans.end() ? from : static_cast<std::size_t>(withPoints - file.scans.begin());
    const std::size_t wanted = source.options->scanIndex.value_or(first);
    if (file.scans.empty()) {
        return source.refused(file.pictures > 0 ? withValues("this E57 file holds no scan, only %1", {counted(file.pictures, "picture")})
                                                : "this E57 file holds no scan",
                              "choose another file");
    }
    if (wanted >= file.scans.size()) return noSuchScan(wanted, file.scans.size());
    E57Choice choice{file.scans[wanted], {}, wanted};
    if (file.scans.size() > 1) {
        choice.table.remarks.push_back(
            withValues("The file holds %1 scans; this is number %2, --scan chooses another.", {file.scans.size(), wanted + 1}));
    }
    if (!source.options->scanIndex && wanted > 0)
        choice.table.remarks.push_back(withValues("The first %1 of these scans hold no point with a return.", {wanted}));
    return choice;
}

/// Puts the points of a scan onto the grid of the file's own indexes, where they make one.
Result<Done> applyGrid(PointTable& table, const containers::E57Scan& scan, const E57Numbers& numbers, const Source& source) {
    if (numbers.row == nullptr) return Done{};
    const bool linesAreRows = scan.lineIndex == "rowIndex";
    const auto grid = gridOf(scan, numbers, linesAreRows, source.bytes.size());
    if (!grid) {
        table.remarks.emplace_back("The rows and columns that the file gives its points make no grid and were not used.");
        return Done{};
    }
    if (auto enough = checkMemory(grid->lines * grid->beams * sizeof(Eigen::Vector3d), source.path.string()); !enough) return enough;
    spread(table, *grid, numbers, linesAreRows);
    table.mayBeTurned = true; // also where the file says it: some say the other index
    if (scan.lineIndex.empty()) {
        table.remarks.emplace_back(
            "The file does not say which way the scan lines run: its columns were taken as lines, its rows as beams.");
    }
    return Done{};
}

Result<E57Choice> readChoice(containers::E57File& file, const Source& source, std::size_t from) {
    auto choice = chosenScan(file, source, from);
    if (!choice) return choice;
    containers::E57Scan& scan = choice->scan;
    PointTable& table = choice->table;
    const std::string which = withValues("scan %1 of this E57 file", {choice->index + 1});
    if (scan.points == 0) return source.refused(withValues("%1 holds no points", {which}), "choose another scan or file");
    const auto columns = columnsOf(scan);
    if (!columns) {
        return source.refused(withValues("%1 has neither cartesian nor spherical coordinates, only %2", {which, fieldNames(scan, nullptr)}),
                              "export it with coordinates");
    }
    auto numbers = numbersOf(file, scan, *columns, source);
    if (!numbers) return numbers.error();
    Unmeasured unmeasured;
    const bool inDegrees = columns->spherical && areDegrees(*numbers);
    table.format = "E57";
    table.unitMm = 1000.0;
    table.precision = precisionOf(scan, *columns);
    table.points = pointsOf(*numbers, columns->spherical, inDegrees, unmeasured);
    table.width = table.points.size();
    if (numbers->intensity != nullptr) table.intensity.assign(numbers->intensity->begin(), numbers->intensity->end());
    if (auto taken = applyGrid(table, scan, *numbers, source); !taken) return taken.error();
    if (numbers->returnIndex != nullptr && !table.gridIsGiven) {
        for (const double index : *numbers->returnIndex) // from 0 in the standard, from 1 in some files
            table.returnNumber.push_back(index >= 0 && index < 255 ? static_cast<std::uint8_t>(index) : std::uint8_t{1});
    }
    if (inDegrees)
        table.remarks.emplace_back("The angles of the points were taken as degrees, because no elevation in radians is so large.");
    if (unmeasured.negative > 0)
        table.remarks.push_back(counted(unmeasured.negative, "point has a range below 0 and counts as no return.",
                                        "points have a range below 0 and count as no return."));
    if (unmeasured.invalid > 0)
        table.remarks.push_back(counted(unmeasured.invalid, "point is marked as invalid in the file and counts as no return.",
                                        "points are marked as invalid in the file and count as no return."));
    if (const std::string unread = fieldNames(scan, &*columns); !unread.empty())
        table.remarks.push_back(withValues("What else a point of this file has is not read: %1.", {unread}));
    if (file.pictures > 0) table.remarks.push_back(withValues("The pictures of this file (%1) are not read.", {file.pictures}));
    if (auto behind = bytesBehind(file.rest, "the end that the header gives")) table.remarks.push_back(std::move(*behind));
    if (scan.poseIsNone)
        table.remarks.emplace_back("The pose in the file is not a rotation and shift, so the scan stays in the scanner's frame.");
    return choice;
}

/// The scan that the options ask for, else the first one with a return.
Result<E57Choice> firstWithReturn(const Source& source) {
    constexpr int kMostTried = 16; // several scans of a hostile file may share their points
    auto file = containers::openE57(source.bytes, source.path.string());
    if (!file) return file.error();
    auto first = readChoice(*file, source, 0);
    // No point has a range, or all have the same place: a value for "nothing".
    const auto isEmpty = [](const Result<E57Choice>& choice) {
        if (!choice) return false;
        const auto& points = choice->table.points;
        const auto one = std::ranges::find_if(points, hasRange);
        return std::ranges::none_of(points, [&](const Eigen::Vector3d& p) { return hasRange(p) && p != *one; });
    };
    if (source.options->scanIndex || !isEmpty(first)) return first;
    std::size_t from = first->index + 1;
    for (int tried = 1; tried < kMostTried && from < file->scans.size(); ++tried) {
        auto next = readChoice(*file, source, from);
        if (!next) break;
        if (!isEmpty(next)) return next;
        from = next->index + 1;
    }
    return first;
}

bool looksLikeE57(const Source& source) { return source.text().starts_with(containers::kE57Magic); }

/// Null where the file names nothing.
std::shared_ptr<const Acquisition> sensorOf(const containers::E57Scan& e57) {
    if (e57.vendor.empty() && e57.model.empty() && e57.serial.empty()) return nullptr;
    auto acquisition = std::make_shared<Acquisition>();
    acquisition->vendor = e57.vendor;
    acquisition->model = e57.model;
    acquisition->serial = e57.serial;
    acquisition->firmware = e57.firmware;
    return acquisition;
}

/// The points of the scan that the options ask for, its pose and its names.
Result<Reading> readE57(const Source& source) {
    auto choice = firstWithReturn(source);
    if (!choice) return choice.error();
    const containers::E57Scan& e57 = choice->scan;
    Reading reading(std::move(choice->table));
    if (e57.pose) reading.place = WrittenPlace{"E57", e57.pose->rotation, e57.pose->translationM, false};
    reading.acquisition = sensorOf(e57);
    reading.note = e57.name + (e57.name.empty() || e57.description.empty() ? "" : ": ") + e57.description;
    return reading;
}

} // namespace

Format e57Format() { return {.title = "E57", .reads = {".e57"}, .recognises = looksLikeE57, .read = readE57, .options = {"scan"}}; }

} // namespace edgescan::files
