// PTX (Leica Cyclone): scans as full grids about their scanner, with the pose of each; columns are lines, rows are beams. The number of
// points that a header promises is compared with the text that is there before anything is allocated.

#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"

#include <Eigen/Dense>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr auto kMostAlongOneSide = static_cast<std::uint64_t>(physical::kAlongOneSide.limits.most);
constexpr float kNoIntensity = 0.5F;

struct PtxHeader {
    std::uint64_t columns = 0, rows = 0;
    Eigen::Vector3d stated = Eigen::Vector3d::Zero(); ///< the scanner's place by the third line
    bool byColumns = false;                           ///< the matrix was written with its rows as columns, and is turned back
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< the scanner's, by the matrix
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< the scanner's by lines 4 to 6, a row each
    std::size_t firstByte = 0;                          ///< of the points
    std::size_t firstLine = 0;                          ///< its number

    [[nodiscard]] std::uint64_t points() const { return productOf({columns, rows}); }
    /// Line 3 and the matrix name two places: no program prints them less exactly than a centimetre.
    [[nodiscard]] bool namesTwoPlaces() const {
        constexpr double kSamePlaceM = 0.01;
        return !stated.isZero(0.0) && (stated - place).norm() > kSamePlaceM;
    }
    /// Lines 4 to 6 and the matrix turn the scanner to two sides. Programs that do not fill them in write the axes as they are.
    [[nodiscard]] bool namesTwoTurns() const {
        constexpr double kSameTurn = 1e-3;
        return !axes.isIdentity(0.0) && !axes.isApprox(turn.transpose(), kSameTurn);
    }
};

std::optional<std::vector<double>> numbersIn(std::string_view line, std::size_t count) {
    std::vector<double> numbers;
    for (std::string_view word : wordsOf(line)) {
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (problem != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
        numbers.push_back(value);
    }
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

std::optional<std::uint64_t> countIn(std::string_view line) {
    const auto words = wordsOf(line);
    return words.size() == 1 ? wholeNumber(words[0]) : std::nullopt;
}

bool isBlankOrComment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos || line[first] == '#' || line.substr(first).starts_with("//");
}

/// The matrix of a header: rows of vectors, p' = p M. Where its last column holds the place that line 3 states and its last row none, it
/// was written the other way.
void readMatrix(PtxHeader& header, Eigen::Matrix4d matrix) {
    const Eigen::Vector3d lastColumn = matrix.col(3).head<3>();
    header.byColumns = matrix.row(3).head<3>().isZero(0.0) && !lastColumn.isZero(0.0);
    if (header.byColumns) matrix.transposeInPlace();
    header.turn = matrix.topLeftCorner<3, 3>().transpose();
    header.place = matrix.row(3).head<3>().transpose();
}

/// The header from `from` on, ten lines or nine where both counts are on one; blank lines and comments before it are passed over. Empty
/// where there is none.
std::optional<PtxHeader> headerAt(std::string_view text, std::size_t from, std::size_t lineNumber) {
    PtxHeader header;
    std::size_t at = from;
    const auto line = [&] {
        const TextLine next = textLineAt(text, at);
        at = next.next;
        ++lineNumber;
        return next.text;
    };
    std::string_view first = line();
    while (at < text.size() && isBlankOrComment(first)) first = line();
    const auto both = numbersIn(first, 2);
    const auto words = wordsOf(first);
    const auto columns = both ? wholeNumber(words[0]) : countIn(first);
    const auto rows = both ? wholeNumber(words[1]) : countIn(line());
    if (!columns || !rows) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) { // the place and the scanner's axes: the matrix says the same
        const auto three = numbersIn(line(), 3);
        if (!three) return std::nullopt;
        const Eigen::Vector3d row((*three)[0], (*three)[1], (*three)[2]);
        if (i == 0)
            header.stated = row;
        else
            header.axes.row(static_cast<Eigen::Index>(i) - 1) = row.transpose();
    }
    Eigen::Matrix4d matrix;
    for (Eigen::Index i = 0; i < 4; ++i) {
        const auto row = numbersIn(line(), 4);
        if (!row) return std::nullopt;
        for (Eigen::Index j = 0; j < 4; ++j) matrix(i, j) = (*row)[static_cast<std::size_t>(j)];
    }
    readMatrix(header, matrix);
    header.columns = *columns;
    header.rows = *rows;
    header.firstByte = at;
    header.firstLine = lineNumber;
    return header;
}

