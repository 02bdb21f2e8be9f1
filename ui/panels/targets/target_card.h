// The card of a target: its distance in large type, and its other properties.
#pragma once

#include "core/inspect/measure/notebook.h"
#include "ui/panels/targets/target_words.h"

#include <QFrame>

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace edgescan::ui {

class FactList;

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class TargetCard : public QFrame {
    Q_OBJECT
public:
    explicit TargetCard(QWidget* parent = nullptr);

    /// `known`: null during the computation; the rows stay.
    void show(const inspect::PinnedTarget& target, const inspect::CellTarget* known, const TargetSurroundings& around);
    /// The next letters replace the name.
    void editName();
    /// All texts of the card, row by row.
    [[nodiscard]] QString text() const;

    [[nodiscard]] QLineEdit* name() const { return name_; }
    [[nodiscard]] QLineEdit* note() const { return note_; }
    [[nodiscard]] QToolButton* lock() const { return lock_; }
    [[nodiscard]] QToolButton* close() const { return close_; }
    [[nodiscard]] QPushButton* why() const { return why_; }
    [[nodiscard]] QPushButton* measure() const { return measure_; }
    [[nodiscard]] QPushButton* copy() const { return copy_; }

signals:
    void closeRequested();
    void lockRequested(bool on);
    void renamed(const QString& name);
    void noted(const QString& note);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitNote();

    QLabel* number_;
    QLineEdit* name_;
    QLineEdit* note_;
    QLabel* wholeNote_;
    QToolButton* lock_;
    QToolButton* close_;
    QLabel* distance_;
    QLabel* tolerance_;
    FactList* rows_;
    QLabel* caveat_;
    QPushButton* why_;
    QPushButton* measure_;
    QPushButton* copy_;
};

/// The rows of a card that are stored when a target is set: those that a slider may change, the distance first.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> rowsToStore(const inspect::CellTarget& target,
                                                                           const TargetSurroundings& around);

} // namespace edgescan::ui
