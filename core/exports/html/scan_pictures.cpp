// Draws gray levels, edges and points as pictures, and collects points for the page's rotating view.
#include "core/exports/html/scan_pictures.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/exports/html/html.h"
#include "core/files/point_tables/edge_colours.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace edgescan::exports {
namespace {

constexpr double kPartOfSide = 1.0 / 58;        // height of a number, as part of the longer side of the picture
constexpr double kDigitWidth = 0.62;            // of the height
constexpr double kLineWidth = 0.2, kDot = 0.25; // of the height
constexpr double kRim = 0.11;                   // of the height: the dark rim of a number

struct Box {
    double x, y, halfWidth, halfHeight;
    [[nodiscard]] bool covers(const Box& other) const {
        return std::abs(x - other.x) < halfWidth + other.halfWidth && std::abs(y - other.y) < halfHeight + other.halfHeight;
    }
};

// The cells of one pixel: the first ones and those behind the last.
struct Block {
    int lines[2], beams[2];
};
Block blockOf(int y, int x, int height, int width, int lines, int beams) {
    const auto part = [](int n, int of, int cells) { return static_cast<int>(static_cast<std::int64_t>(n) * cells / of); };
    Block block{{part(y, height, lines), part(y + 1, height, lines)}, {part(x, width, beams), part(x + 1, width, beams)}};
    block.lines[1] = std::max(block.lines[1], block.lines[0] + 1);
    block.beams[1] = std::max(block.beams[1], block.beams[0] + 1);
    return block;
}

// Colours for the page's dark background; those of files are made for gray points.
Rgb edgeColour(const edges::Detection& detection, std::size_t k) {
    return files::kEdgeColours[detection.classes ? static_cast<std::size_t>((*detection.classes)[k]) : 0];
}

template <class Pixel, class Paint>
Grid<Pixel> reduced(const edges::Detection& detection, int mostPixels, const Paint& paint) {
    const int lines = detection.scan->lines(), beams = detection.scan->beams();
    Grid<Pixel> picture(std::min(lines, mostPixels), std::min(beams, mostPixels));
    for (int y = 0; y < picture.lines; ++y) {
        for (int x = 0; x < picture.beams; ++x) picture.at(y, x) = paint(blockOf(y, x, picture.lines, picture.beams, lines, beams));
    }
    return picture;
}

int meanLevel(const edges::Detection& detection, const Block& block) {
    int sum = 0, count = 0;
    for (int i = block.lines[0]; i < block.lines[1]; ++i) {
        for (int j = block.beams[0]; j < block.beams[1]; ++j, ++count) sum += detection.gray->levels.at(i, j);
    }
    return sum / std::max(1, count);
}

// Points in the frame that the page names, relative to an origin of whole metres, so that floats are exact enough.
class PagePoints {
public:
    explicit PagePoints(const Scan& scan) : tables_(scan), beams_(scan.beams()) {
        if (scan.placement) placed_.emplace(scan);
    }
    [[nodiscard]] Eigen::Vector3d local(std::size_t k) const { return place(k, tables_.point(k)); }
    [[nodiscard]] Eigen::Vector3d sensor() const { return place(0, tables_.sensor()); }
    [[nodiscard]] Eigen::Vector3d origin() const { return placed_ ? placed_->originEnhM() : Eigen::Vector3d::Zero().eval(); }

private:
    [[nodiscard]] Eigen::Vector3d place(std::size_t k, const Eigen::Vector3d& point) const {
        if (!placed_) return point;
        return placed_->local(static_cast<int>(k / static_cast<std::size_t>(beams_)),
                              static_cast<int>(k % static_cast<std::size_t>(beams_)), point);
    }
    CartesianTables tables_;
    std::optional<PlacedPoints> placed_;
    int beams_;
};

template <class Number>
void append(std::string& bytes, Number value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Taking every n-th element would follow the lines of the grid; multiples of the golden ratio are distributed evenly.
bool isChosen(std::size_t number, std::size_t most, std::size_t of) {
    constexpr double kGolden = 0.61803398874989485;
    if (of <= most) return true;
    const double turn = static_cast<double>(number) * kGolden;
    return turn - std::floor(turn) < static_cast<double>(most) / static_cast<double>(of);
}

constexpr double kNearestM = 0.05; // of what the camera sees

struct Camera {
    Eigen::Vector3d eye, right, up, forward;
    double focal = 1;                                 ///< pixels per unit of tangent
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< tangents at the middle of the picture

    /// Of a point in front of it; `d`: from the eye.
    [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& d, int width, int height) const {
        const Eigen::Vector2d tangents = Eigen::Vector2d(d.dot(right), d.dot(up)) / d.dot(forward) - middle;
        return {width / 2.0 + focal * tangents.x(), height / 2.0 - focal * tangents.y()};
    }
};

// The interval of all values, or without the hundredth part at each end where those few would make it much larger.
std::pair<double, double> mostOf(std::vector<double>& values) {
    constexpr double kOutside = 0.01, kMuchLarger = 1.5;
    const auto [least, most] = std::ranges::minmax(values);
    const double low = quantile(values, kOutside), high = quantile(values, 1.0 - kOutside);
    return most - least <= kMuchLarger * (high - low) ? std::pair(least, most) : std::pair(low, high);
}

// Almost all points are in the picture; a few far ones may be outside.
void frame(Camera& camera, const std::vector<Eigen::Vector3d>& points, int width, int height) {
    constexpr double kFilled = 0.94;
    std::vector<double> across, up;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d d = point - camera.eye;
        const double z = d.dot(camera.forward);
        if (z <= kNearestM) continue;
        across.push_back(d.dot(camera.right) / z);
        up.push_back(d.dot(camera.up) / z);
    }
    camera.focal = width;
    if (across.empty()) return;
    const auto [left, right] = mostOf(across);
    const auto [low, high] = mostOf(up);
    camera.middle = {(left + right) / 2, (low + high) / 2};
    camera.focal = kFilled / std::max({(right - left) / width, (high - low) / height, 2e-3 / width});
}

Camera cameraFor(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& sensor, int width, int height) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) sum += point;
    const Eigen::Vector3d middle = sum / static_cast<double>(std::max<std::size_t>(1, points.size()));
    const double far = std::max(0.1, (middle - sensor).norm());
    Camera camera;
    camera.forward = (middle - sensor).norm() > 1e-6 ? (middle - sensor).normalized() : Eigen::Vector3d::UnitY().eval();
    const Eigen::Vector3d above = std::abs(camera.forward.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    camera.right = camera.forward.cross(above).normalized();
    camera.up = camera.right.cross(camera.forward);
    // to the side of the beams' own line of sight
    camera.eye = sensor - camera.forward * far * 1.2 + (camera.right * 0.35 + camera.up * 0.25) * far;
    camera.forward = (middle - camera.eye).normalized();
    camera.right = camera.forward.cross(camera.up).normalized();
    camera.up = camera.right.cross(camera.forward);
    frame(camera, points, width, height);
    return camera;
}

} // namespace

