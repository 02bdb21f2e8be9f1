// A live scanner on the GUI thread.
#include "ui/panels/live/scanner_link.h"

#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kLinkTickMs = 40;
constexpr qint64 kLeastMs = 100; // between two pictures of a growing sweep

/// The first sweep of a connection ended with too few lines although no gap ended it, and more of them are missing than were lost: the
/// scanner was in the middle of it when EdgeScan connected.
bool beganBefore(const scanner::SweepProgress& sweep) {
    const int before = sweep.expected - sweep.lines;
    return sweep.number == 0 && before > static_cast<int>(sweep.lost.size()) && sweep.irregular.count(scanner::Irregularity::Gap) == 0;
}

std::pair<int, int> orderOf(const scanner::SweepState& sweep) { return {sweep.progress.number, sweep.progress.lines}; }

} // namespace

ScannerLink::ScannerLink(Engine& engine, QObject* parent) : QObject(parent), engine_(engine) {
    timer_.setInterval(kLinkTickMs);
    connect(&timer_, &QTimer::timeout, this, &ScannerLink::tick);
    connect(&engine_, &Engine::failed, this, [this] { awaiting_ = false; });
    // The operator opened another file: the next scan line must not replace it.
    connect(&engine_, &Engine::opened, this, [this] {
        follow(false);
        held_.clear();
        emit otherChanged();
    });
}

ScannerLink::~ScannerLink() = default;

void ScannerLink::followPicture() {
    if (engine_.picture()->source.stream != stream_) return;
    if (std::exchange(awaiting_, false)) {
        if (engine_.picture()->detection->scan == posted_.scan) shown_ = posted_.progress;
        // After each picture the worker is free for the sliders for the time that the picture took.
        restMs_ = std::max(kLeastMs, 2 * sincePost_.elapsed());
    }
    if (feed_) return;
    shown_ = onScreen().progress; // it may have come back by Undo
    showStopped();
    emit otherChanged(); // which of them is on the screen has changed
}

void ScannerLink::runInThread(std::function<std::function<void()>()> work) {
    inBackground(this, std::move(work), [this](const QString& what) { emit failed(what); });
}

void ScannerLink::connectTo(const scanner::ConnectionSettings& scanner, const scanner::SweepSettings& sweep) {
    disconnectScanner();
    stream_ = Engine::newStream();
    recordingPath_.clear();
    recordingClosed_ = false;
    heldNumber_ = -1;
    heldAtStop_ = false;
    finished_.reset();
    newest_.reset();
    part_.reset();
    held_.clear();
    emit otherChanged();
    posted_ = {};
    awaiting_ = recordingErrorReported_ = false;
    restMs_ = 0;
    sincePost_.start();
    const auto news = news_;
    feed_ = std::make_shared<files::LiveFeed>(scanner, sweep, [news] { *news = true; });
    timer_.start();
    emit connectedChanged(true);
    setFollowing(true, false);
    tick();
}

std::optional<int> ScannerLink::useSweep(const scanner::SweepSettings& sweep) {
    const std::optional<int> gone = feed_ ? feed_->useSweep(sweep) : std::nullopt;
    if (!gone) return gone;
    heldNumber_ = -1; // the number of sweeps starts again
    finished_.reset();
    newest_.reset();
    part_.reset();
    posted_ = {};
    *news_ = true;
    setFollowing(true, false);
    return gone;
}

