// The card of the target that is pinned: its distance in large type, and all that is known of it.
#pragma once

#include "core/inspect/measure/notebook.h"
#include "ui/panels/targets/target_words.h"

#include <QFrame>

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class TargetCard : public QFrame {
    Q_OBJECT
public:
    explicit TargetCard(QWidget* parent = nullptr);

    /// `known`: null while it is being worked out: the rows stay.
    void show(const PinnedTarget& target, const CellTarget* known, const TargetSurroundings& around);
    /// All that it says, row by row.
    [[nodiscard]] QString text() const;

    [[nodiscard]] QLineEdit* name() const { return name_; }
    [[nodiscard]] QToolButton* lock() const { return lock_; }
    [[nodiscard]] QToolButton* close() const { return close_; }
    [[nodiscard]] QPushButton* why() const { return why_; }
    [[nodiscard]] QPushButton* measure() const { return measure_; }
    [[nodiscard]] QPushButton* copy() const { return copy_; }

signals:
    void closeWanted();
    void lockWanted(bool on);
    void renamed(const QString& name);

private:
    void setRow(std::size_t row, const TargetRow& words, const QString& was);

    QLabel* number_;
    QLineEdit* name_;
    QToolButton* lock_;
    QToolButton* close_;
    QLabel* distance_;
    QLabel* tolerance_;
    QVBoxLayout* lines_;
    std::vector<std::pair<QLabel*, QLabel*>> rows_;
    QLabel* caveat_;
    QPushButton* why_;
    QPushButton* measure_;
    QPushButton* copy_;
};

/// What is kept of a card when a cell is pinned: the rows that a slider may change, the distance first.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> rowsToKeep(const CellTarget& target, const TargetSurroundings& around);

} // namespace edgescan::ui
