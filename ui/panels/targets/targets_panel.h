// The panel "Targets": the list of targets, the card of one target, and the measurements.
#pragma once

#include "core/inspect/measure/notebook.h"

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace edgescan::ui {

class TargetCard;

/// A line of a list.
struct TargetLine {
    QString words;
    QString tip;
    bool chosen = false;
    QStringList shortened{}; ///< parts of the first row that lose letters, in this order, where it has no room
    bool locked = false;     ///< has the sign of a lock
    bool operator==(const TargetLine&) const = default;
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class TargetsPanel : public QWidget {
    Q_OBJECT
public:
    explicit TargetsPanel(QWidget* parent = nullptr);

    void showTargets(const std::vector<TargetLine>& lines);
    void showMeasures(const std::vector<TargetLine>& lines);
    /// The next click of a measuring tool; empty: a click pins.
    void showAsked(const QString& words);
    /// Where the targets are stored, or why they are not.
    void showNote(const QString& note);

    /// On: the card is at the top, else below the lists.
    void setCardFirst(bool on);
    [[nodiscard]] TargetCard& card() const { return *card_; }
    [[nodiscard]] QListWidget* targets() const { return targets_; }
    [[nodiscard]] QListWidget* measures() const { return measures_; }
    [[nodiscard]] QPushButton* copyAllButton() const { return copyAll_; }
    [[nodiscard]] QPushButton* removeAllButton() const { return letGoOfAll_; }
    [[nodiscard]] QPushButton* removeMeasure() const { return removeMeasure_; }
    [[nodiscard]] QPushButton* section() const { return section_; }
    [[nodiscard]] QString note() const;

signals:
    /// Indices into the lists.
    void targetChosen(int place);
    void nameRequested(int place);
    void targetMenuRequested(int place, const QPoint& position);
    void copyAllRequested();
    void removeAllRequested();
    void measureChosen(int place);
    void measureRemoved(int place);

private:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    [[nodiscard]] int freeHeight() const;
    void fitLists();
    void fitSoon();
    void fit(QListWidget& list);
    void showNewest();
    void choose(const QListWidget& list, int row);
    void showRemarks();
    void fill(QListWidget& list, std::vector<TargetLine>& shown, const std::vector<TargetLine>& lines);

    QLabel* hint_;
    QListWidget* targets_;
    QPushButton* copyAll_;
    QPushButton* letGoOfAll_;
    TargetCard* card_;
    QLabel* measuresTitle_;
    QListWidget* measures_;
    QLabel* remarks_; // all that is said of the chosen measurement
    QPushButton *section_, *removeMeasure_;
    QLabel* note_;
    std::vector<TargetLine> shownTargets_, shownMeasures_;
    bool measuring_ = false; // a tool waits for a click
    bool fits_ = false;      // fitLists() is queued
};

} // namespace edgescan::ui
