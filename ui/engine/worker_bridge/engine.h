// The one bridge between the window and the core's threads: opens scans, runs the method, saves results.
#pragma once

#include "core/base/inputs.h"
#include "core/base/result.h"
#include "core/edges/gray/steady_window.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/settings.h"
#include "core/exports/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"
#include "ui/engine/worker_bridge/works.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// Larger scans have a coarse picture first.
inline constexpr std::size_t kCoarseAbove = 2'000'000; // cells

/// Only for the eye: its cells are not those of the scan, and nothing is counted, stored or exported from it.
struct CoarsePicture {
    std::size_t cells = 0;                             ///< of the whole scan
    std::shared_ptr<const edges::Detection> detection; ///< every n-th line and beam, and its gray levels; without mask and edges
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const QImage> gray;
};

/// Every third line and beam, fewer of scans with more than some 20 million cells. Pool's thread.
[[nodiscard]] std::shared_ptr<const CoarsePicture> makeCoarsePicture(const Scan& scan, const edges::Settings& settings);

/// GUI thread only. The screen does not change until the next scan has its first picture; while it is empty, a large scan has a coarse one
/// before.
class Engine : public QObject {
    Q_OBJECT
public:
    explicit Engine(QObject* parent = nullptr);

    /// Reads the file off the GUI thread; cancels an opening that is still running (only the newest is kept).
    void open(const QString& path, const ReadingOptions& options = {});
    /// Opens the demo draw-bell: simulated once, then stored in the cache folder.
    void openDemo(bool afterBlast = false);
    /// Cancels a running opening: the picture on the screen stays.
    void cancel();
    /// Until the first picture of the scan is there.
    [[nodiscard]] bool opening() const { return opener_.behind() || arriving_; }
    /// A scan is being opened for so long that the picture on the screen has to be called the old one.
    [[nodiscard]] bool replacing() const { return replacing_; }
    /// What takes time now, here and in controllers.
    [[nodiscard]] Works& works() { return works_; }
    [[nodiscard]] bool saving() const { return savings_ > 0; }
    [[nodiscard]] bool working() const { return opening() || savings_ > 0; }

    /// Shows a growing scan of a scanner or a played recording; only the newest state is processed. A new stream resets the views; further
    /// scans of the same stream keep them. Cancels a running opening.
    void follow(const std::shared_ptr<const Scan>& scan, const PictureSource& source);
    /// A stream number for follow(); never the same twice.
    [[nodiscard]] static std::uint64_t newStream();

    void setSettings(const edges::Settings& settings);
    [[nodiscard]] const edges::Settings& settings() const { return asked_.settings; }
    /// True if the shown picture was not computed with settings(), or not from the scan that was posted last.
    [[nodiscard]] bool behind() const;

    /// Coordinates of the picture are not those of the pose that is typed: they are not shown.
    void setPlacePending(bool on);
    [[nodiscard]] bool placePending() const { return placePending_; }

    /// The newest picture, null before the first.
    [[nodiscard]] const std::shared_ptr<const Picture>& picture() const { return picture_; }
    /// For an undo step: true while the scan of now is on the screen. Null without one.
    [[nodiscard]] std::function<bool()> hereNow() const {
        if (!picture_) return {};
        return [this, key = scanKey(picture_.get())] { return scanKey(picture_.get()) == key; };
    }
    /// The same with its edges as strong as they are likely to be borders of rocks; null until that is worked out.
    [[nodiscard]] const std::shared_ptr<const Picture>& bordered() const { return bordered_; }
    /// Of the scan that is being opened, until its first picture is there; null: it is small, or another scan is on the screen.
    [[nodiscard]] const std::shared_ptr<const CoarsePicture>& coarse() const { return coarse_; }
    /// Scans with more cells have a coarse picture first.
    void setCoarseAbove(std::size_t cells) { coarseAbove_ = cells; }

    /// Saves the shown picture's data, in the scan's usual frame unless `options` says otherwise.
    void save(exports::ExportContent what, const QString& path, const std::optional<exports::ExportOptions>& options = std::nullopt);

signals:
    void workStarted(const QString& title);
    void workProgressed(const QString& stage, double fraction);
    void workEnded();
    void replacingChanged(bool on);
    void placePendingChanged();
    /// A coarse picture came; or it is gone, because its opening was cancelled or failed.
    void coarseChanged();
    /// A scan was read, and its first picture comes with the next signal.
    void opened(const QString& path);
    /// `count`: points or cells in the file. `coordinates`: their frame and extent; empty for pictures.
    void saved(edgescan::exports::ExportContent what, const QString& path, qint64 count, const QString& coordinates);
    void failed(const QString& sentence);
    /// After failed(): a file that could not be read so.
    void refused(const QString& path);
    void settingsChanged();
    void pictureReady();
    void borderedReady();
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
        std::shared_ptr<const InputClaims> inputs; // files that must not be overwritten while the scan is shown
    };
    /// A scan that was read and has no picture yet.
    struct Arrival {
        QString path;
        std::uint64_t stream = 0;
        std::shared_ptr<const InputClaims> inputs;
    };
    void dropArrival();
    void endOpening();
    void startOpening(const QString& title, const QString& path, std::function<Result<Scan>(const Progress&)> read);
    [[nodiscard]] Opened read(const Opening& opening, const Asker& asker); // pool's thread
    void finishOpening(const QString& path, const Opened& opened);
    void endWork();
    void post(const std::shared_ptr<const Scan>& scan, const PictureSource& source);
    /// The inputs of a picture.
    struct Asked {
        std::shared_ptr<const Scan> scan;
        edges::Settings settings;
        PictureSource source;
        bool coarseFirst = false;
    };
    void setCoarse(const std::shared_ptr<const CoarsePicture>& coarse);
    [[nodiscard]] std::shared_ptr<const Picture> run(const Asked& asked, const Asker& asker);                   // pool's thread
    [[nodiscard]] std::shared_ptr<const Picture> workOutBorders(const std::shared_ptr<const Picture>& picture); // pool's thread
    void storePicture(const std::shared_ptr<const Picture>& newest);

    Works works_;
    Asked asked_; // no scan: nothing was posted yet
    std::optional<Arrival> arriving_;
    std::unique_ptr<Works::Running> openingWork_;
    QTimer replacingTimer_;
    bool replacing_ = false;
    bool placePending_ = false;
    std::shared_ptr<const Picture> picture_, bordered_;
    std::shared_ptr<const CoarsePicture> coarse_;
    std::size_t coarseAbove_ = kCoarseAbove;
    int savings_ = 0;
    std::shared_ptr<const InputClaims> inputs_;           // of the last opened scan
    std::mutex poolMutex_;                                // of what the pool's threads share:
    std::vector<std::shared_ptr<const Picture>> retired_; // pictures to be freed by the pool's thread
    KnownBorders knownBorders_;                           // the newest that were worked out

    // Used only by run().
    edges::Pipeline pipeline_;
    edges::SteadyWindow window_;
    std::shared_ptr<const CloudGeometry> cloud_;
    std::shared_ptr<const Scan> cloudScan_; // the scan of cloud_
    PictureSource lastSource_;              // of the last run
    std::shared_ptr<const Picture> lastMade_;

    Derived<std::weak_ptr<const Picture>, Picture> borders_; // weak: the pool's thread frees a picture that is gone
    Derived<Asked, Picture> pictures_;                       // last, with the opener: they use all of the above
    Derived<Opening, Opened> opener_;
};

} // namespace edgescan::ui
