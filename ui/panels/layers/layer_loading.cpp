// Reads a layer and finds its place.
#include "ui/panels/layers/layer_loading.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/cartesian.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/demo_scan.h"

#include <algorithm>
#include <new>
#include <utility>

namespace edgescan::ui {
namespace {

// Points, normals, state and order of a cloud are 21 bytes per cell; placing holds three copies of the points in double and a tree.
constexpr std::uint64_t kBytesToDraw = 50, kBytesToPlace = 130; // per cell
constexpr std::size_t kPairsTaken = 2000;
constexpr double kMostBentM = 0.01;

Result<Scan> readScan(const inspect::SessionScan& scan, const std::function<bool(const char*, double)>& progress) {
    if (!inspect::hasPath(scan.kind)) return demoScan(progress, scan.kind == inspect::SessionScan::Kind::DemoAfterBlast);
    ReadingOptions options = scan.reading;
    options.progress = progress;
    return files::openAsAsked(scan.path, options);
}

/// One transform of the whole layer: a base that moved while the scan was taken has one per line.
Result<inspect::LayerPlace> rigidPlace(const inspect::Station& station) {
    const CartesianTables own(*station.placed.scan);
    std::vector<inspect::PointPair> pairs;
    const std::size_t cells = station.placed.pointsM.size();
    for (std::size_t k = 0; k < cells; k += std::max<std::size_t>(1, cells / kPairsTaken)) {
        const Eigen::Vector3d there = station.placed.pointsM[k], here = own.point(k);
        if (there.allFinite() && here.allFinite()) pairs.push_back({there, here});
    }
    const auto transform = inspect::transformOfPairs(pairs);
    if (!transform) return transform.error();
    inspect::LayerPlace place{*transform, station.by, std::nullopt, station.pairsM, station.warnings};
    if (station.corrected) place.residualM = station.fit->residualM;
    const bool bent =
        std::ranges::any_of(pairs, [&](const auto& pair) { return (*transform * pair.otherM - pair.firstM).norm() > kMostBentM; });
    if (bent)
        place.warnings.push_back("OUT OF SPEC: the base moved while \"" + station.placed.scan->name +
                                 "\" was taken: one place fits it badly.");
    return place;
}

Result<inspect::LayerPlace> placeOf(const std::shared_ptr<const Scan>& scan, const LayerAsked& asked) {
    const std::uint64_t cells = sumOf({asked.shown->cells(), scan->cells()});
    if (auto enough = checkMemory(productOf({cells, kBytesToPlace}), scan->path); !enough) return enough.error();
    auto station = inspect::stationOf(asked.shown, scan, {asked.pairs, true});
    if (!station) return station.error();
    auto place = rigidPlace(*station);
    if (place) place->toFirst = asked.placeOfShown * place->toFirst;
    return place;
}

} // namespace

std::uint64_t bytesOf(const CloudGeometry& cloud) {
    std::uint64_t bytes = sizeof(float) * (cloud.xyz.capacity() + cloud.normals.capacity()) + cloud.valid.capacity();
    for (const auto& part : cloud.drawOrder) bytes += sizeof(std::uint32_t) * part.capacity();
    return bytes + sizeof(CloudTile) * cloud.tiles.capacity();
}

Result<LoadedLayer> loadLayer(const LayerAsked& asked, const Asker& asker) {
    const BindInputs inputs;
    const std::string path = asked.layer.scan.path.string();
    try {
        auto read = readScan(asked.layer.scan, [&](const char* stage, double fraction) { return asked.show(asker, stage, fraction); });
        if (!read) return read.error();
        const auto scan = std::make_shared<const Scan>(std::move(*read));
        LoadedLayer loaded{asked.layer, nullptr, inputs.claims(), std::nullopt};
        const inspect::NotebookScan now = inspect::notebookScan(*scan);
        const inspect::NotebookScan& before = asked.layer.scan.identity;
        if (!before.sha256.empty() && !isSameContent(before, now))
            return Error{"the layer has another content than when it was placed", path, "remove it and add it again"};
        loaded.layer.scan.identity = now;
        if (auto enough = checkMemory(productOf({scan->cells(), kBytesToDraw}), path); !enough) return enough.error();
        loaded.cloud = makeCloudGeometry(*scan);
        if (loaded.layer.place && asked.pairs.empty()) return loaded;
        if (!asked.show(asker, "placing the points", 0.0)) return Error{"cancelled", path, ""};
        auto place = placeOf(scan, asked);
        loaded.layer.place = place ? std::optional(std::move(*place)) : std::nullopt;
        if (!place) loaded.trouble = place.error();
        return loaded;
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for this layer", path, "hide or remove other layers, or choose a smaller scan"};
    }
}

} // namespace edgescan::ui
