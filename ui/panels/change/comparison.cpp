// Lists, images and colours of the changes.
#include "ui/panels/change/comparison.h"

#include "core/base/inputs.h"
#include "core/base/order_statistic.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/files/open_save/open_scan.h"
#include "core/inspect/change_detection/change_report.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/demo_scan.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/views/cloud/cloud_colours.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kFarthestM = 1.0;     // the same colour for all larger distances
constexpr int kDistanceSteps = 50;     // of the histogram
constexpr double kShareOfScale = 0.98; // of the points, within the scale of the colours
constexpr double kLeastScaleM = 0.02;
constexpr std::uint32_t kDimmed = 0xff545454U; // 84: the contrast of gained and lost edges to it is 3 : 1
const QColor kUnseenColour(200, 200, 200);

std::optional<ChangeRow> rowOf(inspect::EdgeChange change) {
    switch (change) {
    case inspect::EdgeChange::Gained:
        return ChangeRow::Gained;
    case inspect::EdgeChange::Lost:
        return ChangeRow::Lost;
    case inspect::EdgeChange::Unchanged:
        return ChangeRow::Unchanged;
    case inspect::EdgeChange::Unknown:
        return ChangeRow::Unseen;
    default:
        return std::nullopt;
    }
}

std::optional<ChangeRow> rowOf(inspect::RangeChange change) {
    if (change == inspect::RangeChange::Nearer) return ChangeRow::Nearer;
    if (change == inspect::RangeChange::Farther) return ChangeRow::Farther;
    return std::nullopt;
}

bool isOn(const ChangeRows& rows, std::optional<ChangeRow> row) { return row && rows[static_cast<std::size_t>(*row)]; }

EdgeCells cellsOf(const Comparison& made) {
    std::array<std::vector<std::uint32_t>, kEdgeClasses> lists;
    std::vector<std::uint32_t> all;
    const auto& cells = made.change.edges.cells;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const auto row = rowOf(cells[k]);
        if (!isOn(made.asked.rows, row)) continue;
        lists[static_cast<std::size_t>(*row)].push_back(static_cast<std::uint32_t>(k));
        all.push_back(static_cast<std::uint32_t>(k));
    }
    EdgeCells found{std::make_shared<const std::vector<std::uint32_t>>(std::move(all)), {}};
    for (std::size_t n = 0; n < lists.size(); ++n)
        found.byClass[n] = std::make_shared<const std::vector<std::uint32_t>>(std::move(lists[n]));
    return found;
}

QRgb* pixelsOf(QImage& image, int line) { return reinterpret_cast<QRgb*>(image.scanLine(line)); }

void paint(Comparison& made) {
    const Picture& now = *made.asked.now;
    const auto& edges = made.change.edges.cells;
    const auto& ranges = made.change.ranges.cells;
    auto map = std::make_shared<QImage>(now.edges->convertToFormat(QImage::Format_RGB32));
    auto overlay = std::make_shared<QImage>(now.edges->width(), now.edges->height(), QImage::Format_ARGB32_Premultiplied);
    overlay->fill(Qt::transparent);
    for (int line = 0; line < edges.lines; ++line) {
        QRgb* onMap = pixelsOf(*map, line);
        QRgb* over = pixelsOf(*overlay, line);
        for (int beam = 0; beam < edges.beams; ++beam) {
            const std::size_t k = edges.index(line, beam);
            if (now.detection->scan->state[k] == CellState::Valid) onMap[beam] = qRgb(0, 0, 0);
            if (ranges.size() != 0) {
                const auto row = rowOf(ranges[k]);
                // The direction of the hatch separates nearer from farther without colour.
                const bool stripe = (row == ChangeRow::Nearer ? line + beam : line - beam + edges.beams) % 4 == 0;
                const QColor colour = row ? changeColour(*row) : QColor();
                if (isOn(made.asked.rows, row))
                    over[beam] = qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), stripe ? 190 : 100));
            }
            if (const auto row = rowOf(edges[k]); isOn(made.asked.rows, row)) over[beam] = onMap[beam] = changeColour(*row).rgba();
        }
    }
    made.map = std::move(map);
    made.overlay = std::move(overlay);
}

std::uint32_t pointColour(const QColor& colour) {
    const auto half = [](int c) { return static_cast<std::uint32_t>((84 + c) / 2); };
    return 0xff000000U | half(colour.blue()) << 16U | half(colour.green()) << 8U | half(colour.red());
}

