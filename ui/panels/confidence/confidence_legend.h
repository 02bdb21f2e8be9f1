// The legend of edge confidence: the number of edges per confidence band, and the limit from which edges are shown.
#pragma once

#include "ui/panels/confidence/confidence_picture.h"

#include <QWidget>

class QLabel;
class QSlider;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class ConfidenceLegend : public QWidget {
    Q_OBJECT
public:
    explicit ConfidenceLegend(QWidget* parent = nullptr);

    /// The computation is running, `done` percent of it.
    void showWorking(int done);
    /// Shows the reason why there is no confidence picture.
    void showNone(const QString& why);
    void showMade(const ConfidencePicture& made);
    void setColours(const EdgeColours& colours);
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QString counted(std::size_t band) const;
    [[nodiscard]] QString words() const;

signals:
    void leastRequested(int percent);

private:
    void showRows(bool on);

    QLabel *words_, *least_;
    QSlider* slider_;
    std::array<QLabel*, kBands> swatches_{}, names_{}, counts_{};
};

} // namespace edgescan::ui
