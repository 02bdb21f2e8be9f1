// Columns as rows of text, as binary records and as comment lines.
#include "core/files/point_tables/column_rows.h"

#include "core/base/bands.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace edgescan::files {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PCD and PLY are written as the machine stores them");

constexpr std::size_t kRowsAtOnce = 2048;
constexpr std::size_t kRowsOfPiece = 32768; // what a thread begins costs as much as some hundred rows
constexpr std::size_t kMostOfNumber = 400;  // bytes of text: the largest double has 309 digits before its point
constexpr std::size_t kUsualNumber = 8;     // bytes of text with its separator; more is found when it is needed
constexpr int kListDecimals = 9;            // of metres: the digits behind a nanometre are those of arithmetic
constexpr int kMineDecimals = 4;            // tenths of a millimetre: seventeen digits of a mine coordinate would say nothing more

template <class Number>
char* writeShortest(char* to, char* end, Number value) {
    if (value != value) return std::copy_n("nan", 3, to); // whatever its sign
    return std::to_chars(to, end, value).ptr;
}

// At most so many decimals, without zeros at their end.
char* writeDecimals(char* to, double value, int decimals, bool shortest, std::string& room) {
    room.clear();
    appendFixed(room, value, decimals);
    if (shortest) room.erase(room.find_last_not_of('0') + 1);
    if (room.ends_with('.')) room.pop_back();
    return std::copy(room.begin(), room.end(), to);
}

// The text of some rows, in a piece that is used again and again and stays in the cache. How much of it is written is returned.
std::size_t writeRows(std::vector<char>& piece, const CloudColumns& cloud, std::size_t firstRow, std::size_t lastRow, char separator) {
    const std::size_t columns = cloud.columns.size();
    std::size_t written = 0;
    std::string fixed;
    for (std::size_t row = firstRow; row < lastRow; ++row) {
        if (piece.size() - written < columns * kMostOfNumber) piece.resize(2 * piece.size() + columns * kMostOfNumber);
        char* at = piece.data() + written;
        char* const end = piece.data() + piece.size();
        for (std::size_t i = 0; i < columns; ++i) {
            const CloudColumn& column = cloud.columns[i];
            if (i > 0) *at++ = separator;
            const bool isMine = i < 3 && cloud.frame == CoordinateFrame::Mine;
            const auto* doubles = std::get_if<std::vector<double>>(&column.values);
            // A file with its description opens again as the same scan: there every bit counts.
            const bool isRounded = doubles != nullptr && cloud.description.empty();
            if ((isMine || isRounded) && std::isfinite(numberIn(column, row))) {
                at = writeDecimals(at, numberIn(column, row), isMine ? kMineDecimals : kListDecimals, !isMine, fixed);
            } else {
                std::visit([&](const auto& values) { at = writeShortest(at, end, values[row]); }, column.values);
            }
        }
        *at++ = '\n';
        written = static_cast<std::size_t>(at - piece.data());
    }
    return written;
}

} // namespace

IntensitySpan intensitySpan(const CloudColumn& column) {
    IntensitySpan span;
    bool first = true;
    for (std::size_t row = 0; row < std::visit([](const auto& values) { return values.size(); }, column.values); ++row) {
        const double value = numberIn(column, row);
        if (!std::isfinite(value)) continue;
        span.least = first ? value : std::min(span.least, value);
        span.greatest = first ? value : std::max(span.greatest, value);
        span.whole = span.whole && value == std::floor(value);
        first = false;
    }
    return span;
}

double IntensitySpan::ofOne(double value) const {
    if (!std::isfinite(value)) return 0.5;
    if (least >= 0 && greatest <= 1) return value;
    return greatest > least ? (value - least) / (greatest - least) : 0.5;
}

void subtractOrigin(CloudColumns& cloud) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<float> local(rowsOf(cloud));
        for (std::size_t row = 0; row < local.size(); ++row)
            local[row] = static_cast<float>(numberIn(cloud.columns[axis], row) - cloud.originM[static_cast<Eigen::Index>(axis)]);
        cloud.columns[axis].values = std::move(local);
    }
    cloud.frame = CoordinateFrame::MineLocal;
}

