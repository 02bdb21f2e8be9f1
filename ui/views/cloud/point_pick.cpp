// Finds the point under the cursor.
#include "ui/views/cloud/point_pick.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace edgescan::ui {
namespace {

using Eigen::Vector3f;
using Eigen::Vector4d;

// Neighbours on the same surface do not hide each other.
constexpr double kSameSurface = 0.005;

struct Window {
    double x0, y0, x1, y1;
};
struct Candidate {
    std::uint32_t cell;
    ScreenPoint at;
};

bool tileReaches(const ScreenView& view, const Box3f& box, const Window& window) {
    double x0 = std::numeric_limits<double>::infinity();
    double y0 = x0;
    double x1 = -x0;
    double y1 = -x0;
    int behind = 0;
    for (int i = 0; i < 8; ++i) {
        const Vector3f c = box.corner(static_cast<Box3f::CornerType>(i));
        const Vector4d clip = view.worldToClip * Vector4d(c.x(), c.y(), c.z(), 1.0);
        if (clip.w() <= 0.0) {
            ++behind;
            continue;
        }
        const double x = (clip.x() / clip.w() + 1.0) * 0.5 * view.width;
        const double y = (1.0 - clip.y() / clip.w()) * 0.5 * view.height;
        x0 = std::min(x0, x);
        x1 = std::max(x1, x);
        y0 = std::min(y0, y);
        y1 = std::max(y1, y);
    }
    if (behind == 8) return false;
    if (behind > 0) return true; // partly behind the camera: the projected corners are meaningless
    return x0 <= window.x1 && x1 >= window.x0 && y0 <= window.y1 && y1 >= window.y0;
}

void collect(const CloudGeometry& cloud, const ScreenView& view, const Window& window, std::size_t k, std::vector<Candidate>& out) {
    if (cloud.valid[k] == 0) return;
    const ScreenPoint p = toScreen(view, cloud.point(k));
    if (!p.inside || p.x < window.x0 || p.x > window.x1 || p.y < window.y0 || p.y > window.y1) return;
    out.push_back({static_cast<std::uint32_t>(k), p});
}

std::vector<Candidate> candidates(const CloudGeometry& cloud, const ScreenView& view, const Window& window) {
    std::vector<Candidate> out;
    for (const CloudTile& tile : cloud.tiles) {
        if (!tileReaches(view, tile.box, window)) continue;
        for (int line = tile.line0; line < tile.line1; ++line) {
            const std::size_t row = static_cast<std::size_t>(line) * static_cast<std::size_t>(cloud.beams);
            for (int beam = tile.beam0; beam < tile.beam1; ++beam) {
                collect(cloud, view, window, row + static_cast<std::size_t>(beam), out);
            }
        }
    }
    return out;
}

// Depths of a few pixels around the cursor. Every point is drawn as the same square as on the screen.
class DepthPatch {
public:
    DepthPatch(const Window& window, const std::vector<Candidate>& points, double pointSize)
        : left_(static_cast<int>(std::floor(window.x0))), top_(static_cast<int>(std::floor(window.y0))),
          width_(static_cast<int>(std::floor(window.x1)) - left_ + 1), height_(static_cast<int>(std::floor(window.y1)) - top_ + 1),
          depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), std::numeric_limits<double>::infinity()) {
        for (const Candidate& c : points) draw(c.at, 0.5 * pointSize);
    }
    [[nodiscard]] bool hides(const ScreenPoint& p) const {
        const int x = static_cast<int>(std::floor(p.x)) - left_;
        const int y = static_cast<int>(std::floor(p.y)) - top_;
        return depth_[index(x, y)] < p.depth - kSameSurface * std::abs(p.depth);
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    void draw(const ScreenPoint& p, double half) {
        // A point covers a pixel if the centre of the pixel is inside the point's square.
        const int x0 = std::max(0, static_cast<int>(std::ceil(p.x - half - 0.5)) - left_);
        const int x1 = std::min(width_ - 1, static_cast<int>(std::ceil(p.x + half - 0.5)) - 1 - left_);
        const int y0 = std::max(0, static_cast<int>(std::ceil(p.y - half - 0.5)) - top_);
        const int y1 = std::min(height_ - 1, static_cast<int>(std::ceil(p.y + half - 0.5)) - 1 - top_);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) depth_[index(x, y)] = std::min(depth_[index(x, y)], p.depth);
        }
    }

    int left_, top_, width_, height_;
    std::vector<double> depth_;
};

