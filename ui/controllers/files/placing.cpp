// From typed texts to a placed scan.
#include "ui/controllers/files/placing.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/files/open_save/pose_sidecar.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/placed_look.h"
#include "core/scan/georef/survey_line.h"
#include "core/scan/grid/scan.h"
#include "ui/base/core_words.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/files.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/place_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>

namespace edgescan::ui {
namespace {

struct PlaceWords {
    Q_DECLARE_TR_FUNCTIONS(PlaceWords)
};

QString number(double value, int digits) { return shownText(fixedText(value, digits)); }

QString spanOf(const char* name, double from, double to) {
    return QString("%1 %2 … %3 m").arg(QLatin1String(name), number(from, 2), number(to, 2));
}

/// Empty: the pose fits the mounting.
QString doubtWords(const PlacedLook& look, Viewing viewing) {
    switch (lookDoubt(look, viewing)) {
    case LookDoubt::None:
        break;
    case LookDoubt::TurnedForward:
        return PlaceWords::tr(
            "The scanner looks forward: what is above it without a pose is now in front of it. If it looks up into a bell, "
            "choose “up” on the page Mounting.");
    case LookDoubt::NotUp:
        return PlaceWords::tr("The mounting looks up, but pitch and roll turn it to the side: type 0 and 0 for a level boom, or choose "
                              "“forward” on the page Mounting.");
    case LookDoubt::MostlyBelow:
        return PlaceWords::tr("The mounting looks up, but %1 % of the points are lower than the scanner: correct pitch and roll, or choose "
                              "another direction on the page Mounting.")
            .arg(number(100.0 * look.belowShare, 0));
    }
    return {};
}

/// The scanner, where it looks, and the span of its points in the mine grid; in a line of its own, with ▲, what does not fit the mounting.
/// The scan must have a placement.
QString placeWords(const Scan& scan, Viewing viewing) {
    const PlacedLook look = placedLook(scan);
    QString words = PlaceWords::tr("Scanner at E %1, N %2, RL %3 m. ")
                        .arg(number(look.sensor.x(), 3), number(look.sensor.y(), 3), number(look.sensor.z(), 3));
    words +=
        (look.elevationDeg < 0.0 ? PlaceWords::tr("It looks %1° below the horizon. ") : PlaceWords::tr("It looks %1° above the horizon. "))
            .arg(number(std::abs(look.elevationDeg), 0));
    words += PlaceWords::tr("Its points: ");
    words += spanOf("E", look.least.x(), look.most.x()) + ", " + spanOf("N", look.least.y(), look.most.y()) + ", " +
             spanOf("RL", look.least.z(), look.most.z());
    const QString doubt = doubtWords(look, viewing);
    return doubt.isEmpty() ? words : words + QString::fromUtf8("\n▲ ") + doubt;
}

using Json = nlohmann::ordered_json;

constexpr const char* kScanners = "scanners";        // of the preferences: calibrations by name, as JSON
constexpr const char* kLastScanner = "scanner-last"; // name
constexpr auto kWhileTyping = std::chrono::milliseconds(200);
constexpr std::uint64_t kMostCalibrationBytes = std::uint64_t{1} << 20U;

Json scannersIn(const Preferences& preferences) {
    const auto stored = parseOrderedJson(exactBytes(preferences.text(kScanners)), kScanners, kSettingsJson);
    return stored && stored->is_object() ? *stored : Json::object();
}

Axis axisOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    return polar != nullptr ? polar->axis : Axis::Spin;
}

Result<std::string> textAt(const std::string& path) {
    const auto bytes = readWholeFile(path, kMostCalibrationBytes);
    if (!bytes) return bytes.error();
    return std::string(textOf(*bytes));
}

} // namespace

Placing::Placing(Engine& engine, Files& files, NoticeBar& notice, Preferences& preferences, QUndoStack& undo, QObject* parent)
    : QObject(parent), engine_(engine), files_(files), notice_(notice), preferences_(preferences), undo_(undo),
      preview_(
          Urgency::Soon, [](const Question& question) { return placed(question); },
          [this](const Question&, const std::shared_ptr<const Answer>& answer) { showPreview(*answer); },
          [this](const QString& what) {
              if (scan_) dialog_->showState(tr("It failed (%1); close other programs or use a smaller scan.").arg(what), false);
          }) {
    connect(&engine_, &Engine::streamChanged, this, &Placing::follow);
    connect(&engine_, &Engine::pictureReady, this, &Placing::endPending);
    connect(&engine_, &Engine::failed, this, &Placing::endPending);
}

