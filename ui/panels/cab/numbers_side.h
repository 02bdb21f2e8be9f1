// The area right of the cloud in cab mode: the two numbers of a target in large type, or the settings as steppers.
#pragma once

#include <QString>
#include <QWidget>

#include <utility>
#include <vector>

class QGridLayout;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace edgescan::ui {

class FittedLabel;
class FlowLayout;
class Stepper;

/// The text about a target, a rock or a measurement. Empty title: nothing is chosen.
struct TargetNumbers {
    QString title, place;                                   ///< "Target 1", "of 3"
    QString distance, tolerance;                            ///< "4.911 m", "± 0.009"
    QString rock, size, sizeRemark;                         ///< "Rock 4, visible", "2.51 × 1.83 m", "candidate …"
    std::vector<std::pair<QString, QString>> coordinates{}; ///< in large type as well
    QString warned{};                                       ///< lines with ▲
    std::vector<std::pair<QString, QString>> rows{};
    int targets = 0;          ///< of the scan
    int measures = 0;         ///< of the scan: the arrows go over targets and measurements
    bool only = false;        ///< the arrows lead to nothing else
    bool opens = false;       ///< a tap on the title opens a menu
    bool unposed = false;     ///< the coordinates count from the scanner; a tap on the warning, else on the coordinates, opens the pose
    bool measuring = false;   ///< a tap is an end of a measurement
    QString distanceName{};   ///< "Throat Width"; empty: "Distance"
    QString sizeTolerance{};  ///< "± 0.10 m"
    bool locked = false;      ///< a lock is next to the place
    QString note{};           ///< without an entry: what is known about those of the scan before
    bool choosesOnly = false; ///< a tap sets no target
    bool ofRock = false;      ///< its size is above the coordinates: a low screen shows it at once
};

/// One setting. `key`: its key in the parameter table.
struct SteppedSetting {
    QString key, name, value;
    QString found{}; ///< between its buttons: the number of edges
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class NumbersSide : public QWidget {
    Q_OBJECT
public:
    explicit NumbersSide(QWidget* parent = nullptr);

    void showNumbers(const TargetNumbers& numbers);
    /// The first setting is also shown below the numbers.
    void showSettings(const std::vector<SteppedSetting>& settings);
    /// What the buttons of the first setting do, here and among the settings.
    void setMeaning(const QString& ofLess, const QString& ofMore);
    /// Shows the settings instead of the numbers.
    void setTuning(bool on);
    [[nodiscard]] bool tuning() const;
    /// Hidden where the side is too low for it.
    [[nodiscard]] Stepper* mainStepper() const { return main_; }
    [[nodiscard]] bool hasStepper() const { return stepped_; }
    [[nodiscard]] Stepper* stepper(const QString& key) const;
    [[nodiscard]] QString distanceShown() const;
    [[nodiscard]] QString sizeShown() const;
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
    void stepped(const QString& key, int steps);
    void stepEnded();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitTitle();
    void placeLock();
    void placeSize(bool first);
    void fitHeight();
    QWidget* makeNumbers();
    QWidget* makeSettings();
    void fillRows(QGridLayout& grid, std::vector<std::pair<QLabel*, QLabel*>>& labels, const std::vector<std::pair<QString, QString>>& rows,
                  bool large);
    void connectStepper(Stepper& stepper);

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
    QLabel* hint_;
    QWidget* facts_;
    QLabel* distanceName_ = nullptr;
    FittedLabel* distance_;
    QLabel* tolerance_;
    QLabel *rock_, *sizeTolerance_;
    QWidget* rockHead_; // both
    FittedLabel* size_;
    QLabel* sizeRemark_;
    QLabel *pose_, *warned_;
    QGridLayout* coordinates_;
    QGridLayout* rows_;
    std::vector<std::pair<QLabel*, QLabel*>> coordinateLabels_, rowLabels_;
    QWidget* below_;          // covers what is on the next page
    QToolButton* page_;       // turns the page of the facts
    std::vector<int> starts_; // px: the tops of the pages after the first one
    int factsHigh_ = 0;
    std::size_t shownPage_ = 0;
    QString shownTitle_, titleWords_;
    bool stepped_ = false; // the main stepper has a setting
    Stepper* main_;
    QString mainKey_, ofLess_, ofMore_;
    FlowLayout* settingsHead_ = nullptr;
    QVBoxLayout* settings_ = nullptr;
    std::vector<std::pair<QString, Stepper*>> steppers_;
    QGridLayout* foot_;
    int buttons_ = 0;
    QToolButton* tune_ = nullptr;
    QString tuneWord_;
};

} // namespace edgescan::ui
