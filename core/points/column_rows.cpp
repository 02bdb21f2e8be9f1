// Columns as rows of text, as binary records and as comment lines.
#include "core/points/column_rows.h"

#include "core/base/bands.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace edgescan {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PCD and PLY are written as the machine stores them");

constexpr std::size_t kRowsAtOnce = 2048;
constexpr std::size_t kUsualNumber = 8; // bytes of text with its separator; more is found when it is needed
constexpr int kMineDecimals = 4;        // tenths of a millimetre: seventeen digits of a mine coordinate would say nothing more

void appendRowsOf(std::string& text, const CloudColumns& cloud, std::size_t firstRow, std::size_t lastRow, char separator) {
    for (std::size_t row = firstRow; row < lastRow; ++row) {
        for (std::size_t i = 0; i < cloud.columns.size(); ++i) {
            const CloudColumn& column = cloud.columns[i];
            if (i > 0) text += separator;
            std::visit(
                [&](const auto& values) {
                    if (i < 3 && cloud.frame == CoordinateFrame::Mine && std::isfinite(static_cast<double>(values[row])))
                        appendFixed(text, static_cast<double>(values[row]), kMineDecimals);
                    else
                        appendShortest(text, values[row]);
                },
                column.values);
        }
        text += '\n';
    }
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

void appendRows(std::string& text, const CloudColumns& cloud, char separator) {
    const std::size_t rows = rowsOf(cloud);
    const int bands = bandsFor(rows, 0);
    text.reserve(text.size() + kUsualNumber * cloud.columns.size() * rows);
    std::vector<std::string> parts(static_cast<std::size_t>(bands)); // the first one's rows go into the text itself
    inBands(bands, bands, [&](int first, int) {
        const auto band = static_cast<std::size_t>(first);
        std::string& part = band == 0 ? text : parts[band];
        if (band > 0) part.reserve(kUsualNumber * cloud.columns.size() * (rows / parts.size() + 1));
        appendRowsOf(part, cloud, rows * band / parts.size(), rows * (band + 1) / parts.size(), separator);
    });
    for (const std::string& part : parts) text += part;
}

void appendComments(std::string& text, const CloudColumns& cloud, const std::string& word) {
    for (const std::string& line : commentLines(cloud.description)) text += word + line + "\n";
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) text += word + line + "\n";
}

void appendRecords(std::string& bytes, const CloudColumns& cloud) {
    std::size_t record = 0;
    for (const CloudColumn& column : cloud.columns) std::visit([&](const auto& values) { record += sizeof(values[0]); }, column.values);
    const std::size_t rows = rowsOf(cloud);
    bytes.reserve(bytes.size() + record * rows);
    // Some rows at a time, column by column: so the records stay in the cache until they are whole.
    for (std::size_t first = 0; first < rows; first += kRowsAtOnce) {
        const std::size_t count = std::min(kRowsAtOnce, rows - first);
        std::size_t offset = bytes.size();
        bytes.resize(offset + record * count);
        for (const CloudColumn& column : cloud.columns) {
            std::visit(
                [&](const auto& values) {
                    char* at = bytes.data() + offset;
                    for (std::size_t row = first; row < first + count; ++row, at += record)
                        std::memcpy(at, &values[row], sizeof values[row]);
                    offset += sizeof(values[0]);
                },
                column.values);
        }
    }
}

Result<Done> checkRoom(const CloudColumns& cloud, const std::string& where, std::uint64_t bytesPerNumber) {
    return checkMemory(std::uint64_t{rowsOf(cloud)} * cloud.columns.size() * bytesPerNumber, where);
}

} // namespace edgescan
