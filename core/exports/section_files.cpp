// Writes sections.
#include "core/exports/section_files.h"

#include "core/base/number_text.h"
#include "core/containers/png/png.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/exports/frame_points.h"
#include "core/files/formats/dxf_text.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/source.h"
#include "core/rocks/attributes/attributes.h"
#include "core/rocks/attributes/study.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;
using inspect::Section;
using inspect::SectionVertex;

constexpr const char* kSurfaceLayer = "SURFACE";
constexpr const char* kRockLayer = "ROCKS";
constexpr const char* kEdgeLayer = "EDGES";
constexpr const char* kRockNumberLayer = "ROCK_NUMBERS";
constexpr std::array<files::DxfLayer, 4> kLayers{{{kSurfaceLayer, "7"}, {kRockLayer, "5"}, {kEdgeLayer, "3"}, {kRockNumberLayer, "7"}}};
constexpr double kNumberHeightM = 0.10;
constexpr const char* kScaleText = "section: x along it, y up, metres from its origin, equal scales";

Eigen::Vector3d inPlot(const SectionVertex& vertex) { return {vertex.atM.x(), vertex.atM.y(), 0.0}; }

Eigen::AlignedBox2d extentOf(const Section& section) {
    Eigen::AlignedBox2d box;
    for (const inspect::SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) box.extend(vertex.atM);
    }
    return box;
}

/// The largest stretch of each rock, for its number.
std::map<std::uint32_t, SectionVertex> middlesOf(const Section& section) {
    std::map<std::uint32_t, std::vector<const SectionVertex*>> byRock;
    for (const inspect::SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) {
            if (vertex.rock != 0) byRock[vertex.rock].push_back(&vertex);
        }
    }
    std::map<std::uint32_t, SectionVertex> middles;
    for (const auto& [rock, vertices] : byRock) middles.emplace(rock, *vertices[vertices.size() / 2]);
    return middles;
}

std::string dxfSection(const Section& section, bool withRocks, const std::string& frame, const std::string& record) {
    Eigen::AlignedBox3d box;
    const Eigen::AlignedBox2d extent = extentOf(section);
    if (!extent.isEmpty()) {
        box.extend(Eigen::Vector3d(extent.min().x(), extent.min().y(), 0.0));
        box.extend(Eigen::Vector3d(extent.max().x(), extent.max().y(), 0.0));
    }
    files::DxfText drawing(false);
    drawing.comment(kScaleText);
    drawing.comment(frame);
    if (withRocks) drawing.comment(rocks::kRockCaveat);
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) drawing.comment(line);
    drawing.begin(box, kLayers);
    for (const inspect::SectionLine& line : section.lines) {
        const char* layer = nullptr; // of the polyline that is being written
        for (std::size_t n = 0; n < line.size(); ++n) {
            const char* wanted = line[n].rock != 0 ? kRockLayer : kSurfaceLayer;
            if (wanted != layer) {
                if (layer != nullptr) {
                    drawing.vertex(layer, inPlot(line[n]));
                    drawing.endLine(layer);
                }
                layer = wanted;
                drawing.beginLine(layer, false);
            }
            drawing.vertex(layer, inPlot(line[n]));
        }
        if (layer != nullptr) drawing.endLine(layer);
    }
    for (const inspect::SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) {
            if (vertex.edge) drawing.point(kEdgeLayer, inPlot(vertex));
        }
    }
    for (const auto& [rock, vertex] : middlesOf(section))
        drawing.text(kRockNumberLayer, inPlot(vertex), kNumberHeightM, std::to_string(rock));
    return drawing.end();
}

std::string csvSection(const Section& section, const Scan& scan, CoordinateFrame frame) {
    const FramePoints points(scan, frame);
    std::string text = "part,across_m,up_m,x_m,y_m,z_m,line,beam,edge,rock\n";
    const auto beams = static_cast<std::uint32_t>(scan.beams());
    for (std::size_t part = 0; part < section.lines.size(); ++part) {
        for (const SectionVertex& vertex : section.lines[part]) {
            text += std::to_string(part);
            const Eigen::Vector3d place = points.at(vertex.cell, vertex.pointM);
            for (const double number : {vertex.atM.x(), vertex.atM.y(), place.x(), place.y(), place.z()}) {
                text += ',';
                appendFixed(text, number, 4);
            }
            text += "," + std::to_string(vertex.cell / beams) + "," + std::to_string(vertex.cell % beams) + "," +
                    edges::edgeName(vertex.edge, vertex.kind) + "," + (vertex.rock != 0 ? std::to_string(vertex.rock) : "") + "\n";
        }
    }
    return text;
}

/// Length of a scale bar: 1, 2 or 5 times a power of ten, about a quarter of the width.
double barM(double widthM) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(1e-3, widthM / 4.0))));
    for (const double times : {5.0, 2.0}) {
        if (times * power <= widthM / 4.0) return times * power;
    }
    return power;
}

