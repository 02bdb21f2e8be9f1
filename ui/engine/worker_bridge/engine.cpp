// The one bridge between the window and the core's threads.
#include "ui/engine/worker_bridge/engine.h"

#include "core/edges/pipeline/work_memory.h"
#include "core/exports/provenance/provenance.h"
#include "core/files/open_save/open_as_asked.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/demo_scan.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <QFileInfo>
#include <QMetaObject>

#include <chrono>
#include <new>
#include <utility>

namespace edgescan::ui {
namespace {

Error outOfMemory(const QString& where) {
    return {"there is not enough memory for this scan", where.toStdString(), "close other programs or open a smaller scan"};
}

QString itFailed(const QString& title, const QString& what) {
    return Engine::tr("%1: it failed (%2); close other programs or use a smaller scan.").arg(title, what);
}

constexpr auto kBetweenProgress = std::chrono::milliseconds(40);

} // namespace

Engine::Engine(QObject* parent)
    : QObject(parent),
      worker_(
          this, [this](const Asked& asked) { return run(asked); },
          [this](std::shared_ptr<const Picture> newest) { takePicture(std::move(newest)); },
          // The previous picture stays on the screen; OpenCV reports a lack of memory in its own words.
          [this](const QString& what) {
              emit failed(tr("the edges could not be computed (%1); close other programs or open a smaller scan.").arg(what));
          }),
      opener_(
          this, [this](const Opening& opening) { return read(opening); }, [this](const Opened& opened) { takeOpened(opened); },
          [](const QString&) {}) {}

Engine::~Engine() { cancel(); }

void Engine::open(const QString& path, const ReadingOptions& options) {
    const std::string file = path.toStdString();
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

void Engine::cancel() { wantedOpening_ = 0; }

std::uint64_t Engine::newStream() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

void Engine::follow(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    cancel();
    post(scan, source);
}

void Engine::post(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    asked_.scan = scan;
    asked_.source = source;
    worker_.post(asked_);
}

void Engine::setSettings(const edges::Settings& settings) {
    if (settings == asked_.settings) return;
    asked_.settings = settings;
    if (asked_.scan) worker_.post(asked_);
    emit settingsChanged();
}

bool Engine::behind() const {
    if (asked_.scan == nullptr) return false;
    return picture_ == nullptr || picture_->detection->scan != asked_.scan || !(picture_->asked == asked_.settings) ||
           !(picture_->source == asked_.source);
}

void Engine::save(exports::ExportContent what, const QString& path, const std::optional<exports::ExportOptions>& options) {
    if (picture_ == nullptr) return;
    const auto detection = picture_->detection;
    exports::ExportOptions how = options.value_or(exports::ExportOptions{});
    if (!options) how.frame = usualFrame(*detection->scan);
    const QString title = tr("Saving %1").arg(QFileInfo(path).fileName());
    ++savings_;
    emit workStarted(title);
    emit workProgressed(tr("writing"), 0.0);
    const auto write = [this, what, detection, path, how] {
        Result<std::size_t> written{std::size_t{0}};
        try {
            written = exports::exportWithProvenance(what, *detection, path.toStdString(), how);
        } catch (const std::bad_alloc&) {
            written = outOfMemory(path);
        }
        return [this, what, written, path] {
            if (written)
                emit saved(what, path, static_cast<qint64>(*written));
            else
                emit failed(shownText(written.error().sentence()));
        };
    };
    inBackground(
        this, write, [this, title](const QString& failure) { emit failed(itFailed(title, failure)); },
        [this] {
            --savings_;
            endWork();
        });
}

void Engine::endWork() {
    if (!working()) emit workEnded();
}

void Engine::startOpening(const QString& title, const QString& path, std::function<Result<Scan>(const Progress&)> read) {
    wantedOpening_ = ++openings_;
    opening_ = true;
    emit workStarted(title);
    opener_.post({openings_, path, std::move(read)});
}

Engine::Opened Engine::read(const Opening& opening) {
    const auto wanted = [this, &opening] { return wantedOpening_ == opening.number; };
    const Error givenUp{"cancelled", opening.path.toStdString(), ""};
    if (!wanted()) return {opening.number, opening.path, givenUp, nullptr};
    std::string lastStage;
    std::chrono::steady_clock::time_point lastTold;
    const Progress progress = [&](const char* stage, double fraction) {
        const auto now = std::chrono::steady_clock::now();
        if (stage != lastStage || now - lastTold >= kBetweenProgress) {
            lastStage = stage;
            lastTold = now;
            const auto tell = [this, number = opening.number, stage = QString::fromUtf8(stage), fraction] {
                if (number == wantedOpening_) emit workProgressed(stage, fraction);
            };
            QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
        }
        return wanted();
    };
    const BindInputs inputs;
    try {
        Result<Scan> scan = opening.read(progress);
        if (!scan) return {opening.number, opening.path, scan.error(), nullptr};
        return {opening.number, opening.path, std::make_shared<const Scan>(std::move(*scan)), inputs.claims()};
    } catch (const std::bad_alloc&) {
        return {opening.number, opening.path, outOfMemory(opening.path), nullptr};
    } catch (const std::exception& failure) {
        return {opening.number, opening.path,
                Error{"it could not be opened (" + std::string(failure.what()) + ")", opening.path.toStdString(),
                      "close other programs or use a smaller scan"},
                nullptr};
    }
}

void Engine::takeOpened(const Opened& opened) {
    if (opened.number != openings_) return; // the newest one follows
    opening_ = false;
    if (opened.number == wantedOpening_) {
        if (opened.scan) {
            inputs_ = opened.inputs;
            post(*opened.scan, {newStream(), {}});
            emit this->opened(opened.path);
        } else {
            emit failed(shownText(opened.scan.error().sentence()));
        }
    }
    endWork();
}

std::shared_ptr<const Picture> Engine::run(const Asked& asked) {
    std::vector<std::shared_ptr<const Picture>> retired;
    {
        const std::lock_guard lock(retiredMutex_);
        retired.swap(retired_);
    }
    retired.clear();
    if (cloudScan_ != asked.scan) {
        cloud_ = nullptr;
        cloudScan_ = nullptr;
        cloud_ = makeCloudGeometry(*asked.scan);
        cloudScan_ = asked.scan;
    }
    const PictureSource& source = asked.source;
    if (source.stream != lastSource_.stream || source.growth.sweep != lastSource_.growth.sweep) window_.nextSweep();
    lastSource_ = source;
    try {
        const auto detection = pipeline_.run(asked.scan, source.growth.growing ? window_.fix(*asked.scan, asked.settings) : asked.settings);
        return lastMade_ = makePicture(detection, source, asked.settings, cloud_, lastMade_);
    } catch (...) { // an interrupted computation starts again from the beginning
        pipeline_ = edges::Pipeline();
        throw;
    }
}

void Engine::takePicture(std::shared_ptr<const Picture> newest) {
    std::shared_ptr<const Picture> last = std::exchange(picture_, std::move(newest));
    emit pictureReady();
    if (!last || last->source.stream != picture_->source.stream) emit streamChanged();
    // The picture is no longer shown. The worker's thread frees it, because freeing so much memory after every line takes time.
    if (!last || !last->source.growth.growing) return;
    const std::lock_guard lock(retiredMutex_);
    retired_.push_back(std::move(last));
}

} // namespace edgescan::ui
