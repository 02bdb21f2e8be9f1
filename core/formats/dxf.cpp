// DXF, release 12, text: every CAD program reads it. Points on layers, and edges as 3D polylines along the edge map.
#include "core/formats/format.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/formats/edge_chains.h"
#include "core/points/column_rows.h"
#include "core/points/text_layout.h"

#include <Eigen/Geometry>

#include <array>
#include <charconv>
#include <optional>

namespace edgescan {
namespace {

constexpr std::uint64_t kBytesPerPoint = 160;
constexpr int kDecimals = 4; // tenths of a millimetre

constexpr const char* kCloudLayer = "CLOUD";
constexpr const char* kPointLayer = "EDGE_POINTS";
constexpr const char* kLineLayer = "EDGE_LINES";

void appendPair(std::string& text, const char* code, const std::string& value) {
    text += code;
    text += '\n';
    text += value;
    text += '\n';
}

void appendAt(std::string& text, const Eigen::Vector3d& point) {
    static constexpr std::array<const char*, 3> kCodes{"10\n", "20\n", "30\n"};
    for (int axis = 0; axis < 3; ++axis) {
        text += kCodes[static_cast<std::size_t>(axis)];
        appendFixed(text, point[axis], kDecimals);
        text += '\n';
    }
}

void appendEntity(std::string& text, const char* kind, const char* layer) {
    text += "0\n";
    text += kind;
    text += "\n8\n";
    text += layer;
    text += '\n';
}

void appendLayer(std::string& text, const char* name, const char* colour) {
    text += "0\nLAYER\n2\n";
    text += name;
    text += "\n70\n0\n62\n";
    text += colour;
    text += "\n6\nCONTINUOUS\n";
}

void appendHeader(std::string& text, const CloudColumns& cloud) {
    appendPair(text, "999", frameText(cloud));
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) appendPair(text, "999", line);
    text += "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n";
    Eigen::AlignedBox3d box;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) box.extend(pointIn(cloud, row));
    if (!box.isEmpty()) {
        text += "9\n$EXTMIN\n";
        appendAt(text, box.min());
        text += "9\n$EXTMAX\n";
        appendAt(text, box.max());
    }
    text += "0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid "
            "line\n72\n65\n73\n0\n40\n0.0\n0\nENDTAB\n"
            "0\nTABLE\n2\nLAYER\n70\n3\n";
    appendLayer(text, kCloudLayer, "8");
    appendLayer(text, kPointLayer, "3");
    appendLayer(text, kLineLayer, "3");
    text += "0\nENDTAB\n0\nENDSEC\n";
}

/// The rows that are edges: all, or those that the column says.
std::vector<std::size_t> edgeRows(const CloudColumns& cloud) {
    const CloudColumn* edge = columnNamed(cloud, "edge");
    const CloudColumn* attached = columnNamed(cloud, "attached"); // a point behind its cell's has no neighbours in the map
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (edge != nullptr && numberIn(*edge, row) == 0) continue;
        if (attached == nullptr || numberIn(*attached, row) == 0) rows.push_back(row);
    }
    return rows;
}

void appendPolylines(std::string& text, const CloudColumns& cloud) {
    const CloudColumn* line = columnNamed(cloud, "line");
    const CloudColumn* beam = columnNamed(cloud, "beam");
    const CloudColumn* range = columnNamed(cloud, "range_mm");
    if (line == nullptr || beam == nullptr || range == nullptr) return;
    const std::vector<std::size_t> rows = edgeRows(cloud);
    std::vector<EdgeCell> cells;
    cells.reserve(rows.size());
    for (const std::size_t row : rows) {
        cells.push_back({static_cast<std::uint32_t>(numberIn(*line, row)), static_cast<std::uint32_t>(numberIn(*beam, row)),
                         static_cast<float>(numberIn(*range, row))});
    }
    for (const auto& chain : chainsOf(cells)) {
        appendEntity(text, "POLYLINE", kLineLayer);
        const bool closed = chain.size() > 3 && chain.front() == chain.back();
        text += closed ? "66\n1\n70\n9\n" : "66\n1\n70\n8\n"; // 8: 3D polyline, 1: closed
        appendAt(text, Eigen::Vector3d::Zero());
        for (std::size_t n = 0; n + (closed ? 1 : 0) < chain.size(); ++n) {
            appendEntity(text, "VERTEX", kLineLayer);
            appendAt(text, pointIn(cloud, rows[chain[n]]));
            text += "70\n32\n";
        }
        appendEntity(text, "SEQEND", kLineLayer);
    }
}

Result<std::string> dxfBytes(const CloudColumns& cloud, const std::string& where, bool) {
    if (auto enough = checkMemory(std::uint64_t{rowsOf(cloud)} * kBytesPerPoint, where); !enough) return enough.error();
    std::string text;
    appendHeader(text, cloud);
    text += "0\nSECTION\n2\nENTITIES\n";
    const CloudColumn* edge = columnNamed(cloud, "edge");
    const CloudColumn* state = columnNamed(cloud, "state");
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (state != nullptr && numberIn(*state, row) != 0) continue; // no point there
        const bool cloudOnly = state != nullptr || (edge != nullptr && numberIn(*edge, row) == 0);
        appendEntity(text, "POINT", cloudOnly ? kCloudLayer : kPointLayer);
        appendAt(text, pointIn(cloud, row));
    }
    if (state == nullptr) appendPolylines(text, cloud);
    text += "0\nENDSEC\n0\nEOF\n";
    return text;
}

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

template <class Number>
std::optional<Number> wholeText(std::string_view text) {
    Number value{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Coordinates of every POINT, for comparing a file with what was to be written; a group is a code and a value. Polylines are left out.
Result<PointTable> dxfPoints(const Source& source) {
    const std::string_view text = source.text();
    PointTable table;
    auto& points = table.points;
    bool inPoint = false;
    std::size_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
        const TextLine codeLine = textLineAt(text, at);
        const auto code = wholeText<int>(withoutBlanks(codeLine.text));
        if (!code || codeLine.next >= text.size()) return source.refusedAtLine(line + 1, "this is no whole DXF group", "export it again");
        const TextLine valueLine = textLineAt(text, codeLine.next);
        const std::string_view value = withoutBlanks(valueLine.text);
        at = valueLine.next;
        line += 2;
        if (*code == 0) {
            inPoint = value == "POINT";
            if (inPoint) points.emplace_back(Eigen::Vector3d::Zero());
        }
        if (!inPoint || (*code != 10 && *code != 20 && *code != 30)) continue;
        const auto number = wholeText<double>(value);
        if (!number) return source.refusedAtLine(line, "this coordinate is no number", "export it again");
        points.back()[*code / 10 - 1] = *number;
    }
    return table;
}

} // namespace

Format dxfFormat() {
    return {.title = "Drawing with edge lines", .writes = {".dxf"}, .points = dxfPoints, .write = dxfBytes, .keeps = Keeps::Points};
}

} // namespace edgescan
