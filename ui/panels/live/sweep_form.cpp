// The stepper in numbers.
#include "ui/panels/live/sweep_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>

namespace edgescan::ui {
namespace {

constexpr double kStepNotGiven = -10.00001; // minimum of the box, displayed as text: the step is not given

/// 0 is shown in words.
class CountBox : public QDoubleSpinBox {
public:
    [[nodiscard]] QString textFromValue(double value) const override {
        return value == 0.0 ? SweepForm::tr("not known") : QDoubleSpinBox::textFromValue(value);
    }
    [[nodiscard]] double valueFromText(const QString& text) const override {
        return text == textFromValue(0.0) ? 0.0 : QDoubleSpinBox::valueFromText(text);
    }
    [[nodiscard]] QValidator::State validate(QString& text, int& place) const override {
        return text == textFromValue(0.0) ? QValidator::Acceptable : QDoubleSpinBox::validate(text, place);
    }
};

QDoubleSpinBox* degrees(double least, double most, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setRange(least, most);
    box->setDecimals(decimals);
    box->setSuffix("°");
    return box;
}

} // namespace

SweepForm::SweepForm(QWidget* parent)
    : QWidget(parent), lines_(new QSpinBox), step_(degrees(kStepNotGiven, 10, 5)), first_(degrees(-360, 360, 3)), ticks_(new CountBox),
      axis_(new QComboBox), standing_(new QCheckBox(tr("Does not turn while a line is measured"))) {
    lines_->setRange(0, 20000);
    lines_->setSpecialValueText(tr("not known"));
    step_->setSingleStep(0.01);
    step_->setSpecialValueText(tr("not known (0.18° assumed)"));
    ticks_->setRange(-1e7, 1e7);
    ticks_->setDecimals(4);
    ticks_->setToolTip(tr("0: no encoder; the lines are placed by the stepper's step"));
    axis_->addItem(tr("not known (spin assumed)"));
    axis_->addItem(tr("spin: about the viewing direction"), static_cast<int>(Axis::Spin));
    axis_->addItem(tr("sweep: about the 0/180 degree line"), static_cast<int>(Axis::Sweep));
    auto* form = new QFormLayout(this);
    form->addRow(tr("Lines of a whole sweep"), lines_);
    form->addRow(tr("Step per line"), step_);
    form->addRow(tr("Angle of the first line"), first_);
    form->addRow(tr("Encoder counts per degree"), ticks_);
    form->addRow(tr("Mounting of the stepper"), axis_);
    form->addRow(QString(), standing_);
    showSettings(scanner::assumedSweep());
}

void SweepForm::showSettings(const scanner::SweepSettings& settings) {
    shown_ = settings;
    lines_->setValue(settings.expectedLines);
    step_->setValue(settings.stepAssumed ? kStepNotGiven : settings.degPerLine.value_or(0.18));
    first_->setValue(settings.firstLineDeg);
    ticks_->setValue(settings.ticksPerDeg.value_or(0.0));
    axis_->setCurrentIndex(settings.axisAssumed ? 0 : axis_->findData(static_cast<int>(settings.axis)));
    standing_->setChecked(!settings.continuous);
}

void SweepForm::begin() {
    lines_->setFocus();
    lines_->selectAll();
}

scanner::SweepSettings SweepForm::settings() const {
    scanner::SweepSettings settings = shown_;
    settings.expectedLines = lines_->value();
    const scanner::SweepSettings assumed = scanner::assumedSweep();
    settings.stepAssumed = step_->value() <= step_->minimum();
    settings.degPerLine = settings.stepAssumed ? assumed.degPerLine : step_->value();
    settings.firstLineDeg = first_->value();
    settings.ticksPerDeg = ticks_->value() != 0.0 ? std::optional<double>(ticks_->value()) : std::nullopt;
    settings.axisAssumed = axis_->currentIndex() == 0;
    settings.axis = settings.axisAssumed ? assumed.axis : static_cast<Axis>(axis_->currentData().toInt());
    settings.continuous = !standing_->isChecked();
    return settings;
}

} // namespace edgescan::ui

#include "moc_sweep_form.cpp"
