// The panel of rocks.
#include "ui/panels/rocks/rocks_panel.h"

#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/size_curve_view.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace edgescan::ui {
namespace {

constexpr double kSlidersPerLevel = 10.0; // positions of the slider per unit
constexpr int kNarrowestNumber = 84;      // px

} // namespace

RocksPanel::RocksPanel(QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), result_(new QLabel), curve_(new QLabel), card_(new RockCard) {
    setObjectName("rocks-panel");
    auto* ends = new QHBoxLayout;
    ends->addWidget(new QLabel(tr("fine")));
    ends->addWidget(slider_, 1);
    ends->addWidget(new QLabel(tr("coarse")));
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 1);
    for (const rocks::RockParameter& parameter : rocks::rockParameters()) {
        auto* name = new QLabel(QObject::tr(parameter.label));
        name->setWordWrap(true); // for a narrow dock
        auto* number = new QDoubleSpinBox;
        number->setObjectName(QString("rocks-") + parameter.key);
        number->setDecimals(parameter.decimals);
        number->setRange(parameter.minimum, parameter.maximum);
        number->setSingleStep(parameter.step);
        number->setKeyboardTracking(false);
        number->setMinimumWidth(kNarrowestNumber); // by default it is as wide as the longest possible number
        if (*parameter.unit != '\0') number->setSuffix(" " + QObject::tr(parameter.unit));
        for (QWidget* widget : {static_cast<QWidget*>(name), static_cast<QWidget*>(number)})
            widget->setToolTip(QObject::tr(parameter.help));
        const int row = grid->rowCount();
        if (numbers_.empty()) { // the most used number is next to its slider
            ends->addWidget(number);
            name->deleteLater();
        } else {
            grid->addWidget(name, row, 0);
            grid->addWidget(number, row, 1);
        }
        numbers_.push_back(number);
        connect(number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RocksPanel::emitSettings);
    }
    const rocks::RockParameter& level = rocks::rockParameters().front();
    slider_->setObjectName("rocks-slider");
    slider_->setRange(static_cast<int>(std::lround(level.minimum * kSlidersPerLevel)),
                      static_cast<int>(std::lround(level.maximum * kSlidersPerLevel)));
    slider_->setPageStep(static_cast<int>(kSlidersPerLevel));
    slider_->setToolTip(QObject::tr(level.help));
    connect(slider_, &QSlider::valueChanged, this, [this](int position) {
        if (!showing_) numbers_.front()->setValue(position / kSlidersPerLevel);
    });
    result_->setWordWrap(true);
    curve_->setWordWrap(true);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(4);
    column->addLayout(ends);
    column->addWidget(card_);
    column->addWidget(result_);
    column->addWidget(curve_);
    column->addLayout(grid);
    column->addStretch(1);
    showSettings({});
    showResult(nullptr, QString());
}

void RocksPanel::setBrief(bool on) {
    for (QWidget* each : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each != card_ && each != result_) each->setVisible(!on);
    }
}

QDoubleSpinBox* RocksPanel::number(const char* key) const {
    const auto rows = rocks::rockParameters();
    for (std::size_t n = 0; n < rows.size(); ++n) {
        if (std::strcmp(rows[n].key, key) == 0) return numbers_[n];
    }
    return nullptr;
}

void RocksPanel::showSettings(const rocks::RockSettings& settings) {
    showing_ = true;
    settings_ = settings;
    const auto rows = rocks::rockParameters();
    for (std::size_t n = 0; n < rows.size(); ++n) numbers_[n]->setValue(rows[n].get(settings));
    slider_->setValue(static_cast<int>(std::lround(settings.level * kSlidersPerLevel)));
    showing_ = false;
}

void RocksPanel::emitSettings() {
    if (showing_) return;
    rocks::RockSettings settings = settings_;
    const auto rows = rocks::rockParameters();
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n].set(settings, numbers_[n]->value());
    showSettings(settings);
    emit edited(settings);
}

void RocksPanel::showResult(const RockPicture* picture, const QString& remark) {
    if (picture == nullptr) {
        result_->setText(remark);
        curve_->clear();
        return;
    }
    const std::vector<rocks::Rock>& rocks = picture->study.rocks;
    const rocks::RegionCounts fines = rocks::regionCounts(picture->study.map, rocks::RegionKind::Fines);
    QString text = remark.isEmpty() ? QString() : remark + "\n";
    text += tr("%1, %2 of them uncertain (hatched); %3 pieces too small to be a rock")
                .arg(rockCount(rocks.size()))
                .arg(std::count_if(rocks.begin(), rocks.end(), edgescan::rocks::isDoubtful))
                .arg(fines.regions);
    const std::size_t changes = rocks::changesByHand(picture->study.edits);
    if (changes > 0) text += tr("; %1 changed by hand").arg(changes);
    if (!picture->study.settings.region.empty())
        text += tr("; %1 pieces outside the region of interest are left out")
                    .arg(rocks::regionCounts(picture->study.map, rocks::RegionKind::Outside).regions);
    result_->setText(text + "\n" + rockCaveat() + "\n" +
                     tr("A click selects a rock (Ctrl+click one more); the tool Pin (P) sets a target (Shift+click)."));
    curve_->setText(sizeCurveText(rocks::sizeCurve(rocks, picture->study.settings.oversizeM)));
}

QString RocksPanel::text() const { return result_->text() + "\n" + curve_->text(); }

} // namespace edgescan::ui

#include "moc_rocks_panel.cpp"