inspect::RegistrationRequest registrationOf(const ComparisonAsked& asked) {
    inspect::RegistrationRequest wish;
    if (asked.onePlace) wish.poses = std::array<RigidTransform, 2>{};
    wish.bySurfaces = asked.bySurfaces && onlyOneIsPlaced(asked);
    return wish;
}

/// Of the points of the current scan from those of A, after registration.
std::shared_ptr<const SurfaceDistances> distancesOf(const Comparison& made) {
    auto found = std::make_shared<SurfaceDistances>();
    const auto both = inspect::inOneFrame(made.asked.now->detection->scan, made.earlier->detection->scan, made.change.earlier.how,
                                          registrationOf(made.asked));
    found->metres = inspect::cloudDistances(both[0].pointsM, inspect::PointIndex(both[1].pointsM), kFarthestM);
    found->histogram = inspect::distanceHistogram(found->metres, kFarthestM, kDistanceSteps);
    std::vector<float> known;
    for (const float distance : found->metres) {
        if (!std::isnan(distance)) known.push_back(std::min(distance, static_cast<float>(kFarthestM)));
    }
    found->scaleM = known.empty() ? kFarthestM : std::max(kLeastScaleM, static_cast<double>(quantile(known, kShareOfScale)));
    return found;
}

std::uint32_t byteColour(QRgb colour) {
    return 0xff000000U | static_cast<std::uint32_t>(qBlue(colour)) << 16U | static_cast<std::uint32_t>(qGreen(colour)) << 8U |
           static_cast<std::uint32_t>(qRed(colour));
}

std::shared_ptr<const std::vector<std::uint32_t>> distanceColours(const SurfaceDistances& distances) {
    auto points = std::make_shared<std::vector<std::uint32_t>>(distances.metres.size(), kDimmed);
    for (std::size_t k = 0; k < points->size(); ++k) {
        const float distance = distances.metres[k];
        if (!std::isnan(distance)) (*points)[k] = byteColour(colourAt(std::min(1.0, static_cast<double>(distance) / distances.scaleM)));
    }
    return points;
}

std::shared_ptr<const std::vector<std::uint32_t>> pointsOf(const Comparison& made) {
    if (made.distances) return distanceColours(*made.distances);
    const auto& ranges = made.change.ranges.cells;
    auto points = std::make_shared<std::vector<std::uint32_t>>(made.asked.now->detection->scan->cells(), kDimmed);
    const std::uint32_t nearer = pointColour(changeColour(ChangeRow::Nearer)), farther = pointColour(changeColour(ChangeRow::Farther));
    for (std::size_t k = 0; k < ranges.size(); ++k) {
        const auto row = rowOf(ranges[k]);
        if (isOn(made.asked.rows, row)) (*points)[k] = row == ChangeRow::Nearer ? nearer : farther;
    }
    return points;
}

std::shared_ptr<const std::vector<std::uint32_t>> changedOf(const Comparison& made) {
    const auto& ranges = made.change.ranges.cells;
    auto changed = std::make_shared<std::vector<std::uint32_t>>(made.points->size(), 0U);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
        if (isOn(made.asked.rows, rowOf(ranges[k]))) (*changed)[k] = (*made.points)[k];
    }
    return changed;
}

/// The earlier picture if its cells match those of the later one; else a picture of its points on that grid.
std::shared_ptr<const Picture> beforeOf(const std::shared_ptr<const Picture>& before, const inspect::EarlierOnGrid& earlier) {
    if (earlier.how.sameCells) return before;
    const auto found = edges::detectEdges(earlier.scan, before->detection->settings);
    auto moved = std::make_shared<edges::Detection>(*found);
    moved->mask = earlier.edges;
    moved->classes = nullptr;
    std::vector<std::uint32_t> edges;
    for (std::size_t k = 0; k < earlier.edges->size(); ++k) {
        if ((*earlier.edges)[k] != 0) edges.push_back(static_cast<std::uint32_t>(k));
    }
    moved->edges = std::make_shared<const std::vector<std::uint32_t>>(std::move(edges));
    moved->borders = {};
    return makePicture(moved, {before->source.stream, {}}, before->asked, makeCloudGeometry(*earlier.scan), nullptr);
}

bool sameScans(const ComparisonAsked& asked, const Comparison& last) {
    return last.asked.before == asked.before && last.asked.now->detection->scan == asked.now->detection->scan;
}

