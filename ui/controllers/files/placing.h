// Scan > Pose and Mounting: the place that the operator types is checked, shown in the cloud, and stored with the scan as an undo step.
#pragma once

#include "core/scan/georef/place_form.h"
#include "core/scan/grid/reading_options.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <string>

class QUndoCommand;
class QUndoStack;

namespace edgescan::ui {

class Engine;
class Files;
class NoticeBar;
class PlaceDialog;
class Preferences;

/// GUI thread only. The objects passed to it must outlive it.
class Placing : public QObject {
    Q_OBJECT
public:
    Placing(Engine& engine, Files& files, NoticeBar& notice, Preferences& preferences, QUndoStack& undo, QObject* parent);

    /// Shows the form for the scan on the screen.
    void show();
    /// Null before the first show().
    [[nodiscard]] PlaceDialog* dialog() const { return dialog_; }
    /// Nothing is being placed or stored.
    [[nodiscard]] bool settled() const { return !preview_.behind() && !storing_; }

    /// Stores the typed mounting under a name, for the next scan of this scanner.
    void keepScanner(const QString& name);
    void useCalibration(const QString& path);

private:
    struct Question {
        std::shared_ptr<const Scan> scan;
        std::string file; ///< a pose file that holds its calibration
    };
    struct Answer {
        Result<std::shared_ptr<const Scan>> scan;
        QString words; ///< where it is
    };
    /// What is stored with the scan, and how the scan is read.
    struct Stored {
        ReadingOptions options;
        std::optional<std::string> file;
    };
    [[nodiscard]] static Answer placed(const Question& question); // pool's thread
    void make();
    [[nodiscard]] bool load(const Scan& scan);
    void follow();
    void check();
    void endPending();
    void showPreview(const Answer& answer);
    void useSurveyLine(const QString& line, bool northingFirst);
    void useScanner(const QString& name);
    void forgetScanner(const QString& name);
    void askScannerName();
    void askFile();
    void showScanners(const QString& inUse);
    [[nodiscard]] QStringList scannerNames() const;
    void store(const std::optional<std::string>& file, const QString& what);
    bool use(const std::string& scanPath, const Stored& stored);
    void reopen(const ReadingOptions& options);
    void closed();

    Engine& engine_;
    Files& files_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    PlaceDialog* dialog_ = nullptr;
    std::shared_ptr<const Scan> scan_; ///< of the form, as it was opened; null: the form is closed
    PictureSource source_;
    Stored stored_;
    std::string poseBase_, mountingBase_; ///< files with which the form began
    TypedPlace typed_;
    bool previewed_ = false;
    std::shared_ptr<const Scan> awaited_; ///< the placed scan whose picture ends that coordinates are pending
    bool storing_ = false;
    std::optional<Stored> next_;           ///< to be stored after that
    const QUndoCommand* newest_ = nullptr; ///< the step of the last change, to see whether it is the newest of all
    QString message_;                      ///< shown as soon as the scan is opened again
    Derived<Question, Answer> preview_;    // last
};

} // namespace edgescan::ui
