// The one bridge between the window and the core's threads.
#include "ui/engine/worker_bridge/engine.h"

#include "core/base/stop.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/every_nth.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/demo_scan.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/works.h"

#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kLeastStep = 3;
constexpr double kMostCells = 2.0e6; // about: what is read, placed and drawn in a fraction of a second

int stepFor(std::size_t cells) {
    return std::max(kLeastStep, static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells) / kMostCells))));
}

Error outOfMemory(const QString& where) {
    return {"there is not enough memory for this scan", exactBytes(where), "close other programs or open a smaller scan"};
}

QString itFailed(const QString& title, const QString& what) {
    return Engine::tr("%1: it failed (%2); close other programs or use a smaller scan.").arg(title, what);
}

constexpr double kReadingShare = 0.6; // of the time of an opening
constexpr auto kBetweenProgress = std::chrono::milliseconds(40);

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

Engine::Engine(QObject* parent)
    : QObject(parent), borders_(
                           Urgency::Soon, [this](const std::weak_ptr<const Picture>& of) { return workOutBorders(of.lock()); },
                           [this](const std::weak_ptr<const Picture>& of, const std::shared_ptr<const Picture>& made) {
                               if (of.lock() != picture_) return;
                               bordered_ = made;
                               emit borderedReady();
                           },
                           [](const QString&) {}), // they stay as they are
      // While a slider moves, older pictures are shown as well; the picture before stays when it fails, and OpenCV reports a lack of memory
      // in its own words.
      pictures_(
          Urgency::Now, [this](const Asked& asked, const Asker& asker) { return run(asked, asker); },
          [this](const Asked&, const std::shared_ptr<const Picture>& newest) { storePicture(newest); },
          [this](const QString& what) {
              const bool arriving = arriving_.has_value();
              dropArrival();
              if (arriving && !opening()) endOpening();
              emit failed(tr("the edges could not be computed (%1); close other programs or open a smaller scan.").arg(what));
          },
          Older::Delivered),
      opener_(
          Urgency::Soon, [this](const Opening& opening, const Asker& asker) { return read(opening, asker); },
          [this](const Opening& opening, const std::shared_ptr<const Opened>& opened) { finishOpening(opening.path, *opened); },
          [](const QString&) {}) {
    constexpr int kReplacingAfterMs = 300;
    replacingTimer_.setSingleShot(true);
    replacingTimer_.setInterval(kReplacingAfterMs);
    connect(&replacingTimer_, &QTimer::timeout, this, [this] {
        replacing_ = picture_ != nullptr;
        if (replacing_) emit replacingChanged(true);
    });
}

void Engine::open(const QString& path, const ReadingOptions& options) {
    const std::string file = exactBytes(path);
    startOpening(tr("Opening %1").arg(QFileInfo(path).fileName()), path, [file, options](const Progress& progress) {
        ReadingOptions withProgress = options;
        withProgress.progress = progress;
        auto scan = files::openAsAsked(file, withProgress);
        if (!scan) return scan;
        if (auto enough = edges::checkMemoryFor(edges::Work::Detect, *scan); !enough) return Result<Scan>(enough.error());
        return scan;
    });
}

void Engine::openDemo(bool afterBlast) {
    startOpening(tr("Making the demo draw-bell"), QString(),
                 [afterBlast](const Progress& progress) { return demoScan(progress, afterBlast); });
}

void Engine::cancel() {
    if (!opening()) return;
    opener_.giveUp();
    dropArrival();
    endOpening();
}

/// Back to the scan on the screen.
void Engine::dropArrival() {
    if (!arriving_) return;
    arriving_.reset();
    setCoarse(nullptr);
    pictures_.giveUp();
    asked_.scan = picture_ ? picture_->detection->scan : nullptr;
    asked_.source = picture_ ? picture_->source : PictureSource{};
    if (behind()) pictures_.ask(asked_);
}

void Engine::endOpening() {
    openingWork_.reset();
    replacingTimer_.stop();
    if (std::exchange(replacing_, false)) emit replacingChanged(false);
    endWork();
}