std::shared_ptr<const Picture> bySettingsOfNow(const ComparisonAsked& asked, const Comparison* last) {
    const Picture& before = *asked.before;
    const edges::Settings& settings = asked.now->asked;
    if (before.detection->scan == asked.now->detection->scan || before.asked == settings) return asked.before;
    if (last != nullptr && last->asked.before == asked.before && last->earlier->asked == settings) return last->earlier;
    return makePicture(edges::detectEdges(before.detection->scan, settings), before.source, settings, before.cloud, nullptr);
}

} // namespace

const EdgeColours& changeColours() {
    static const EdgeColours colours{changeColour(ChangeRow::Gained), changeColour(ChangeRow::Lost), changeColour(ChangeRow::Unchanged),
                                     changeColour(ChangeRow::Unseen)};
    return colours;
}

QColor changeColour(ChangeRow row) {
    if (row == ChangeRow::Unchanged) return colourOf(inspect::kUnchangedColour);
    if (row == ChangeRow::Unseen) return kUnseenColour;
    return colourOf(row == ChangeRow::Gained || row == ChangeRow::Nearer ? inspect::kGainedColour : inspect::kLostColour);
}

std::size_t Comparison::count(ChangeRow row) const {
    const std::array<std::size_t, kChangeRows> counts{change.edges.gained,  change.edges.lost,    change.edges.unchanged,
                                                      change.edges.unknown, change.ranges.nearer, change.ranges.farther};
    return counts[static_cast<std::size_t>(row)];
}

bool onlyOneIsPlaced(const ComparisonAsked& asked) {
    const auto isPlaced = [](const Picture& picture) { return picture.detection->scan->placement != nullptr; };
    return isPlaced(*asked.before) != isPlaced(*asked.now);
}

Result<std::shared_ptr<const Comparison>> compared(const ComparisonAsked& asked, const Comparison* last) {
    auto made = std::make_shared<Comparison>();
    made->asked = asked;
    made->earlier = bySettingsOfNow(asked, last);
    const inspect::ScanEdges now{asked.now->detection->scan, asked.now->detection->mask};
    if (last != nullptr && sameScans(asked, *last) && last->earlier == made->earlier) {
        made->change = inspect::withEdges(last->change, now);
        made->before = last->before;
    } else {
        auto change = inspect::sceneChange(now, {made->earlier->detection->scan, made->earlier->detection->mask}, registrationOf(asked));
        if (!change) return change.error();
        made->change = std::move(*change);
        made->before = withBorders(beforeOf(made->earlier, made->change.earlier)); // drawn as B is
    }
    if (asked.byDistance && made->isOfTwoScans()) {
        const bool known = last != nullptr && last->distances && sameScans(asked, *last);
        made->distances = known ? last->distances : distancesOf(*made);
    }
    made->edges = cellsOf(*made);
    made->points = pointsOf(*made);
    made->changed = changedOf(*made);
    paint(*made);
    return std::shared_ptr<const Comparison>(std::move(made));
}

Result<std::shared_ptr<const Picture>> pictureOf(const std::shared_ptr<const Scan>& scan, const edges::Settings& settings) {
    try {
        if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
        return makePicture(edges::detectEdges(scan, settings), {Engine::newStream(), {}}, settings, makeCloudGeometry(*scan), nullptr);
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for a second picture", scan->path, "close other programs or choose a smaller scan"};
    }
}

Result<std::shared_ptr<const Picture>> earlierPicture(const QString& path, const ReadingOptions& reading, const edges::Settings& settings) {
    const BindInputs inputs;
    try {
        Result<Scan> scan = files::openAsAsked(exactBytes(path), reading);
        if (!scan) return scan.error();
        // No export replaces the scan's files while it is compared.
        const auto used = std::make_shared<const std::pair<Scan, std::shared_ptr<const InputClaims>>>(std::move(*scan), inputs.claims());
        return pictureOf(std::shared_ptr<const Scan>(used, &used->first), settings);
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for a second scan", exactBytes(path), "close other programs or choose a smaller one"};
    }
}

Result<std::shared_ptr<const Picture>> earlierDemo(bool afterBlast, const edges::Settings& settings) {
    Result<Scan> scan = demoScan([](const char*, double) { return true; }, afterBlast);
    if (!scan) return scan.error();
    return pictureOf(std::make_shared<const Scan>(std::move(*scan)), settings);
}

} // namespace edgescan::ui
