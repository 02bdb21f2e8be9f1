// Connects the window with a live scanner and with recordings.
#include "ui/controllers/live.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scanner/cola/host_port.h"
#include "ui/base/core_words.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/files/source.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/live/topic_menu.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>

#include <nlohmann/json.hpp>

namespace edgescan::ui {
namespace {

// The colours of the badges HELD, STALE and LOST, as bright as lines over a dark view need.
const QColor kHeldFrame(91, 141, 214), kStaleFrame(213, 154, 0), kLostFrame(224, 88, 79);

scanner::SweepSettings rememberedSweep(const Preferences& preferences) {
    const auto json = parseJson(preferences.text("live/sweep").toStdString(), "viewer.ini", kSettingsJson);
    scanner::SweepMetadata metadata;
    if (json && json->is_object()) {
        for (const auto& [key, value] : json->items()) {
            if (value.is_string()) metadata[key] = value.get<std::string>();
        }
    }
    return scanner::settingsOf(metadata).settings; // values that are not stored are assumed
}

/// "sweep 2: 63/120 lines, partial".
QString sweepName(const scanner::SweepProgress& sweep) {
    if (sweep.expected == 0) return Live::tr("sweep %1: %2 lines").arg(sweep.number + 1).arg(sweep.received);
    return (sweep.complete() ? Live::tr("sweep %1: %2/%3 lines, complete") : Live::tr("sweep %1: %2/%3 lines, partial"))
        .arg(sweep.number + 1)
        .arg(sweep.received)
        .arg(sweep.expected);
}

/// `brief`: for a cab.
QString mountingQuestion(bool brief) {
    return brief ? Live::tr("How the stepper turns the scanner is not known.")
                 : Live::tr("How the stepper turns the scanner is not known. Edges are found all the same, but the shape of the cloud is "
                            "assumed until you give it.");
}

QStringList mountingQuestions() { return {mountingQuestion(true), mountingQuestion(false)}; }

} // namespace

Live::Live(Engine& engine, LivePanel& panel, Timeline& timeline, LinkedViews& views, Files& files, NoticeBar& notice,
           Preferences& preferences)
    : engine_(engine), panel_(panel), timeline_(timeline), views_(views), files_(files), notice_(notice), preferences_(preferences),
      scanner_(engine) {
    panel_.setSweep(rememberedSweep(preferences_));
    panel_.setAddress(preferences_.text("live/host"), preferences_.text("live/port", "2112").toInt());
    panel_.hide();
    recordingFolder_ = preferences_.recordingFolder();
    connectPanel();
    connectScanner();
    connect(&engine_, &Engine::opened, this, [this](const QString& path) {
        if (!scanner_.connected()) panel_.forgetScanner(); // what it says is about another picture
        loadTimeline(path);
    });
    for (const auto changed : {&ScannerLink::connectedChanged, &ScannerLink::followingChanged})
        connect(&scanner_, changed, this, &Live::growthChanged);
    connect(&timeline_, &Timeline::playingChanged, this, &Live::growthChanged);
    connect(&engine_, &Engine::streamChanged, this, [this] {
        if (scanner_.connected()) showHealth();
    });
    connect(&timeline_, &Timeline::arrived, this, &Live::showReplayed);
    connect(&timeline_, &Timeline::refused, this, [this](const QString& why) { notice_.showNotice(NoticeBar::Kind::Error, why); });
}

void Live::followPicture() {
    scanner_.followPicture();
    panel_.showAxisFromRanges(axisShownByRanges());
    views_.setShapeNote(shapeNote());
    reportSweepEnd();
}

void Live::connectPanel() {
    connect(&panel_, &LivePanel::connectRequested, this, [this] {
        if (panel_.host().isEmpty()) {
            notice_.showHint(tr("There is no host to connect to: type the scanner's name or address."));
            return panel_.askAddress();
        }
        panel_.splitAddress();
        if ((panel_.host().contains("://") && !panel_.bridge()) || !scanner::hostPort(panel_.host().toStdString())) {
            notice_.showNotice(NoticeBar::Kind::Warning,
                               tr("%1 cannot be connected to: type the scanner's name or address, or ws://ROBOT for a robot with ROS.")
                                   .arg(shownName(panel_.host(), 60)));
            return panel_.askAddress();
        }
        const bool same = topicOf_ == panel_.host();
        connectTo(panel_.host(), panel_.port(), panel_.sweep(), same ? topic_ : std::string(), same ? joint_ : std::string());
    });
    connect(&panel_.topics(), &TopicMenu::asked, this, [this] { panel_.topics().showTopics(scanner_.topics(), joint_); });
    connect(&panel_.topics(), &TopicMenu::chosen, this, [this](const std::string& topic, const std::string& joint) {
        connectTo(panel_.host(), panel_.port(), panel_.sweep(), topic, joint);
    });
    connect(&panel_, &LivePanel::disconnectRequested, this, [this] {
        scanner_.disconnectScanner();
        if (showsScanner()) return;
        panel_.forgetScanner();
        notice_.withdraw(mountingQuestions()); // of a sweep without a line
    });
    connect(&panel_, &LivePanel::recordRequested, this, &Live::record);
    connect(&panel_, &LivePanel::keepRequested, this, &Live::keepLastMinute);
    connect(&panel_, &LivePanel::sweepRequested, this, &Live::useSweep);
    connect(&panel_, &LivePanel::otherRequested, this, [this](int place) {
        notice_.withdraw({endNote_});
        scanner_.showOther(static_cast<std::size_t>(place));
    });
    connect(&panel_, &LivePanel::followRequested, this, [this](bool on) {
        scanner_.follow(on);
        panel_.setFollowing(scanner_.following());
    });
}

void Live::connectScanner() {
    connect(&scanner_, &ScannerLink::connectedChanged, &panel_, &LivePanel::setConnected);
    connect(&scanner_, &ScannerLink::recordingChanged, &panel_, &LivePanel::setRecording);
    connect(&scanner_, &ScannerLink::followingChanged, &panel_, &LivePanel::setFollowing);
    connect(&scanner_, &ScannerLink::followingChanged, this, [this](bool on) {
        if (on) notice_.withdraw({endNote_}); // it is of the sweep that was held
    });
    connect(&scanner_, &ScannerLink::connectedChanged, this, [this](bool on) {
        if (!on) notice_.withdraw({endNote_}); // it speaks of Follow, or of the next sweep
    });
    connect(&scanner_, &ScannerLink::healthChanged, this, &Live::showHealth);
    connect(&scanner_, &ScannerLink::otherChanged, this, &Live::offerOther);
    connect(&scanner_, &ScannerLink::failed, this, [this](const QString& why) { notice_.showNotice(NoticeBar::Kind::Error, why); });
    connect(&scanner_, &ScannerLink::written, this, [this](const QString& path, int linesBefore) {
        preferences_.keepRecentFile(path);
        notice_.showSaved(path, {},
                          linesBefore == 0 ? QString()
                                           : tr("It begins with the sweep under way: %1 lines of it came before Record.").arg(linesBefore));
        notice_.offer(
            tr("Open"), [this, path] { files_.open({path}); }, QFileInfo(path).absolutePath());
    });
}

void Live::connectTo(const QString& host, int port, const scanner::SweepSettings& sweep, const std::string& topic,
                     const std::string& joint) {
    panel_.setAddress(host, port);
    panel_.setSweep(sweep);
    panel_.show();
    preferences_.keep("live/host", host);
    preferences_.keep("live/port", QString::number(port));
    preferences_.keep("live/sweep", exactText(jsonText(nlohmann::json(scanner::metadataOf(sweep)))));
    timeline_.clear();
    files_.leave();
    topicOf_ = host;
    topic_ = topic;
    joint_ = joint;
    scanner::ConnectionSettings scanner;
    scanner.bridge = panel_.bridge();
    scanner.host = (scanner.bridge ? QUrl(host).host() : host).toStdString();
    scanner.port = static_cast<std::uint16_t>(panel_.port());
    scanner.topic = topic;
    scanner.joint = joint;
    scanner.keepRepeated = panel_.keepsRepeated();
    scanner_.connectTo(scanner, sweep);
    if (scanner.bridge || (!sweep.axisAssumed && !sweep.stepAssumed)) return;
    askMounting();
}

void Live::askMounting() {
    notice_.showNotice(NoticeBar::Kind::Warning, mountingQuestion(panel_.brief()));
    notice_.offer(tr("Give it…"), [this] { panel_.askSweep(); });
}

void Live::useSweep() {
    const scanner::SweepSettings sweep = panel_.sweep();
    const std::optional<int> gone = scanner_.useSweep(sweep);
    if (!gone) return;
    preferences_.keep("live/sweep", exactText(jsonText(nlohmann::json(scanner::metadataOf(sweep)))));
    const bool asks = !notice_.isHidden() && mountingQuestions().contains(notice_.text());
    notice_.withdraw(mountingQuestions());
    if (asks && (sweep.axisAssumed || sweep.stepAssumed)) askMounting(); // about the rest
    QStringList remarks;
    if (*gone > 0) remarks << tr("The first %1 lines of this sweep are too old to be moved to their new places.").arg(*gone);
    if (scanner_.recording())
        remarks << tr(
            "The recording in progress has the old mounting and steps. Correct them with Scan > How the Scan Is Read after you open it, "
            "or start another recording.");
    if (!remarks.isEmpty()) notice_.showNotice(NoticeBar::Kind::Warning, remarks.join('\n'));
}

bool Live::showsScanner() const {
    const auto& shown = engine_.picture();
    return shown && shown->source.stream == scanner_.stream();
}

bool Live::grows() const {
    const auto& shown = engine_.picture();
    if (!shown || !shown->source.growth.growing) return false;
    return showsScanner() ? scanner_.connected() && scanner_.following() : timeline_.playing();
}

void Live::showHealth() {
    // LIVE above a picture that does not move, or comes from another source, would be misleading.
    const auto& shown = engine_.picture();
    const bool own = !shown || showsScanner();
    const bool held = scanner_.connected() && !scanner_.following() && shown && own;
    // After Stop there may be two sweeps, and by Undo the picture is not that of the count: the count has the number of its sweep.
    const bool otherSweep =
        !scanner_.connected() && shown && own && (!scanner_.others().empty() || shown->source.growth.sweep + 1 != scanner_.health().sweep);
    panel_.showHealth(scanner_.health(),
                      !own                 ? HealthStrip::Picture::Other
                      : held || otherSweep ? HealthStrip::Picture::Held
                                           : HealthStrip::Picture::Follows,
                      own ? note(held) : QString());
    const bool lost = scanner_.health().liveness == files::Liveness::Lost;
    views_.setPictureFrame(scanner_.showsStale()
                               ? PictureFrame{lost ? kLostFrame : kStaleFrame, coreWords(scanner_.health().badge), lastLine()}
                           : held ? PictureFrame{kHeldFrame}
                                  : PictureFrame{});
    const QString note = scanner_.connected() && !shown ? waitsFor() : QString();
    if (std::exchange(waitNote_, note) != note) views_.setNote(note);
    views_.setShapeNote(shapeNote());
}

/// "last line 612 at 10:31:44 UTC"; empty without a picture. LOST adds what EdgeScan does.
QString Live::lastLine() const {
    const auto& shown = engine_.picture();
    if (!shown) return {};
    const Scan& scan = *shown->detection->scan;
    const QString time = scan.acquisition ? timeWords(scan.acquisition->endUtc) : QString();
    const QString last =
        time.isEmpty() ? tr("last line %1").arg(scan.lines()) : tr("last line %1 at %2 UTC").arg(scan.lines()).arg(time.mid(11, 8));
    const bool retries = scanner_.connected() && scanner_.health().liveness == files::Liveness::Lost;
    return retries ? last + " · " + tr("trying to connect again") : last;
}

/// Before the first line: what is wrong with the connection, or that nothing is.
QString Live::waitsFor() const {
    const std::string& wrong = scanner_.health().sentence;
    return wrong.empty() ? tr("Waiting for the first line") : coreSentence(wrong);
}

/// That the ranges of the connected scanner show.
std::optional<Axis> Live::axisShownByRanges() const {
    if (!scanner_.connected() || !showsScanner()) return std::nullopt;
    const Scan& scan = *engine_.picture()->detection->scan;
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    return polar != nullptr && isAxisFromRanges(scan) ? std::optional(polar->axis) : std::nullopt;
}

/// Also after Stop and of a recording, while lengths and rocks have the sign too.
QString Live::shapeNote() const {
    const auto& shown = engine_.picture();
    if (!shown) return {};
    const Scan& scan = *shown->detection->scan;
    const Assumed assumed = assumedIn(scan);
    if (assumed == Assumed::Nothing || !scanner_.connected() || !showsScanner() || panel_.bridge()) return assumedText(scan);
    return panel_.brief()                  ? QString() // its strip has the badge
           : assumed == Assumed::Step      ? tr("▲ The shape is assumed: give the step in Scan > Sweep…")
           : assumed == Assumed::Direction ? tr("▲ The direction of the cloud is assumed: give the first line in Scan > Sweep…")
           : assumed == Assumed::SeenAxis  ? tr("▲ The ranges show the mounting: confirm it in Scan > Sweep…")
                                           : tr("▲ The shape is assumed: give mounting and step in Scan > Sweep…");
}

/// What is on the screen, and what the button does.
QString Live::note(bool held) const {
    const int counted = scanner_.health().sweep;
    if (held) {
        const int sweep = engine_.picture()->source.growth.sweep + 1;
        return sweep == counted ? tr("Sweep %1 is held on the screen. Follow shows its newest lines.").arg(sweep)
                                : tr("Sweep %1 is held on the screen. Follow shows sweep %2, which grows now.").arg(sweep).arg(counted);
    }
    const auto& part = scanner_.part();
    return part ? tr("Sweep %1 is a part: %2 of %3 lines.").arg(part->number + 1).arg(part->received).arg(part->expected) : QString();
}

void Live::offerOther() {
    showHealth();
    QStringList sweeps;
    for (const scanner::SweepState& other : scanner_.others()) sweeps << sweepName(other.progress);
    panel_.offerOthers(sweeps, sweeps.isEmpty() ? QString() : tr("On the screen: %1").arg(sweepName(scanner_.shown())));
}

void Live::reportSweepEnd() {
    const Picture& picture = *engine_.picture();
    const std::uint64_t stream = picture.source.stream;
    const bool growing = picture.source.growth.growing;
    const bool grew = std::exchange(growingStream_, growing ? stream : 0) == stream;
    if (growing || !grew || stream != scanner_.stream()) return;
    const Scan& scan = *picture.detection->scan;
    notice_.withdraw({endNote_}); // of the sweep before
    QStringList warnings;
    for (const std::string& warning : scan.warnings) {
        const bool isInStrip = scanner_.connected() && assumedIn(warning) != Assumed::Nothing; // and in the cloud, where it is given now
        if (!isInStrip) warnings << coreSentence(warning);
    }
    QString name = scanName(scan.name); // begins a sentence
    name.replace(0, 1, name.left(1).toUpper());
    // The note of a recording has the button that opens it.
    const auto show = [this](NoticeBar::Kind kind, const QString& text) { endNote_ = notice_.showBehind(kind, text); };
    if (scanner_.heldAtStop())
        return show(NoticeBar::Kind::Warning, tr("%1 was held with %2 lines when the connection ended.").arg(name).arg(scan.lines()));
    if (const auto& part = scanner_.part(); part && part->number == picture.source.growth.sweep) {
        return show(NoticeBar::Kind::Warning,
                    tr("%1 is a part: %2 of %3 lines. The scanner was in the middle of it when EdgeScan connected.")
                            .arg(name)
                            .arg(part->received)
                            .arg(part->expected) +
                        (scanner_.connected() ? " " + tr("The next sweep replaces it.") : QString()));
    }
    const int expected = picture.source.growth.expectedLines;
    if (warnings.isEmpty() && expected == 0)
        return show(NoticeBar::Kind::Done,
                    tr("%1 has ended: %2 lines. How many lines a sweep has is not known.").arg(name).arg(scan.lines()));
    const bool isWhole =
        warnings.isEmpty() || (scan.lines() == expected && countCells(scan)[static_cast<std::size_t>(CellState::Lost)] == 0);
    warnings.prepend(isWhole ? tr("%1 is complete: %2 lines.").arg(name).arg(scan.lines()) : tr("%1 has ended.").arg(name));
    // First what the operator can do: a small screen cuts the end.
    if (scanner_.connected() && !scanner_.following()) warnings.prepend(tr("Held. Follow shows the next ones, until Hold."));
    show(scan.warnings.empty() ? NoticeBar::Kind::Done : NoticeBar::Kind::Warning, warnings.join('\n'));
}

void Live::loadTimeline(const QString& path) {
    fileScan_ = nullptr;
    if (QFileInfo(path).suffix().compare("mcap", Qt::CaseInsensitive) == 0)
        timeline_.load(exactBytes(path), files_.options());
    else
        timeline_.clear();
}

/// At the end of the sweep with which the file opens, the file's own scan is shown again: it contains its source.
void Live::showReplayed(const ReplayedSweep& at) {
    const auto& picture = engine_.picture();
    if (!picture || !at.sweep.scan) return;
    if (!fileScan_ && picture->source.growth.sweep < 0) fileScan_ = picture->detection->scan;
    const std::uint64_t stream = picture->source.stream;
    const scanner::SweepProgress& progress = at.sweep.progress;
    if (fileScan_ && at.position == timeline_.home())
        engine_.follow(fileScan_, {stream, {}});
    else
        engine_.follow(at.sweep.scan, {stream, {progress.number, progress.growing, progress.expected}});
}

void Live::showWhole(QObject* asker, std::function<void()> then) {
    const auto source = [this] { return engine_.picture() ? engine_.picture()->source : PictureSource{}; };
    if (!timeline_.active() || source().growth.sweep < 0) return then();
    const auto waits = std::make_shared<QMetaObject::Connection>();
    *waits = connect(&engine_, &Engine::pictureReady, asker, [source, waits, stream = source().stream, then = std::move(then)] {
        const PictureSource now = source();
        if (now.stream == stream && now.growth.sweep >= 0) return;
        disconnect(*waits);
        if (now.stream == stream) then(); // else another file was opened meanwhile
    });
    timeline_.play(false);
    timeline_.goTo(timeline_.home());
}

void Live::record(bool on) {
    if (on)
        scanner_.startRecording(newRecordingPath("sweep"));
    else
        scanner_.stopRecording();
}

void Live::keepLastMinute() { scanner_.keepRecent(newRecordingPath("last-minute")); }

void Live::setRecordingFolder(const QString& folder) {
    recordingFolder_ = folder;
    preferences_.keep("folder/recordings", folder);
}

void Live::askRecordingFolder() {
    const QString folder = QFileDialog::getExistingDirectory(panel_.window(), tr("Folder for recordings"), recordingFolder_);
    if (!folder.isEmpty()) setRecordingFolder(folder);
}

QString Live::newRecordingPath(const char* kind) const {
    QDir().mkpath(recordingFolder_);
    const QString time = QDateTime::currentDateTimeUtc().toString("yyyy-MM-dd'T'HHmmss'Z'");
    QString path = QDir(recordingFolder_).filePath(QString("%1_%2.mcap").arg(kind, time));
    for (int again = 2; QFileInfo::exists(path); ++again)
        path = QDir(recordingFolder_).filePath(QString("%1_%2_%3.mcap").arg(kind, time).arg(again));
    return path;
}

} // namespace edgescan::ui

#include "moc_live.cpp"