namespace {

/// The rows first <= row < last of a cloud, made in `made` where they are to be made later: then these are whole lines.
const CloudColumns& rowsFrom(const CloudColumns& cloud, CloudColumns& made, std::size_t& first, std::size_t& last) {
    if (!cloud.linesLater) return cloud;
    cloud.linesLater(first / cloud.width, last / cloud.width, made.columns);
    made.frame = cloud.frame;
    last -= std::exchange(first, 0);
    return made;
}

/// Rows at once: about as many as are wanted, and whole lines where they are made line by line.
std::size_t rowsAtOnce(const CloudColumns& cloud, std::size_t wanted) {
    return cloud.linesLater ? std::max<std::size_t>(1, wanted / cloud.width) * cloud.width : wanted;
}

} // namespace

void appendRows(std::string& text, const CloudColumns& cloud, char separator) {
    const std::size_t rows = rowsOf(cloud);
    const auto bands = static_cast<std::size_t>(bandsFor(rows, 0));
    text.reserve(text.size() + kUsualNumber * cloud.columns.size() * rows);
    // Each thread writes the next piece, and in turn they go into the text.
    const std::size_t rowsOfPiece = rowsAtOnce(cloud, bands > 1 ? kRowsOfPiece : kRowsAtOnce);
    std::vector<std::vector<char>> pieces(bands);
    std::vector<CloudColumns> made(bands);
    std::vector<std::size_t> written(bands);
    for (std::size_t first = 0; first < rows; first += bands * rowsOfPiece) {
        const auto rowOf = [&](std::size_t band) { return std::min(rows, first + band * rowsOfPiece); };
        runInBands(static_cast<int>(bands), static_cast<int>(bands), [&](int one, int) {
            const auto band = static_cast<std::size_t>(one);
            std::size_t from = rowOf(band), to = rowOf(band + 1);
            const CloudColumns& rowsOfBand = rowsFrom(cloud, made[band], from, to);
            written[band] = writeRows(pieces[band], rowsOfBand, from, to, separator);
        });
        for (std::size_t band = 0; band < bands; ++band) text.append(pieces[band].data(), written[band]);
    }
}

void appendComments(std::string& text, const CloudColumns& cloud, const std::string& word) {
    for (const std::string& line : commentLines(cloud.description)) text += word + line + "\n";
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) text += word + line + "\n";
}

void appendRecords(std::string& bytes, const CloudColumns& cloud) {
    std::size_t record = 0;
    for (const CloudColumn& column : cloud.columns) std::visit([&](const auto& values) { record += sizeof *values.data(); }, column.values);
    const std::size_t rows = rowsOf(cloud);
    bytes.reserve(bytes.size() + record * rows);
    // Some rows at a time, column by column: so the records stay in the cache until they are whole.
    const std::size_t atOnce = rowsAtOnce(cloud, kRowsAtOnce);
    std::vector<char> piece(record * std::min(rows, atOnce));
    CloudColumns made;
    for (std::size_t next = 0; next < rows; next += atOnce) {
        std::size_t first = next, last = std::min(rows, next + atOnce);
        const CloudColumns& part = rowsFrom(cloud, made, first, last);
        const std::size_t count = last - first;
        std::size_t offset = 0;
        for (const CloudColumn& column : part.columns) {
            std::visit(
                [&](const auto& values) {
                    char* at = piece.data() + offset;
                    const auto* value = values.data() + first;
                    for (std::size_t row = 0; row < count; ++row, at += record) std::memcpy(at, value + row, sizeof *value);
                    offset += sizeof *value;
                },
                column.values);
        }
        bytes.append(piece.data(), record * count);
    }
}

Result<Done> checkRoom(const CloudColumns& cloud, const std::string& where, std::uint64_t bytesPerNumber) {
    return checkMemory(std::uint64_t{rowsOf(cloud)} * cloud.columns.size() * bytesPerNumber, where);
}

} // namespace edgescan::files
