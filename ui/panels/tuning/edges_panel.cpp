// The panel "Edges".
#include "ui/panels/tuning/edges_panel.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/parameter_change.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/elided_label.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"
#include "ui/panels/tuning/count_curve.h"
#include "ui/panels/tuning/parameter_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QObject>
#include <QScrollArea>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

namespace edgescan::ui {
namespace {

/// "each cell errs for itself; sigma 6.1 mm at 2.6 m, 6.7 mm at 5.2 m, ..."; empty if the method uses no noise.
QString noiseWords(const edges::Detection& detection) {
    if (!detection.responses || !(detection.responses->scales.rangeM > 0)) return {};
    const edges::DepthResponses& found = *detection.responses;
    const auto at = [](const RangeNoise& noise, double rangeM) {
        return QObject::tr("%1 mm at %2 m").arg(noise.at(rangeM), 0, 'f', 1).arg(rangeM, 0, 'f', 1);
    };
    const double usual = found.scales.rangeM;
    const QString kind = found.neighboursAlike  ? QObject::tr("neighbours err alike, as in a depth camera")
                         : found.scales.inSteps ? QObject::tr("each cell errs for itself, in steps of the file")
                                                : QObject::tr("each cell errs for itself");
    QString text = QObject::tr("Noise in use: %1; sigma %2, %3, %4.")
                       .arg(kind, at(found.noise, 0.5 * usual), at(found.noise, usual), at(found.noise, 2 * usual));
    if (found.neighboursAlike) text += " " + QObject::tr("Folds have to exceed %1.").arg(at(found.foldNoise, usual));
    if (found.roughness.rough)
        text += " " + QObject::tr("Rough scan: around half of the folds %1 % of the cells fold, so a fold must exceed its surroundings.")
                          .arg(100 * found.roughness.aroundFolds, 0, 'f', 0);
    return text;
}

constexpr int kNarrowestPanel = 220; // px: a label, a number and "auto" next to each other
constexpr int kNarrowestLabel = 84;
constexpr double kThesisRatio = 3.0;
// maximum of |gx| + |gy| of Sobel 3x3 on 8-bit gray (4 x 255 along each axis)
constexpr double kLargestGradient = 2040.0;

} // namespace

struct EdgesPanel::InUse {
    edges::GrayScale scale{};
    edges::Measured measured{};
};

EdgesPanel::EdgesPanel(QWidget* parent)
    : QWidget(parent), inUse_(std::make_shared<const InUse>()), preset_(edges::builtInPresets().front()) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(6, 6, 6, 6);
    auto* grid = new QGridLayout;
    advanced_ = new QWidget;
    auto* advancedGrid = new QGridLayout(advanced_);
    for (QGridLayout* each : {grid, advancedGrid}) {
        each->setColumnStretch(1, 1);
        each->setColumnMinimumWidth(0, kNarrowestLabel);
        each->setHorizontalSpacing(2); // the numbers need the room
    }
    addPresets(*grid);
    for (const edges::Parameter& p : edges::parameters()) {
        if (!p.advanced && !p.several) addRow(p, *grid); // the classes are switches of the legend
        if (p.feeds == edges::Stage::Threshold) addCurve(p, *grid);
        if (std::strcmp(p.key, "lower") == 0) addMeaning(*grid);
        if (std::strcmp(p.key, "ratio") == 0) addUpper(*grid);
    }
    column->addLayout(grid);