std::uint64_t Engine::newStream() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

void Engine::follow(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    cancel();
    post(scan, source);
}

void Engine::setCoarse(const std::shared_ptr<const CoarsePicture>& coarse) {
    if (std::exchange(coarse_, coarse) != coarse) emit coarseChanged();
}

void Engine::post(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    asked_.scan = scan;
    asked_.source = source;
    asked_.coarseFirst = arriving_ && !picture_ && scan->cells() > coarseAbove_;
    pictures_.ask(asked_);
}

void Engine::setSettings(const edges::Settings& settings) {
    if (settings == asked_.settings) return;
    asked_.settings = settings;
    if (asked_.scan) pictures_.ask(asked_);
    emit settingsChanged();
}

bool Engine::behind() const {
    if (asked_.scan == nullptr) return false;
    return picture_ == nullptr || picture_->detection->scan != asked_.scan || !(picture_->asked == asked_.settings) ||
           !(picture_->source == asked_.source);
}

void Engine::setPlacePending(bool on) {
    if (std::exchange(placePending_, on) != on) emit placePendingChanged();
}

void Engine::save(exports::ExportContent what, const QString& path, const std::optional<exports::ExportOptions>& options) {
    if (picture_ == nullptr) return;
    const auto detection = picture_->detection;
    exports::ExportOptions how = options.value_or(exports::ExportOptions{});
    if (!options) how.frame = files::usualFrame(*detection->scan, exactBytes(path));
    const QString title = tr("Saving %1").arg(QFileInfo(path).fileName());
    ++savings_;
    emit workStarted(title);
    emit workProgressed(tr("writing"), 0.0);
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    const auto work = std::make_shared<std::unique_ptr<Works::Running>>();
    *work = works_.start(title, [stop, work] {
        *stop = true;
        if (*work) (*work)->progress(tr("being cancelled"), 1.0);
    });
    (*work)->progress(tr("writing"), 0.0);
    const auto write = [this, what, detection, path, how, stop] {
        const BindStop bound(*stop);
        Result<exports::Written> written{exports::Written{}};
        try {
            written = exports::exportWithProvenance(what, *detection, exactBytes(path), how);
        } catch (const std::bad_alloc&) {
            written = outOfMemory(path);
        }
        return [this, what, written, path] {
            const auto coordinates =
                written && written->coordinates ? shownText(exports::coordinatesText(*written->coordinates)) : QString();
            if (written)
                emit saved(what, path, static_cast<qint64>(written->count), coordinates);
            else
                emit failed(shownText(written.error().sentence()));
        };
    };
    inBackground(
        this, write, [this, title](const QString& failure) { emit failed(itFailed(title, failure)); },
        [this, work] {
            work->reset();
            --savings_;
            endWork();
        });
}

void Engine::endWork() {
    if (!working()) emit workEnded();
}

void Engine::startOpening(const QString& title, const QString& path, std::function<Result<Scan>(const Progress&)> read) {
    dropArrival();
    if (!replacing_) replacingTimer_.start();
    openingWork_ = works_.start(title, [this] { cancel(); });
    emit workStarted(title);
    opener_.ask({path, std::move(read)});
}

Engine::Opened Engine::read(const Opening& opening, const Asker& asker) {
    std::string lastStage;
    std::chrono::steady_clock::time_point lastShown;
    const Progress progress = [&](const char* stage, double fraction) {
        const auto now = std::chrono::steady_clock::now();
        if (stage == lastStage && now - lastShown < kBetweenProgress) return asker.waits();
        lastStage = stage;
        lastShown = now;
        return asker.show([this, stage, fraction] {
            if (openingWork_) openingWork_->progress(stageWords(stage), kReadingShare * fraction);
            emit workProgressed(stageWords(stage), fraction);
        });
    };
    const BindInputs inputs;
    try {
        Result<Scan> scan = opening.read(progress);
        if (!scan) return {scan.error(), nullptr};
        return {std::make_shared<const Scan>(std::move(*scan)), inputs.claims()};
    } catch (const std::bad_alloc&) {
        return {outOfMemory(opening.path), nullptr};
    } catch (const std::exception& failure) {
        return {Error{"it could not be opened (" + std::string(failure.what()) + ")", exactBytes(opening.path),
                      "close other programs or use a smaller scan"},
                nullptr};
    }
}