std::string pictureNumbers(int width, int height, const std::vector<PictureNumber>& numbers, std::size_t& leftOut,
                           const std::vector<PictureLine>& lines) {
    const double unit = std::max(width, height) * kPartOfSide;
    std::string html = "<svg class=\"numbers\" style=\"--unit:" + fixedText(unit, 2) + "px\" viewBox=\"0 0 " + std::to_string(width) + " " +
                       std::to_string(height) + "\" aria-hidden=\"true\">\n";
    for (const PictureLine& line : lines)
        html += "<line x1=\"" + fixedText(line.fromX, 1) + "\" y1=\"" + fixedText(line.fromY, 1) + "\" x2=\"" + fixedText(line.toX, 1) +
                "\" y2=\"" + fixedText(line.toY, 1) + "\" stroke=\"#78beff\" stroke-width=\"" + fixedText(kLineWidth * unit, 2) + "\"/>\n";
    std::vector<Box> placed;
    leftOut = 0;
    for (const PictureNumber& each : numbers) {
        Box box{each.x, each.dot ? each.y - unit : each.y, (0.5 * kDigitWidth * static_cast<double>(each.text.size()) + kRim) * unit,
                (0.5 + kRim) * unit};
        if (each.dot && box.y < box.halfHeight) box.y = each.y + unit;                            // below its dot
        box.x = std::clamp(box.x, box.halfWidth, std::max(box.halfWidth, width - box.halfWidth)); // whole in the picture
        box.y = std::clamp(box.y, box.halfHeight, std::max(box.halfHeight, height - box.halfHeight));
        if (!each.always && std::ranges::any_of(placed, [&](const Box& other) { return other.covers(box); })) {
            ++leftOut;
            continue;
        }
        placed.push_back(box);
        if (each.dot)
            html += "<circle cx=\"" + fixedText(each.x, 1) + "\" cy=\"" + fixedText(each.y, 1) + "\" r=\"" + fixedText(kDot * unit, 2) +
                    "\" fill=\"#fff\"/>\n";
        html += "<text x=\"" + fixedText(box.x, 1) + "\" y=\"" + fixedText(box.y, 1) + "\"" + (each.always ? "" : " class=\"small\"") +
                ">" + htmlText(each.text) + "</text>\n";
    }
    return html + "</svg>\n";
}

