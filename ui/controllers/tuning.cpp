// Connects the panel with the engine.
#include "ui/controllers/tuning.h"

#include "core/base/whole_file.h"
#include "core/edges/pipeline/parameter_change.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/tuning/flat_scan.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/engine/worker_bridge/edge_counter.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/tuning/edges_panel.h"

#include <QFileDialog>
#include <QFileInfo>

#include <functional>

namespace edgescan::ui {
namespace {

/// "class data border on, class jump off": the choices that only one of the two sets has.
QString describeSet(const edges::Parameter& set, const edges::Settings& before, const edges::Settings& after) {
    const auto from = static_cast<unsigned>(set.get(before)), to = static_cast<unsigned>(set.get(after));
    QStringList source, shown;
    for (const edges::Choice& choice : set.choices) {
        const auto bit = static_cast<unsigned>(choice.value);
        if (((from ^ to) & bit) == 0) continue;
        const char* text = (to & bit) != 0 ? QT_TRANSLATE_NOOP("QObject", "class %1 on") : QT_TRANSLATE_NOOP("QObject", "class %1 off");
        source << QString(text).arg(choice.label);
        shown << QObject::tr(text).arg(QObject::tr(choice.label));
    }
    return source.join(", ") + '\n' + shown.join(", ");
}

// "Lower threshold 10 to 25": the first parameter that differs.
QString describe(const edges::Settings& before, const edges::Settings& after) {
    for (const edges::Parameter& p : edges::parameters()) {
        const std::string from = edges::choiceLabel(p, before), to = edges::choiceLabel(p, after);
        if (from == to) continue;
        if (p.several) return describeSet(p, before, after);
        const auto shown = [](const std::string& value) { return QObject::tr(value.c_str()); }; // numbers stay
        return QString("%1 %2 to %3").arg(QString(p.label), shownText(from), shownText(to)) + '\n' +
               QObject::tr("%1 %2 to %3").arg(QObject::tr(p.label), shown(from), shown(to));
    }
    return stepName("settings");
}

} // namespace

Tuning::Tuning(Engine& engine, EdgesPanel& panel, NoticeBar& notice, Preferences& preferences, QUndoStack& undo)
    : engine_(engine), panel_(panel), notice_(notice), preferences_(preferences), undo_(undo), counts_(new EdgeCounter(this)) {
    connect(&panel_, &EdgesPanel::edited, this, &Tuning::change);
    connect(&panel_, &EdgesPanel::editEnded, this, [this] { drag_ = nextDrag(); });
    connect(&panel_, &EdgesPanel::refused, this, [this](const QString& why) { notice_.showNotice(NoticeBar::Kind::Error, why); });
    connect(&panel_, &EdgesPanel::presetChosen, this, &Tuning::usePreset);
    connect(&panel_, &EdgesPanel::openPresetRequested, this, &Tuning::askOpenPreset);
    connect(&panel_, &EdgesPanel::savePresetRequested, this, &Tuning::askSavePreset);
    connect(&panel_, &EdgesPanel::ratioLockChanged, this, [this](bool locked) { preferences_.keep("edges/ratio-locked", locked); });
    connect(counts_, &EdgeCounter::outdated, &panel_, &EdgesPanel::forgetCounts);
    connect(counts_, &EdgeCounter::counted, &panel_, &EdgesPanel::showCounts);
    connect(&engine_, &Engine::settingsChanged, this, &Tuning::noteChange);
    recall();
}

void Tuning::recall() {
    const QString preset = preferences_.text("edges/preset");
    if (const auto found = edges::findPreset(exactBytes(preset)); !preset.isEmpty() && found) panel_.setPreset(*found);
    if (!preferences_.flag("edges/ratio-locked", true)) panel_.setRatioLocked(false);
    useSettings(preferences_.settings(engine_.settings()));
}

void Tuning::noteChange() {
    panel_.show(engine_.settings());
    panel_.setBehind(engine_.behind());
    if (!starting_) preferences_.keepSettings(engine_.settings());
}

void Tuning::followPicture() {
    const Picture& picture = *engine_.picture();
    const bool newScan = std::exchange(shownScan_, picture.detection->scan) != picture.detection->scan;
    panel_.showResult(*picture.detection);
    panel_.setBehind(engine_.behind());
    if (newScan && !picture.source.growth.growing) proposePreset(*picture.detection);
}

void Tuning::count(bool grows) {
    if (grows)
        counts_->forget();
    else if (engine_.picture())
        counts_->want(engine_.picture()->detection);
}

void Tuning::proposePreset(const edges::Detection& detection) {
    if (!(detection.settings == edges::Settings{}) || !edges::isFlatAndQuiet(detection)) return;
    notice_.showNotice(NoticeBar::Kind::Done,
                       tr("This scan is flat and quiet: with the preset Smooth walls low steps far away are edges too."));
    notice_.offer(tr("Use It"), [this] {
        if (const auto preset = edges::findPreset("smooth-walls")) usePreset(*preset);
    });
}

void Tuning::change(const edges::Settings& settings, bool dragging) { push({settings, panel_.preset()}, dragging); }

/// The name of the preset goes back with its values.
void Tuning::push(const Tuned& after, bool dragging) {
    if (after.settings == engine_.settings()) return name(after.preset);
    const auto use = [this](const Tuned& value) {
        name(value.preset);
        engine_.setSettings(value.settings);
        return true;
    };
    const auto words = [](const Tuned& from, const Tuned& to) { return describe(from.settings, to.settings); };
    undo_.push(new UndoStep<Tuned>(dragging ? drag_ : nextDrag(), words, {engine_.settings(), panel_.preset()}, after, use));
}

void Tuning::name(const edges::Preset& preset) {
    const edges::Preset& now = panel_.preset();
    if (preset.name == now.name && preset.path == now.path && preset.settings == now.settings) return;
    panel_.setPreset(preset);
    if (!starting_) preferences_.keep("edges/preset", exactText(preset.path.empty() ? preset.name : preset.path));
}

void Tuning::usePreset(const edges::Preset& preset) {
    push({preset.settings, preset}, false);
    panel_.show(engine_.settings());
}

void Tuning::useSettings(const edges::Settings& settings) {
    engine_.setSettings(settings);
    panel_.show(engine_.settings());
}

inspect::TuningPart Tuning::part() const {
    const edges::Preset& preset = panel_.preset();
    return {engine_.settings(), preset.path.empty() ? preset.name : preset.path};
}

void Tuning::setPart(const inspect::TuningPart& part) {
    if (const auto preset = edges::findPreset(part.preset); preset && !part.preset.empty()) panel_.setPreset(*preset);
    useSettings(part.settings);
}

void Tuning::setParameter(const char* key, double value) {
    edges::Settings settings = engine_.settings();
    edges::findParameter(key)->set(settings, value);
    change(settings, false);
}

void Tuning::reset(const QString& parameter) {
    if (parameter.isEmpty()) return usePreset(edges::builtInPresets().front());
    const edges::Parameter* p = edges::findParameter(parameter.toStdString()); // null: one of rocks
    if (p != nullptr) change(edges::withParameterChanged(engine_.settings(), *p, p->get(edges::Settings{}), engine_.settings()), false);
}

void Tuning::startWith(const edges::Preset& preset, const edges::Settings& settings) {
    starting_ = true;
    panel_.setPreset(preset);
    useSettings(settings);
    starting_ = false;
}

bool Tuning::settled() const { return !counts_->behind(); }

void Tuning::askOpenPreset() {
    const QString path =
        QFileDialog::getOpenFileName(panel_.window(), tr("Open preset"), preferences_.folder("presets"), tr("EdgeScan presets (*.json)"));
    if (path.isEmpty()) return;
    preferences_.keepFolder("presets", path);
    if (const Result<edges::Preset> preset = edges::findPreset(exactBytes(path)); preset)
        usePreset(*preset);
    else
        notice_.showError(preset.error());
}

void Tuning::askSavePreset() {
    SaveQuestion question{tr("Save preset"), preferences_.folder("presets"), {tr("EdgeScan presets (*.json)")}};
    // Scans use this extension too.
    question.keeps = [](const QString& there) {
        return edges::findPreset(exactBytes(there)) ? QString()
                                                    : tr("%1 is not a preset and stays as it is: choose another name.").arg(there);
    };
    const QString path = askWhereToSave(panel_.window(), question);
    if (path.isEmpty()) return;
    preferences_.keepFolder("presets", path);
    const edges::Preset preset{exactBytes(QFileInfo(path).completeBaseName()), "", engine_.settings(), exactBytes(path)};
    if (const Result<Done> written = writeWholeFile(exactBytes(path), edges::presetText(preset)); written)
        usePreset(preset);
    else
        notice_.showError(written.error());
}

} // namespace edgescan::ui

#include "moc_tuning.cpp"
