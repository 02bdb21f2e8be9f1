// The legend of edge confidence over the cloud: how many edges hold how well, and from where on they are shown.
#pragma once

#include "ui/base/view_plate.h"
#include "ui/panels/confidence/confidence_picture.h"

class QLabel;
class QSlider;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class ConfidenceLegend : public ViewPlate {
    Q_OBJECT
public:
    explicit ConfidenceLegend(QWidget* parent = nullptr);

    /// It is being worked out, `done` percent of it.
    void showWorking(int done);
    /// Why there is nothing to show.
    void showNone(const QString& why);
    void showMade(const ConfidencePicture& made);
    void setColours(const EdgeColours& colours);
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QString counted(std::size_t band) const;
    [[nodiscard]] QString words() const;

signals:
    void leastWanted(int percent);

private:
    void showRows(bool on);

    QLabel *words_, *least_;
    QSlider* slider_;
    std::array<QLabel*, kBands> swatches_{}, names_{}, counts_{};
};

} // namespace edgescan::ui