void Placing::make() {
    if (dialog_ != nullptr) return;
    dialog_ = new PlaceDialog(notice_.window());
    connect(dialog_, &PlaceDialog::changed, this, [this] {
        const bool shown = scan_ && engine_.picture()->detection->scan->placement != nullptr;
        if (shown) engine_.setPlacePending(true);
        awaited_.reset();
        check();
    });
    connect(dialog_, &PlaceDialog::surveyLineTyped, this, &Placing::useSurveyLine);
    connect(dialog_, &PlaceDialog::keepRequested, this, [this] { store(typed_.file, stepName("Store Pose")); });
    connect(dialog_, &PlaceDialog::removeRequested, this, [this] { store(std::nullopt, stepName("Remove Pose")); });
    connect(dialog_, &PlaceDialog::scannerChosen, this, &Placing::useScanner);
    connect(dialog_, &PlaceDialog::scannerKept, this, &Placing::askScannerName);
    connect(dialog_, &PlaceDialog::scannerForgotten, this, &Placing::forgetScanner);
    connect(dialog_, &PlaceDialog::fileRequested, this, &Placing::askFile);
    connect(dialog_, &QDialog::finished, this, &Placing::closed);
}

void Placing::show() {
    const auto& picture = engine_.picture();
    if (!picture) return notice_.showHint(tr("Open a scan first."));
    if (scan_) return dialog_->raise();
    const Scan& scan = *picture->detection->scan;
    if (scan.path.empty() || picture->source.growth.sweep >= 0 || (files_.path().isEmpty() && !files_.demo()))
        return notice_.showHint(tr("The picture does not come from a file, so its pose cannot be stored: open a scan or a recording."));
    make();
    source_ = picture->source;
    previewed_ = false;
    if (!load(scan)) return;
    scan_ = picture->detection->scan;
    check();
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

/// Fills the form: from the sidecar of the scan, else from the files that it was opened with, else with the scanner used last.
bool Placing::load(const Scan& scan) {
    const auto beside = files::readPoseSidecar(scan.path);
    if (!beside) {
        notice_.showError(beside.error());
        return false;
    }
    stored_ = {files_.options(), *beside};
    poseBase_ = beside->value_or(std::string());
    mountingBase_.clear();
    std::string scanner;
    if (!stored_.options.pose.empty()) {
        const auto text = textAt(stored_.options.pose);
        poseBase_ = text ? *text : std::string();
    }
    if (!stored_.options.calibration.empty()) {
        const auto text = textAt(stored_.options.calibration);
        mountingBase_ = text ? *text : std::string();
    } else if (!poseBase_.empty()) {
        mountingBase_ = calibrationInPose(poseBase_);
    } else {
        const Json scanners = scannersIn(preferences_);
        scanner = exactBytes(preferences_.text(kLastScanner));
        if (scanners.contains(scanner))
            mountingBase_ = jsonText(scanners[scanner], 2);
        else
            scanner.clear();
    }
    const PlaceTexts none(poseFields().size());
    const auto pose = poseBase_.empty() ? Result<PlaceTexts>(none) : placeTexts(poseFields(), poseBase_, files::poseSidecar(scan.path));
    if (!pose) notice_.showError(pose.error());
    auto mounting =
        mountingBase_.empty() ? Result<PlaceTexts>(nominalMounting(axisOf(scan))) : placeTexts(mountingFields(), mountingBase_, scan.path);
    if (!mounting) mounting = nominalMounting(axisOf(scan));
    dialog_->setRemovable(beside->has_value());
    dialog_->showPose(pose ? *pose : none);
    dialog_->showMounting(*mounting);
    showScanners(exactText(scanner));
    return true;
}

/// Another scan is on the screen: the form belongs to the former one.
void Placing::follow() {
    if (!message_.isEmpty()) {
        notice_.showNotice(NoticeBar::Kind::Done, message_); // the scan's warnings are one of the earlier notes
        if (isNewest(undo_, newest_)) notice_.offerUndo(undo_);
        message_.clear();
    }
    if (!scan_ || engine_.picture()->source.stream == source_.stream) return;
    previewed_ = false;
    dialog_->hide();
    closed();
}

void Placing::check() {
    if (!scan_) return;
    typed_ = typedPlace({dialog_->poseTexts(), poseBase_}, {dialog_->mountingTexts(), mountingBase_});
    dialog_->showFaults(typed_);
    if (!typed_.isSound()) return preview_.giveUp();
    dialog_->showComputing();
    preview_.ask({scan_, typed_.file}, kWhileTyping);
}

/// The form is closed, or its values have reached the screen.
void Placing::endPending() {
    if (!scan_ || (awaited_ && awaited_ == engine_.picture()->detection->scan)) engine_.setPlacePending(false);
}

Placing::Answer Placing::placed(const Question& question) {
    try {
        const auto poses = parsePoses(question.file, "form");
        if (!poses) return {poses.error(), {}};
        const auto placement = placeScan(*question.scan, *poses->calibration, *poses);
        if (!placement) return {placement.error(), {}};
        if (auto enough = edges::checkMemoryFor(edges::Work::Detect, *question.scan); !enough) return {enough.error(), {}};
        auto scan = std::make_shared<Scan>(*question.scan);
        scan->placement = *placement;
        const QString words = placeWords(*scan, poses->calibration->viewing);
        return {std::shared_ptr<const Scan>(std::move(scan)), words};
    } catch (const std::bad_alloc&) {
        return {Error{"there is not enough memory to show the scan in its place", "", "close other programs"}, {}};
    }
}

void Placing::showPreview(const Answer& answer) {
    if (!scan_) return;
    if (!answer.scan) return dialog_->showState("✕ " + shownText(answer.scan.error().what) + ".", false);
    previewed_ = true;
    awaited_ = *answer.scan;
    engine_.follow(awaited_, source_);
    dialog_->showState(answer.words, true);
}

void Placing::useSurveyLine(const QString& line, bool northingFirst) {
    const auto read = parseSurveyLine(exactBytes(line), northingFirst ? SurveyOrder::NorthingFirst : SurveyOrder::EastingFirst);
    if (!read) return dialog_->showState("✕ " + coreSentence(read.error().sentence()), false);
    PlaceTexts texts = dialog_->poseTexts();
    const auto put = [&](const std::string& key, std::optional<double> value) { // an angle that the line does not give is of another pose
        for (std::size_t n = 0; n < texts.size(); ++n) {
            if (key == poseFields()[n].key) texts[n] = value ? shortestText(*value) : std::string();
        }
    };
    put("easting_m", read->enhM.x());
    put("northing_m", read->enhM.y());
    put("elevation_m", read->enhM.z());
    put("heading_deg", read->headingDeg);
    put("tilt_x_deg", read->pitchDeg);
    put("tilt_y_deg", read->rollDeg);
    put("pitch_deg", std::nullopt);
    put("roll_deg", std::nullopt);
    dialog_->showPose(texts);
}

QStringList Placing::scannerNames() const {
    const Json scanners = scannersIn(preferences_); // items() does not own it
    QStringList names;
    for (const auto& [name, value] : scanners.items()) names << exactText(name);
    return names;
}

void Placing::showScanners(const QString& inUse) { dialog_->showScanners(scannerNames(), inUse); }

void Placing::useScanner(const QString& name) {
    const Json scanners = scannersIn(preferences_);
    const std::string key = exactBytes(name);
    mountingBase_ = scanners.contains(key) ? jsonText(scanners[key], 2) : std::string();
    const auto texts =
        mountingBase_.empty() ? Result<PlaceTexts>(nominalMounting(axisOf(*scan_))) : placeTexts(mountingFields(), mountingBase_, key);
    if (texts) dialog_->showMounting(*texts);
    preferences_.keep(kLastScanner, name);
    showScanners(name);
}

void Placing::askScannerName() {
    const QString typed = exactText(dialog_->mountingTexts().front());
    const QString name =
        QInputDialog::getText(dialog_, tr("Store the mounting"), tr("Name of the scanner"), QLineEdit::Normal, typed).trimmed();
    if (!name.isEmpty()) keepScanner(name);
}

void Placing::keepScanner(const QString& name) {
    const auto file = typedMounting({dialog_->mountingTexts(), mountingBase_});
    if (!file) return dialog_->showState("✕ " + shownText(file.error().what), false);
    Json scanners = scannersIn(preferences_);
    scanners[exactBytes(name)] = *parseOrderedJson(*file, kScanners);
    preferences_.keep(kScanners, exactText(jsonText(scanners)));
    preferences_.keep(kLastScanner, name);
    showScanners(name);
}

void Placing::forgetScanner(const QString& name) {
    Json scanners = scannersIn(preferences_);
    scanners.erase(exactBytes(name));
    preferences_.keep(kScanners, exactText(jsonText(scanners)));
    preferences_.keep(kLastScanner, QString());
    showScanners({});
}

void Placing::askFile() {
    const QString path =
        QFileDialog::getOpenFileName(dialog_, tr("The robot's calibration"), preferences_.folder("exports"), tr("Calibration (*.json)"));
    if (!path.isEmpty()) useCalibration(path);
}

void Placing::useCalibration(const QString& path) {
    const auto text = textAt(exactBytes(path));
    const auto sound = text ? parseCalibration(*text, exactBytes(path)) : Result<Calibration>(text.error());
    if (!sound) return dialog_->showState("✕ " + coreSentence(sound.error().sentence()), false);
    const auto texts = placeTexts(mountingFields(), *text, exactBytes(path));
    if (!texts) return dialog_->showState("✕ " + coreSentence(texts.error().sentence()), false);
    mountingBase_ = *text;
    dialog_->showMounting(*texts);
    showScanners({});
}

void Placing::store(const std::optional<std::string>& file, const QString& what) {
    if (!scan_ || storing_) return;
    Stored after{stored_.options, file};
    after.options.pose.clear();
    after.options.calibration.clear();
    const Stored before = stored_;
    const std::string path = scan_->path;
    previewed_ = false; // opening the scan again shows it in its place
    dialog_->accept();
    auto* step = new UndoStep<Stored>(what, before, after, [this, path](const Stored& value) { return use(path, value); });
    step->giveWayIn(undo_);
    newest_ = step;
    undo_.push(step);
}

/// Writes or removes the sidecar of the scan, and opens the scan again.
bool Placing::use(const std::string& scanPath, const Stored& stored) {
    if (!engine_.picture() || engine_.picture()->detection->scan->path != scanPath) return false;
    if (storing_) { // the file has one value after the other
        next_ = stored;
        return true;
    }
    storing_ = true;
    inBackground(
        this,
        [this, scanPath, stored]() -> std::function<void()> {
            const auto before = files::readPoseSidecar(scanPath);
            const bool replaces = before && *before && *before != stored.file;
            const auto written = files::writePoseSidecar(scanPath, stored.file);
            return [this, scanPath, stored, written, replaces] {
                if (!written) {
                    reopen(files_.options());
                    return notice_.showError(written.error());
                }
                const QString name = shownName(QFileInfo(exactText(files::poseSidecar(scanPath).string())).fileName());
                message_ = !stored.file ? tr("The pose that was stored with the scan is removed.")
                           : replaces   ? tr("The pose is stored with the scan, in %1; it replaced the one that was there.").arg(name)
                                        : tr("The pose is stored with the scan, in %1.").arg(name);
                reopen(stored.options);
            };
        },
        [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Error, tr("The pose could not be stored (%1).").arg(what)); },
        [this, scanPath] {
            storing_ = false;
            if (const auto next = std::exchange(next_, std::nullopt)) use(scanPath, *next);
        });
    return true;
}

void Placing::reopen(const ReadingOptions& options) {
    if (files_.demo())
        files_.openDemo(*files_.demo());
    else
        files_.look(options);
}

/// Closed without storing: the scan is again where it was.
void Placing::closed() {
    preview_.giveUp();
    awaited_.reset();
    const auto scan = std::exchange(scan_, nullptr);
    if (scan && previewed_)
        engine_.follow(scan, source_);
    else if (!storing_)
        engine_.setPlacePending(false);
    previewed_ = false;
}

} // namespace edgescan::ui

#include "moc_placing.cpp"
