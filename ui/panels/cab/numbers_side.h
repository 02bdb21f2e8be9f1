// The area right of the cloud in cab mode: the facts of a target, a rock or a measurement in large type, or the settings as steppers.
#pragma once

#include "ui/base/fact_row.h"

#include <QString>
#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace edgescan::ui {

class FlowLayout;
class ParameterRow;
class Stepper;

/// What the side shows of a target, a rock or a measurement.
struct SideFacts {
    QString title; ///< "Target 1", and in a second line "of 3"
    std::vector<FactList::Shown> rows{};
    bool arrows = false; ///< they lead to another target or measurement
    bool locked = false; ///< a lock is next to the title
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class NumbersSide : public QWidget {
    Q_OBJECT
public:
    /// `settings`: must outlive it.
    explicit NumbersSide(const std::vector<ParameterRow*>& settings, QWidget* parent = nullptr);

    void show(const SideFacts& facts);
    /// This one is below the numbers, with what it found; the threshold of another method may follow.
    void showMain(ParameterRow& row, const QString& found);
    /// Shows the settings instead of the numbers.
    void setTuning(bool on);
    [[nodiscard]] bool tuning() const;
    /// Hidden where the side is too low for it.
    [[nodiscard]] Stepper* mainStepper() const { return main_; }
    [[nodiscard]] Stepper* stepper(const QString& key) const;
    /// The value of this fact; empty: it is not shown.
    [[nodiscard]] QString shown(const char* key) const;
    /// Adds a button such as Report or Export at the bottom.
    void addButton(QToolButton* button);
    /// The button that opens the settings; it has the first value where that has no room.
    void addTune(QToolButton* button);
    /// Adds one above the settings.
    void addSettingsButton(QToolButton* button);

signals:
    /// The operator wants the next (1) or previous (-1) target or measurement.
    void entryStepRequested(int by);
    void titleTapped();
    void poseRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitTitle();
    void fitHeight();
    QWidget* makeSettings(const std::vector<ParameterRow*>& settings);

    [[nodiscard]] bool factsFitAbove(int stepperHigh) const;
    [[nodiscard]] std::vector<int> pageStarts(int room, int high) const;
    void fitPages();
    void showPage();
    void showValueInTune();

    QStackedWidget* pages_;
    QScrollArea* scroll_ = nullptr; // of the numbers
    QToolButton* previous_;
    QToolButton* next_;
    QLabel *title_, *lock_;
    FactList* facts_;
    QWidget* below_;          // covers what is on the next page
    QToolButton* page_;       // turns the page of the facts
    std::vector<int> starts_; // px: the tops of the pages after the first one
    int factsHigh_ = 0;
    std::size_t shownPage_ = 0;
    QString titleWords_;
    Stepper* main_;
    FlowLayout* settingsHead_ = nullptr;
    std::vector<Stepper*> steppers_;
    QGridLayout* foot_;
    int buttons_ = 0;
    QToolButton* tune_ = nullptr;
    QString tuneWord_;
};

} // namespace edgescan::ui
