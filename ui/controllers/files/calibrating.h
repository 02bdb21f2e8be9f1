// Scan > Calibrate: the errors of the assembly from the scan on the screen and others of it, worked out off the GUI thread; saved
// and applied only when somebody says so.
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
class Memory;
class NoticeBar;
class Engine;

/// GUI thread only. What it is given must outlive it.
class Calibrating : public QObject {
    Q_OBJECT
public:
    Calibrating(Engine& engine, Files& files, NoticeBar& notice, Memory& memory, QObject* parent);

    /// The card, with the scan on the screen.
    void show();
    /// Further scans of the same assembly; what was found before is gone.
    void add(const QStringList& paths);
    /// The robot's present file; empty: none.
    void setBase(const QString& path);
    void start();
    void saveTo(const QString& path);
    /// Opens the scan on the screen again with the file that was saved, as a step of undo.
    void apply();

    /// Null before the first show().
    [[nodiscard]] CalibrationCard* card() const { return card_; }
    /// Null while nothing was found.
    [[nodiscard]] const SelfCalibration* found() const { return found_ && *found_->found ? &**found_->found : nullptr; }
    [[nodiscard]] bool saving() const { return saving_; }

signals:
    void saved(const QString& path);

private:
    struct Question {
        std::shared_ptr<const Detection> shown; ///< its edges are those of the picture
        QStringList others;
        ReadingOptions reading; ///< of the others
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
        std::optional<Result<SelfCalibration>> found;
        std::string file; ///< as it is saved
        Seam seam;
        std::shared_ptr<const InputClaims> inputs; ///< nothing is saved over them
    };
    using Progress = std::function<bool(const char* stage, double fraction)>;
    [[nodiscard]] static Answer run(const Question& question, const Progress& progress); // pool's thread
    [[nodiscard]] static Result<std::vector<std::shared_ptr<const Scan>>> read(const Question& question, const Progress& progress,
                                                                               std::vector<CalibrationSource>& sources);
    static Seam seamOf(const Detection& shown, const AssemblyErrors& errors);
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
    Memory& memory_;
    CalibrationCard* card_ = nullptr;
    QString screenPath_; // of the scan that the card is about
    QStringList others_;
    QString base_, saved_;
    std::shared_ptr<const Answer> found_;
    bool saving_ = false;
    Derived<Question, Answer> calibration_; // last
};

} // namespace edgescan::ui
