// The bar of tools: what is done most, what a click or a drag means, what is to be clicked next.
#pragma once

#include <QToolBar>

#include <vector>

class QLabel;
class QMenu;
class QToolButton;

namespace edgescan::ui {

/// Signs, with words beside them where there is room for all words. GUI thread only.
class ToolBar : public QToolBar {
    Q_OBJECT
public:
    enum class Word { Always, WhereRoom };

    explicit ToolBar(QWidget* parent = nullptr);

    /// A button with the action's key in its tip. `sign`: of toolIcon().
    void add(QAction& action, const char* sign, const QString& word, Word shown = Word::WhereRoom);
    /// A button that opens `menu`, which becomes its child. It is lit while one of `lights` is on.
    void add(QMenu* menu, const char* name, const char* sign, const QString& word, const QList<QAction*>& lights);
    void addGap();
    /// What the tool asks for; empty: nothing.
    void showAsked(const QString& words);
    /// What is selected and hidden.
    void showSelected(const QString& words);
    [[nodiscard]] QString shown() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void take(QToolButton& button, Word shown);
    void fit();
    void showWords();

    struct Button {
        QToolButton* button = nullptr;
        Word shown = Word::WhereRoom;
    };
    std::vector<Button> buttons_;
    QLabel* words_;
    QAction* wordsPlace_;
    QString asked_, selected_;
};

} // namespace edgescan::ui
