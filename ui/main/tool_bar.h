// The bar of tools: what a click or a drag means, what is to be clicked next.
#pragma once

#include <QToolBar>

class QLabel;

namespace edgescan::ui {

class ToolBar : public QToolBar {
    Q_OBJECT
public:
    explicit ToolBar(QWidget* parent = nullptr);

    /// A button with the action's own words.
    void add(QAction& action);
    void addGap();
    /// What the tool asks for; empty: nothing.
    void showAsked(const QString& words);
    /// What is selected and hidden.
    void showSelected(const QString& words);
    [[nodiscard]] QString shown() const;

private:
    void showWords();

    QLabel* words_;
    QAction* wordsPlace_;
    QString asked_, selected_;
};

} // namespace edgescan::ui