/// Where the line after `count` lines begins; empty when the text ends before.
std::optional<std::size_t> afterLines(std::string_view text, std::size_t at, std::uint64_t count) {
    for (; count > 0; --count) {
        if (at >= text.size()) return std::nullopt;
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) return count == 1 ? std::optional(text.size()) : std::nullopt;
        at = end + 1;
    }
    return at;
}

/// Some of these rows is not 0 0 0. Looks no further than the first such row.
bool holdsReturn(std::string_view rows) {
    for (std::size_t at = 0; at < rows.size();) {
        const TextLine line = textLineAt(rows, at);
        at = line.next;
        std::size_t numbers = 0;
        for (const std::string_view word : wordsOf(line.text)) {
            if (numbers++ == 3) break;
            if (word.find_first_of("123456789") != std::string_view::npos) return true;
        }
    }
    return false;
}

struct PtxScan {
    PtxHeader header;
    std::size_t endByte = 0;
    std::size_t index = 0;   ///< of the scan in the file
    std::size_t inFile = 0;  ///< scans that the file holds
    bool restIsNone = false; ///< what follows a later scan is not a scan
};

Error cutOff(const PtxHeader& header, std::size_t index, const Source& source) {
    return source.refused(withValues("scan %1 of this PTX file promises %2 of %3, and the file ends before them",
                                     {index + 1, counted(header.columns, "column"), counted(header.rows, "point")}),
                          "copy the file again");
}

Result<PtxScan> findScan(const Source& source) {
    const std::string_view text = source.text();
    std::size_t wanted = source.options->scanIndex.value_or(0);
    PtxScan found;
    PtxScan first; // with points, where there is one
    bool some = false;
    std::size_t at = 0;
    std::size_t lineNumber = 1;
    while (at < text.size()) {
        const auto header = headerAt(text, at, lineNumber);
        if (!header) {
            if (text.find_first_not_of(" \t\r\n", at) == std::string_view::npos) break;
            if (found.inFile > wanted + 1) { // what was asked for is whole
                found.restIsNone = true;
                break;
            }
            if (found.inFile == wanted + 1) {
                return source.refusedAtLine(lineNumber,
                                            withValues("behind the %1 of %2 that the header promises there are more",
                                                       {counted(found.header.columns, "column"), counted(found.header.rows, "point")}),
                                            "export the file again");
            }
            return source.refusedAtLine(lineNumber, withValues("scan %1 has no PTX header here", {found.inFile + 1}),
                                        "export the file again");
        }
        const std::uint64_t left = text.size() - header->firstByte;
        // A point takes four numbers with a blank or line end behind each.
        const bool isEmpty = header->columns == 0 && header->rows == 0;
        const bool isWrong = (header->points() == 0 && !isEmpty) || header->columns > kMostAlongOneSide ||
                             header->rows > kMostAlongOneSide || header->points() > left / 6 + 1;
        const auto end = isWrong ? std::nullopt : afterLines(text, header->firstByte, header->points());
        if (!end && found.inFile <= wanted) return cutOff(*header, found.inFile, source);
        const bool noReturn = end && !holdsReturn(text.substr(header->firstByte, *end - header->firstByte));
        if (!some && !isEmpty && end) first = {*header, *end, found.inFile, 0, false};
        some = some || (!isEmpty && end);
        if (noReturn && !source.options->scanIndex && found.inFile == wanted) ++wanted; // the first that has points
        if (found.inFile == wanted) {
            found.header = *header;
            found.endByte = *end;
        }
        ++found.inFile;
        if (!end) break;
        lineNumber = header->firstLine + static_cast<std::size_t>(header->points());
        at = *end;
        if (!source.goOn("reading points", 0.1 * static_cast<double>(at) / static_cast<double>(text.size()))) return source.cancelled();
    }
    if (found.inFile > wanted) {
        found.index = wanted;
        return found;
    }
    if (!source.options->scanIndex && some) { // no scan has a return: the first one says so
        found.header = first.header;
        found.endByte = first.endByte;
        found.index = first.index;
        return found;
    }
    if (!source.options->scanIndex && found.inFile > 0)
        return source.refused(found.inFile == 1 ? "the scan of this PTX file holds 0 points"
                                                : withValues("the %1 scans of this PTX file hold 0 points", {found.inFile}),
                              "export the file again");
    return noSuchScan(wanted, found.inFile);
}