std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers, const std::string& caption,
                           const char* kind) {
    return std::string("<figure class=\"") + kind + "\"><div class=\"numbered\">" + htmlImage(png, alternative) + numbers +
           "</div><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string grayPicture(const edges::Detection& detection, int mostPixels) {
    const auto picture = reduced<std::uint8_t>(detection, mostPixels,
                                               [&](const Block& block) { return static_cast<std::uint8_t>(meanLevel(detection, block)); });
    const auto bytes = containers::png8Bytes(picture, "report");
    return bytes ? *bytes : std::string();
}

std::string edgePicture(const edges::Detection& detection, int mostPixels) {
    const auto picture = reduced<Rgb>(detection, mostPixels, [&](const Block& block) {
        for (int i = block.lines[0]; i < block.lines[1]; ++i) {
            for (int j = block.beams[0]; j < block.beams[1]; ++j) {
                if (detection.mask->at(i, j) != 0)
                    return edgeColour(detection, static_cast<std::size_t>(i) * static_cast<std::size_t>(detection.scan->beams()) +
                                                     static_cast<std::size_t>(j));
            }
        }
        const auto level = static_cast<std::uint8_t>(meanLevel(detection, block) * 2 / 5);
        return Rgb{level, level, level};
    });
    const auto bytes = containers::pngRgbBytes(picture, "report");
    return bytes ? *bytes : std::string();
}

std::string rockPicture(const edges::Detection& detection, const rocks::Faces& faces, int mostPixels) {
    const auto picture = reduced<Rgb>(detection, mostPixels, [&](const Block& block) {
        if (const auto face = faces.at(block.lines[0], block.beams[0])) return *face;
        const auto level = static_cast<std::uint8_t>(meanLevel(detection, block) * 3 / 5);
        return Rgb{level, level, level};
    });
    const auto bytes = containers::pngRgbBytes(picture, "report");
    return bytes ? *bytes : std::string();
}