void Engine::finishOpening(const QString& path, const Opened& opened) {
    if (opened.scan) {
        const std::uint64_t stream = newStream();
        arriving_ = Arrival{path, stream, opened.inputs};
        return post(*opened.scan, {stream, {}});
    }
    emit failed(shownText(opened.scan.error().sentence()));
    emit refused(path);
    endOpening();
}

std::shared_ptr<const Picture> Engine::run(const Asked& asked, const Asker& asker) {
    const auto show = [&](const char* stage, double fraction) {
        asker.show([this, stage, fraction, stream = asked.source.stream] {
            if (!arriving_ || arriving_->stream != stream) return;
            if (openingWork_) openingWork_->progress(stageWords(stage), kReadingShare + (1.0 - kReadingShare) * fraction);
            emit workProgressed(stageWords(stage), fraction);
        });
    };
    std::vector<std::shared_ptr<const Picture>> retired;
    KnownBorders known;
    {
        const std::lock_guard lock(poolMutex_);
        retired.swap(retired_);
        known = knownBorders_;
    }
    retired.clear();
    if (cloudScan_ != asked.scan) {
        show("placing the points", 0.0);
        cloud_ = nullptr;
        cloudScan_ = nullptr;
        if (asked.coarseFirst) {
            asker.show([this, coarse = makeCoarsePicture(*asked.scan, asked.settings), stream = asked.source.stream] {
                if (!picture_ && !coarse_ && arriving_ && arriving_->stream == stream) setCoarse(coarse);
            });
        }
        cloud_ = makeCloudGeometry(*asked.scan);
        cloudScan_ = asked.scan;
    }
    const PictureSource& source = asked.source;
    if (source.stream != lastSource_.stream || source.growth.sweep != lastSource_.growth.sweep) window_.nextSweep();
    lastSource_ = source;
    try {
        show("finding edges", 0.2);
        const auto detection = pipeline_.run(asked.scan, source.growth.growing ? window_.fix(*asked.scan, asked.settings) : asked.settings);
        show("drawing", 0.9);
        return lastMade_ = makePicture(detection, source, asked.settings, cloud_, lastMade_, known);
    } catch (...) { // an interrupted computation starts again from the beginning
        pipeline_ = edges::Pipeline();
        throw;
    }
}

std::shared_ptr<const Picture> Engine::workOutBorders(const std::shared_ptr<const Picture>& picture) {
    if (!picture) return nullptr;
    auto made = withBorders(picture);
    const std::lock_guard lock(poolMutex_);
    knownBorders_ = knownBordersOf(*made);
    return made;
}

void Engine::storePicture(const std::shared_ptr<const Picture>& newest) {
    const bool arrives = arriving_ && newest->source.stream == arriving_->stream;
    if (arrives) {
        inputs_ = arriving_->inputs;
        coarse_ = nullptr; // the views replace it by the picture
        const QString path = std::exchange(arriving_, std::nullopt)->path;
        emit opened(path);
    }
    std::shared_ptr<const Picture> last = std::exchange(picture_, newest);
    bordered_ = nullptr;
    if (newest->detection->borders) borders_.ask(newest);
    emit pictureReady();
    if (!last || last->source.stream != picture_->source.stream) emit streamChanged();
    if (arrives && !opening()) endOpening();
    // The picture is no longer shown. The pool's thread frees it, because freeing so much memory after every line takes time.
    if (!last || !last->source.growth.growing) return;
    const std::lock_guard lock(poolMutex_);
    retired_.push_back(std::move(last));
}

} // namespace edgescan::ui

#include "moc_engine.cpp"
