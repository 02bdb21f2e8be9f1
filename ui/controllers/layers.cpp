// Adds, places, shows and activates layers.
#include "ui/controllers/layers.h"

#include "core/base/memory.h"
#include "core/inspect/registration/scan_alignment.h"
#include "core/scan/grid/cartesian.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/engine/worker_bridge/works.h"
#include "ui/panels/layers/layers_panel.h"
#include "ui/panels/rocks/rock_colours.h"
#include "ui/views/cloud/cloud_view.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

const QColor kActiveColour(121, 121, 121); // of the cloud under edges

/// Neighbours in the list differ; the last colour of rocks is too near to the gray of the active cloud.
QColor colourOf(std::size_t place) { return rockColour(place % (rocks::kRockColourCount - 1)); }

bool isSameFile(const inspect::SessionScan& a, const inspect::SessionScan& b) {
    return a.kind == b.kind && a.path == b.path && a.reading.scanIndex == b.reading.scanIndex;
}

/// The layer of the scan that is shown; by content if its file was renamed.
template <class List, class Of>
auto findShown(List& list, const std::optional<inspect::SessionScan>& shown, Of of) {
    const auto found = [&](auto is) { return std::ranges::find_if(list, [&](const auto& each) { return shown && is(of(each)); }); };
    const auto same = found([&](const inspect::SessionScan& each) { return inspect::isSame(each.identity, shown->identity); });
    if (same != std::end(list)) return same;
    return found(
        [&](const inspect::SessionScan& each) { return each.path != shown->path && isSameContent(each.identity, shown->identity); });
}

QString nameOf(const inspect::SessionScan& scan) {
    if (!inspect::hasPath(scan.kind))
        return scan.kind == inspect::SessionScan::Kind::Demo ? Layers::tr("the demo") : Layers::tr("the demo after the blast");
    const QString file = shownName(exactText(scan.path.filename().string()), 40);
    return scan.reading.scanIndex ? Layers::tr("%1, scan %2").arg(file).arg(*scan.reading.scanIndex + 1) : file;
}

QString millimetres(double metres) { return QString::number(1000.0 * metres, 'f', 1); }

QString placeWords(const inspect::LayerPlace& place) {
    QString words;
    if (place.toFirst == RigidTransform{})
        words = Layers::tr("the first: the others are placed against it");
    else if (place.residualM)
        words = (*place.residualM > inspect::kMostResidualM ? Layers::tr("OUT OF SPEC, residual %1 mm")
                                                            : Layers::tr("registered, residual %1 mm"))
                    .arg(millimetres(*place.residualM));
    else if (place.pairsM)
        words = Layers::tr("placed by targets, %1 mm apart").arg(millimetres(*place.pairsM));
    else
        words = Layers::tr("placed by pose");
    return place.warnings.empty() ? words : QString("▲ ") + words;
}

QString warningText(const inspect::LayerPlace& place) {
    QStringList sentences;
    for (const std::string& warning : place.warnings) sentences << coreSentence(warning);
    return sentences.join('\n');
}

} // namespace

Layers::Layers(Engine& engine, LinkedViews& views, Files& files, Targets& targets, LayersPanel& panel, NoticeBar& notice,
               Preferences& preferences, QUndoStack& undo)
    : engine_(engine), views_(views), files_(files), targets_(targets), panel_(panel), notice_(notice), preferences_(preferences),
      undo_(undo), loader_(
                       Urgency::Soon, [](const LayerAsked& asked, const Asker& asker) { return loadLayer(asked, asker); },
                       [this](const LayerAsked& asked, const std::shared_ptr<const Loaded>& loaded) { finishLoading(asked, *loaded); },
                       [this](const QString& what) {
                           work_.reset();
                           notice_.showNotice(NoticeBar::Kind::Error, tr("The layer could not be read (%1).").arg(what));
                       }) {
    connect(&panel_, &LayersPanel::addRequested, this, &Layers::ask);
    connect(&panel_, &LayersPanel::visibleRequested, this, &Layers::setVisible);
    connect(&panel_, &LayersPanel::activeRequested, this, &Layers::activate);
    connect(&panel_, &LayersPanel::removeRequested, this, &Layers::remove);
    connect(&panel_, &LayersPanel::targetsRequested, this, &Layers::placeByTargets);
    connect(&panel_, &LayersPanel::locateRequested, this, [this](int layer) {
        const QString path = Files::askScan(notice_.window(), tr("Where is the layer now?"), preferences_);
        if (!path.isEmpty()) locate(layer, path);
    });
    connect(&views_.cloud(), &CloudView::layerClicked, this, [this](int drawn) {
        const int layer = drawn_[static_cast<std::size_t>(drawn)];
        notice_.showNotice(NoticeBar::Kind::Warning, tr("This point is of the layer %1: make it active to measure in it.")
                                                         .arg(nameOf(layers_[static_cast<std::size_t>(layer)].layer.scan)));
        notice_.offer(tr("Make Active"), [this, layer] { activate(layer); });
    });
}

