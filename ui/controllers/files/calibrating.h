// Scan > Calibrate: estimates the mounting errors from the scan on the screen and other scans of the same mounting, off the GUI thread. The
// result is saved and applied only on the operator's request.
#pragma once

#include "core/base/inputs.h"
#include "core/inspect/calibration/calibration_file.h"
#include "core/scan/grid/reading_options.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QImage>
#include <QObject>
#include <QPoint>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

class CalibrationCard;
class Files;
class Preferences;
class NoticeBar;
class Engine;

/// GUI thread only. The objects passed to it must outlive it.
class Calibrating : public QObject {
    Q_OBJECT
public:
    Calibrating(Engine& engine, Files& files, NoticeBar& notice, Preferences& preferences, QObject* parent);

    /// Shows the card for the scan on the screen.
    void show();
    /// Adds scans of the same mounting; drops the former result.
    void add(const QStringList& paths);
    /// Sets the robot's present calibration file; empty: none.
    void setBase(const QString& path);
    void start();
    void saveTo(const QString& path);
    /// Opens the scan on the screen again with the saved file, as an undo step.
    void apply();

    /// Null before the first show().
    [[nodiscard]] CalibrationCard* card() const { return card_; }
    /// Null while there is no result.
    [[nodiscard]] const inspect::SelfCalibration* found() const { return found_ && *found_->found ? &**found_->found : nullptr; }
    [[nodiscard]] bool saving() const { return saving_; }

signals:
    void saved(const QString& path);

private:
    struct Question {
        std::shared_ptr<const edges::Detection> shown; ///< with the edges of the shown picture
        QStringList others;
        ReadingOptions reading; ///< for the other scans
        QString base;
    };
    /// The seam before and after.
    struct Seam {
        std::array<QImage, 2> edges, apart;
        std::array<double, 2> met{};
        std::size_t lateEdges = 0;
        QPoint busiest;
    };
    struct Answer {
        std::optional<Result<inspect::SelfCalibration>> found;
        std::string file; ///< the text to be saved
        Seam seam;
        std::shared_ptr<const InputClaims> inputs; ///< files that must not be overwritten
    };
    using Progress = std::function<bool(const char* stage, double fraction)>;
    [[nodiscard]] static Answer run(const Question& question, const Progress& progress); // pool's thread
    [[nodiscard]] static Result<std::vector<std::shared_ptr<const Scan>>> read(const Question& question, const Progress& progress,
                                                                               std::vector<inspect::CalibrationSource>& sources);
    static Seam seamOf(const edges::Detection& shown, const AssemblyErrors& errors);
    void take(const std::shared_ptr<const Answer>& answer);
    void ask();
    void askAdd();
    void askBase();
    void askSave();
    void giveUp();
    void followScreen();
    [[nodiscard]] QString whyNotApplied() const;

    Engine& engine_;
    Files& files_;
    NoticeBar& notice_;
    Preferences& preferences_;
    CalibrationCard* card_ = nullptr;
    QString screenPath_; // path of the card's scan
    QStringList others_;
    QString base_, saved_;
    std::shared_ptr<const Answer> found_;
    bool saving_ = false;
    Derived<Question, Answer> calibration_; // last
};

} // namespace edgescan::ui
