// Estimates the mounting errors from the scan on the screen.
#include "ui/controllers/files/calibrating.h"

#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/pose_sidecar.h"
#include "core/inspect/calibration/seam_edges.h"
#include "core/inspect/calibration/views_picture.h"
#include "ui/base/core_words.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/calibration_words.h"
#include "ui/controllers/files/files.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/calibration_card.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <new>

namespace edgescan::ui {
namespace {

QImage imageOf(const Grid<Rgb>& picture) {
    QImage image(picture.beams, picture.lines, QImage::Format_RGB32);
    for (int y = 0; y < picture.lines; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < picture.beams; ++x) row[x] = qRgb(picture.at(y, x).red, picture.at(y, x).green, picture.at(y, x).blue);
    }
    return image;
}

/// The pixel of the seam's picture with the most edges of both views around it.
QPoint busiestOf(const inspect::SeamEdges& seam) {
    constexpr int kSquare = 40, kPxPerCell = 3;
    int most = -1;
    QPoint best(seam.late.beams / 2, seam.late.lines / 2);
    for (int top = 0; top < seam.late.lines; top += kSquare) {
        for (int left = 0; left < seam.late.beams; left += kSquare) {
            int count = 0;
            for (int i = top; i < std::min(top + kSquare, seam.late.lines); ++i) {
                for (int j = left; j < std::min(left + kSquare, seam.late.beams); ++j)
                    count += seam.late.at(i, j) != 0 && seam.early.at(i, j) != 0 ? 1 : 0;
            }
            if (count <= most) continue;
            most = count;
            best = QPoint(left + kSquare / 2, top + kSquare / 2);
        }
    }
    return best * kPxPerCell;
}

Result<inspect::CalibrationSource> sourceOf(const std::string& file) {
    const Result<std::string> hash = sha256OfFile(file);
    if (!hash) return hash.error();
    return inspect::CalibrationSource{std::filesystem::path(file).filename().string(), *hash};
}

} // namespace

Calibrating::Calibrating(Engine& engine, Files& files, NoticeBar& notice, Preferences& preferences, QObject* parent)
    : QObject(parent), engine_(engine), files_(files), notice_(notice), preferences_(preferences),
      calibration_(
          Urgency::Later,
          [this](const Question& question, const Asker& asker) {
              return run(question, [this, &asker](const char* stage, double fraction) {
                  return asker.show([this, stage = QString::fromUtf8(stage), percent = static_cast<int>(100 * fraction)] {
                      card_->showStage(stage, percent);
                  });
              });
          },
          [this](const Question&, const std::shared_ptr<const Answer>& answer) { take(answer); },
          [this](const QString& what) {
              if (card_ != nullptr) card_->refuse(tr("It failed (%1); close other programs or use a smaller scan.").arg(what));
          }) {
    connect(&engine_, &Engine::streamChanged, this, &Calibrating::followScreen);
}

void Calibrating::show() {
    if (!engine_.picture()) return notice_.showHint(tr("Open a scan first."));
    if (files_.path().isEmpty())
        return notice_.showHint(tr("The picture does not come from a file, so a calibration cannot name it: open a scan or a recording."));
    if (card_ == nullptr) {
        card_ = new CalibrationCard(notice_.window());
        connect(card_, &CalibrationCard::addRequested, this, &Calibrating::askAdd);
        connect(card_, &CalibrationCard::removeRequested, this, [this](int row) {
            if (row <= 0 || row > others_.size()) return; // the scan on the screen stays in the list
            others_.removeAt(row - 1);
            ask();
        });
        connect(card_, &CalibrationCard::baseRequested, this, &Calibrating::askBase);
        connect(card_, &CalibrationCard::startRequested, this, &Calibrating::start);
        connect(card_, &CalibrationCard::givenUp, this, &Calibrating::giveUp);
        connect(card_, &CalibrationCard::saveRequested, this, &Calibrating::askSave);
        connect(card_, &CalibrationCard::applyRequested, this, &Calibrating::apply);
    }
    if (screenPath_ != files_.path()) {
        screenPath_ = files_.path();
        others_.clear();
        base_ = exactText(files_.options().calibration);
        ask();
    }
    card_->show();
    card_->raise();
    card_->activateWindow();
}

