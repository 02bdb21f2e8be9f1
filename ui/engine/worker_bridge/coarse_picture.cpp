// Makes the first picture of a large scan.
#include "ui/engine/worker_bridge/coarse_picture.h"

#include "core/edges/gray/gray.h"
#include "core/scan/grid/every_nth.h"
#include "ui/engine/worker_bridge/picture.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kLeastStep = 3;
constexpr double kMostCells = 2.0e6; // about: what is read, placed and drawn in a fraction of a second

int stepFor(std::size_t cells) {
    return std::max(kLeastStep, static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells) / kMostCells))));
}

} // namespace

std::shared_ptr<const CoarsePicture> makeCoarsePicture(const Scan& scan, const edges::Settings& settings) {
    const auto some = std::make_shared<const Scan>(everyNth(scan, stepFor(scan.cells())));
    edges::Detection detection;
    detection.scan = some;
    detection.settings = settings;
    detection.gray = MadeWhenRead<edges::GrayImage>([some, settings] { return edges::grayImage(*some, settings); });
    auto coarse = std::make_shared<CoarsePicture>();
    coarse->cells = scan.cells();
    coarse->cloud = makeCloudGeometry(*some);
    coarse->gray = std::make_shared<const QImage>(grayPicture(detection, std::nullopt, some->lines()));
    coarse->detection = std::make_shared<const edges::Detection>(std::move(detection));
    return coarse;
}

} // namespace edgescan::ui