    auto* fold = fold_ = new QToolButton;
    fold->setText(tr("Advanced"));
    fold->setCheckable(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setAutoRaise(true);
    advancedGrid->setContentsMargins(0, 0, 0, 0);
    for (const edges::Parameter& p : edges::parameters()) {
        if (!p.advanced) continue;
        addRow(p, *advancedGrid);
        if (std::string_view(p.key) == "noise-kind") addNoise(*advancedGrid);
    }
    advanced_->hide();
    connect(fold, &QToolButton::toggled, this, [this, fold](bool open) {
        advanced_->setVisible(open);
        fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
    column->addWidget(fold);
    column->addWidget(advanced_);
    behind_ = new QLabel;
    column->addWidget(behind_);
    column->addStretch(1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scrolled(*content));
    setMinimumWidth(kNarrowestPanel);
    setRatioLocked(true);
    show(edges::Settings{});
    setPreset(preset_);
}

/// Each built-in preset in plain words, and what it is for, in one line. Files and the command line have its key.
struct PresetWords {
    const char *key, *label, *purpose;
};
constexpr std::array<PresetWords, 7> kPresetWords{{
    {"default", QT_TRANSLATE_NOOP("QObject", "Default"), QT_TRANSLATE_NOOP("QObject", "For most scans of rock")},
    {"log", QT_TRANSLATE_NOOP("QObject", "Percent of range"), QT_TRANSLATE_NOOP("QObject", "Steps in percent of the range")},
    {"thesis", QT_TRANSLATE_NOOP("QObject", "Thesis"), QT_TRANSLATE_NOOP("QObject", "To compare with the thesis")},
    {"window", QT_TRANSLATE_NOOP("QObject", "Thesis, contrast"), QT_TRANSLATE_NOOP("QObject", "The thesis, with more contrast")},
    {"smooth-walls", QT_TRANSLATE_NOOP("QObject", "Smooth walls"), QT_TRANSLATE_NOOP("QObject", "For flat walls with low steps")},
    {"default-4", QT_TRANSLATE_NOOP("QObject", "Version 4"), QT_TRANSLATE_NOOP("QObject", "To compare with version 4")},
    {"default-3", QT_TRANSLATE_NOOP("QObject", "Version 3"), QT_TRANSLATE_NOOP("QObject", "To compare with version 3")},
}};

QString presetName(const std::string& name) {
    const auto known = std::ranges::find(kPresetWords, std::string_view(name), &PresetWords::key);
    return known != kPresetWords.end() ? QObject::tr(known->label) : shownName(exactText(name), 60);
}

void EdgesPanel::addPresets(QGridLayout& grid) {
    presets_ = new QComboBox;
    presets_->setObjectName("presets");
    presets_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    presets_->setMinimumContentsLength(8);
    for (const edges::Preset& preset : edges::builtInPresets()) {
        presets_->addItem(presetName(preset.name), shownText(preset.name));
        presets_->setItemData(presets_->count() - 1, QObject::tr(preset.help.c_str()), Qt::ToolTipRole);
    }
    connect(presets_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        const auto builtIn = edges::builtInPresets();
        if (static_cast<std::size_t>(index) < builtIn.size())
            emit presetChosen(builtIn[static_cast<std::size_t>(index)]);
        else
            emit presetChosen(preset_);
    });
    modified_ = new QLabel;
    modified_->setWordWrap(true);
    modified_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the panel keeps its width under a finger
    auto* open = new QToolButton;
    open->setText(tr("Open…"));
    open->setToolTip(tr("Open a preset file"));
    auto* save = new QToolButton;
    save->setText(tr("Save…"));
    save->setToolTip(tr("Save these settings as a preset file"));
    connect(open, &QToolButton::clicked, this, &EdgesPanel::openPresetRequested);
    connect(save, &QToolButton::clicked, this, &EdgesPanel::savePresetRequested);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(modified_, 1);
    buttons->addWidget(open);
    buttons->addWidget(save);
    auto* label = new QLabel(tr("Preset"));
    label->setBuddy(presets_);
    purpose_ = new ElidedLabel;
    purpose_->setObjectName("preset-purpose");
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(presets_, row, 1, 1, 3);
    grid.addWidget(purpose_, row + 1, 0, 1, 4);
    grid.addLayout(buttons, row + 2, 0, 1, 4);
}

void EdgesPanel::addRow(const edges::Parameter& parameter, QGridLayout& grid) {
    auto* row = new ParameterRow(parameter, grid, this);
    rows_.push_back(row);
    connect(row, &ParameterRow::changed, this, [this, row](double value, bool dragging) { edit(row->parameter(), value, dragging); });
    connect(row, &ParameterRow::dragEnded, this, &EdgesPanel::editEnded);
    connect(row, &ParameterRow::refused, this, &EdgesPanel::refused);
    connect(row, &ParameterRow::resetRequested, this, [this, row] {
        edit(row->parameter(), row->parameter().get(preset_.settings), false);
        emit editEnded();
    });
}

void EdgesPanel::addNoise(QGridLayout& grid) {
    noise_ = new QLabel;
    noise_->setObjectName("noise-found");
    noise_->setWordWrap(true);
    noise_->setTextFormat(Qt::PlainText);
    noise_->hide();
    grid.addWidget(noise_, grid.rowCount(), 0, 1, 4);
}

void EdgesPanel::addCurve(const edges::Parameter& parameter, QGridLayout& grid) {
    auto* curve = new CountCurve(parameter, this);
    curves_.push_back(curve);
    grid.addWidget(curve, grid.rowCount(), 0, 1, 4);
}

void EdgesPanel::addMeaning(QGridLayout& grid) {
    meaning_ = new QLabel;
    meaning_->setObjectName("meaning");
    meaning_->setWordWrap(true);
    meaning_->setToolTip(
        tr("The steps in depth that reach the thresholds, computed from the kernels: the smaller number for a step that "
           "runs diagonally, the larger one along lines or beams. A depth such as 0.5 m can be typed into the box above; "
           "with logarithmic gray levels it is taken at the range given here, and a share such as 5 % holds at every range."));
    grid.addWidget(meaning_, grid.rowCount(), 0, 1, 4);
    row("lower")->read([this](const QString& text) { return lowerOfDepth(text); });
}

Result<double> EdgesPanel::lowerOfDepth(const QString& text) const {
    const auto step = edges::typedStep(text.toStdString());
    return step ? edges::lowerOfStep(*step, shown_, inUse_->scale) : edges::parseValue(*edges::findParameter("lower"), text.toStdString());
}

CountCurve* EdgesPanel::curve(const char* key) const {
    const auto found = std::ranges::find(curves_, QString("curve-") + key, [](const CountCurve* curve) { return curve->objectName(); });
    return found == curves_.end() ? nullptr : *found;
}

void EdgesPanel::showCounts(const QString& parameter, const edges::EdgeCountCurve& counts) {
    if (CountCurve* shown = curve(parameter.toUtf8().constData())) shown->showCurve(counts);
}

void EdgesPanel::forgetCounts() {
    for (CountCurve* curve : curves_) curve->showCurve(std::nullopt);
}

void EdgesPanel::showMeaning() {
    const edges::GrayScale& scale = inUse_->scale;
    const std::string text = scale.farMm > scale.nearMm ? edges::thresholdText(shown_, scale) : std::string();
    meaning_->setText(shownText(text));
    meaning_->setVisible(!text.empty());
}

void EdgesPanel::addUpper(QGridLayout& grid) {
    upper_ = new QLabel;
    upper_->setObjectName("upper");
    upper_->setWordWrap(true);
    lock_ = new QToolButton;
    lock_->setObjectName("ratio-lock");
    lock_->setCheckable(true);
    lock_->setToolTip(tr("Locked: the upper threshold is 3 times the lower one, as in the thesis. Click to open the lock."));
    connect(lock_, &QToolButton::clicked, this, &EdgesPanel::setRatioLocked);
    const int row = grid.rowCount();
    grid.addWidget(upper_, row, 0, 1, 2);
    grid.addWidget(lock_, row, 2, 1, 2);
}

bool EdgesPanel::ratioLocked() const { return lock_->isChecked(); }

void EdgesPanel::setRatioLocked(bool locked) {
    lock_->setChecked(locked);
    lock_->setText(locked ? tr("Locked 1 : 3") : tr("Unlocked"));
    row("ratio")->setEnabled(!locked);
    emit ratioLockChanged(locked);
    if (locked && shown_.ratio != kThesisRatio) {
        edit(*edges::findParameter("ratio"), kThesisRatio, false);
        emit editEnded();
    }
}

ParameterRow* EdgesPanel::row(const char* key) const {
    for (ParameterRow* row : rows_) {
        if (std::strcmp(row->parameter().key, key) == 0) return row;
    }
    return nullptr;
}

void EdgesPanel::setForGloves(bool on) {
    for (ParameterRow* row : rows_) row->setForGloves(on);
    setMinimumWidth(on ? 0 : kNarrowestPanel); // a cab's column is as wide as the rows need
}

void EdgesPanel::edit(const edges::Parameter& parameter, double value, bool dragging) {
    const edges::Settings settings = edges::withParameterChanged(shown_, parameter, value, lastGray_);
    if (settings.method != shown_.method) carried_[settings.method] = {settings.lower, lastGray_.method, lastGray_.lower};
    emit edited(settings, dragging);
}

// Stores the gray-level settings whose threshold the operator chose. A threshold that was only carried over to another method does not
// count as chosen: when the operator returns to the method where it was chosen, it has its original value again.
void EdgesPanel::noteThreshold(const edges::Settings& settings) {
    if (!edges::reads(settings.method, edges::kReadsGray)) return;
    lastGray_ = settings;
    const auto carried = carried_.find(settings.method);
    if (carried == carried_.end() || settings.lower != carried->second.lower) return;
    lastGray_.method = carried->second.chosenFor;
    lastGray_.lower = carried->second.chosen;
}

void EdgesPanel::show(const edges::Settings& settings) {
    shown_ = settings;
    noteThreshold(settings);
    if (settings.ratio != kThesisRatio && ratioLocked()) {
        setRatioLocked(false);
    }
    showInUse();
    showUpper();
    showMeaning();
    showPresetName();
}

void EdgesPanel::showResult(const edges::Detection& detection) {
    inUse_ = std::make_shared<const InUse>(InUse{detection.gray->scale, edges::measuredOf(detection)});
    const edges::Parameter& swept = edges::sweptParameter(detection.settings.method);
    curve(swept.key)->showFound(swept.get(detection.settings), detection.edges->size());
    const QString noise = noiseWords(detection);
    noise_->setText(noise);
    noise_->setVisible(!noise.isEmpty());
    showInUse();
    showMeaning();
}

void EdgesPanel::showInUse() {
    const auto folded = [this](const edges::Parameter& p) { return p.advanced && p.usedBy(shown_); };
    fold_->setVisible(std::ranges::any_of(edges::parameters(), folded));
    for (ParameterRow* row : rows_) {
        const edges::Parameter& p = row->parameter();
        row->show(p.get(shown_), automaticValue(p), p.get(preset_.settings));
        row->setVisible(p.usedBy(shown_));
        if (CountCurve* below = curve(p.key)) {
            below->showValue(p.get(shown_));
            below->setVisible(p.usedBy(shown_));
        }
    }
}

double EdgesPanel::automaticValue(const edges::Parameter& p) const {
    return p.automatic != nullptr ? p.automatic(shown_, inUse_->measured) : edges::kAutomatic;
}

void EdgesPanel::showUpper() {
    const bool used = edges::reads(shown_.method, edges::kReadsTwoThresholds);
    upper_->setVisible(used);
    lock_->setVisible(used);
    const bool share = edges::reads(shown_.method, edges::kReadsRangeStep); // a share of the range, not gray levels
    QString text =
        share ? tr("Strong from  %1 % of range").arg(100 * std::expm1(shown_.ratio * std::log1p(shown_.stepPercent / 100)), 0, 'f', 1)
              : tr("Upper threshold  %1").arg(shown_.upper(), 0, 'f', 1);
    if (!share && shown_.aperture == 3 && shown_.upper() >= kLargestGradient) text += tr("  (no gradient reaches it)");
    upper_->setText(text);
}

void EdgesPanel::showPresetName() { modified_->setText(modified() ? tr("• modified") : QString()); }

void EdgesPanel::setPreset(const edges::Preset& preset) {
    preset_ = preset;
    const QString name = shownName(exactText(preset.name), 60);
    int index = presets_->findData(name);
    if (index < 0) {
        presets_->addItem(name, name);
        index = presets_->count() - 1;
    }
    presets_->setCurrentIndex(index);
    const auto known = std::ranges::find(kPresetWords, std::string_view(preset.name), &PresetWords::key);
    QString help = QObject::tr(preset.help.c_str());
    if (known != kPresetWords.end()) help += "\n" + tr("In files and on the command line its name is %1").arg(known->key);
    purpose_->setText(known != kPresetWords.end() ? QObject::tr(known->purpose) : tr("From a file"));
    for (QWidget* each : std::initializer_list<QWidget*>{presets_, purpose_}) each->setToolTip(help);
    showInUse();
    showPresetName();
}

void EdgesPanel::setBehind(bool behind) { behind_->setText(behind ? tr("computing …") : QString()); }

} // namespace edgescan::ui

#include "moc_edges_panel.cpp"
