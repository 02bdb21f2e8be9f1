// The stepper in numbers.
#include "ui/panels/live/sweep_form.h"

#include "core/base/number_text.h"
#include "ui/base/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTimer>

namespace edgescan::ui {
namespace {

constexpr int kLeastAxis = 200; // px
// Minimum of their boxes, displayed as text: not given.
constexpr double kStepNotGiven = -10.00001, kTurnNotGiven = -3600.001, kFirstNotGiven = -360.001;

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

QString notKnown(double deg) { return SweepForm::tr("not known (%1° assumed)").arg(exactText(significantText(deg, 4))); }

bool isNotGiven(const QDoubleSpinBox& box) { return box.value() <= box.minimum(); }

} // namespace

SweepForm::SweepForm(QWidget* parent)
    : QWidget(parent), lines_(new QSpinBox), turn_(degrees(kTurnNotGiven, 3600, 3)), step_(degrees(kStepNotGiven, 10, 5)),
      first_(degrees(kFirstNotGiven, 360, 3)), ticks_(new CountBox), axis_(new QComboBox),
      standing_(new QCheckBox(tr("Does not turn while a line is measured"))) {
    lines_->setRange(0, 20000);
    lines_->setSpecialValueText(tr("not known"));
    step_->setSingleStep(0.01);
    first_->setToolTip(tr("Where the stepper begins. The cloud turns with it, its shape is the same."));
    ticks_->setRange(-1e7, 1e7);
    ticks_->setDecimals(4);
    ticks_->setToolTip(tr("0: no encoder; the lines are placed by the stepper's step"));
    axis_->addItem({});
    axis_->addItem(tr("spin: like a wheel, about its viewing direction"), static_cast<int>(Axis::Spin));
    axis_->addItem(tr("sweep: nodding, about the line from beam 0° to 180°"), static_cast<int>(Axis::Sweep));
    showAxisFromRanges({});
    auto* source = new QLabel(tr("The numbers are in the stepper's program or data sheet. Leave out what you do not know."));
    source->setWordWrap(true);
    axis_->setMinimumWidth(kLeastAxis); // a cab has no room for all of its words
    auto* form = new QFormLayout(this);
    form->addRow(source);
    form->addRow(tr("The scanner turns"), axis_);
    form->addRow(tr("Lines of a whole sweep"), lines_);
    form->addRow(tr("Turn of a whole sweep"), turn_);
    form->addRow(tr("Step per line"), step_);
    form->addRow(tr("Angle of the first line"), first_);
    form->addRow(tr("Encoder counts per degree"), ticks_);
    form->addRow(QString(), standing_);
    for (auto* box : findChildren<QAbstractSpinBox*>()) box->findChild<QLineEdit*>()->installEventFilter(this);
    connect(lines_, qOverload<int>(&QSpinBox::valueChanged), this, &SweepForm::followLines);
    connect(step_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &SweepForm::followStep);
    connect(axis_, qOverload<int>(&QComboBox::currentIndexChanged), this, &SweepForm::nameFirst);
    connect(turn_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &SweepForm::followTurn);
    showSettings(scanner::assumedSweep());
}

void SweepForm::showAxisFromRanges(std::optional<Axis> axis) {
    if (axis == seen_ && !axis_->itemText(0).isEmpty()) return; // each picture says it, also while a number is typed
    const Axis taken = axis.value_or(scanner::assumedSweep().axis);
    axis_->setItemText(0, !axis                 ? tr("not known (spin assumed until the ranges show it)")
                          : taken == Axis::Spin ? tr("not known (the ranges show spin)")
                                                : tr("not known (the ranges show sweep)"));
    seen_ = axis;
    nameFirst();
}

/// Words of a box are set only here: setting them writes its text again, under the fingers of the operator.
void SweepForm::followLines() {
    const int lines = lines_->value();
    step_->setSpecialValueText(notKnown(scanner::assumedStepDeg(lines)));
    turn_->setSpecialValueText(lines > 0 ? notKnown(scanner::assumedStepDeg(lines) * lines) : tr("needs the number of lines"));
    turn_->setEnabled(lines > 0);
    followStep();
}

void SweepForm::followStep() {
    const QSignalBlocker quiet(turn_);
    const int lines = lines_->value();
    turn_->setValue(lines > 0 && !isNotGiven(*step_) ? step_->value() * lines : kTurnNotGiven);
    nameFirst();
}

void SweepForm::followTurn() {
    const QSignalBlocker quiet(step_);
    step_->setValue(isNotGiven(*turn_) ? kStepNotGiven : turn_->value() / lines_->value());
    nameFirst();
}

void SweepForm::nameFirst() {
    const scanner::SweepSettings now = settings();
    first_->setSpecialValueText(notKnown(scanner::assumedFirstDeg(now.axisAssumed && seen_ ? *seen_ : now.axis, now)));
}

void SweepForm::showSettings(const scanner::SweepSettings& settings) {
    shown_ = settings;
    lines_->setValue(settings.expectedLines);
    step_->setValue(settings.stepAssumed ? kStepNotGiven : settings.degPerLine.value_or(0.18));
    const bool ofSpin = !scanner::guessesFirst(settings) && settings.firstLineDeg == 0.0; // 0 is not a guess there
    first_->setValue(settings.firstAssumed || ofSpin ? kFirstNotGiven : settings.firstLineDeg);
    ticks_->setValue(settings.ticksPerDeg.value_or(0.0));
    axis_->setCurrentIndex(settings.axisAssumed ? 0 : axis_->findData(static_cast<int>(settings.axis)));
    standing_->setChecked(!settings.continuous);
    followLines();
}

void SweepForm::begin() {
    lines_->setFocus();
    lines_->selectAll();
}

/// A click into "not known" selects it: the first digit replaces it.
bool SweepForm::eventFilter(QObject* watched, QEvent* event) {
    auto* edit = qobject_cast<QLineEdit*>(watched);
    if (edit != nullptr && event->type() == QEvent::MouseButtonRelease && !edit->text().isEmpty() && edit->text().front().isLetter())
        QTimer::singleShot(0, edit, &QLineEdit::selectAll);
    return QWidget::eventFilter(watched, event);
}

scanner::SweepSettings SweepForm::settings() const {
    scanner::SweepSettings settings = shown_;
    settings.expectedLines = lines_->value();
    const scanner::SweepSettings assumed = scanner::assumedSweep();
    settings.stepAssumed = isNotGiven(*step_);
    settings.degPerLine = settings.stepAssumed ? scanner::assumedStepDeg(settings.expectedLines) : step_->value();
    settings.firstLineDeg = isNotGiven(*first_) ? assumed.firstLineDeg : first_->value();
    settings.ticksPerDeg = ticks_->value() != 0.0 ? std::optional<double>(ticks_->value()) : std::nullopt;
    settings.axisAssumed = axis_->currentIndex() == 0;
    settings.axis = settings.axisAssumed ? assumed.axis : static_cast<Axis>(axis_->currentData().toInt());
    settings.firstAssumed = isNotGiven(*first_) && scanner::guessesFirst(settings);
    settings.continuous = !standing_->isChecked();
    return settings;
}

} // namespace edgescan::ui

#include "moc_sweep_form.cpp"
