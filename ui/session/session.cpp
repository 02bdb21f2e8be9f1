// The one bridge between the window and the core's threads.
#include "ui/session/session.h"

#include "core/georef/placed_points.h"
#include "core/io/open_as_asked.h"
#include "core/report/provenance.h"
#include "ui/session/demo_scan.h"

#include <QFileInfo>
#include <QMetaObject>

#include <atomic>
#include <new>
#include <utility>

namespace edgescan::ui {
namespace {

Error outOfMemory(const QString& where) {
    return {"there is not enough memory for this scan", where.toStdString(), "close other programs or open a smaller scan"};
}

Result<std::shared_ptr<const Scan>> readScan(const std::function<Result<Scan>(const BackgroundJob::Progress&)>& work,
                                             const BackgroundJob::Progress& progress, const QString& path) {
    try {
        Result<Scan> scan = work(progress);
        if (!scan) return scan.error();
        return std::make_shared<const Scan>(std::move(*scan));
    } catch (const std::bad_alloc&) {
        return outOfMemory(path);
    }
}

} // namespace

Session::Session(QObject* parent)
    : QObject(parent), worker_([this](const Asked& asked) { return run(asked); },
                               [this] {
                                   // One event at a time: it takes whatever is newest when it arrives.
                                   if (told_.exchange(true)) return;
                                   QMetaObject::invokeMethod(
                                       this, [this] { takePicture(); }, Qt::QueuedConnection);
                               }) {}

Session::~Session() = default;

void Session::open(const QString& path, const ReadingOptions& options) {
    const std::string file = path.toStdString();
    startOpening(tr("Opening %1").arg(QFileInfo(path).fileName()), path, [file, options](const BackgroundJob::Progress& progress) {
        ReadingOptions withProgress = options;
        withProgress.progress = progress;
        return openAsAsked(file, withProgress);
    });
}

void Session::openDemo() {
    startOpening(tr("Making the demo draw-bell"), QString(), [](const BackgroundJob::Progress& progress) { return demoScan(progress); });
}

void Session::cancel() {
    if (opening_ != nullptr) opening_->cancel();
}

std::uint64_t Session::newStream() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

void Session::follow(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    cancel();
    post(scan, source);
}

void Session::post(const std::shared_ptr<const Scan>& scan, const PictureSource& source) {
    asked_.scan = scan;
    asked_.source = source;
    worker_.post(asked_);
}

void Session::setSettings(const Settings& settings) {
    if (settings == asked_.settings) return;
    asked_.settings = settings;
    if (asked_.scan) worker_.post(asked_);
    emit settingsChanged();
}

bool Session::behind() const {
    if (asked_.scan == nullptr) return false;
    return picture_ == nullptr || picture_->detection->scan != asked_.scan || !(picture_->asked == asked_.settings) ||
           !(picture_->source == asked_.source);
}

void Session::save(ExportContent what, const QString& path, const std::optional<ExportOptions>& options) {
    if (picture_ == nullptr) return;
    const auto detection = picture_->detection;
    ExportOptions how = options.value_or(ExportOptions{});
    if (!options) how.frame = usualFrame(*detection->scan);
    startJob(tr("Saving %1").arg(QFileInfo(path).fileName()), [this, what, detection, path, how](const BackgroundJob::Progress& progress) {
        progress("writing", 0.0);
        Result<std::size_t> written{std::size_t{0}};
        try {
            written = exportWithProvenance(what, *detection, path.toStdString(), how);
        } catch (const std::bad_alloc&) {
            written = outOfMemory(path);
        }
        return [this, what, written, path] {
            if (written)
                emit saved(what, path, static_cast<qint64>(*written));
            else
                emit failed(QString::fromStdString(written.error().sentence()));
        };
    });
}

void Session::startOpening(const QString& title, const QString& path, OpenWork work) {
    // Newest wins: the opening before this one delivers nothing.
    cancel();
    opening_ = startJob(title, [this, path, work = std::move(work)](const BackgroundJob::Progress& progress) -> std::function<void()> {
        const Result<std::shared_ptr<const Scan>> scan = readScan(work, progress, path);
        return [this, scan, path] {
            if (!scan) {
                emit failed(QString::fromStdString(scan.error().sentence()));
                return;
            }
            post(*scan, {newStream(), {}});
            emit opened(path);
        };
    });
}

BackgroundJob* Session::startJob(const QString& title, BackgroundJob::Work work) {
    auto* job = new BackgroundJob(std::move(work), this);
    connect(job, &BackgroundJob::progressed, this, [this, job](const QString& stage, double fraction) {
        if (!job->cancelled()) emit workProgressed(stage, fraction);
    });
    connect(job, &BackgroundJob::crashed, this, [this, title](const QString& what) {
        emit failed(tr("%1: it failed (%2); close other programs or use a smaller scan.").arg(title, what));
    });
    connect(job, &BackgroundJob::ended, this, [this, job] {
        if (opening_ == job) opening_ = nullptr;
        job->deleteLater();
        if (--jobs_ == 0) emit workEnded();
    });
    ++jobs_;
    emit workStarted(title);
    return job;
}

std::shared_ptr<const Picture> Session::run(const Asked& asked) {
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
    } catch (...) { // what is half done is begun anew
        pipeline_ = Pipeline();
        throw;
    }
}

void Session::takePicture() {
    told_ = false;
    // The picture before stays on the screen; OpenCV reports a lack of memory in its own words.
    if (const std::string failure = worker_.takeFailure(); !failure.empty())
        emit failed(
            tr("the edges could not be computed (%1); close other programs or open a smaller scan.").arg(QString::fromStdString(failure)));
    std::optional<std::shared_ptr<const Picture>> newest = worker_.take();
    if (!newest) return;
    std::shared_ptr<const Picture> last = std::exchange(picture_, std::move(*newest));
    emit pictureReady();
    if (!last || last->source.stream != picture_->source.stream) emit streamChanged();
    // Now that nothing shows it any more the worker's thread lets go of it: giving back so much memory, line after line, takes its time.
    if (!last || !last->source.growth.growing) return;
    const std::lock_guard lock(retiredMutex_);
    retired_.push_back(std::move(last));
}

} // namespace edgescan::ui
