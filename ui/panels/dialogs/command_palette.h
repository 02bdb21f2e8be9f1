// Runs a command by its name: the operator types a few letters and Return.
#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;

namespace edgescan::ui {

/// The commands are read from the actions, so that the list always equals the menus.
class CommandPalette : public QDialog {
    Q_OBJECT
public:
    CommandPalette(const QList<QAction*>& actions, QWidget* parent);

    [[nodiscard]] QLineEdit* words() const { return words_; }
    [[nodiscard]] QListWidget* list() const { return list_; }
    /// The chosen action; null: no choice.
    [[nodiscard]] QAction* chosen() const { return chosen_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void find();
    void chooseCurrent();

    QList<QAction*> actions_;
    QLineEdit* words_;
    QListWidget* list_;
    QLabel* none_; // in the empty list
    QAction* chosen_ = nullptr;
};

/// Shows the palette and runs the chosen command.
void runFromPalette(QWidget* parent, const QList<QAction*>& actions);

} // namespace edgescan::ui
