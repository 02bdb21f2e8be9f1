// The panel of rocks: the slider from fine to coarse, other settings, the number of rocks, the card of the selection.
#pragma once

#include "ui/panels/rocks/rock_picture.h"

#include <QWidget>

#include <vector>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace edgescan::ui {

class RockCard;

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class RocksPanel : public QWidget {
    Q_OBJECT
public:
    explicit RocksPanel(QWidget* parent = nullptr);

    void showSettings(const rocks::RockSettings& settings);
    /// `remark`: see RockTable. Null: no rocks yet.
    void showResult(const RockPicture* picture, const QString& remark);
    [[nodiscard]] QSlider* slider() const { return slider_; }
    /// The number box of a row of rockParameters(); null: unknown key.
    [[nodiscard]] QDoubleSpinBox* number(const char* key) const;
    [[nodiscard]] RockCard& card() { return *card_; }
    /// On: only the card.
    void setBrief(bool on);
    /// The text about the result.
    [[nodiscard]] QString text() const;

signals:
    void edited(const edgescan::rocks::RockSettings& settings);

private:
    void emitSettings();

    QSlider* slider_;
    std::vector<QDoubleSpinBox*> numbers_; // one per row of rockParameters()
    QLabel* result_;
    QLabel* curve_;
    RockCard* card_;
    rocks::RockSettings settings_;
    bool showing_ = false;
};

} // namespace edgescan::ui