Result<Done> readPoints(PointTable& table, const PtxHeader& header, const Source& source) {
    TextLayout layout;
    layout.firstByte = header.firstByte;
    layout.firstLine = header.firstLine;
    RowReader rows(source, layout);
    std::vector<double> row;
    table.points.reserve(header.points());
    while (rows.next(row)) {
        if (row.size() < 3)
            return source.refusedAtLine(rows.lineNumber(),
                                        withValues("holds %1 where a point needs three", {counted(row.size(), "number")}),
                                        "copy the file again");
        table.points.emplace_back(row[0], row[1], row[2]);
        table.intensity.push_back(row.size() > 3 ? static_cast<float>(row[3]) : kNoIntensity);
        if (table.points.size() % 16384 == 0 && !source.goOn("reading points", 0.1 + 0.4 * rows.fraction())) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    if (table.points.size() != header.points()) {
        return source.refused(
            withValues("the header promises %1 and the file holds %2", {counted(header.points(), "point"), table.points.size()}),
            "copy the file again");
    }
    table.precision = precisionOf(rows.digits());
    // Who writes PTX without intensities writes one half everywhere.
    if (std::ranges::all_of(table.intensity, [](float value) { return value == kNoIntensity; })) table.intensity.clear();
    return Done{};
}

bool looksLikePtx(const Source& source) {
    return !firstByteThatIsNoText(source.text()) && headerAt(source.text().substr(0, 8192), 0, 1).has_value();
}

/// The points of the scan that the options ask for, and its matrix.
Result<Reading> readPtx(const Source& source) {
    const auto found = findScan(source);
    if (!found) return found.error();
    const PtxHeader& header = found->header;
    if (auto enough = checkMemory(productOf({header.points(), sizeof(Eigen::Vector3d)}), source.path.string()); !enough)
        return enough.error();
    PointTable table;
    table.format = "PTX";
    table.unitMm = 1000.0;
    table.width = header.rows;
    table.height = header.columns;
    Source part = source;
    part.bytes = source.bytes.first(found->endByte);
    if (auto read = readPoints(table, header, part); !read) return read.error();
    if (found->inFile > 1) {
        table.remarks.push_back(
            withValues("The file holds %1 scans; this is number %2, --scan chooses another.", {found->inFile, found->index + 1}));
    }
    if (!source.options->scanIndex && found->index > 0)
        table.remarks.push_back(withValues("The first %1 of these scans hold no point with a return.", {found->index}));
    if (header.byColumns)
        table.remarks.emplace_back(
            "The matrix of the header has the scanner's place in its last column and not in its last row: it was read by columns.");
    if (header.namesTwoTurns())
        table.remarks.emplace_back("Lines 4 to 6 of the header turn the scanner to another side than its matrix: the matrix was used.");
    if (header.namesTwoPlaces())
        table.remarks.push_back(
            withValues("Line 3 of the header puts the scanner %1 m from the place that its matrix gives: the matrix was used.",
                       {significantText((header.stated - header.place).norm(), 4)}));
    if (endsWithoutLineEnd(part.text())) table.remarks.emplace_back(kMayBeCutOff);
    if (found->restIsNone) table.remarks.emplace_back("Behind the last of these scans there is text that is none.");
    Reading reading(std::move(table));
    reading.place = WrittenPlace{"PTX", header.turn, header.place, true};
    return reading;
}

constexpr std::size_t kNoRow = ~std::size_t{0};

/// The row of each cell of the grid.
std::vector<std::size_t> rowOfCell(const CloudColumns& cloud) {
    std::vector<std::size_t> rows(cloud.lines * cloud.beams, kNoRow);
    const CloudColumn* line = columnNamed(cloud, "line");
    const CloudColumn* beam = columnNamed(cloud, "beam");
    const CloudColumn* state = columnNamed(cloud, "state");
    if (line == nullptr || beam == nullptr) return rows;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (state != nullptr && numberIn(*state, row) != 0) continue;
        rows[static_cast<std::size_t>(numberIn(*line, row)) * cloud.beams + static_cast<std::size_t>(numberIn(*beam, row))] = row;
    }
    return rows;
}

