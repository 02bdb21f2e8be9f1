// Cab mode: the same window for operators with gloves. Tools, numbers and steppers replace menus, cards and sliders.
#pragma once

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <vector>

class QAbstractButton;
class QMenu;
class QToolButton;

namespace edgescan::rocks {
struct Rock;
}

namespace edgescan::ui {

class CabFrame;
class CornerPicture;
class GloveMenus;
class Keypad;
class ZoomButtons;
class MainWindow;
struct PictureMark;
class StateBadge;
class Swipes;
struct TargetNumbers;

/// GUI thread only. The window must outlive it.
class CabMode : public QObject {
    Q_OBJECT
public:
    /// `middle`: the central content of the window. The frame around it becomes the window's central widget.
    CabMode(MainWindow& window, QWidget* middle);
    ~CabMode() override;

    void set(bool on);
    [[nodiscard]] bool on() const { return on_; }
    [[nodiscard]] CabFrame& frame() { return *frame_; }
    [[nodiscard]] CornerPicture& corner() { return *corner_; }
    [[nodiscard]] Keypad& keypad() { return *keypad_; }

signals:
    void changed(bool on);
    /// The operator held the button for a second.
    void leaveRequested();

private:
    enum class Corner { Range, Edges, None };
    void connectHead();
    void fillMenu();
    void addTools();
    void addSideButtons();
    void addMeasures(QMenu& menu);
    void fillRemoval(QMenu& menu) const;
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
    void zoom(double factor);
    void lockDocks(bool on);
    [[nodiscard]] TargetNumbers numbers() const;
    [[nodiscard]] TargetNumbers ofRock(const rocks::Rock& rock) const;
    [[nodiscard]] TargetNumbers ofMeasure(std::size_t place) const;
    [[nodiscard]] const rocks::Rock* chosenRock() const;
    void step(int by);
    [[nodiscard]] PictureMark chosenPlace() const;

    MainWindow& window_;
    StateBadge* badge_;
    CabFrame* frame_;
    CornerPicture* corner_;
    CornerPicture* back_; // returns to the cloud, over the image
    ZoomButtons* zoom_;
    QMenu* menu_;
    Keypad* keypad_;
    GloveMenus* gloveMenus_;
    Swipes* swipes_;
    QToolButton* remove_ = nullptr;
    std::vector<QWidget*> ofScan_; // useless without a scan
    QTimer cancelSoon_;
    Corner shown_ = Corner::Range;
    bool on_ = false;
    bool swapped_ = false; // the large pane is an image, and the cloud is in the corner
};

} // namespace edgescan::ui