const Scan* Layers::shownScan() const { return engine_.picture() ? engine_.picture()->detection->scan.get() : nullptr; }

bool Layers::isActive(const Held& held) const { return active_ && inspect::isSame(held.layer.scan.identity, *active_); }

Layers::Held* Layers::of(const inspect::SessionScan& scan) {
    const auto found = std::ranges::find_if(layers_, [&](const Held& held) { return isSameFile(held.layer.scan, scan); });
    return found == layers_.end() ? nullptr : &*found;
}

/// Null for the active layer, which has to stay.
Layers::Held* Layers::other(int layer) {
    if (layer < 0 || layer >= static_cast<int>(layers_.size())) return nullptr;
    Held& held = layers_[static_cast<std::size_t>(layer)];
    return isActive(held) ? nullptr : &held;
}

std::vector<inspect::Layer> Layers::part() const {
    std::vector<inspect::Layer> layers;
    for (const Held& held : layers_) layers.push_back(held.layer);
    return layers;
}

void Layers::setPart(const std::vector<inspect::Layer>& part) { (void)use(part); }

void Layers::change(const QString& what, std::vector<inspect::Layer> after) {
    auto* step = new UndoStep<std::vector<inspect::Layer>>(what, part(), std::move(after),
                                                           [this](const std::vector<inspect::Layer>& layers) { return use(layers); });
    step->giveWayIn(undo_);
    undo_.push(step);
}

/// False: the scan on the screen is not one of them.
bool Layers::use(const std::vector<inspect::Layer>& layers) {
    const Scan* scan = shownScan();
    const auto shown = scan != nullptr ? files_.scanShown(*scan) : std::nullopt;
    const auto isShown = findShown(layers, shown, [](const inspect::Layer& layer) -> const inspect::SessionScan& { return layer.scan; });
    if (!layers.empty() && isShown == layers.end()) return false;
    std::vector<Held> next;
    for (const inspect::Layer& layer : layers) {
        Held held{layer};
        if (const Held* before = of(layer.scan)) {
            held = *before;
            held.layer.visible = layer.visible;
        }
        next.push_back(std::move(held));
    }
    layers_ = std::move(next);
    loader_.giveUp();
    work_.reset();
    if (layers_.empty()) active_.reset();
    followPicture();
    show();
    emit changed();
    return true;
}

void Layers::followPicture() {
    if (layers_.empty() || !engine_.picture()) return;
    const Picture& picture = *engine_.picture();
    const std::shared_ptr<const Scan>& scan = picture.detection->scan;
    const auto scanShown = files_.scanShown(*scan);
    const auto shown = findShown(layers_, scanShown, [](const Held& held) -> const inspect::SessionScan& { return held.layer.scan; });
    if (shown == layers_.end()) return (void)use({}); // another place: the layers are in the session of their scans
    const inspect::NotebookScan now = scanShown->identity;
    const bool readAgain = active_ && inspect::isSame(*active_, now) && activeScan_.lock() != scan;
    if (active_ && !inspect::isSame(*active_, now)) notice_.hide();
    active_ = now;
    activeScan_ = scan;
    shown->layer.scan = *scanShown; // its file may have moved, or is read in another way
    shown->cloud = picture.cloud;
    shown->trouble.clear();
    if (readAgain) placeAgain();
    show();
    loadNext();
}

/// The pose or the angles of the active scan changed.
void Layers::placeAgain() {
    for (Held& held : layers_) {
        if (isActive(held) || (held.layer.place && held.layer.place->by == inspect::StationBasis::Pairs)) continue;
        held.layer.place.reset();
        held.cloud = nullptr;
        held.trouble.clear();
    }
}

void Layers::ask() {
    if (shownScan() == nullptr) return add({});
    add(Files::askScans(notice_.window(), tr("Add scans as layers"), preferences_));
}

