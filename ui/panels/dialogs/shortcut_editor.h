// Every command with its shortcut in one table: the operator finds a command and presses another key.
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QList>
#include <QString>

#include <functional>
#include <vector>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace edgescan::ui {

/// One row. `change` returns the reason of a refusal; empty: it was changed.
struct ShortcutRow {
    QString name;
    std::function<QString()> keys;
    std::function<bool()> isUsual;
    std::function<QString(const QKeySequence& key)> change;
    std::function<QString()> reset;
};

/// GUI thread only. A shortcut is valid as soon as it is pressed.
class ShortcutEditor : public QDialog {
    Q_OBJECT
public:
    ShortcutEditor(std::vector<ShortcutRow> rows, std::function<void()> resetAll, QWidget* parent);

    [[nodiscard]] QLineEdit* words() const { return words_; }
    [[nodiscard]] QTableWidget* table() const { return table_; }
    [[nodiscard]] QKeySequenceEdit* keyField() const { return key_; }
    /// The result of the last change, or the reason of its refusal.
    [[nodiscard]] QString message() const;

private:
    void find();
    void show(int row);
    void showAll();
    void say(const QString& refusal, const QString& done);
    void takeKey();
    [[nodiscard]] ShortcutRow* current();

    std::vector<ShortcutRow> rows_;
    QLineEdit* words_;
    QTableWidget* table_;
    QKeySequenceEdit* key_;
    QPushButton* none_;
    QPushButton* reset_;
    QLabel* message_;
};

} // namespace edgescan::ui