Window windowAround(double x, double y, double reach) { return {x - reach, y - reach, x + reach, y + reach}; }

std::optional<std::uint32_t> nearest(const std::vector<Candidate>& points, const Window& window, const ScreenView& view, double x, double y,
                                     double radius) {
    if (points.empty()) return std::nullopt;
    const DepthPatch patch(window, points, view.pointSize);
    std::optional<std::uint32_t> best;
    double bestDistance = radius * radius;
    double bestDepth = std::numeric_limits<double>::infinity();
    for (const Candidate& c : points) {
        const double d = (c.at.x - x) * (c.at.x - x) + (c.at.y - y) * (c.at.y - y);
        if (d > bestDistance || (d == bestDistance && c.at.depth >= bestDepth)) continue;
        if (patch.hides(c.at)) continue;
        best = c.cell;
        bestDistance = d;
        bestDepth = c.at.depth;
    }
    return best;
}

} // namespace

ScreenPoint toScreen(const ScreenView& view, const Vector3f& point) {
    const Vector4d clip = view.worldToClip * Vector4d(point.x(), point.y(), point.z(), 1.0);
    ScreenPoint out;
    const double w = clip.w();
    if (w <= 0.0) return out;
    out.inside = clip.z() >= -w && clip.z() <= w;
    out.x = (clip.x() / w + 1.0) * 0.5 * view.width;
    out.y = (1.0 - clip.y() / w) * 0.5 * view.height;
    const bool parallel = view.worldToClip.row(3).head<3>().isZero();
    // Parallel: from 1 (near) to 3 (far), so that a relative difference of depth is defined.
    out.depth = parallel ? clip.z() + 2.0 : w;
    return out;
}

std::optional<ScreenSegment> screenSegment(const ScreenView& view, const Vector3f& from, const Vector3f& to) {
    Vector4d a = view.worldToClip * Vector4d(from.x(), from.y(), from.z(), 1.0);
    Vector4d b = view.worldToClip * Vector4d(to.x(), to.y(), to.z(), 1.0);
    const double least = 1e-3 * std::max(std::abs(a.w()), std::abs(b.w()));
    if (a.w() < least && b.w() < least) return std::nullopt;
    if (a.w() < least) a += (b - a) * ((least - a.w()) / (b.w() - a.w()));
    if (b.w() < least) b += (a - b) * ((least - b.w()) / (a.w() - b.w()));
    const auto x = [&](const Vector4d& p) { return (p.x() / p.w() + 1.0) * 0.5 * view.width; };
    const auto y = [&](const Vector4d& p) { return (1.0 - p.y() / p.w()) * 0.5 * view.height; };
    return ScreenSegment{x(a), y(a), x(b), y(b)};
}

std::optional<std::uint32_t> pickPoint(const CloudGeometry& cloud, const ScreenView& view, double x, double y, double radius) {
    const Window window = windowAround(x, y, radius + view.pointSize);
    return nearest(candidates(cloud, view, window), window, view, x, y, radius);
}

