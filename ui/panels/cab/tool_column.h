// The tools of cab mode: icons with text in one column, or two columns in a low window; Undo and Redo are always at the bottom.
#pragma once

#include <QWidget>

#include <utility>
#include <vector>

class QGridLayout;
class QToolButton;

namespace edgescan::ui {

/// Large enough for gloves, with an icon and text below it.
void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word);
[[nodiscard]] QToolButton* gloveButton(const char* name, const char* sign, const QString& word);

/// A small triangle: a tap opens a menu.
void showMenuSign(QToolButton& button, bool on = true);

/// GUI thread only.
class ToolColumn : public QWidget {
    Q_OBJECT
public:
    explicit ToolColumn(QWidget* parent = nullptr);

    QToolButton* add(const char* name, const char* sign, const QString& word);
    /// Sets the buttons at the bottom, the lowest first; of two columns each has one.
    void setFoot(std::vector<QToolButton*> buttons);

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();

    std::vector<QToolButton*> buttons_;
    std::vector<QToolButton*> foot_;
    QGridLayout* grid_;
    std::pair<int, int> laidOut_{}; // rows and buttons
};

} // namespace edgescan::ui