void Layers::add(const QStringList& paths) {
    const Scan* shown = shownScan();
    const auto first = shown != nullptr ? files_.scanShown(*shown) : std::nullopt;
    if (!first || engine_.picture()->source.growth.growing)
        return notice_.showHint(tr("Layers are scans of files: open the first one, or record the sweep and open its recording."));
    if (paths.isEmpty()) return;
    std::vector<inspect::Layer> after = part();
    if (after.empty()) after.push_back({*first, true, inspect::LayerPlace{}});
    for (const QString& path : paths) {
        ReadingOptions reading = files_.options();
        reading.scanIndex.reset();
        reading.pose.clear(); // it is that of the scan on the screen
        inspect::Layer layer{inspect::fileScan(exactBytes(path), reading), true, std::nullopt};
        for (const inspect::Layer& other : after) {
            const std::size_t next = other.scan.reading.scanIndex.value_or(0) + 1;
            if (other.scan.path == layer.scan.path) layer.scan.reading.scanIndex = std::max(next, layer.scan.reading.scanIndex.value_or(0));
        }
        after.push_back(std::move(layer));
    }
    if (after.size() > inspect::kMostLayers)
        return notice_.showHint(tr("A cloud has at most %1 layers: remove some first.").arg(inspect::kMostLayers));
    change(stepName("Add a Layer"), std::move(after));
}

void Layers::remove(int layer) {
    if (other(layer) == nullptr) return;
    std::vector<inspect::Layer> after = part();
    after.erase(after.begin() + layer);
    if (after.size() == 1) after.clear();
    change(stepName("Remove the Layer"), std::move(after));
}

void Layers::setVisible(int layer, bool on) {
    if (other(layer) == nullptr) return;
    std::vector<inspect::Layer> after = part();
    after[static_cast<std::size_t>(layer)].visible = on;
    change(on ? stepName("Show the Layer") : stepName("Hide the Layer"), std::move(after));
}

void Layers::locate(int layer, const QString& path) {
    if (other(layer) == nullptr) return;
    std::vector<inspect::Layer> after = part();
    after[static_cast<std::size_t>(layer)].scan.path = exactBytes(absolutePath(path));
    change(stepName("Locate the Layer"), std::move(after));
}

void Layers::activate(int layer) {
    const Held* held = other(layer);
    if (held == nullptr || held->cloud == nullptr) return;
    files_.openAgain(inspect::SessionScan(held->layer.scan));
}

std::map<int, inspect::PointPair> Layers::targetsInBoth(const Held& held) const {
    std::map<int, inspect::PointPair> pairs;
    const auto there = targets_.notebookOf(held.layer.scan.identity);
    if (!there || !held.cloud) return pairs;
    for (const inspect::PinnedTarget& target : targets_.notebook().targets) {
        const auto same = std::ranges::find(there->targets, target.number, &inspect::PinnedTarget::number);
        if (same == there->targets.end() || !held.cloud->drawable(same->cell)) continue;
        const Eigen::Vector3d here = pointOfCell(*shownScan(), target.cell);
        if (here.allFinite()) pairs[target.number] = {here, held.cloud->point(same->cell).cast<double>() + held.cloud->originM};
    }
    return pairs;
}

void Layers::placeByTargets(int layer) {
    Held* held = other(layer);
    if (held == nullptr || !held->cloud || loader_.behind()) return;
    std::vector<inspect::PointPair> pairs;
    for (const auto& [number, places] : targetsInBoth(*held)) pairs.push_back(places);
    if (pairs.size() < 3)
        return notice_.showNotice(
            NoticeBar::Kind::Warning,
            tr("Three places are needed that both scans show: pin them here as targets 1, 2 and 3, make %1 active, pin "
               "the same places there in the same order, and come back.")
                .arg(nameOf(held->layer.scan)));
    held->layer.place.reset();
    held->trouble.clear();
    show();
    load(static_cast<std::size_t>(layer), pairs);
}

/// The first one that is not read, or has no place although it could have one.
void Layers::loadNext(const std::vector<inspect::PointPair>& pairs) {
    if (loader_.behind()) return;
    const auto active = std::ranges::find_if(layers_, [this](const Held& held) { return isActive(held); });
    if (active == layers_.end()) return;
    for (std::size_t n = 0; n < layers_.size(); ++n) {
        const Held& held = layers_[n];
        const bool wanted = !held.cloud || (!held.layer.place && active->layer.place);
        if (!isActive(held) && held.trouble.isEmpty() && wanted) return load(n, pairs);
    }
}

