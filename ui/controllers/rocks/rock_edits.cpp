// The operator's edits of rocks: merge, split, rock or not a rock, undo.
#include "ui/base/notice_bar.h"
#include "ui/base/step_name.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/rocks/rocks_panel.h"

#include <QElapsedTimer>
#include <QUndoCommand>
#include <QUndoStack>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

class RockEditStep : public QUndoCommand {
public:
    RockEditStep(const QString& name, Rocks& rocks, const Engine& engine, OperatorEdits after)
        : QUndoCommand(name), rocks_(rocks), engine_(engine), stream_(streamNow()), before_(rocks.operatorEdits()),
          after_(std::move(after)) {}

    void undo() override { apply(before_); }
    void redo() override { apply(after_); }

private:
    [[nodiscard]] std::uint64_t streamNow() const { return engine_.picture() ? engine_.picture()->source.stream : 0; }
    void apply(const OperatorEdits& byHand) {
        if (streamNow() == stream_)
            rocks_.setOperatorEdits(byHand);
        else
            setObsolete(true); // the scan was closed, and its edits with it
    }

    Rocks& rocks_;
    const Engine& engine_;
    std::uint64_t stream_;
    OperatorEdits before_, after_;
};

constexpr int kRockTurning = 0x40000000; // of QUndoCommand::id(): differs from the drag numbers in Tuning
constexpr qint64 kOneTurnMs = 1000;

QString nameOfTurn(const rocks::RockSettings& before, const rocks::RockSettings& after) {
    for (const rocks::RockParameter& row : rocks::rockParameters()) {
        if (row.get(before) != row.get(after)) return QString(row.label) + '\n' + QObject::tr(row.label);
    }
    return stepName("region of interest");
}

/// Changes without a pause between them are one step.
class RockTurn : public QUndoCommand {
public:
    RockTurn(Rocks& rocks, const rocks::RockSettings& after)
        : QUndoCommand(nameOfTurn(rocks.settings(), after)), rocks_(rocks), before_(rocks.settings()), after_(after) {
        since_.start();
    }

    void undo() override { turnTo(before_); }
    void redo() override { turnTo(after_); }
    [[nodiscard]] int id() const override { return kRockTurning; }
    bool mergeWith(const QUndoCommand* later) override {
        const auto* next = dynamic_cast<const RockTurn*>(later);
        if (next == nullptr || next->text() != text() || since_.elapsed() > kOneTurnMs) return false;
        after_ = next->after_;
        since_.restart();
        return true;
    }

private:
    // The region belongs to one scan and has its own undo steps.
    void turnTo(rocks::RockSettings settings) {
        settings.region = rocks_.settings().region;
        rocks_.useSettings(settings);
    }

    Rocks& rocks_;
    rocks::RockSettings before_, after_;
    QElapsedTimer since_; // since the last change
};

} // namespace

void Rocks::change(const rocks::RockSettings& settings) {
    if (settings != settings_) undo_.push(new RockTurn(*this, settings));
}

void Rocks::restore(const rocks::Preset& preset) {
    if (sidecar_.reading()) {
        restored_ = preset;
        return;
    }
    rocks::RockSettings settings = preset.settings.value_or(settings_);
    const OperatorEdits byHandThen{preset.edits, settings.region};
    change(settings);
    if (byHandThen == operatorEdits()) return;
    const bool replaces = operatorEdits() != OperatorEdits{};
    pushOperatorEdits(stepName("Open Session"), byHandThen);
    if (replaces)
        notice_.showNotice(
            NoticeBar::Kind::Warning,
            tr("The session's edits of rocks took the place of those that were kept beside the scan; Ctrl+Z brings them back."));
}

void Rocks::setOperatorEdits(const OperatorEdits& byHand) {
    if (byHand == this->operatorEdits()) return;
    edits_ = byHand.edits;
    settings_.region = byHand.region;
    panel_.showSettings(settings_);
    sidecar_.keep(settings_, edits_);
    ask();
    emit changed();
}

void Rocks::pushOperatorEdits(const QString& name, OperatorEdits after) {
    undo_.push(new RockEditStep(name, *this, engine_, std::move(after)));
}

void Rocks::push(const QString& name, rocks::Edit edit) {
    OperatorEdits after = operatorEdits();
    after.edits.push_back(std::move(edit));
    pushOperatorEdits(name, std::move(after));
}

void Rocks::mergeSelected() {
    if (!picture_) return;
    rocks::Edit join{rocks::EditKind::Join, {}};
    for (const std::size_t cell : selected_) {
        if (picture_->regionAt(cell) != nullptr) join.cells.push_back(static_cast<std::uint32_t>(cell));
    }
    if (join.cells.size() < 2) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("Nothing was merged: select two rocks or more with Ctrl+click, or in the table."));
        return;
    }
    select({selected_.back()});
    push(stepName("merge of rocks"), std::move(join));
}

void Rocks::callSelected(bool rock) {
    if (!picture_ || selected_.empty()) return;
    const auto cell = static_cast<std::uint32_t>(selected_.back());
    if (picture_->regionAt(cell) == nullptr) return;
    push(rock ? stepName("call of a rock") : stepName("call of no rock"),
         {rock ? rocks::EditKind::Rock : rocks::EditKind::NotRock, {cell}});
}

void Rocks::toggleSelected() {
    if (picture_ && !selected_.empty()) callSelected(picture_->labelAt(selected_.back()) == 0);
}

} // namespace edgescan::ui
