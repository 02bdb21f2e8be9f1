// Columns as PCD, PLY and text.
#include "core/writers/cloud_columns.h"

#include "core/writers/column_rows.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace edgescan {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PCD and PLY are written as the machine stores them");

constexpr int kMineDecimals = 4; // tenths of a millimetre: seventeen digits of a mine coordinate would say nothing more

void appendRows(std::string& text, const CloudColumns& cloud, char separator) {
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
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

/// Comment lines of the description and the record, each behind the format's own comment word.
void appendComments(std::string& text, const CloudColumns& cloud, const std::string& word) {
    for (const std::string& line : commentLines(cloud.description)) text += word + line + "\n";
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) text += word + line + "\n";
}

/// Lists are read line by line whatever their length: the record takes one line, and whoever counts rows is hardly off.
void appendListComments(std::string& text, const CloudColumns& cloud) {
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    for (const std::string& line : commentLines(cloud.description)) text += "# " + line + "\n";
    if (!cloud.record.empty()) text += "# " + (kRecordMark + cloud.record) + "\n";
}

/// Records one after the other, each column's values as they are in memory.
void appendRecords(std::string& bytes, const CloudColumns& cloud) {
    std::size_t record = 0;
    for (const CloudColumn& column : cloud.columns) std::visit([&](const auto& values) { record += sizeof(values[0]); }, column.values);
    const std::size_t start = bytes.size();
    bytes.resize(start + record * rowsOf(cloud));
    std::size_t offset = start;
    for (const CloudColumn& column : cloud.columns) {
        std::visit(
            [&](const auto& values) {
                char* at = bytes.data() + offset;
                for (const auto value : values) {
                    std::memcpy(at, &value, sizeof value);
                    at += record;
                }
                offset += sizeof(values[0]);
            },
            column.values);
    }
}

struct TypeNames {
    const char* pcdSize;
    const char* pcdType;
    const char* ply;
};
TypeNames typeNamesOf(const CloudColumn& column) {
    static constexpr std::array<TypeNames, 4> kNames{{{"4", "F", "float"}, {"8", "F", "double"}, {"4", "U", "uint"}, {"1", "U", "uchar"}}};
    return kNames[column.values.index()];
}

template <class Word>
std::string headerLine(const char* key, const CloudColumns& cloud, Word word) {
    std::string line = key;
    for (const CloudColumn& column : cloud.columns) {
        line += ' ';
        line += word(column);
    }
    line += '\n';
    return line;
}

Result<Done> checkRoom(const CloudColumns& cloud, const std::string& where, std::uint64_t bytesPerNumber) {
    return checkMemory(std::uint64_t{rowsOf(cloud)} * cloud.columns.size() * bytesPerNumber, where);
}

} // namespace

Result<std::string> pcdBytes(const CloudColumns& cloud, const std::string& where, bool ascii) {
    if (auto enough = checkRoom(cloud, where, ascii ? 12 : 8); !enough) return enough.error();
    std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    appendComments(text, cloud, "# ");
    text += "VERSION 0.7\n";
    text += headerLine("FIELDS", cloud, [](const CloudColumn& c) { return c.name; });
    text += headerLine("SIZE", cloud, [](const CloudColumn& c) { return typeNamesOf(c).pcdSize; });
    text += headerLine("TYPE", cloud, [](const CloudColumn& c) { return typeNamesOf(c).pcdType; });
    text += headerLine("COUNT", cloud, [](const CloudColumn&) { return "1"; });
    text += "WIDTH " + std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) + "\nVIEWPOINT ";
    for (int axis = 0; axis < 3; ++axis) {
        appendShortest(text, cloud.sensorM[axis]);
        text += ' ';
    }
    text += "1 0 0 0\nPOINTS " + std::to_string(rowsOf(cloud)) + "\nDATA " + (ascii ? "ascii" : "binary") + "\n";
    if (ascii)
        appendRows(text, cloud, ' ');
    else
        appendRecords(text, cloud);
    return text;
}

Result<std::string> plyBytes(const CloudColumns& cloud, const std::string& where, bool ascii) {
    if (auto enough = checkRoom(cloud, where, ascii ? 12 : 8); !enough) return enough.error();
    std::string text = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
    text += "comment " + frameText(cloud) + "\n";
    appendComments(text, cloud, "comment ");
    text += "element vertex " + std::to_string(rowsOf(cloud)) + "\n";
    for (const CloudColumn& column : cloud.columns) text += std::string("property ") + typeNamesOf(column).ply + " " + column.name + "\n";
    text += "end_header\n";
    if (ascii)
        appendRows(text, cloud, ' ');
    else
        appendRecords(text, cloud);
    return text;
}

Result<std::string> pointTextBytes(const CloudColumns& cloud, const std::string& where, char separator) {
    if (auto enough = checkRoom(cloud, where, 12); !enough) return enough.error();
    std::string text;
    appendListComments(text, cloud);
    if (separator == ' ') text += "# "; // many readers of .xyz take no header line
    for (std::size_t i = 0; i < cloud.columns.size(); ++i) {
        if (i > 0) text += separator;
        text += cloud.columns[i].name + (i < 3 ? "_m" : "");
    }
    text += '\n';
    appendRows(text, cloud, separator);
    return text;
}

} // namespace edgescan
