// The docks of the window: what a dock shows decides whether it is wanted, the width and the operator whether it is open.
#pragma once

#include <QObject>
#include <QString>

#include <set>
#include <vector>

class QDockWidget;
class QMainWindow;
class QStackedWidget;
class QWidget;

namespace edgescan::ui {

class DockRail;
class Preferences;
struct Viewer;

/// What hides all docks: cab mode, or the start page, which covers their places.
enum class DockLock { Cab, Start };

/// GUI thread only. A dock that the operator opened or folded stays so, also in the next session, until reset().
class Docks : public QObject {
    Q_OBJECT
public:
    /// Adds the docks of the viewer's panels to the window. All must outlive it.
    Docks(QMainWindow& window, DockRail& rail, Viewer& viewer);

    /// Opens and folds them for the window's size. `most`: px of its width that the docks at the right may take.
    void fit(int most);
    /// As fit() would open them without what the operator did, in their first order.
    void reset();
    /// After a stored layout is back: what is open in it is wanted, though its content may arrive later.
    void wantOpen();
    /// While locked all are hidden. In cab mode the operator can open the table of rocks; cover() places it.
    void setLocked(DockLock by, bool on);
    /// On: the panels of edges, rocks and targets are in this stack, in this order, with their titles; off: in their docks again.
    void lend(QStackedWidget& stack, bool on);
    /// Gives a table that is open in cab mode the place of the views, in the window.
    void cover(const QRect& views);
    [[nodiscard]] bool locked() const { return !locks_.empty(); }
    /// After fit(): gives the open docks at the right the width to which the operator dragged them, else their usual one. Returns px of the
    /// window's width that they take, with the rail.
    int setWidths(int most);
    /// On while the operator drags the edge of a dock.
    void setHeld(bool on);
    /// For the settings memory; 0: it was never dragged.
    [[nodiscard]] int draggedWidth() const { return dragged_; }
    void setDraggedWidth(int width) { dragged_ = width; }
    [[nodiscard]] int draggedTableHeight() const { return draggedTable_; }
    void setDraggedTableHeight(int height) { draggedTable_ = height; }
    /// On: A is in the views; the titles say that the panels are of B.
    void showOfB(bool on);

signals:
    /// A dock is wanted, or the operator opened or folded one: fit() is needed.
    void changed();

private:
    enum class Side { Right, Bottom };
    struct Dock {
        QDockWidget* widget;
        Side side;
        int opensFrom;       ///< px of the window: in a narrower one only the operator opens it
        bool wanted = false; ///< there is something to show in it
    };
    void add(const QString& title, const char* name, QWidget* content, Side side, int opensFrom);
    void want(const char* name, bool on);
    [[nodiscard]] QDockWidget* rocksInFront();
    void keep(QDockWidget& dock, const QString& byHand);
    [[nodiscard]] Dock& named(const char* name);
    [[nodiscard]] Side sideOf(const Dock& dock) const;
    [[nodiscard]] bool isOpenAt(const Dock& dock, int width, int most) const;
    [[nodiscard]] int usualWidth(const QDockWidget& dock) const;
    [[nodiscard]] std::vector<QDockWidget*> openAtRight() const;
    [[nodiscard]] int widthNow() const; ///< of the docks at the right
    void place();
    void stack();
    void stackOnRocks(QDockWidget& dock, bool together, Qt::DockWidgetArea otherwise);
    void showTitles();
    [[nodiscard]] int neededHeight(const QDockWidget& dock) const;
    void shareHeight();
    [[nodiscard]] bool tableIsBelow(); ///< the table of rocks is below the views
    void setTableHeight();

    QMainWindow& window_;
    DockRail& rail_;
    Preferences& preferences_;
    std::vector<Dock> docks_;                // in their order from top to bottom
    const QDockWidget* behindTab_ = nullptr; // the operator chose it in a menu while another tab hid it
    std::set<DockLock> locks_;
    bool ofB_ = false;
    bool held_ = false;
    int heldFrom_ = 0;       // width when the drag began; 0: it has changed since
    bool restacked_ = false; // docks left or joined a place: each place gets its height again
    int arranged_ = 0;       // width set by setWidths()
    int dragged_ = 0;        // 0: the width follows the window
    int arrangedTable_ = 0;  // height set by setTableHeight()
    int draggedTable_ = 0;   // 0: the height follows the window
    int triesOfTable_ = 0;   // to give it that height
};

} // namespace edgescan::ui
