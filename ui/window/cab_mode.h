// Cab mode: the same window for operators with gloves. Tools, numbers and steppers replace menus, cards and sliders.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QRegion>
#include <QTimer>

#include <cstddef>
#include <string>
#include <vector>

class QAbstractButton;
class QMenu;
class QToolButton;

namespace edgescan::inspect {
struct PinnedTarget;
}
namespace edgescan::rocks {
struct Rock;
}

namespace edgescan::ui {

class CabFrame;
class CornerPicture;
class GloveMenus;
class ImageView;
class Keypad;
class MainWindow;
struct PictureMark;
class StateBadge;
class Swipes;
struct SideFacts;

/// GUI thread only. The window must outlive it.
class CabMode : public QObject {
    Q_OBJECT
public:
    /// `middle`: the central content of the window. The frame around it becomes the window's central widget.
    CabMode(MainWindow& window, QWidget* middle);
    ~CabMode() override;

    /// Its buttons do what the commands do: call it after the menus are made.
    void addTools();
    void set(bool on);
    [[nodiscard]] bool on() const { return on_; }
    [[nodiscard]] CabFrame& frame() { return *frame_; }
    [[nodiscard]] CornerPicture& corner() { return *corner_; }
    [[nodiscard]] Keypad& keypad() { return *keypad_; }
    /// What is large and what is in the corner, for a session.
    [[nodiscard]] std::string viewsKept() const;
    void useViews(const QString& kept);

signals:
    void changed(bool on);
    /// The operator held the button for a second.
    void leaveRequested();
    /// Another view is large, or in the corner.
    void viewsChanged();

private:
    enum class Large { Cloud, Range, Edges };
    bool eventFilter(QObject* watched, QEvent* event) override;
    void connectHead();
    void fillMenu();
    void addSideButtons();
    void fillRemoval(QMenu& menu, bool all);
    void fillMeasures(QMenu& menu);
    void openTitleMenu();
    /// The menu with this command of the menu bar: its entries, not a second list. `id`: its path in English.
    [[nodiscard]] QMenu& menuWith(const QString& id) const;
    void fillViews(QMenu& menu);
    void addUndo();
    void connectSide();
    void follow();
    void nameUndone();
    void showScan();
    void showWork();
    void showAsked();
    void showNumbers();
    void showSettings();
    void showCorner();
    void swap();
    void noteChangeUnder(const QRegion& place);
    [[nodiscard]] bool isOnLeftPlace(const QPoint& onScreen) const;
    void showCloud();
    void showLarge(Large which);
    [[nodiscard]] ImageView& imageView() const;
    void fit();
    void zoom(double factor);
    void addZoom();
    void lockDocks(bool on);
    [[nodiscard]] SideFacts ofTarget(const inspect::PinnedTarget& target) const;
    [[nodiscard]] SideFacts ofRock(const rocks::Rock& rock) const;
    [[nodiscard]] SideFacts ofMeasure(std::size_t place) const;
    [[nodiscard]] SideFacts ofNothing() const;
    [[nodiscard]] const rocks::Rock* chosenRock() const;
    void step(int by);
    [[nodiscard]] PictureMark chosenPlace() const;

    MainWindow& window_;
    StateBadge* badge_;
    CabFrame* frame_;
    CornerPicture* corner_;
    CornerPicture* back_; // returns to the cloud, over the image
    QWidget* zoom_;
    QMenu* menu_;
    Keypad* keypad_;
    GloveMenus* gloveMenus_;
    Swipes* swipes_;
    QToolButton* remove_ = nullptr;
    std::vector<QWidget*> ofScan_; // useless without a scan
    QTimer cancelSoon_;
    Large large_ = Large::Cloud, image_ = Large::Range; // image_: in the corner, or the one that was large last
    bool small_ = true;                                 // there is a picture in the corner
    /// Of what exchanged the views, closed or became smaller.
    struct LeftPlace {
        QRegion onScreen;
        QElapsedTimer since{}; // it is painted; not valid: not painted yet
        [[nodiscard]] bool isOver() const;
    };
    std::vector<LeftPlace> left_; // within the time of a second tap
    bool secondTap_ = false;      // at one of these places
    bool on_ = false;
};

} // namespace edgescan::ui
