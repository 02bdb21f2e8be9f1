// Sentences about the coordinates in exported files.
#include "core/exports/written_coordinates.h"

#include "core/base/number_text.h"
#include "core/files/formats/formats.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::exports {
namespace {

std::string originText(const Eigen::Vector3d& enhM) {
    return "E " + shortestText(enhM.x()) + ", N " + shortestText(enhM.y()) + ", RL " + shortestText(enhM.z());
}

std::string extentText(const Eigen::AlignedBox3d& box, const std::array<const char*, 3>& names) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis)
        text += std::string(axis == 0 ? ": " : ", ") + names[static_cast<std::size_t>(axis)] + " " + fixedText(box.min()[axis], 2) +
                " to " + fixedText(box.max()[axis], 2);
    return text + " m";
}

std::string frameAndExtent(const WrittenCoordinates& written) {
    std::string text;
    std::array<const char*, 3> names{"x", "y", "z"};
    switch (written.frame) {
    case CoordinateFrame::Scanner:
        text = written.originEnhM ? "Scanner frame" : "Scanner frame, as the scan has no pose";
        break;
    case CoordinateFrame::Mine:
        text = "Mine grid";
        names = {"E", "N", "RL"};
        break;
    case CoordinateFrame::MineLocal:
        text = "Local metres from " + originText(*written.originEnhM) + " in the mine grid";
        names = {"east", "north", "up"};
        break;
    }
    return text + (written.box.isEmpty() ? std::string() : extentText(written.box, names)) + ".";
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t n = 0; n < names.size(); ++n) text += (n == 0 ? "" : n + 1 == names.size() ? " and " : ", ") + names[n];
    return text;
}

void addMissing(std::vector<std::string>& names, const std::vector<std::string>& others) {
    for (const std::string& name : others) {
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
}

} // namespace

double stepOfFloatsM(const Eigen::AlignedBox3d& box) {
    const double largest = box.isEmpty() ? 0 : std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0;
}

void WrittenCoordinates::add(const WrittenCoordinates& other) {
    box.extend(other.box);
    measurements = measurements && other.measurements;
    addMissing(aboutOrigin, other.aboutOrigin);
    addMissing(inFloats, other.inFloats);
}

std::optional<CoordinateFrame> frameOfFile(ExportContent content, const std::filesystem::path& path, const ExportOptions& options) {
    const ExportKind& kind = exportKind(content);
    if (kind.holds == ExportKind::Holds::Points || kind.holds == ExportKind::Holds::Scan) return options.frame;
    const auto file = std::ranges::find(kind.files, asciiLower(path.extension().string()), &ExportFile::extension);
    if (file == kind.files.end() || file->coordinates == ExportFile::Coordinates::None) return std::nullopt;
    return file->coordinates == ExportFile::Coordinates::MineOnly ? CoordinateFrame::Mine : options.frame;
}

WrittenCoordinates coordinatesOf(ExportContent content, const Scan& scan, const std::filesystem::path& path, const ExportOptions& options,
                                 const Eigen::AlignedBox3d& box) {
    WrittenCoordinates written;
    written.frame = frameOfFile(content, path, options).value_or(options.frame);
    if (scan.placement) written.originEnhM = scan.placement->originEnhM;
    written.box = box;
    const files::Format* format = files::writtenFormat(path);
    if (format != nullptr && exportKind(content).holds != ExportKind::Holds::Numbers) {
        written.measurements = format->write == nullptr;
        if (format->aboutOrigin && !options.choices.doubles) written.aboutOrigin = {format->writes.front()};
        written.inFloats = {format->inFloats.begin(), format->inFloats.end()};
    }
    return written;
}

std::string coordinatesText(const WrittenCoordinates& written) {
    if (written.measurements)
        return std::string("Ranges and angles of the scanner, ") + (written.originEnhM ? "with" : "without") + " a place in the mine grid.";
    std::string text = frameAndExtent(written);
    if (written.frame != CoordinateFrame::Mine) return text;
    if (!written.aboutOrigin.empty())
        text += " " + listed(written.aboutOrigin) + ": 4-byte metres from " + originText(*written.originEnhM) + ".";
    const double step = stepOfFloatsM(written.box);
    if (!written.inFloats.empty() && step >= kLeastStepM)
        text += " For " + listed(written.inFloats) + " use the local frame (--frame local): 4-byte numbers step by " +
                fixedText(step * 1000, 0) + " mm here.";
    return text;
}

} // namespace edgescan::exports