CloudPicture cloudPicture(const edges::Detection& detection, int width, int height, const rocks::Faces* faces,
                          const std::vector<std::size_t>& wanted) {
    const PagePoints place(*detection.scan);
    std::vector<Eigen::Vector3d> points;
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k < detection.scan->cells(); ++k) {
        if (detection.scan->state[k] != CellState::Valid) continue;
        points.push_back(place.local(k));
        cells.push_back(k);
    }
    const Camera camera = cameraFor(points, place.sensor(), width, height);
    Grid<Rgb> picture(height, width, Rgb{23, 25, 27});
    Grid<float> depth(height, width, std::numeric_limits<float>::infinity());
    constexpr int kSplat = 3; // pixels
    double depthSum = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        const Eigen::Vector3d d = points[n] - camera.eye;
        const double z = d.dot(camera.forward);
        if (!(z > kNearestM)) continue;
        depthSum += z;
        const Eigen::Vector2d at = camera.pixel(d, width, height);
        const int x = static_cast<int>(std::floor(at.x()));
        const int y = static_cast<int>(std::floor(at.y()));
        const bool edge = faces == nullptr && (*detection.mask)[cells[n]] != 0;
        const auto level = static_cast<std::uint8_t>(60 + detection.gray->levels[cells[n]] * 3 / 5);
        const auto beams = static_cast<std::size_t>(detection.scan->beams());
        const auto face =
            faces == nullptr ? std::nullopt : faces->at(static_cast<int>(cells[n] / beams), static_cast<int>(cells[n] % beams));
        const Rgb colour = edge ? edgeColour(detection, cells[n]) : face.value_or(Rgb{level, level, level});
        const auto nearer = static_cast<float>(edge ? z * 0.995 : z); // an edge is not hidden by its own surface
        for (int dy = 0; dy < kSplat; ++dy) {
            for (int dx = 0; dx < kSplat; ++dx) {
                if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height || depth.at(y + dy, x + dx) <= nearer) continue;
                depth.at(y + dy, x + dx) = nearer;
                picture.at(y + dy, x + dx) = colour;
            }
        }
    }
    const auto bytes = containers::pngRgbBytes(picture, "report");
    const double middle = points.empty() ? 1 : std::max(0.1, depthSum / static_cast<double>(points.size()));
    CloudPicture made{bytes ? *bytes : std::string(), camera.focal / middle, {}};
    for (const std::size_t k : wanted) {
        const Eigen::Vector3d d = place.local(k) - camera.eye;
        const Eigen::Vector2d at = camera.pixel(d, width, height);
        const bool inside = d.dot(camera.forward) > kNearestM && at.x() >= 0 && at.x() < width && at.y() >= 0 && at.y() < height;
        made.places.push_back(inside ? std::optional(at) : std::nullopt);
    }
    return made;
}

ViewPoints viewPoints(const edges::Detection& detection, std::size_t mostPoints, std::size_t mostEdges, const rocks::Faces* faces) {
    const Scan& scan = *detection.scan;
    ViewPoints view;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) ++((*detection.mask)[k] != 0 ? view.edgesOf : view.pointsOf);
    }
    const PagePoints place(scan);
    const Eigen::Vector3d origin = place.origin(), sensor = place.sensor();
    std::copy(origin.data(), origin.data() + 3, view.originM);
    std::copy(sensor.data(), sensor.data() + 3, view.sensorM);
    std::size_t edges = 0, points = 0; // counted so far
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const bool edge = (*detection.mask)[k] != 0;
        if (!(edge ? isChosen(edges++, mostEdges, view.edgesOf) : isChosen(points++, mostPoints, view.pointsOf))) continue;
        const Eigen::Vector3d point = place.local(k);
        if (!point.allFinite() || (edge ? view.edges >= mostEdges : view.points >= mostPoints)) continue;
        ++(edge ? view.edges : view.points);
        for (int axis = 0; axis < 3; ++axis) append(view.positions, static_cast<float>(point[axis]));
        append(view.ranges, scan.rangeMm[k]);
        append(view.cells, static_cast<std::uint32_t>(k));
        const int kind = !edge ? 0 : 1 + (detection.classes ? static_cast<int>((*detection.classes)[k]) : 0);
        append(view.classes, static_cast<std::uint8_t>(kind));
        append(view.levels, detection.gray->levels[k]);
        if (faces != nullptr) append(view.rocks, static_cast<std::uint16_t>(faces->labels[k] <= UINT16_MAX ? faces->labels[k] : 0));
        ++view.count;
    }
    return view;
}

} // namespace edgescan::exports
