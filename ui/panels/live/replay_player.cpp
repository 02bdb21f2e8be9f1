// Plays a recording off the GUI thread.
#include "ui/panels/live/replay_player.h"

#include "core/scan/grid/given_angles.h"
#include "ui/base/shown_text.h"

#include <QMetaObject>

#include <algorithm>
#include <new>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr std::size_t kMostStarts = 500; // copies of the state; a recording with more sweeps goes back several sweeps at a time

} // namespace

ReplayPlayer::ReplayPlayer(const std::filesystem::path& path, const ReadingOptions& options, QObject* parent)
    : QObject(parent), options_(options) {
    thread_ = std::thread([this, path] {
        try {
            work(path);
        } catch (const std::bad_alloc&) {
            const Error error{"there is not enough memory to play this recording", path.string(), "close other programs"};
            QMetaObject::invokeMethod(
                this, [this, text = shownText(error.sentence())] { emit refused(text); }, Qt::QueuedConnection);
        }
    });
}

ReplayPlayer::~ReplayPlayer() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

bool ReplayPlayer::stopping() const {
    const std::lock_guard lock(mutex_);
    return stop_;
}

void ReplayPlayer::seek(int line) {
    {
        const std::lock_guard lock(mutex_);
        wanted_ = line;
    }
    wake_.notify_one();
}

void ReplayPlayer::work(const std::filesystem::path& path) {
    const auto recording = files::Recording::open(path, [this] { return !stopping(); });
    if (!recording) {
        QMetaObject::invokeMethod(
            this, [this, text = shownText(recording.error().sentence())] { emit refused(text); }, Qt::QueuedConnection);
        return;
    }
    files::Replay replay(*recording, options_);
    const RecordingContents contents = survey(replay);
    QMetaObject::invokeMethod(
        this, [this, contents] { emit loaded(contents); }, Qt::QueuedConnection);
    while (true) {
        int line = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stop_ || wanted_; });
            if (stop_) return;
            line = *std::exchange(wanted_, std::nullopt);
        }
        const ReplayedSweep there = at(replay, line);
        QMetaObject::invokeMethod(
            this, [this, there] { emit arrived(there); }, Qt::QueuedConnection);
    }
}

/// Plays the whole recording once: finds the start of each sweep and copies the state there.
RecordingContents ReplayPlayer::survey(files::Replay& replay) {
    RecordingContents contents;
    for (int line = 0; line < replay.lines(); ++line) contents.lineNs.push_back(replay.timeNs(line));
    int number = -1;
    while (!stopping() && replay.step()) {
        const scanner::SweepProgress now = replay.progress();
        if (now.lines == 0 && now.number == number) continue;
        if (now.number != number) {
            if (contents.sweeps.empty()) contents.first = replay.position();
            number = now.number;
            contents.sweeps.push_back({replay.position() - std::max(now.lines, 1), 0});
            if (starts_.size() < kMostStarts) {
                static_cast<void>(replay.feed().assembler().popFinished());
                static_cast<void>(replay.snapshot()); // frees the previous sweep
                starts_.push_back(replay);
            }
        }
        contents.sweeps.back().received = now.received;
    }
    return contents;
}

ReplayedSweep ReplayPlayer::at(files::Replay& replay, int line) {
    if (line < replay.position()) {
        const auto behind = std::find_if(starts_.rbegin(), starts_.rend(), [line](const files::Replay& r) { return r.position() <= line; });
        if (behind != starts_.rend())
            replay = *behind;
        else
            replay.seek(0);
    }
    replay.seek(line);
    static_cast<void>(replay.feed().assembler().popFinished());
    ReplayedSweep there{replay.position(), {replay.snapshot(), replay.progress()}};
    if (there.sweep.scan) {
        auto scan = files::describedSweep(*there.sweep.scan, replay.recording(), std::string(), options_);
        if (scan) {
            applyGivenAngles(*scan, options_);
            there.sweep.scan = std::make_shared<const Scan>(std::move(*scan));
        }
    }
    return there;
}

} // namespace edgescan::ui

#include "moc_replay_player.cpp"