// Another scan is on the screen: the result belongs to the previous one. The same scan with other reading options keeps the result.
void Calibrating::followScreen() {
    if (card_ == nullptr || files_.path() == screenPath_) return;
    calibration_.giveUp();
    found_.reset();
    card_->hide();
    screenPath_.clear();
}

void Calibrating::ask() {
    calibration_.giveUp();
    found_.reset();
    saved_.clear();
    card_->setQuestion(QStringList{screenPath_} + others_, base_);
}

void Calibrating::askAdd() { add(Files::askScans(card_, tr("Scans with the same mounting"), preferences_)); }

void Calibrating::add(const QStringList& paths) {
    if (card_ == nullptr || paths.isEmpty()) return;
    for (const QString& path : paths) {
        if (path != screenPath_ && !others_.contains(path)) others_ << path;
    }
    ask();
}

void Calibrating::askBase() {
    const QString path = QFileDialog::getOpenFileName(card_, tr("The robot's calibration"),
                                                      base_.isEmpty() ? preferences_.folder("exports") : base_, tr("Calibration (*.json)"));
    if (!path.isEmpty()) setBase(path);
}

void Calibrating::setBase(const QString& path) {
    base_ = path;
    if (card_ != nullptr) ask();
}

void Calibrating::start() {
    if (card_ == nullptr || !engine_.picture() || files_.path() != screenPath_) return;
    Question question{engine_.picture()->detection, others_, files_.options(), base_};
    question.reading.pose.clear(); // they belong only to the scan on the screen
    question.reading.calibration.clear();
    found_.reset();
    saved_.clear();
    card_->begin();
    calibration_.ask(question);
}

void Calibrating::giveUp() {
    calibration_.giveUp();
    card_->refuse(tr("stopped"));
}

Result<std::vector<std::shared_ptr<const Scan>>> Calibrating::read(const Question& question, const Progress& progress,
                                                                   std::vector<inspect::CalibrationSource>& sources) {
    const std::string& shown = question.shown->scan->path;
    const Result<inspect::CalibrationSource> first = sourceOf(shown);
    if (!first) return first.error();
    sources.push_back(*first);
    std::vector<std::shared_ptr<const Scan>> scans{question.shown->scan};
    ReadingOptions reading = question.reading;
    reading.progress = progress;
    for (const QString& path : question.others) {
        const std::string file = exactBytes(path);
        Result<Scan> scan = files::openAsAsked(file, reading);
        if (!scan) return scan.error();
        if (auto enough = edges::checkMemoryFor(edges::Work::Detect, *scan); !enough) return enough.error();
        const Result<inspect::CalibrationSource> source = sourceOf(file);
        if (!source) return source.error();
        sources.push_back(*source);
        scan->name = file;
        scans.push_back(std::make_shared<const Scan>(std::move(*scan)));
    }
    return scans;
}

Calibrating::Seam Calibrating::seamOf(const edges::Detection& shown, const AssemblyErrors& errors) {
    Seam seam;
    const std::array<AssemblyErrors, 2> both{AssemblyErrors{}, errors};
    for (std::size_t n = 0; n < 2; ++n) {
        const inspect::SeamEdges edges = inspect::seamEdges(*shown.scan, *shown.mask, both[n]);
        seam.edges[n] = imageOf(inspect::seamPicture(edges));
        seam.apart[n] = imageOf(inspect::viewsPicture(*shown.scan, both[n]));
        seam.met[n] = edges.matchedShare();
        seam.lateEdges = edges.lateEdges;
        if (n == 1) seam.busiest = busiestOf(edges);
    }
    return seam;
}