std::optional<std::uint32_t> pickVoid(const CloudGeometry& cloud, const CartesianTables& tables, const ScreenView& view, double x, double y,
                                      double radius) {
    std::optional<std::uint32_t> best;
    double bestDistance = radius * radius;
    const auto rangeM = [&](std::size_t k) { return static_cast<double>((cloud.point(k) - cloud.sensor).norm()); };
    const auto look = [&](int line, int beam, double awayM) {
        const Vector3f point = cloud.sensor + (awayM * tables.direction(line, beam)).cast<float>();
        const ScreenPoint at = toScreen(view, point);
        const double d = (at.x - x) * (at.x - x) + (at.y - y) * (at.y - y);
        if (!at.inside || !(d < bestDistance)) return; // without a direction it has no place
        bestDistance = d;
        best = static_cast<std::uint32_t>(line * cloud.beams + beam);
    };
    for (int line = 0; line < cloud.lines; ++line) {
        const auto first = static_cast<std::size_t>(line) * static_cast<std::size_t>(cloud.beams);
        int before = -1; // the last beam with a point
        for (int beam = 0; beam <= cloud.beams; ++beam) {
            const bool isEnd = beam == cloud.beams;
            if (!isEnd && cloud.valid[first + static_cast<std::size_t>(beam)] == 0) continue;
            double awayM = std::numeric_limits<double>::infinity();
            if (before >= 0) awayM = rangeM(first + static_cast<std::size_t>(before));
            if (!isEnd) awayM = std::min(awayM, rangeM(first + static_cast<std::size_t>(beam)));
            for (int between = before + 1; between < beam && std::isfinite(awayM); ++between) look(line, between, awayM);
            before = beam;
        }
    }
    return best;
}

std::optional<std::uint32_t> pickDrawnOver(const CloudGeometry& cloud, const ScreenView& view, double x, double y, double half,
                                           std::span<const std::uint32_t> cells) {
    const Window window = windowAround(x, y, half + view.pointSize);
    const std::vector<Candidate> points = candidates(cloud, view, window);
    if (points.empty()) return std::nullopt;
    const DepthPatch patch(window, points, view.pointSize);
    std::optional<std::uint32_t> best;
    double least = half;
    for (const Candidate& c : points) {
        const double away = std::max(std::abs(c.at.x - x), std::abs(c.at.y - y));
        if (away > least || (best && away == least) || !std::ranges::binary_search(cells, c.cell) || patch.hides(c.at)) continue;
        best = c.cell;
        least = away;
    }
    return best;
}

std::optional<std::uint32_t> pickPointSlowly(const CloudGeometry& cloud, const ScreenView& view, double x, double y, double radius) {
    const Window window = windowAround(x, y, radius + view.pointSize);
    std::vector<Candidate> points;
    for (std::size_t k = 0; k < cloud.cells(); ++k) collect(cloud, view, window, k, points);
    return nearest(points, window, view, x, y, radius);
}

std::vector<std::uint32_t> pointsInside(const CloudGeometry& cloud, const ScreenView& view, const QPolygonF& corners) {
    const QRect place = corners.boundingRect().toAlignedRect().intersected(QRectF(0, 0, view.width, view.height).toAlignedRect());
    std::vector<std::uint32_t> inside;
    if (corners.size() < 3 || place.isEmpty()) return inside;
    QImage mask(place.size(), QImage::Format_Grayscale8); // a lasso has hundreds of corners: rasterised once, then looked up
    mask.fill(0);
    QPainter painter(&mask);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPolygon(corners.translated(-place.topLeft()), Qt::OddEvenFill);
    painter.end();
    // Points outside the polygon can hide points inside it.
    const double reach = view.pointSize + 1.0;
    const Window window{place.left() - reach, place.top() - reach, place.right() + 1 + reach, place.bottom() + 1 + reach};
    const std::vector<Candidate> points = candidates(cloud, view, window);
    const DepthPatch patch(window, points, view.pointSize);
    for (const Candidate& c : points) {
        const QPoint at(static_cast<int>(std::floor(c.at.x)) - place.left(), static_cast<int>(std::floor(c.at.y)) - place.top());
        if (mask.rect().contains(at) && *(mask.constScanLine(at.y()) + at.x()) != 0 && !patch.hides(c.at)) inside.push_back(c.cell);
    }
    std::sort(inside.begin(), inside.end());
    return inside;
}

bool isPointHidden(const CloudGeometry& cloud, const ScreenView& view, std::uint32_t cell) {
    if (!cloud.drawable(cell)) return false;
    const ScreenPoint p = toScreen(view, cloud.point(cell));
    if (!p.inside) return false;
    const Window window = windowAround(p.x, p.y, view.pointSize + 1.0);
    return DepthPatch(window, candidates(cloud, view, window), view.pointSize).hides(p);
}

} // namespace edgescan::ui
