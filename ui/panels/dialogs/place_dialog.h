// Scan > Pose and Mounting: the place of the scan typed in fields, and how the scanner is mounted. Not modal: the cloud shows the place
// while it is typed.
#pragma once

#include "core/scan/georef/place_form.h"

#include <QDialog>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class PlaceDialog : public QDialog {
    Q_OBJECT
public:
    explicit PlaceDialog(QWidget* parent);

    void showPose(const PlaceTexts& texts);
    void showMounting(const PlaceTexts& texts);
    [[nodiscard]] PlaceTexts poseTexts() const;
    [[nodiscard]] PlaceTexts mountingTexts() const;
    /// A sentence under each wrong field, and the sign of the tab that has one.
    void showFaults(const TypedPlace& typed);
    /// Where the scan is by these values, or why it cannot be placed; `ready`: the pose may be stored.
    void showState(const QString& words, bool ready);
    /// The words are of values before these, until showState().
    void showComputing();
    /// The stored scanners, and the one in use (empty: another mounting).
    void showScanners(const QStringList& names, const QString& inUse);
    /// A pose is stored with the scan.
    void setRemovable(bool on);
    [[nodiscard]] QString stateText() const;

signals:
    void changed();
    void surveyLineTyped(const QString& line, bool northingFirst);
    void keepRequested();
    void removeRequested();
    void scannerChosen(const QString& name);
    void scannerKept();
    void scannerForgotten(const QString& name);
    void fileRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Row {
        std::function<QString()> text;
        std::function<void(const QString&)> show;
        QLabel* fault;
        QLineEdit* edit; // null: a choice
        QString usual;   // shown while it is empty
    };
    [[nodiscard]] QWidget* posePage();
    [[nodiscard]] QWidget* mountingPage();
    void addField(QGridLayout& grid, int columns, const PlaceField& field, std::vector<Row>& rows);
    void showTexts(const std::vector<Row>& rows, const PlaceTexts& texts);

    QLineEdit* line_ = nullptr;
    QComboBox* order_ = nullptr;
    QComboBox* scanner_ = nullptr;
    QPushButton* forget_ = nullptr;
    QTabWidget* tabs_;
    QLabel* state_;
    QPushButton* keep_;
    QPushButton* remove_;
    std::vector<Row> pose_, mounting_;
    bool low_ = false;     // the screen: texts have fewer lines, and the buttons are at the top
    bool showing_ = false; ///< texts that the program sets are not a change
    bool typed_ = false;   ///< a pose is in the form, whole or in part
};

} // namespace edgescan::ui
