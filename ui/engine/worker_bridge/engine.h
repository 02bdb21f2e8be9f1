// The one bridge between the window and the core's threads: opens scans, runs the method, saves results.
#pragma once

#include "core/base/inputs.h"
#include "core/base/result.h"
#include "core/edges/gray/steady_window.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/settings.h"
#include "core/exports/provenance/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace edgescan::ui {

/// GUI thread only. What is on the screen stays until the next scan has its first picture.
class Engine : public QObject {
    Q_OBJECT
public:
    explicit Engine(QObject* parent = nullptr);

    /// Reads the file on a thread of its own; a file that is still being read is given up (newest wins).
    void open(const QString& path, const ReadingOptions& options = {});
    /// The demo draw-bell: simulated once, then kept in the cache folder.
    void openDemo(bool afterBlast = false);
    /// Gives up the opening that is under way. A saving goes on: it is short, and its result must be told.
    void cancel();
    [[nodiscard]] bool opening() const { return opener_.behind(); }
    [[nodiscard]] bool saving() const { return savings_ > 0; }
    [[nodiscard]] bool working() const { return opening() || savings_ > 0; }

    /// Shows a scan that grows, from a scanner or a recording that is played: newest wins. A new stream sets the views up anew;
    /// further scans of it keep them. Gives up an opening that is under way.
    void follow(const std::shared_ptr<const Scan>& scan, const PictureSource& source);
    /// For follow(): never the same twice.
    [[nodiscard]] static std::uint64_t newStream();

    void setSettings(const Settings& settings);
    [[nodiscard]] const Settings& settings() const { return asked_.settings; }
    /// The picture shown was not computed with settings(), or not of the scan posted last.
    [[nodiscard]] bool behind() const;

    /// The newest picture, null before the first.
    [[nodiscard]] const std::shared_ptr<const Picture>& picture() const { return picture_; }

    /// Of the picture shown, in the scan's usual frame unless `options` say otherwise.
    void save(ExportContent what, const QString& path, const std::optional<ExportOptions>& options = std::nullopt);

signals:
    void workStarted(const QString& title);
    void workProgressed(const QString& stage, double fraction);
    void workEnded();
    /// A scan was read; its first picture follows.
    void opened(const QString& path);
    /// `count`: points or cells in the file.
    void saved(edgescan::ExportContent what, const QString& path, qint64 count);
    void failed(const QString& sentence);
    void settingsChanged();
    void pictureReady();
    /// After pictureReady(): the first picture of another file, scanner or recording.
    void streamChanged();

private:
    using Progress = std::function<bool(const char* stage, double fraction)>;
    struct Opening {
        QString path; // empty: the demo
        std::function<Result<Scan>(const Progress&)> read;
    };
    struct Opened {
        Result<std::shared_ptr<const Scan>> scan;
        std::shared_ptr<const InputClaims> inputs; // files that nothing may be saved over while the scan is shown
    };
    void startOpening(const QString& title, const QString& path, std::function<Result<Scan>(const Progress&)> read);
    [[nodiscard]] Opened read(const Opening& opening, const Asker& asker); // pool's thread
    void takeOpened(const QString& path, const Opened& opened);
    void endWork();
    void post(const std::shared_ptr<const Scan>& scan, const PictureSource& source);
    /// What a picture is made of.
    struct Asked {
        std::shared_ptr<const Scan> scan;
        Settings settings;
        PictureSource source;
    };
    [[nodiscard]] std::shared_ptr<const Picture> run(const Asked& asked); // pool's thread
    void takePicture(const std::shared_ptr<const Picture>& newest);

    Asked asked_; // no scan: nothing was posted yet
    std::shared_ptr<const Picture> picture_;
    int savings_ = 0;
    std::shared_ptr<const InputClaims> inputs_; // of the scan that was opened last
    std::mutex retiredMutex_;
    std::vector<std::shared_ptr<const Picture>> retired_; // to be freed on the pool's thread

    // Of run() alone.
    Pipeline pipeline_;
    SteadyWindow window_;
    std::shared_ptr<const CloudGeometry> cloud_;
    std::shared_ptr<const Scan> cloudScan_; // that cloud_ was made of
    PictureSource lastSource_;              // of the last run
    std::shared_ptr<const Picture> lastMade_;

    Derived<Asked, Picture> pictures_; // last, with the opener: they use all of the above
    Derived<Opening, Opened> opener_;
};

} // namespace edgescan::ui