Grid<Rgb> picture(const Section& section, bool withRocks) {
    constexpr int kWide = 1600, kMostHigh = 4000, kMargin = 60, kFoot = 60;
    const Eigen::AlignedBox2d extent = extentOf(section);
    const Eigen::Vector2d least = extent.isEmpty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(extent.min());
    const Eigen::Vector2d size = extent.isEmpty() ? Eigen::Vector2d(1, 1) : Eigen::Vector2d(extent.sizes().cwiseMax(0.01));
    const double perM = std::min((kWide - 2.0 * kMargin) / size.x(), (kMostHigh - 2.0 * kMargin - kFoot) / size.y());
    const int high = static_cast<int>(std::ceil(size.y() * perM)) + 2 * kMargin + kFoot;
    cv::Mat sheet(high, kWide, CV_8UC3, cv::Scalar(255, 255, 255));
    const auto place = [&](const Eigen::Vector2d& at) {
        return cv::Point(kMargin + static_cast<int>(std::lround((at.x() - least.x()) * perM)),
                         high - kMargin - kFoot - static_cast<int>(std::lround((at.y() - least.y()) * perM)));
    };
    const cv::Scalar surface(110, 110, 110), rock(40, 90, 200), edge(0, 130, 0), words(0, 0, 0);
    for (const inspect::SectionLine& line : section.lines) {
        for (std::size_t n = 1; n < line.size(); ++n) {
            const bool ofRock = line[n].rock != 0 && line[n - 1].rock == line[n].rock;
            cv::line(sheet, place(line[n - 1].atM), place(line[n].atM), ofRock ? rock : surface, ofRock ? 3 : 2);
        }
    }
    for (const inspect::SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) {
            if (vertex.edge) cv::circle(sheet, place(vertex.atM), 5, edge, cv::FILLED);
        }
    }
    constexpr double kText = 0.6;
    for (const auto& [number, vertex] : middlesOf(section))
        cv::putText(sheet, std::to_string(number), place(vertex.atM) + cv::Point(6, -8), cv::FONT_HERSHEY_SIMPLEX, kText, words, 1);
    const double bar = barM(size.x());
    const cv::Point from(kMargin, high - kMargin / 2), to(kMargin + static_cast<int>(std::lround(bar * perM)), high - kMargin / 2);
    cv::line(sheet, from, to, words, 3);
    cv::putText(sheet,
                shortestText(bar) + (withRocks ? std::string(" m; rocks blue, edges green; ") + rocks::kRockCaveat : " m; edges green"),
                from + cv::Point(0, -12), cv::FONT_HERSHEY_SIMPLEX, kText, words, 1);
    Grid<Rgb> pixels(high, kWide);
    for (int y = 0; y < high; ++y) {
        for (int x = 0; x < kWide; ++x) {
            const cv::Vec3b& value = sheet.at<cv::Vec3b>(y, x);
            pixels.at(y, x) = {value[0], value[1], value[2]};
        }
    }
    return pixels;
}

std::optional<Eigen::Vector3d> vectorOf(const Json& record, const char* key) {
    if (!record.is_object() || !record.contains(key) || !record[key].is_array() || record[key].size() != 3) return std::nullopt;
    Eigen::Vector3d vector;
    for (int n = 0; n < 3; ++n) {
        const Json& number = record[key][static_cast<std::size_t>(n)];
        if (!number.is_number() || !std::isfinite(number.get<double>())) return std::nullopt;
        vector[n] = number.get<double>();
    }
    return vector;
}

Section cutBy(const edges::Detection& detection, const ExportOptions& options) {
    std::optional<Grid<std::uint32_t>> labels;
    if (options.rocks) labels = rocks::rockLabels(*options.rocks->segmentation, options.rocks->map);
    return inspect::sectionOf(detection, *options.section, labels ? &*labels : nullptr);
}

} // namespace

OwnPart::Content sectionContent(const edges::Detection& detection, const ExportOptions& options, const std::filesystem::path& path) {
    OwnPart::Content content;
    if (!options.section || !files::checkFrame(*detection.scan, options.frame, path.string())) return content;
    const Section section = cutBy(detection, options);
    const FramePoints points(*detection.scan, options.frame);
    for (const inspect::SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) content.box.extend(points.at(vertex.cell, vertex.pointM));
    }
    content.count = middlesOf(section).size();
    return content;
}

Result<std::string> sectionBytes(const ExportInput& input) {
    const std::string where = input.path.string();
    if (!input.options.section) return Error{"a section needs a plane", where, "give two cells, or a rock, that it goes through"};
    const bool withRocks = input.options.rocks != nullptr;
    const Scan& scan = *input.detection.scan;
    const Section section = cutBy(input.detection, input.options);
    if (section.lines.empty()) return Error{"the plane of the section meets no surface", where, "choose two other cells"};
    const std::string extension = files::Source::lowerCase(input.path.extension());
    if (auto known = files::checkFrame(scan, input.options.frame, where); !known) return known.error();
    if (extension == ".csv") return csvSection(section, scan, input.options.frame);
    if (extension == ".png") return containers::pngRgbBytes(picture(section, withRocks), where);
    return dxfSection(section, withRocks, FramePoints(scan, input.options.frame).text(), input.record);
}

Json planeRecord(const ExportOptions& options, const Scan& /*scan*/) {
    if (!options.section) return {};
    const inspect::SectionPlane& plane = *options.section;
    const auto vector = [](const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); };
    return {
        {"origin_m", vector(plane.originM)}, {"across", vector(plane.across)}, {"up", vector(plane.up)}, {"up_assumed", plane.upAssumed}};
}

Result<Done> readPlane(const Json& record, const Scan& /*scan*/, const std::string& where, ExportOptions& options) {
    const auto origin = vectorOf(record, "origin_m"), across = vectorOf(record, "across"), up = vectorOf(record, "up");
    if (!origin || !across || !up)
        return Error{"the record's section is not understood", where, "verify with the version that made the export"};
    options.section =
        std::make_shared<const inspect::SectionPlane>(inspect::SectionPlane{*origin, *across, *up, record.value("up_assumed", false)});
    return Done{};
}

} // namespace edgescan::exports
