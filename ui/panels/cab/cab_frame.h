// The central area of the window with the parts that only cab mode has around it: head, tools, and one panel of the desk.
#pragma once

#include <QWidget>

#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QSpacerItem;
class QStackedWidget;
class QToolButton;

namespace edgescan::ui {

class ElidedLabel;
class HoldButton;

/// The top row in cab mode. GUI thread only.
class CabHead : public QWidget {
    Q_OBJECT
public:
    /// `badge`: the source of the picture; always at the right end.
    explicit CabHead(QWidget* badge, QWidget* parent = nullptr);

    void showScan(const QString& name, const QString& facts);
    /// Shows the text instead of the facts, with the button that cancels; empty: the facts.
    void showWork(const QString& text);
    [[nodiscard]] bool working() const { return !work_.isEmpty(); }
    /// Whatever is shown, it fits into a narrow window.
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QToolButton* menu() const { return menu_; }
    [[nodiscard]] QToolButton* open() const { return open_; }
    [[nodiscard]] QToolButton* connectScanner() const { return connect_; }
    /// The time; hidden where the row has no room for it.
    [[nodiscard]] QLabel* clock() const { return clock_; }
    [[nodiscard]] QToolButton* warnings() const { return warnings_; }
    [[nodiscard]] QToolButton* cancel() const { return cancel_; }
    [[nodiscard]] HoldButton* leave() const { return leave_; }

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showClock();
    [[nodiscard]] int reservedWidth() const;
    void fit();

    QToolButton* menu_;
    QToolButton* open_;
    QToolButton* connect_;
    QLabel* name_;
    ElidedLabel* facts_;
    QToolButton* cancel_;
    QToolButton* warnings_;
    QLabel* clock_;
    HoldButton* leave_;
    QWidget* badge_;
    QString scan_, scanFacts_, work_;
    int reservedWidth_ = 0; // px, when the rest was fitted
};

/// GUI thread only.
class CabFrame : public QWidget {
    Q_OBJECT
public:
    CabFrame(QWidget* middle, QWidget* badge);

    void setCab(bool on);
    /// As few columns of tools as the height has room for; the last tools are at the bottom.
    void addTool(QToolButton* button);
    /// Such as Report, below the panel.
    void addBelowPanel(QToolButton* button);
    /// `ofB`: A is in the views meanwhile.
    void showPanel(int place, bool ofB);
    [[nodiscard]] CabHead& head() { return *head_; }
    [[nodiscard]] QWidget& tools() { return *tools_; }
    /// Empty while the panels are at the desk.
    [[nodiscard]] QStackedWidget& panels() { return *panels_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void layTools();

    CabHead* head_;
    QWidget *tools_, *side_;
    QGridLayout* toolsGrid_;
    std::vector<QToolButton*> buttons_;
    QLabel* ofB_;
    QStackedWidget* panels_;
    QHBoxLayout* foot_;
    QSpacerItem* leastWide_;
};

} // namespace edgescan::ui
