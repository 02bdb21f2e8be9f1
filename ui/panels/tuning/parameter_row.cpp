// One row of the panel.
#include "ui/panels/tuning/parameter_row.h"

#include "core/edges/settings/slider_scale.h"
#include "ui/base/icons.h"
#include "ui/base/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kNarrowestNumber = 72, kUsualNumber = 160; // px of a number box
constexpr int kResetIcon = 14;                           // px

// A number box that accepts any text while typing. Text that is not a value is reported when typing ends; single letters are not rejected.
class ReadingBox : public QDoubleSpinBox {
public:
    using Refusal = std::function<void(const Error& why)>;

    explicit ReadingBox(QWidget* parent) : QDoubleSpinBox(parent) {}
    void read(ParameterRow::Reading reading) { reading_ = std::move(reading); }
    void onRefusal(Refusal refusal) { refusal_ = std::move(refusal); }

    /// Room for the present value with its unit, in the letters of the window; by default it would be as wide as the longest possible
    /// number.
    QSize minimumSizeHint() const override {
        QStyleOptionSpinBox option;
        initStyleOption(&option);
        const QSize usual = QDoubleSpinBox::minimumSizeHint();
        constexpr int kCursor = 6; // px, with the margins of the text
        const int letters = fontMetrics().horizontalAdvance(textFromValue(value()) + suffix()) + kCursor;
        const int frame = style()->sizeFromContents(QStyle::CT_SpinBox, &option, QSize(letters, usual.height()), this).width();
        return {std::max(kNarrowestNumber, frame), usual.height()};
    }
    QSize sizeHint() const override { return minimumSizeHint().expandedTo({kUsualNumber, 0}); }

    QValidator::State validate(QString& text, int& /*position*/) const override {
        return reading_(withoutSuffix(text)) ? QValidator::Acceptable : QValidator::Intermediate;
    }
    double valueFromText(const QString& text) const override {
        const Result<double> read = reading_(withoutSuffix(text));
        return read ? *read : value();
    }
    void fixup(QString& text) const override {
        const Result<double> read = reading_(withoutSuffix(text));
        if (!read) refusal_(read.error());
    }

private:
    [[nodiscard]] QString withoutSuffix(QString text) const {
        if (!suffix().isEmpty() && text.endsWith(suffix())) text.chop(suffix().size());
        return text.trimmed();
    }

    ParameterRow::Reading reading_;
    Refusal refusal_;
};

// The steps grow, so that a large change takes few repeats.
int stepsAfter(int repeats) { return repeats < 12 ? 1 : repeats < 30 ? 5 : 25; }

QString limitsText(const edges::Parameter& p) {
    QString text = QObject::tr(p.help);
    if (p.choices.empty())
        text += QObject::tr("\n%1 to %2 %3").arg(p.minimum).arg(p.maximum).arg(*p.unit == '\0' ? QString() : QObject::tr(p.unit));
    return text + QObject::tr("\nDouble-click: back to the preset");
}

} // namespace

ParameterRow::ParameterRow(const edges::Parameter& parameter, QGridLayout& grid, QWidget* parent) : QObject(parent), parameter_(parameter) {
    const int row = grid.rowCount();
    label_ = new QLabel(QObject::tr(parameter.label), parent);
    label_->setToolTip(limitsText(parameter));
    label_->setWordWrap(true); // for a narrow dock
    label_->installEventFilter(this);
    if (parameter.choices.empty() || numericChoices()) grid.addWidget(label_, row, 0);
    addReset(parent);
    if (parameter.choices.empty())
        addNumber(grid, row, parent);
    else
        addChoice(grid, row, parent);
    if (slider_ != nullptr) addSlider(grid, row + 1, parent);
}

/// On its own line: a short slider cannot be set finely. Left is less. Less of a threshold gives more edges: its buttons have no signs.
void ParameterRow::addSlider(QGridLayout& grid, int row, QWidget* parent) {
    slider_->setObjectName(QString("slider-") + parameter_.key);
    slider_->setToolTip(limitsText(parameter_));
    slider_->setAccessibleName(label_->text());
    slider_->installEventFilter(this);
    connect(slider_, &QSlider::valueChanged, this, [this](int position) { changeTo(edges::sliderValue(parameter_, position)); });
    connect(slider_, &QSlider::sliderReleased, this, &ParameterRow::dragEnded);
    const bool threshold = parameter_.feeds == edges::Stage::Threshold;
    auto *line = new QHBoxLayout, *words = new QHBoxLayout;
    line->addWidget(slider_, 1);
    for (const int direction : {-1, +1}) {
        auto* button = new QToolButton(parent);
        button->setObjectName((direction < 0 ? "less-" : "more-") + QString(parameter_.key));
        button->setText(QString(u"−+◀▶"[(threshold ? 2 : 0) + (direction > 0 ? 1 : 0)]));
        button->setAccessibleName((direction < 0 ? tr("less: %1") : tr("more: %1")).arg(label_->text()));
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
        connect(button, &QToolButton::clicked, this, [this, button, direction] {
            step(direction * stepsAfter(repeats_++));
            if (button->isDown()) return; // it is still pressed
            repeats_ = 0;
            emit dragEnded();
        });
        line->insertWidget(direction < 0 ? 0 : 2, button);
        ofGloves_.push_back(button);
        if (!threshold) continue;
        auto* word = new QLabel(direction < 0 ? tr("More edges") : tr("Fewer edges"), parent);
        word->setObjectName("meaning-of-" + button->objectName());
        words->addWidget(word, 1, direction < 0 ? Qt::AlignLeft : Qt::AlignRight);
        ofGloves_.push_back(word);
    }
    for (QWidget* each : ofGloves_) each->hide();
    grid.addLayout(line, row, 0, 1, 4);
    grid.addLayout(words, row + 1, 0, 1, 4);
}

