// The tool bar: the most frequent commands, the tools for clicks and drags, and a prompt for the next click.
#pragma once

#include <QToolBar>

#include <vector>

class QLabel;
class QMenu;
class QToolButton;

namespace edgescan::ui {

class MainWindow;

/// Icons, with the names for which the bar has room next to the place of the prompt: a prompt never moves a button. GUI thread only.
class ToolBar : public QToolBar {
    Q_OBJECT
public:
    /// Which names appear first; those of well-known icons come last.
    enum class Word { First, Next, Last };

    explicit ToolBar(QWidget* parent = nullptr);

    /// A button with the action's shortcut in its tool tip. `sign`: name for toolIcon().
    void add(QAction& action, const char* sign, const QString& word, Word shown = Word::Next);
    /// A button that opens `menu`, which becomes its child. It is highlighted while one of `lights` is on.
    void add(QMenu* menu, const char* name, const char* sign, const QString& word, const QList<QAction*>& lights);
    /// Disabled until a scan is open.
    void needsScan(QAction& action) { ofScan_ << &action; }
    void addGap();
    /// The prompt of the tool; empty: none.
    void showAsked(const QString& words);
    /// What the tool of the rocks waits for; empty: no tool.
    void showRockTool(const QString& words);
    /// Text about selected and hidden cells.
    void showSelected(const QString& words);
    [[nodiscard]] QString shown() const;
    /// The width of the window without what is reserved: buttons without room go into the menu at the end.
    [[nodiscard]] QSize sizeHint() const override;
    /// Pixels of the window's width for the bar of the badge right of it.
    void reserve(int pixels);
    /// Px that its buttons may need: what has no room there is in the menu at the end.
    void setMost(int pixels);
    /// Off: the buttons of a scan are disabled, with their commands.
    void setScanOpen(bool on);

signals:
    /// What shown() returns.
    void wordsChanged(const QString& words);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addButton(QToolButton& button, Word shown);
    void fit();
    void showWords();

    struct Button {
        QToolButton* button = nullptr;
        Word shown = Word::Next;
    };
    std::vector<Button> buttons_;
    QList<QAction*> ofScan_;
    int reserved_ = 0; // px of the window's width
    int most_ = QWIDGETSIZE_MAX;
    QLabel* words_;
    QAction* wordsPlace_;
    QString asked_, rockTool_, selected_;
};

/// Adds the buttons of commands. Call it after the menus are made.
void addToolButtons(MainWindow& window);

} // namespace edgescan::ui
