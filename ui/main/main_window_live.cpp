// What the window does with a live scanner and with recordings: panel, commands, stale pictures, timeline.
#include "ui/main/main_window.h"

#include "ui/base/notice_bar.h"
#include "ui/cloud/cloud_view.h"
#include "ui/image/image_view.h"
#include "ui/live/live_panel.h"
#include "ui/live/scanner_link.h"
#include "ui/live/timeline.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

#include <nlohmann/json.hpp>

namespace edgescan::ui {
namespace {

SweepSettings rememberedSweep(const Memory& memory) {
    const auto json = nlohmann::json::parse(memory.text("live/sweep").toStdString(), nullptr, false);
    SweepMetadata metadata;
    if (json.is_object()) {
        for (const auto& [key, value] : json.items()) {
            if (value.is_string()) metadata[key] = value.get<std::string>();
        }
    }
    return settingsOf(metadata).settings;
}

} // namespace

void MainWindow::buildLive(QLayout& column) {
    live_ = new LivePanel;
    live_->setSweep(rememberedSweep(memory_));
    live_->setAddress(memory_.text("live/host"), memory_.text("live/port", "2112").toInt());
    live_->hide();
    timeline_ = new Timeline;
    column.addWidget(timeline_);
    column.addWidget(live_);
    recordingFolder_ = memory_.text("folder/recordings", QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/EdgeScan");
}

void MainWindow::connectLive() {
    connect(live_, &LivePanel::connectWanted, this, [this] {
        if (live_->host().isEmpty()) {
            notice_->showNotice(NoticeBar::Kind::Warning, tr("There is no host to connect to: type the scanner's name or address."));
            return live_->askAddress();
        }
        connectScanner(live_->host(), live_->port(), live_->sweep());
    });
    ScannerLink* scanner = scanner_.get();
    connect(live_, &LivePanel::disconnectWanted, scanner, &ScannerLink::hangUp);
    connect(live_, &LivePanel::recordWanted, this, [this](bool on) {
        if (on)
            scanner_->startRecording(newRecordingPath("sweep"));
        else
            scanner_->stopRecording();
    });
    connect(live_, &LivePanel::keepWanted, this, [this] { scanner_->keepRecent(newRecordingPath("last-minute")); });
    connect(live_, &LivePanel::followWanted, scanner, [this](bool on) {
        scanner_->follow(on);
        live_->setFollowing(scanner_->following());
    });
    connect(scanner, &ScannerLink::connectedChanged, live_, &LivePanel::setConnected);
    connect(scanner, &ScannerLink::recordingChanged, live_, &LivePanel::setRecording);
    connect(scanner, &ScannerLink::followingChanged, live_, &LivePanel::setFollowing);
    connect(scanner, &ScannerLink::healthChanged, this, &MainWindow::showLiveHealth);
    connect(scanner, &ScannerLink::failed, this,
            [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    connect(scanner, &ScannerLink::written, this, [this](const QString& path) {
        notice_->showNotice(NoticeBar::Kind::Done, tr("Saved %1, %2 kB.").arg(path).arg((QFileInfo(path).size() + 999) / 1000));
        notice_->offer(tr("Open folder"), [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath())); });
    });
    connect(&session_, &Session::opened, this, [this](const QString& path) {
        fileScan_ = nullptr;
        if (QFileInfo(path).suffix().compare("mcap", Qt::CaseInsensitive) == 0)
            timeline_->load(path.toStdString(), openOptions_);
        else
            timeline_->clear();
    });
    connect(timeline_, &Timeline::arrived, this, &MainWindow::showReplayed);
    connect(timeline_, &Timeline::refused, this,
            [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    QApplication::instance()->installEventFilter(this);
}

void MainWindow::connectScanner(const QString& host, int port, const SweepSettings& sweep) {
    live_->setAddress(host, port);
    live_->setSweep(sweep);
    live_->show();
    memory_.keep("live/host", host);
    memory_.keep("live/port", QString::number(port));
    memory_.keep("live/sweep", QString::fromStdString(nlohmann::json(metadataOf(sweep)).dump()));
    rememberTimer_.start();
    timeline_->clear();
    series_.clear();
    openedPath_.clear();
    openOptions_ = {};
    straighten_->setChecked(false);
    notice_->hide();
    SessionSettings scanner;
    scanner.host = host.toStdString();
    scanner.port = static_cast<std::uint16_t>(port);
    scanner_->connectTo(scanner, sweep);
}

void MainWindow::showLiveHealth() {
    live_->showHealth(scanner_->health());
    const QString stale = scanner_->showsStale() ? QString::fromStdString(scanner_->health().badge) : QString();
    for (ImageView* view : {gray_, edges_}) view->setStale(stale);
    cloud_->setStale(stale);
    // A strip that says LIVE beside a picture that stands still would be misleading.
    const bool held = scanner_->connected() && !scanner_->following() && shown_ && shown_->source.stream == scanner_->stream();
    const QString note =
        held ? tr("Held: %1. Follow shows what the scanner sends now.").arg(QString::fromStdString(shown_->detection->scan->name))
             : QString();
    if (note == heldNote_) return;
    heldNote_ = note;
    for (ImageView* view : {gray_, edges_}) view->setNote(note);
    cloud_->setNote(note);
}

void MainWindow::tellSweepEnded() {
    if (shown_->source.stream != scanner_->stream()) return;
    QStringList warnings;
    for (const std::string& warning : shown_->detection->scan->warnings) warnings << QString::fromStdString(warning);
    const QString name = QString::fromStdString(shown_->detection->scan->name);
    if (warnings.isEmpty())
        notice_->showNotice(NoticeBar::Kind::Done, tr("%1 is whole: %2 lines.").arg(name).arg(shown_->detection->scan->lines()));
    else
        notice_->showNotice(NoticeBar::Kind::Warning, tr("%1 has ended. ").arg(name) + warnings.join("\n"));
}

/// At the end of the sweep that the file opens with, it is the file's own scan again: it knows where it came from.
void MainWindow::showReplayed(const ReplayedSweep& at) {
    const auto& picture = session_.picture();
    if (!picture || !at.sweep.scan) return;
    if (!fileScan_ && picture->source.growth.sweep < 0) fileScan_ = picture->detection->scan;
    const std::uint64_t stream = picture->source.stream;
    const SweepProgress& progress = at.sweep.progress;
    if (fileScan_ && at.position == timeline_->home())
        session_.follow(fileScan_, {stream, {}});
    else
        session_.follow(at.sweep.scan, {stream, {progress.number, progress.growing, progress.expected}});
}

void MainWindow::addLiveCommands(QMenu& file) {
    addCommand(file, tr("&Connect to Scanner…"), {QKeySequence("Ctrl+L")}, [this] { live_->askAddress(); });
}

void MainWindow::addTimelineCommands(QMenu& scan) {
    scan.addSeparator();
    QList<QAction*> live;
    live << addCommand(scan, tr("&Record"), {QKeySequence("Ctrl+R")}, [this] {
        if (scanner_->recording())
            scanner_->stopRecording();
        else
            scanner_->startRecording(newRecordingPath("sweep"));
    });
    live << addCommand(scan, tr("&Keep Last Minute"), {QKeySequence("Ctrl+K")},
                       [this] { scanner_->keepRecent(newRecordingPath("last-minute")); });
    for (QAction* action : live) {
        action->setEnabled(false);
        connect(scanner_.get(), &ScannerLink::connectedChanged, action, &QAction::setEnabled);
    }
    addSwitch(scan, tr("&Hold Picture at End of Sweep"), {}, true, "live/hold", [this](bool on) { scanner_->setHoldAtEnd(on); });
    addCommand(scan, tr("Recordings &Folder…"), {}, [this] { chooseRecordingFolder(); });
    scan.addSeparator();
    QList<QAction*> actions;
    actions << addCommand(scan, tr("P&lay or Pause"), {QKeySequence(Qt::Key_Space)}, [this] { timeline_->togglePlay(); });
    const auto step = [&](const QString& text, int key, int lines) {
        actions << addCommand(scan, text, {QKeySequence(key)}, [this, lines] { timeline_->stepBy(lines); });
    };
    step(tr("Next Line"), Qt::Key_Right, 1);
    step(tr("Last Line"), Qt::Key_Left, -1);
    step(tr("Ten Lines Forward"), static_cast<int>(Qt::SHIFT) | static_cast<int>(Qt::Key_Right), 10);
    step(tr("Ten Lines Back"), static_cast<int>(Qt::SHIFT) | static_cast<int>(Qt::Key_Left), -10);
    for (QAction* action : actions) {
        action->setEnabled(false);
        connect(timeline_, &Timeline::activeChanged, action, &QAction::setEnabled);
    }
    scan.addSeparator();
}

/// Space presses the button that has the focus, Home and End move the slider that has it; only elsewhere they are the window's.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QMainWindow::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool presses = qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    const bool slides = qobject_cast<QAbstractSlider*>(watched) != nullptr;
    if ((key != Qt::Key_Space || !presses) && ((key != Qt::Key_Home && key != Qt::Key_End) || !slides))
        return QMainWindow::eventFilter(watched, event);
    event->accept();
    return true;
}

void MainWindow::setRecordingFolder(const QString& folder) {
    recordingFolder_ = folder;
    memory_.keep("folder/recordings", folder);
    rememberTimer_.start();
}

void MainWindow::chooseRecordingFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for recordings"), recordingFolder_);
    if (!folder.isEmpty()) setRecordingFolder(folder);
}

QString MainWindow::newRecordingPath(const char* kind) {
    QDir().mkpath(recordingFolder_);
    const QString time = QDateTime::currentDateTimeUtc().toString("yyyy-MM-dd'T'HHmmss'Z'");
    QString path = QDir(recordingFolder_).filePath(QString("%1_%2.mcap").arg(kind, time));
    for (int again = 2; QFileInfo::exists(path); ++again)
        path = QDir(recordingFolder_).filePath(QString("%1_%2_%3.mcap").arg(kind, time).arg(again));
    return path;
}

} // namespace edgescan::ui
