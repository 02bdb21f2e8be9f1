// Cab mode: the same window for operators with gloves. One column shows the desk's panels, one at a time; tools replace the menus.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QRegion>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <string>
#include <vector>

class QMenu;
class QToolButton;

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
    /// The menu with this command of the menu bar: its entries, not a second list. `id`: its path in English.
    [[nodiscard]] QMenu& menuWith(const char* id) const;
    static constexpr const char* kDirection = "View/Look from/Top (from Above)";
    void fillViews(QMenu& menu);
    void addUndo();
    void follow();
    void nameUndone();
    void showScan();
    void showWork();
    void showAsked();
    void showPanel();
    void showCorner();
    void swap();
    void noteChangeUnder(const QRegion& place);
    [[nodiscard]] bool isOnLeftPlace(const QPoint& onScreen) const;
    void showCloud();
    void showLarge(Large which);
    [[nodiscard]] ImageView& imageView() const;
    void zoom(double factor);
    void addZoom();
    void lockDocks(bool on);
    [[nodiscard]] const rocks::Rock* chosenRock() const;
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
    QToolButton* tune_;
    QString shown_;                // of the panel: changes with what is chosen
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