void ScannerLink::disconnectScanner() {
    if (!feed_) return;
    timer_.stop();
    const bool shows = following_;
    const std::optional<scanner::SweepState> newest = newest_;
    const std::uint64_t stream = stream_;
    const QString recorded = recording_ ? recordingPath_ : QString();
    const std::shared_ptr<files::LiveFeed> feed = std::exchange(feed_, nullptr);
    last_ = feed->status();
    last_.connection.phase = scanner::ConnectionPhase::Stopped;
    last_.recording.reset();
    last_.connection.sentence.clear(); // "... is sending." was so until now
    part_.reset();
    showStopped();
    runInThread([this, feed, shows, newest, stream, recorded]() -> std::function<void()> {
        feed->stop();
        const Result<files::RecordingState> closed = feed->stopRecording();
        std::vector<scanner::SweepState> sweeps = feed->popFinished();
        if (newest) sweeps.insert(sweeps.begin(), *newest);
        sweeps.push_back(feed->sweep());
        return [this, closed, sweeps, shows, stream, recorded] {
            if (!recorded.isEmpty() || !closed) reportRecorded(closed, recorded);
            // a file that is being opened meanwhile is wanted more
            if (stream == stream_ && !engine_.opening()) storeStopped(sweeps, shows);
        };
    });
    // A picture that was held while its sweep grew stays, but nothing grows any more.
    const auto& picture = engine_.picture();
    heldAtStop_ = !shows && picture && picture->source.stream == stream && picture->source.growth.growing;
    if (heldAtStop_ && !engine_.opening()) {
        PictureSource ended = picture->source;
        ended.growth.growing = false;
        engine_.follow(picture->detection->scan, ended);
    }
    if (std::exchange(recording_, false)) emit recordingChanged(false);
    if (std::exchange(following_, false)) emit followingChanged(false);
    emit connectedChanged(false);
    emit healthChanged();
}

/// `sweeps`: ascending, the newest last.
void ScannerLink::storeStopped(const std::vector<scanner::SweepState>& sweeps, bool shows) {
    const auto& picture = engine_.picture();
    const bool own = picture && picture->source.stream == stream_;
    if (!own && !shows) return;
    if (!shows) hold(onScreen());
    for (const scanner::SweepState& sweep : sweeps) hold(sweep);
    if (shows && sweeps.back().scan) return post(sweeps.back(), false);
    emit otherChanged();
}

/// The same lines of a sweep are held once.
void ScannerLink::hold(const scanner::SweepState& sweep) {
    const auto at = std::ranges::lower_bound(held_, orderOf(sweep), {}, orderOf);
    if (sweep.scan && (at == held_.end() || orderOf(*at) != orderOf(sweep))) held_.insert(at, sweep);
}

scanner::SweepState ScannerLink::onScreen() const {
    const Picture& picture = *engine_.picture();
    const std::shared_ptr<const Scan>& scan = picture.detection->scan;
    if (posted_.scan == scan) return posted_;
    const auto held = std::ranges::find(held_, scan, &scanner::SweepState::scan);
    if (held != held_.end()) return *held;
    scanner::SweepState other{scan, {}}; // by Undo
    other.progress.number = picture.source.growth.sweep;
    other.progress.expected = picture.source.growth.expectedLines;
    other.progress.lines = other.progress.received = scan->lines();
    return other;
}

std::vector<scanner::SweepState> ScannerLink::others() const {
    const auto& picture = engine_.picture();
    if (feed_ || !picture || picture->source.stream != stream_) return {};
    std::vector<scanner::SweepState> others = held_;
    std::erase_if(others, [shown = orderOf(onScreen())](const scanner::SweepState& each) { return orderOf(each) == shown; });
    return others;
}

void ScannerLink::follow(bool on) { setFollowing(on, on); }

void ScannerLink::setFollowing(bool on, bool throughEnds) {
    throughEnds_ = throughEnds;
    const bool wanted = on && feed_ != nullptr;
    if (wanted == following_) return;
    following_ = wanted;
    again_ = true;
    if (wanted) finished_.reset();
    emit followingChanged(following_);
    emit healthChanged();
}

/// The strip counts the sweep on the screen, not one after it.
void ScannerLink::showStopped() {
    const auto& picture = engine_.picture();
    scanner::SweepProgress ended = shown_;
    ended.growing = false;
    const bool own = picture && picture->source.stream == stream_;
    health_ = files::healthOf(last_, own ? picture->detection->scan->placement.get() : nullptr, own ? &ended : nullptr);
    health_.end.clear();
    emit healthChanged();
}

void ScannerLink::showOther(std::size_t place) {
    const std::vector<scanner::SweepState> others = this->others();
    if (place >= others.size() || awaiting_ || engine_.opening()) return;
    hold(onScreen());
    post(others[place], false);
}

bool ScannerLink::showsStale() const {
    const auto& picture = engine_.picture();
    return following_ && health_.stale() && picture && picture->source.stream == stream_;
}

