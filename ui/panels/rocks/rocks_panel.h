// The panel of rocks: the slider from fine to coarse, what else can be turned, how many there are, the card of the selected one.
#pragma once

#include "ui/panels/rocks/rock_picture.h"

#include <QWidget>

#include <vector>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace edgescan::ui {

class RockCard;

/// GUI thread only. Shows what it is told and says what the operator wants.
class RocksPanel : public QWidget {
    Q_OBJECT
public:
    explicit RocksPanel(QWidget* parent = nullptr);

    void showSettings(const RockSettings& settings);
    /// `remark`: as in the table. Null: no rocks yet.
    void showResult(const RockPicture* picture, const QString& remark);
    [[nodiscard]] QSlider* slider() const { return slider_; }
    /// Of a row of rockParameters(); null: there is none.
    [[nodiscard]] QDoubleSpinBox* number(const char* key) const;
    [[nodiscard]] RockCard& card() { return *card_; }
    /// What it says of the result.
    [[nodiscard]] QString text() const;

signals:
    void edited(const edgescan::RockSettings& settings);

private:
    void tell();

    QSlider* slider_;
    std::vector<QDoubleSpinBox*> numbers_; // one per row of rockParameters()
    QLabel* result_;
    QLabel* curve_;
    RockCard* card_;
    RockSettings settings_;
    bool showing_ = false;
};

} // namespace edgescan::ui