void Layers::load(std::size_t layer, const std::vector<inspect::PointPair>& pairs) {
    const auto active = std::ranges::find_if(layers_, [this](const Held& held) { return isActive(held); });
    const inspect::LayerPlace place = active->layer.place.value_or(inspect::LayerPlace{});
    work_ = engine_.works().start(tr("Reading the layer %1").arg(nameOf(layers_[layer].layer.scan)), [this, layer] {
        loader_.giveUp();
        work_.reset();
        layers_[layer].trouble = tr("Cancelled");
        show();
        loadNext();
    });
    const auto progress = [this](const Asker& asker, const char* stage, double fraction) {
        return asker.show([this, stage, fraction] {
            if (work_) work_->progress(stageWords(stage), fraction);
        });
    };
    loader_.ask({layers_[layer].layer, pairs, active->layer.place ? engine_.picture()->detection->scan : nullptr, place.toFirst, progress});
}

void Layers::finishLoading(const LayerAsked& asked, const Loaded& loaded) {
    work_.reset();
    if (Held* held = of(asked.layer.scan)) {
        const QString twiceWords = tr("The same scan is a layer already: remove one of the two.");
        if (!loaded) {
            // A file that was added again has no further scan.
            const bool again = std::ranges::any_of(
                layers_, [&](const Held& each) { return &each != held && each.layer.scan.path == held->layer.scan.path; });
            held->trouble = again ? twiceWords : coreSentence(loaded.error().sentence());
        } else {
            const bool twice = std::ranges::any_of(layers_, [&](const Held& each) {
                return &each != held && inspect::isSame(each.layer.scan.identity, loaded->layer.scan.identity);
            });
            held->layer.scan.identity = loaded->layer.scan.identity;
            held->layer.place = loaded->layer.place;
            held->cloud = loaded->cloud;
            held->inputs = loaded->inputs;
            if (loaded->trouble) held->trouble = coreSentence(loaded->trouble->sentence());
            if (twice) {
                held->layer.scan.identity = {};
                held->cloud = nullptr;
                held->trouble = twiceWords;
            }
        }
        const QString warnings = held->layer.place ? warningText(*held->layer.place) : QString();
        if (!held->trouble.isEmpty() || !warnings.isEmpty())
            notice_.showNotice(NoticeBar::Kind::Warning, tr("Layer %1: %2").arg(nameOf(held->layer.scan), held->trouble + warnings));
    }
    show();
    emit changed();
    loadNext();
}

void Layers::show() {
    const auto active = std::ranges::find_if(layers_, [this](const Held& held) { return isActive(held); });
    const bool placed = active != layers_.end() && active->layer.place;
    std::vector<CloudLayer> clouds;
    std::vector<LayerLine> lines;
    drawn_.clear();
    for (std::size_t n = 0; n < layers_.size(); ++n) {
        const Held& held = layers_[n];
        LayerLine line{nameOf(held.layer.scan), {}, exactText(held.layer.scan.path.string()), colourOf(n), held.layer.visible};
        line.missing = !held.cloud && !held.trouble.isEmpty();
        line.active = isActive(held);
        if (held.cloud)
            line.tip +=
                '\n' + tr("%1 points · %2 of memory").arg(countText(held.cloud->validCount)).arg(shownText(sizeText(bytesOf(*held.cloud))));
        if (line.active) line.colour = kActiveColour;
        if (line.active)
            line.words = held.layer.place ? tr("active") : tr("▲ active, not placed");
        else if (!held.trouble.isEmpty())
            line.words = held.cloud ? tr("▲ not placed") : tr("▲ not read");
        else if (!held.cloud || (!held.layer.place && placed))
            line.words = tr("being read");
        else if (!held.layer.place || !placed)
            line.words = tr("▲ not placed against the active one");
        else
            line.words = placeWords(*held.layer.place);
        if (!held.trouble.isEmpty()) line.tip += '\n' + held.trouble;
        if (held.layer.place && placed && held.layer.place->by == inspect::StationBasis::Pairs) {
            const RigidTransform toActive = inverse(active->layer.place->toFirst) * held.layer.place->toFirst;
            for (const auto& [number, places] : targetsInBoth(held))
                line.tip +=
                    '\n' + tr("Target %1: %2 mm apart").arg(number).arg(millimetres((places.firstM - toActive * places.otherM).norm()));
        }
        if (held.layer.place && !held.layer.place->warnings.empty()) line.tip += '\n' + warningText(*held.layer.place);
        lines.push_back(line);
        if (line.active || !held.layer.visible || !held.cloud || !held.layer.place || !placed) continue;
        clouds.push_back({held.cloud, inverse(active->layer.place->toFirst) * held.layer.place->toFirst, line.colour});
        drawn_.push_back(static_cast<int>(n));
    }
    views_.cloud().setLayers(std::move(clouds));
    panel_.showLayers(lines);
    emit shownChanged(!layers_.empty());
}

} // namespace edgescan::ui

#include "moc_layers.cpp"