void ScannerLink::tick() {
    if (!feed_) return;
    const files::LiveStatus status = feed_->status();
    noticeTroubles(status);
    const auto& picture = engine_.picture();
    const bool shown = picture && picture->source.stream == stream_;
    const bool grows = shown && following_ && picture->source.growth.growing && shown_.growing;
    files::LiveHealth now = files::healthOf(status, shown ? picture->detection->scan->placement.get() : nullptr, grows ? &shown_ : nullptr);
    const bool changed = !(now == health_);
    health_ = std::move(now);
    for (const scanner::FinishedSweep& sweep : feed_->popFinished()) {
        if (sweep.progress.number > heldNumber_) finished_ = sweep;
        newest_ = sweep;
    }
    showSweep();
    if (changed) emit healthChanged();
}

void ScannerLink::noticeTroubles(const files::LiveStatus& status) {
    if (!status.recording || !status.recording->problem || std::exchange(recordingErrorReported_, true)) return;
    emit failed(shownText(status.recording->problem->sentence()));
}

/// Shows the newest state of the sweep when the last picture is finished and the pause is over.
void ScannerLink::showSweep() {
    if (!following_ || engine_.opening() || (awaiting_ && engine_.behind()) || sincePost_.elapsed() < restMs_) return;
    if (finished_) return showFinal(*std::exchange(finished_, std::nullopt));
    if (!news_->exchange(false) && posted_.scan && !again_) return;
    const scanner::SweepState sweep = feed_->sweep();
    if (!sweep.scan || (sweep.scan == posted_.scan && !again_)) return;
    if (sweep.progress.growing)
        post(sweep, true);
    else if (sweep.progress.number > heldNumber_)
        showFinal(sweep);
    else
        post(sweep, false); // once more, because the operator chose to follow
}

void ScannerLink::showFinal(const scanner::SweepState& sweep) {
    heldNumber_ = sweep.progress.number;
    const bool part = beganBefore(sweep.progress);
    part_ = part ? std::optional(sweep.progress) : std::nullopt;
    post(sweep, false);
    if (holdAtEnd_ && !throughEnds_ && !part) setFollowing(false, false);
}

void ScannerLink::post(const scanner::SweepState& sweep, bool growing) {
    posted_ = sweep;
    again_ = false;
    awaiting_ = true;
    sincePost_.restart();
    engine_.follow(sweep.scan, {stream_, {sweep.progress.number, growing, sweep.progress.expected}});
}

void ScannerLink::startRecording(const QString& path) {
    if (!feed_ || recording_) return;
    recording_ = true;
    recordingPath_ = path;
    recordingClosed_ = false;
    recordingErrorReported_ = false;
    linesBefore_ = 0;
    runInThread([this, feed = feed_, path]() -> std::function<void()> {
        const Result<int> started = feed->startRecording(exactBytes(path));
        return [this, started, feed, path] {
            if (started && path == recordingPath_) linesBefore_ = *started;
            if (started) return;
            emit failed(shownText(started.error().sentence()));
            if (feed != feed_) return;
            recording_ = false;
            emit recordingChanged(false);
        };
    });
    emit recordingChanged(true);
}

void ScannerLink::stopRecording() {
    if (!feed_ || !recording_) return;
    recording_ = false;
    runInThread([this, feed = feed_, path = recordingPath_]() -> std::function<void()> {
        const Result<files::RecordingState> closed = feed->stopRecording();
        return [this, closed, path] { reportRecorded(closed, path); };
    });
    emit recordingChanged(false);
}

void ScannerLink::reportRecorded(const Result<files::RecordingState>& closed, const QString& path) {
    if (!closed) return emit failed(shownText(closed.error().sentence()));
    recordingClosed_ = recordingClosed_ || path == recordingPath_;
    if (closed->unsynced() == 0) return emit written(path, path == recordingPath_ ? linesBefore_ : 0);
    emit failed(tr("%1 is written, but the disk has not confirmed the last %2 kB: keep the power on until it is idle.")
                    .arg(path)
                    .arg(closed->unsynced() / 1000 + 1));
}

void ScannerLink::keepRecent(const QString& path) {
    if (!feed_) return;
    runInThread([this, feed = feed_, path]() -> std::function<void()> {
        const Result<Done> kept = feed->keepRecent(exactBytes(path));
        return [this, kept, path] {
            if (kept)
                emit written(path, 0);
            else
                emit failed(shownText(kept.error().sentence()));
        };
    });
}

} // namespace edgescan::ui

#include "moc_scanner_link.cpp"
