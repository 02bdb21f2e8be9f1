// Scan > Calibrate: the scans, the estimated mounting errors or the reason why there is no estimate, and the seam before and after. Not
// modal.
#pragma once

#include <QDialog>
#include <QImage>
#include <QPoint>
#include <QString>
#include <QStringList>

#include <array>
#include <vector>

class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace edgescan::ui {

class TwoPictures;

/// The seam before and after.
struct CalibrationPicture {
    QString title;         ///< "Edges of both views"
    QString before, after; ///< titles of the pictures
    QImage beforeImage, afterImage;
    QPoint busiest; ///< the pixel with the most edges
};

/// The result, in the words of the window.
struct CalibrationShown {
    std::vector<std::array<QString, 3>> rows; ///< error, value, ± two standard deviations
    QString verdict;
    QString about; ///< text under the table
    std::vector<CalibrationPicture> pictures;
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class CalibrationCard : public QDialog {
    Q_OBJECT
public:
    explicit CalibrationCard(QWidget* parent);

    /// The scans in use, the one on the screen first, and the robot's present calibration file (empty: none). Clears the result.
    void setQuestion(const QStringList& scans, const QString& base);
    void begin();
    void showStage(const QString& stage, int percent);
    void showResult(const CalibrationShown& found);
    void refuse(const QString& why);
    /// The path of the saved file (empty: not saved yet); `cannot`: the reason why it cannot be applied, empty if it can.
    void setSaved(const QString& path, const QString& cannot);

    [[nodiscard]] bool working() const { return working_; }
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] QString about() const;
    [[nodiscard]] const TwoPictures& pictures() const { return *pictures_; }

signals:
    void addRequested();
    void removeRequested(int row);
    void baseRequested();
    void startRequested();
    void givenUp();
    void saveRequested();
    void applyRequested();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QWidget* question();
    [[nodiscard]] QWidget* answer();
    void setWorking(bool on);
    void showPicture(int which);
    void forgetResult();
    void fit();

    QListWidget* scans_;
    QPushButton* remove_ = nullptr;
    QLabel* base_;
    QPushButton* start_;
    QProgressBar* progress_;
    QLabel* verdict_;
    QTableWidget* table_;
    QLabel* about_;
    QComboBox* which_;
    TwoPictures* pictures_;
    QWidget* answer_ = nullptr;
    QLabel* saved_;
    QPushButton* save_ = nullptr;
    QPushButton* apply_ = nullptr;
    std::vector<CalibrationPicture> shown_;
    bool working_ = false;
    bool found_ = false;
};

} // namespace edgescan::ui
