// DXF, release 12 unless 2000 is asked for, text: every CAD program reads it. Points on layers, and edges as 3D polylines along the edge
// map.
#include "core/files/formats/format.h"

#include "core/base/memory.h"
#include "core/files/formats/dxf_text.h"
#include "core/files/formats/edge_chains.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/text_layout.h"

#include <Eigen/Geometry>

#include <array>
#include <charconv>
#include <optional>

namespace edgescan::files {
namespace {

constexpr std::uint64_t kBytesPerPoint = 260;

constexpr DxfLayer kCloudLayer{"CLOUD", "8"};
/// Layers of points and of lines, by the number in the column "class"; 0: an edge of a method without classes.
constexpr std::array<DxfLayer, 7> kPointLayers{{{"EDGE_POINTS", "3"},
                                                {"EDGE_POINTS_JUMP", "3"},
                                                {"EDGE_POINTS_CONVEX", "4"},
                                                {"EDGE_POINTS_CONCAVE", "6"},
                                                {"EDGE_POINTS_BORDER", "30"},
                                                {"EDGE_POINTS_SILHOUETTE", "2"},
                                                {"EDGE_POINTS_RIM", "151"}}};
constexpr std::array<DxfLayer, 7> kLineLayers{{{"EDGE_LINES", "3"},
                                               {"EDGE_LINES_JUMP", "3"},
                                               {"EDGE_LINES_CONVEX", "4"},
                                               {"EDGE_LINES_CONCAVE", "6"},
                                               {"EDGE_LINES_BORDER", "30"},
                                               {"EDGE_LINES_SILHOUETTE", "2"},
                                               {"EDGE_LINES_RIM", "151"}}};

/// The class of a row's edge: an index of the layers above.
std::size_t classOf(const CloudColumn* classes, std::size_t row) {
    if (classes == nullptr) return 0;
    const double number = numberIn(*classes, row);
    return number >= 0 && number < static_cast<double>(kLineLayers.size()) ? static_cast<std::size_t>(number) : 0;
}

/// Those of the classes that the cloud has.
std::vector<DxfLayer> layersOf(const CloudColumns& cloud) {
    std::array<bool, kLineLayers.size()> isThere{};
    const CloudColumn* classes = columnNamed(cloud, "class");
    const CloudColumn* edge = columnNamed(cloud, "edge");
    for (std::size_t row = 0; row < rowsOf(cloud) && columnNamed(cloud, "state") == nullptr; ++row) {
        if (edge == nullptr || numberIn(*edge, row) != 0) isThere.at(classOf(classes, row)) = true;
    }
    std::vector<DxfLayer> layers{kCloudLayer};
    for (std::size_t n = 0; n < isThere.size(); ++n) {
        if (isThere.at(n)) layers.insert(layers.end(), {kPointLayers.at(n), kLineLayers.at(n)});
    }
    return layers;
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

void appendPolylines(DxfText& drawing, const CloudColumns& cloud) {
    const CloudColumn* line = columnNamed(cloud, "line");
    const CloudColumn* beam = columnNamed(cloud, "beam");
    const CloudColumn* range = columnNamed(cloud, "range_mm");
    const CloudColumn* classes = columnNamed(cloud, "class");
    if (line == nullptr || beam == nullptr || range == nullptr) return;
    const std::vector<std::size_t> rows = edgeRows(cloud);
    std::vector<EdgeCell> cells;
    cells.reserve(rows.size());
    for (const std::size_t row : rows) {
        cells.push_back({static_cast<std::uint32_t>(numberIn(*line, row)), static_cast<std::uint32_t>(numberIn(*beam, row)),
                         static_cast<float>(numberIn(*range, row))});
    }
    const std::size_t least = cloud.choices.shortLines ? 2 : 3; // lines of two points are crumbs: their points are there anyway
    for (const auto& chain : chainsOf(cells)) {
        if (chain.size() < least) continue;
        const auto kind = [&](std::size_t n) { return classOf(classes, rows[chain[n]]); };
        // A link belongs to the class of its first cell, so that lines of several classes have no gap.
        for (std::size_t first = 0; first + 1 < chain.size();) {
            std::size_t last = first + 1;
            while (last + 1 < chain.size() && kind(last) == kind(first)) ++last;
            const bool closed = first == 0 && last + 1 == chain.size() && chain.size() > 3 && chain.front() == chain.back();
            const char* layer = kLineLayers.at(kind(first)).name;
            drawing.beginLine(layer, closed);
            for (std::size_t n = first; n + (closed ? 1 : 0) <= last; ++n) drawing.vertex(layer, pointIn(cloud, rows[chain[n]]));
            drawing.endLine(layer);
            first = last;
        }
    }
}

Result<std::string> dxfBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkMemory(std::uint64_t{rowsOf(cloud)} * kBytesPerPoint, where); !enough) return enough.error();
    DxfText drawing(cloud.choices.dxf2000);
    drawing.comment(frameText(cloud));
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) drawing.comment(line);
    const CloudColumn* edge = columnNamed(cloud, "edge");
    const CloudColumn* state = columnNamed(cloud, "state");
    const CloudColumn* classes = columnNamed(cloud, "class");
    const auto isThere = [&](std::size_t row) { return state == nullptr || numberIn(*state, row) == 0; };
    Eigen::AlignedBox3d box;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (isThere(row)) box.extend(pointIn(cloud, row));
    }
    drawing.begin(box, layersOf(cloud));
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        const bool cloudOnly = state != nullptr || (edge != nullptr && numberIn(*edge, row) == 0);
        if (isThere(row)) drawing.point(cloudOnly ? kCloudLayer.name : kPointLayers.at(classOf(classes, row)).name, pointIn(cloud, row));
    }
    if (state == nullptr) appendPolylines(drawing, cloud);
    return drawing.end();
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
        if (!code || codeLine.next >= text.size())
            return source.refusedAtLine(line + 1, "this is not a whole DXF group", "export it again");
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
        if (!number) return source.refusedAtLine(line, "this coordinate is not a number", "export it again");
        points.back()[*code / 10 - 1] = *number;
    }
    return table;
}

} // namespace

Format dxfFormat() {
    return {.title = "Drawing with edge lines",
            .writes = {".dxf"},
            .read = readingOf<dxfPoints>,
            .write = dxfBytes,
            .keeps = Keeps::Points,
            .inFloats = {"LibreCAD"},
            .drawsEdges = true};
}

} // namespace edgescan::files