bool ParameterRow::numericChoices() const { return parameter_.choices.size() > 2 && parameter_.choices.front().name[0] <= '9'; }

void ParameterRow::addNumber(QGridLayout& grid, int row, QWidget* parent) {
    const edges::Parameter& p = parameter_;
    slider_ = new QSlider(Qt::Horizontal, parent);
    slider_->setRange(0, edges::kSliderSteps);
    slider_->setSingleStep(std::max(1, static_cast<int>(std::lround(edges::kSliderSteps * p.step / (p.sliderMaximum - p.minimum)))));
    auto* box = new ReadingBox(parent);
    number_ = box;
    // Automatic values are shown even beyond the limits for typed values.
    box->read([this, box](const QString& text) -> Result<double> {
        const Result<double> value = edges::parseValue(parameter_, text.toStdString());
        if (value && std::isnan(*value)) return Error{"auto is not a number", "", "tick auto next to the box"};
        if (!value && text == box->textFromValue(box->value())) return box->value();
        return value;
    });
    box->onRefusal([this](const Error& why) {
        const QString sentence =
            tr("%1: %2; %3. The value stays as it was.").arg(QObject::tr(parameter_.label), shownText(why.what), shownText(why.hint));
        // The box is still handling the event.
        QMetaObject::invokeMethod(
            this, [this, sentence] { emit refused(sentence); }, Qt::QueuedConnection);
    });
    number_->setObjectName(QString("number-") + p.key);
    number_->setLocale(QLocale::c());
    number_->setDecimals(p.decimals);
    number_->setRange(p.minimum, p.maximum);
    number_->setSingleStep(p.step);
    number_->setKeyboardTracking(false);
    number_->setAccessibleName(label_->text());
    number_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    if (*p.unit != '\0') number_->setSuffix(" " + QObject::tr(p.unit));
    label_->setBuddy(number_);
    connect(number_, &QDoubleSpinBox::editingFinished, this, &ParameterRow::dragEnded);
    connect(number_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this](double value) { changeTo(edges::snapped(parameter_, value)); });
    auto* line = new QHBoxLayout;
    line->setSpacing(2);
    line->addStretch(1);
    line->addWidget(reset_); // before the number, whose arrows stay under the pointer
    line->addWidget(number_);
    grid.addLayout(line, row, 1, 1, p.automatic == nullptr ? 3 : 2);
    if (p.automatic == nullptr) return;
    auto* automatic = new QCheckBox(tr("auto"), parent);
    automatic->setObjectName(QString("auto-") + p.key);
    automatic_ = automatic;
    grid.addWidget(automatic, row, 3);
    connect(automatic, &QCheckBox::toggled, this,
            [this](bool on) { changeTo(on ? edges::kAutomatic : edges::snapped(parameter_, number_->value())); });
}

void ParameterRow::addChoice(QGridLayout& grid, int row, QWidget* parent) {
    choice_ = new QComboBox(parent);
    choice_->setObjectName(QString("choice-") + parameter_.key);
    choice_->setToolTip(limitsText(parameter_));
    choice_->setAccessibleName(label_->text());
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    label_->setBuddy(choice_);
    for (const edges::Choice& choice : parameter_.choices) choice_->addItem(QObject::tr(choice.label));
    connect(choice_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
        if (index >= 0) changeTo(parameter_.choices[static_cast<std::size_t>(index)].value);
    });
    choice_->setMinimumContentsLength(8);
    if (!numericChoices()) { // its names are long: they begin where its own label ends
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        line->addWidget(label_);
        line->addWidget(choice_, 1);
        line->addWidget(reset_);
        grid.addLayout(line, row, 0, 1, 4);
        return;
    }
    slider_ = new QSlider(Qt::Horizontal, parent);
    slider_->setRange(0, static_cast<int>(parameter_.choices.size()) - 1);
    slider_->setPageStep(1);
    slider_->setTickPosition(QSlider::TicksBelow);
    auto* line = new QHBoxLayout;
    line->setSpacing(2);
    line->addWidget(choice_, 1);
    line->addWidget(reset_);
    grid.addLayout(line, row, 1, 1, 3);
}

