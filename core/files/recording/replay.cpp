// Playing recordings.
#include "core/files/recording/replay.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/files/recording/recorded_grid.h"
#include "core/files/recording/recorded_robot.h"
#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/scanner/sweep_assembly/played_line.h"

#include <algorithm>
#include <limits>

namespace edgescan::files {
namespace {

/// Where the payload of a frame begins, to know a scan telegram without taking the frame apart.
bool isScanTelegram(const RecordedMessage& message) {
    if (message.topic != RecordingTopic::ColaRx || message.payload.size() < 2) return false;
    constexpr std::size_t kBinaryPayload = 8;
    const bool binary = message.payload.size() > kBinaryPayload && message.payload[1] == 2;
    return scanner::isScanTelegram(message.payload.subspan(binary ? kBinaryPayload : 1));
}

} // namespace

bool feedMessage(scanner::SweepFeed& feed, const RecordedMessage& message) {
    if (message.topic == RecordingTopic::ColaRx) return feed.frames(message.payload, message.logNs);
    if (message.topic != RecordingTopic::Stepper) return false;
    if (const auto reading = parseStepper(message.payload, message.logNs)) feed.assembler().push(*reading);
    return false;
}

namespace {

/// The user's word instead of a guess; over what a recording says itself it goes when the scan is opened.
void sayAssumed(scanner::SweepSettings& settings, const ReadingOptions& options) {
    if (options.axis) {
        if (settings.axisAssumed || settings.firstAssumed) settings.axis = *options.axis;
        settings.axisAssumed = false;
    }
    if (options.lineStepDeg) {
        if (settings.stepAssumed && settings.degPerLine) settings.degPerLine = options.lineStepDeg;
        settings.stepAssumed = false;
    }
    if (settings.firstAssumed && options.lineStartDeg) settings.firstLineDeg = *options.lineStartDeg;
    settings.firstAssumed = settings.firstAssumed && !options.lineStartDeg && (!options.axis || scanner::guessesFirst(settings));
}

} // namespace

Replay::Replay(std::shared_ptr<const Recording> recording, const ReadingOptions& options)
    : recording_(std::move(recording)), warnings_(recording_->warnings()), feed_(settings_) {
    scanner::SettingsFound found = scanner::settingsOf(recording_->metadata());
    settings_ = found.settings;
    sayAssumed(settings_, options);
    warnings_.insert(warnings_.end(), found.warnings.begin(), found.warnings.end());
    if (recording_->source() != nullptr) player_ = atBegin_ = recording_->source()->player(settings_, options);
    feed_ = scanner::SweepFeed(settings_);
    for (std::size_t i = 0; i < recording_->messages().size(); ++i) {
        if (isLine(recording_->messages()[i])) lineAt_.push_back(i);
    }
}

bool Replay::isLine(const RecordedMessage& message) const {
    if (message.topic == RecordingTopic::Bridge) return player_.has_value() && player_->isLine(message);
    return isScanTelegram(message);
}

std::int64_t Replay::timeNs(int line) const {
    if (lineAt_.empty()) return 0;
    const auto last = static_cast<int>(lineAt_.size()) - 1;
    return recording_->messages()[lineAt_[static_cast<std::size_t>(std::clamp(line, 0, last))]].logNs;
}

void Replay::playOne() {
    const std::size_t message = next_++;
    const RecordedMessage& played = recording_->messages()[message];
    if (played.topic != RecordingTopic::Bridge)
        feedMessage(feed_, played);
    else if (player_)
        player_->play(played, feed_.assembler());
    const auto line = static_cast<std::size_t>(position_);
    if (line < lineAt_.size() && lineAt_[line] == message) ++position_;
    if (atEnd()) feed_.assembler().finish();
}

bool Replay::step() {
    if (atEnd()) return false;
    seek(position_ + 1);
    return true;
}

void Replay::seek(int line) {
    if (line < position_) {
        feed_ = scanner::SweepFeed(settings_);
        player_ = atBegin_;
        next_ = 0;
        position_ = 0;
    }
    // The messages between this line and the next one (the stepper's report of it) belong to this line.
    const auto behind = static_cast<std::size_t>(std::max(line, 0));
    const std::size_t end = behind < lineAt_.size() ? lineAt_[behind] : recording_->messages().size();
    while (next_ < end) playOne();
}

Result<Scan> describedSweep(Scan sweep, const Recording& recording, const std::string& where, const ReadingOptions& options) {
    const scanner::SweepMetadata& metadata = recording.metadata();
    sweep.format = "recording";
    if (const auto note = metadata.find("note"); note != metadata.end()) sweep.note = note->second;
    if (recording.source() != nullptr) sweep.format = recording.source()->kind();
    if (metadata.contains(kMadeFromKey))
        sweep.acquisition.reset(); // telegrams made of another file: neither their times nor their sender are real
    else if (recording.source() == nullptr)
        nameScanner(sweep, recording);
    if (options.unitMm && *options.unitMm != sweep.unitMm)
        return Error{"--unit does not apply: the telegrams of a recording say their unit themselves", where, "leave --unit out"};
    auto whole = withRecordedGrid(std::move(sweep), metadata, where);
    if (!whole) return whole;
    if (options.axis) std::get<PolarGeometry>(whole->geometry).axis = *options.axis;
    if (auto placed = placeRecordedSweep(*whole, recording, options, where); !placed) return placed.error();
    return whole;
}

Result<Scan> scanOf(const std::shared_ptr<const Recording>& recording, const std::string& where, const ReadingOptions& options,
                    const LinePlayed& played) {
    Replay replay(recording, options);
    scanner::FinishedSweep best;
    int sweeps = 0;
    const auto collect = [&] {
        for (scanner::FinishedSweep& sweep : replay.feed().assembler().popFinished()) {
            const bool asked = options.scanIndex ? *options.scanIndex == static_cast<std::size_t>(sweeps)
                                                 : !best.scan || sweep.progress.received > best.progress.received;
            ++sweeps;
            if (asked) best = std::move(sweep);
        }
    };
    while (replay.step()) {
        collect();
        const int line = replay.position() - 1;
        if (played && line >= 0)
            played({line, replay.timeNs(line), line + 1 < replay.lines() ? replay.timeNs(line + 1) : 0, replay.progress()});
    }
    collect();
    const std::int64_t undecodable = replay.feed().undecodable();
    const scanner::TelegramAccount account = replay.progress().account;
    if (!best.scan && sweeps > 0)
        return noSuchScan(*options.scanIndex, static_cast<std::size_t>(sweeps), "the recording", "one sweep", "%1 sweeps");
    if (!best.scan) {
        const std::string why = replay.feed().whyUndecodable();
        return Error{account.telegrams > 0
                         ? withValues("the %1 scan telegrams in this recording hold no line of ranges", {account.telegrams})
                     : undecodable > 0 ? withValues("no scan telegram in this recording can be decoded%1", {why.empty() ? why : ": " + why})
                                       : withValues("this recording holds no scan telegram%1", {recording->whatWasLeftOut()}),
                     where, "choose another recording"};
    }
    Scan scan = *best.scan;
    scan.warnings.insert(scan.warnings.begin(), replay.warnings().begin(), replay.warnings().end());
    if (sweeps > 1 && !options.scanIndex) {
        scan.warnings.push_back(
            withValues("The recording holds %1 sweeps; sweep %2 was opened; no other has more lines.", {sweeps, best.progress.number + 1}));
    }
    if (undecodable > 0)
        scan.warnings.push_back(withValues("%1 scan telegrams could not be decoded: %2.", {undecodable, replay.feed().whyUndecodable()}));
    if (const std::int64_t torn = replay.feed().torn(); torn > 0)
        scan.warnings.push_back(counted(torn, "message holds bytes that are not a whole telegram: what was in it is lost.",
                                        "messages hold bytes that are not a whole telegram: what was in them is lost."));
    if (!recording->clean() && best.progress.expected == 0)
        scan.warnings.push_back(withValues("INCOMPLETE: %1 lines are there, how many there were is not known.", {best.progress.received}));
    return describedSweep(std::move(scan), *recording, where, options);
}

Result<Scan> readRecording(const Source& source) {
    const ByteView bytes = source.octets();
    const auto recording =
        Recording::fromBytes(Bytes(bytes.begin(), bytes.end()), source.path.string(), [&] { return source.goOn("reading", 0.0); });
    if (!recording) return recording.error();
    return scanOf(*recording, source.path.string(), *source.options, source.played);
}

} // namespace edgescan::files