void appendThree(std::string& text, const Eigen::Vector3d& v, int decimals) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendFixed(text, v[axis], decimals);
    }
}

/// The whole grid about its sensor and in its axes, 0 0 0 where a cell has no point to save; the matrix turns and moves it into the frame
/// of the columns.
Result<std::string> ptxBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkMemory(productOf({cloud.lines, cloud.beams, 48}), where); !enough) return enough.error();
    if (const CloudColumn* attached = columnNamed(cloud, "attached"); attached != nullptr)
        return Error{"PTX holds one point per cell, and points behind the nearest of their cell were asked for", where,
                     "use .pcd, .ply, .csv, .xyz, .las or .obj for them"};
    std::string text = std::to_string(cloud.lines) + "\n" + std::to_string(cloud.beams) + "\n";
    appendThree(text, cloud.sensorM, 6);
    text += '\n';
    for (int axis = 0; axis < 3; ++axis) { // the scanner's axes
        appendThree(text, cloud.turn.col(axis), 9);
        text += '\n';
    }
    for (int axis = 0; axis < 3; ++axis) {
        appendThree(text, cloud.turn.col(axis), 9);
        text += " 0\n";
    }
    appendThree(text, cloud.sensorM, 6);
    text += " 1\n";
    const CloudColumn* edge = columnNamed(cloud, "edge");
    const CloudColumn* intensity = edge == nullptr ? columnNamed(cloud, "intensity") : nullptr;
    const IntensitySpan span = intensity != nullptr ? intensitySpan(*intensity) : IntensitySpan{};
    for (const std::size_t row : rowOfCell(cloud)) {
        if (row == kNoRow) {
            text += "0 0 0 0.5\n";
            continue;
        }
        appendThree(text, cloud.turn.transpose() * (pointIn(cloud, row) - cloud.sensorM), 6);
        text += ' ';
        if (intensity != nullptr)
            appendFixed(text, span.ofOne(numberIn(*intensity, row)), 6);
        else
            text += edge != nullptr && numberIn(*edge, row) != 0 ? "1" : "0.5"; // edges are brighter
        text += '\n';
    }
    return text;
}

} // namespace

Format ptxFormat() {
    return {.title = "Leica PTX",
            .reads = {".ptx"},
            .writes = {".ptx"},
            .recognises = looksLikePtx,
            .read = readPtx,
            .write = ptxBytes,
            .keeps = Keeps::NoReturns,
            .keepsIntensity = true,
            .inFloats = {"MeshLab"},
            .options = {"scan"}};
}

} // namespace edgescan::files