void ParameterRow::addReset(QWidget* parent) {
    reset_ = new QToolButton(parent);
    reset_->setObjectName(QString("reset-") + parameter_.key);
    reset_->setIcon(toolIcon("usual"));
    reset_->setIconSize({kResetIcon, kResetIcon});
    reset_->setAutoRaise(true);
    reset_->hide();
    connect(reset_, &QToolButton::clicked, this, &ParameterRow::resetRequested);
}

void ParameterRow::show(double value, double inUse, double preset) {
    showing_ = true;
    value_ = value;
    inUse_ = inUse;
    const bool automatic = std::isnan(value);
    const double shown = automatic ? inUse : value;
    if (automatic_ != nullptr) automatic_->setChecked(automatic);
    if (number_ != nullptr && !std::isnan(shown)) {
        number_->setRange(std::min(parameter_.minimum, shown), std::max(parameter_.maximum, shown));
        number_->setValue(shown);
        number_->updateGeometry();
    }
    if (choice_ != nullptr) choice_->setCurrentIndex(edges::sliderPosition(parameter_, value));
    // While the operator drags the slider it must not be moved: its own rounding would push it back.
    if (slider_ != nullptr && !std::isnan(shown) && !slider_->isSliderDown()) slider_->setValue(edges::sliderPosition(parameter_, shown));
    showing_ = false;
    const std::string before = edges::formatValue(parameter_, preset);
    differs_ = edges::formatValue(parameter_, value) != before && !(automatic_ != nullptr && std::isnan(preset));
    reset_->setVisible(visible_ && differs_ && !forGloves_); // it would widen the column of a cab under the finger
    const QString back = tr("Back to %1, the value of the preset")
                             .arg(choice_ != nullptr ? choice_->itemText(edges::sliderPosition(parameter_, preset)) : shownText(before));
    reset_->setToolTip(back);
    reset_->setAccessibleName(label_->text() + ": " + back);
}

std::vector<QWidget*> ParameterRow::widgets() const {
    std::vector<QWidget*> all;
    for (QWidget* widget : {static_cast<QWidget*>(label_), static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_),
                            static_cast<QWidget*>(choice_), static_cast<QWidget*>(automatic_)}) {
        if (widget != nullptr) all.push_back(widget);
    }
    return all;
}

void ParameterRow::setEnabled(bool enabled) {
    for (QWidget* widget : widgets()) widget->setEnabled(enabled);
    reset_->setEnabled(enabled);
}

void ParameterRow::read(Reading reading) {
    if (number_ != nullptr) static_cast<ReadingBox*>(number_)->read(std::move(reading));
}

void ParameterRow::setVisible(bool visible) {
    visible_ = visible;
    for (QWidget* widget : widgets()) widget->setVisible(visible);
    for (QWidget* each : ofGloves_) each->setVisible(visible && forGloves_);
    reset_->setVisible(visible && differs_ && !forGloves_);
}

void ParameterRow::setForGloves(bool on) {
    forGloves_ = on;
    setVisible(visible_);
}

/// As a drag does. A choice goes to its next value.
void ParameterRow::step(int steps) {
    const edges::Parameter& p = parameter_;
    double value = value_;
    if (!p.choices.empty()) {
        const int at = edges::sliderPosition(p, value), last = static_cast<int>(p.choices.size()) - 1;
        value = p.choices[static_cast<std::size_t>(std::clamp(at + std::clamp(steps, -1, 1), 0, last))].value;
    } else {
        if (std::isnan(value)) value = std::isnan(inUse_) ? p.minimum : inUse_;
        value = edges::snapped(p, std::clamp(value + steps * p.step, p.minimum, p.sliderMaximum));
    }
    emit changed(value, true);
}

void ParameterRow::changeTo(double value) {
    if (showing_) return;
    emit changed(value, slider_ != nullptr && slider_->isSliderDown());
}

// Arrow keys on a slider of numbers: one step, with Shift ten, with Ctrl a tenth of a step.
bool ParameterRow::stepByKey(const QKeyEvent& event) {
    if (number_ == nullptr) return false;
    const bool up = event.key() == Qt::Key_Up || event.key() == Qt::Key_Right;
    const bool down = event.key() == Qt::Key_Down || event.key() == Qt::Key_Left;
    if (!up && !down) return false;
    double step = parameter_.step * (up ? 1.0 : -1.0);
    if ((event.modifiers() & Qt::ShiftModifier) != 0) step *= 10.0;
    if ((event.modifiers() & Qt::ControlModifier) != 0) step /= 10.0;
    number_->setValue(edges::snapped(parameter_, number_->value() + step));
    return true;
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == slider_ && event->type() == QEvent::KeyPress) return stepByKey(*static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::MouseButtonDblClick) {
        emit resetRequested();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace edgescan::ui

#include "moc_parameter_row.cpp"