Calibrating::Answer Calibrating::run(const Question& question, const Progress& progress) {
    const BindInputs inputs;
    Answer answer;
    try {
        std::vector<inspect::CalibrationSource> sources;
        const auto scans = read(question, progress, sources);
        if (!scans) {
            answer.found = scans.error();
            return answer;
        }
        answer.found = inspect::calibrateFromSweeps(*scans, progress);
        if (!*answer.found) return answer;
        std::string base;
        if (!question.base.isEmpty()) {
            const auto bytes = readInput(exactBytes(question.base));
            if (!bytes) {
                answer.found = bytes.error();
                return answer;
            }
            base = textOf(*bytes);
        }
        const Result<std::string> file = inspect::calibrationText(base, exactBytes(question.base), **answer.found, sources);
        if (!file) {
            answer.found = file.error();
            return answer;
        }
        answer.file = *file;
        if (!progress("pictures of the seam", 0.0)) return answer;
        answer.seam = seamOf(*question.shown, (*answer.found)->errors);
        answer.inputs = inputs.claims();
    } catch (const std::bad_alloc&) {
        answer.found =
            Error{"there is not enough memory for these scans", question.shown->scan->path, "close other programs or use fewer scans"};
    }
    return answer;
}

void Calibrating::take(const std::shared_ptr<const Answer>& answer) {
    const Result<inspect::SelfCalibration>& calibration = *answer->found;
    if (!calibration) return card_->refuse(coreSentence(calibration.error().sentence()));
    found_ = answer;
    const Seam& seam = answer->seam;
    CalibrationShown shown = calibrationWords(*calibration);
    shown.pictures = {seamWords(seam.lateEdges, seam.met), apartWords(*calibration)};
    shown.pictures[0].beforeImage = seam.edges[0];
    shown.pictures[0].afterImage = seam.edges[1];
    shown.pictures[0].busiest = seam.busiest;
    shown.pictures[1].beforeImage = seam.apart[0];
    shown.pictures[1].afterImage = seam.apart[1];
    shown.pictures[1].busiest = seam.busiest / 3;
    card_->showResult(shown);
}

void Calibrating::askSave() {
    if (found() == nullptr) return;
    SaveQuestion question;
    question.title = tr("Save the calibration");
    question.extension = ".json";
    const QString name = QFileInfo(screenPath_).completeBaseName() + "_calibration.json";
    question.place = QDir(preferences_.folder("exports")).filePath(name);
    question.filters << tr("Calibration (*.json)");
    const QString path = askWhereToSave(card_, question);
    if (!path.isEmpty()) saveTo(path);
}

void Calibrating::saveTo(const QString& path) {
    if (found() == nullptr || saving_) return;
    saving_ = true;
    inBackground(
        this,
        [this, path, answer = found_]() -> std::function<void()> {
            const Result<Done> written = writeWholeFile(exactBytes(path), answer->file);
            return [this, path, answer, written] {
                if (!written) return notice_.showError(written.error());
                preferences_.keepFolder("exports", path);
                notice_.showSaved(path, tr("a calibration"));
                emit saved(path);
                if (found_ != answer) return; // another question was asked meanwhile
                saved_ = path;
                card_->setSaved(path, whyNotApplied());
            };
        },
        [this](const QString& what) {
            notice_.showNotice(NoticeBar::Kind::Error, tr("The calibration could not be saved (%1).").arg(what));
        },
        [this] { saving_ = false; });
}

// A calibration alone does not give a pose (docs/reference/coordinates.md).
QString Calibrating::whyNotApplied() const {
    const Scan& scan = *engine_.picture()->detection->scan;
    const bool recorded = scan.format == "recording" || scan.format == "sweep";
    const bool posed = !files_.options().pose.empty() || isFile(exactText(files::poseSidecar(scan.path).string()));
    if (posed || (recorded && scan.placement)) return {};
    return tr("This scan was opened without a pose, so it has no place that the calibration could correct: give both in Scan > Pose and "
              "Mounting.");
}

void Calibrating::apply() {
    if (saved_.isEmpty() || files_.path() != screenPath_ || !whyNotApplied().isEmpty()) return;
    ReadingOptions options = files_.options();
    options.calibration = exactBytes(absolutePath(saved_));
    files_.readAgain(options, stepName("Apply Calibration"));
}

} // namespace edgescan::ui

#include "moc_calibrating.cpp"
