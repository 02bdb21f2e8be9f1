// A/B comparison: keeps a picture as A and compares the picture on the screen with it. A key flips between both in all views.
#pragma once

#include "core/inspect/session_file/viewer_state.h"
#include "ui/base/notice_bar.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/works.h"
#include "ui/panels/change/comparison.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>

class QUndoStack;

namespace edgescan::ui {

class ChangeLegend;
class Files;
class LinkedViews;
class Preferences;
class Engine;

/// GUI thread only. The objects passed to it must outlive it.
class Comparing : public QObject {
    Q_OBJECT
public:
    Comparing(Engine& engine, LinkedViews& views, ChangeLegend& legend, Files& files, NoticeBar& notice, Preferences& preferences,
              QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    /// The picture on the screen becomes A, until another one is kept or A is removed. Each of these actions is one undo step. A step
    /// stores no picture: it makes the picture again.
    void keep();
    void forget(const std::function<bool()>& here = {});
    /// Forgets A, and offers to open it if it is another scan.
    void end();
    [[nodiscard]] const std::shared_ptr<const Picture>& pictureA() const { return pictureA_; }
    /// A while it is drawn in place of the engine's picture; else null.
    [[nodiscard]] const Picture* drawnA() const;
    /// A, as it can be made again; empty: there is none, or it is of no file.
    [[nodiscard]] const std::optional<inspect::EarlierScan>& part() const { return earlier_; }
    void setPart(const std::optional<inspect::EarlierScan>& part);
    /// Another scan becomes A. It is read off the GUI thread, with the reading options of the scan on the screen, and its edges are found
    /// with the current settings.
    void compareWith(const QString& path);
    void askScan();
    /// B becomes A, and the scan of A is opened.
    void swap();
    /// Opens the demo after the blast, with the demo before it as A.
    void openDemoPair();

    /// Off: edges have their normal colours; the key still shows A.
    void setDifferenceShown(bool on);
    /// The points have the colours of their distances from the surfaces of A, and the legend has a histogram.
    void setByDistance(bool on);
    [[nodiscard]] bool byDistance() const { return byDistance_; }
    /// The kinds of change that are shown.
    void setRows(const ChangeRows& rows);
    [[nodiscard]] const ChangeRows& rows() const { return rows_; }
    /// On: shows A in all views; off: shows the current picture again.
    void flip(bool on);
    /// The comparison of A with the picture on the screen; null while unknown or without A.
    [[nodiscard]] const std::shared_ptr<const Comparison>& comparison() const { return comparison_; }
    /// True if no scan is being read or compared.
    [[nodiscard]] bool settled() const { return !reader_.behind() && !comparer_.behind(); }
    /// All views zoom to the next changed region, the largest first, or to the one before.
    void nextRegion() { goToRegion(1); }
    void previousRegion() { goToRegion(-1); }
    /// Some cells of the region that the views zoomed to last, or of the largest one; none while no difference is shown.
    [[nodiscard]] std::vector<std::uint32_t> someOfRegion() const;
    /// The region that was visited last.
    [[nodiscard]] std::optional<std::size_t> visited() const { return comparison_ ? region_ : std::nullopt; }

    /// Handles the key that flips while it is pressed.
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pictureAChanged(bool some);
    void rowsChanged();
    void byDistanceChanged(bool on);
    void flipped(bool on);
    void differenceShownChanged(bool on);
    /// The operator chose another A.
    void begun();
    /// A could not be read, or the comparison could not be made.
    void refused(const QString& sentence);

private:
    struct Reading {
        inspect::EarlierScan from;
        std::shared_ptr<const Scan> scan; ///< set if it is the scan on the screen
        bool asStep = false;              ///< the result becomes an undo step
        /// Shows the stage; false: the reading is not wanted any more
        std::function<bool(const Asker& asker, const char* stage, double fraction)> show{};
    };
    using Read = Result<std::shared_ptr<const Picture>>;
    using Compared = Result<std::shared_ptr<const Comparison>>;
    [[nodiscard]] static Read pictureOf(const Reading& reading, const Asker& asker); // pool's thread
    void ask();
    [[nodiscard]] std::shared_ptr<const Compared> compare(const ComparisonAsked& asked); // pool's thread
    void finishComparison(const ComparisonAsked& asked, const Compared& made);
    void finishReading(const Reading& asked, const Read& read);
    void note(NoticeBar::Kind kind, const QString& sentence);
    void endNotes();
    void forgetDemo();
    void refuse(NoticeBar::Kind kind, const QString& sentence);
    void use(std::shared_ptr<const Picture> kept, std::optional<inspect::EarlierScan> from);
    void read(const inspect::EarlierScan& from, bool asStep);
    /// `here`: the step is undone on that scan only.
    void push(const QString& what, const std::shared_ptr<const Picture>& after, const std::optional<inspect::EarlierScan>& from,
              std::function<bool()> here = {});
    [[nodiscard]] std::optional<inspect::EarlierScan> fromShown() const;
    void show();
    void showLegend();
    [[nodiscard]] bool comparable() const;
    void goToRegion(int by);
    void outlineRegion(const std::vector<std::uint32_t>& cells);

    Engine& engine_;
    LinkedViews& views_;
    ChangeLegend& legend_;
    Files& files_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    std::shared_ptr<const Picture> pictureA_;
    std::optional<inspect::EarlierScan> earlier_;
    std::shared_ptr<const Comparison> comparison_;
    ChangeRows rows_{true, true, true, true, true, true};
    bool shown_ = true;
    bool refused_ = false;    ///< A and the picture on the screen could not be compared
    QString readingNote_;     ///< that A is being read
    QStringList notes_;       ///< of the comparison, in the notice bar; they go with A
    bool bySurfaces_ = false; ///< the operator lets the surfaces line up A with a scan without a place, or the other way round
    bool byDistance_ = false;
    bool pairWanted_ = false;                                    ///< the demo after the blast is being opened
    bool pairShown_ = false;                                     ///< it is on the screen, or was the last one
    std::optional<std::size_t> region_;                          ///< the changed region that the views zoomed to last
    QRectF regionPart_;                                          ///< the part of the images that it zoomed to
    std::shared_ptr<const std::vector<std::uint32_t>> outlined_; ///< of that region in the cloud; null: no region
    quint32 heldCode_ = 0;                                       ///< of the flip key while it is pressed
    std::unique_ptr<Works::Running> readingWork_, comparingWork_;
    std::shared_ptr<const Comparison> last_; // used only by compare()
    Derived<Reading, Read> reader_;
    Derived<ComparisonAsked, Compared> comparer_; // last
};

} // namespace edgescan::ui
