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
    RockEditStep(const QString& name, Rocks& rocks, const Engine& engine, RockByHand after)
        : QUndoCommand(name), rocks_(rocks), engine_(engine), stream_(streamNow()), before_(rocks.byHand()), after_(std::move(after)) {}

    void undo() override { apply(before_); }
    void redo() override { apply(after_); }

private:
    [[nodiscard]] std::uint64_t streamNow() const { return engine_.picture() ? engine_.picture()->source.stream : 0; }
    void apply(const RockByHand& byHand) {
        if (streamNow() == stream_)
            rocks_.setByHand(byHand);
        else
            setObsolete(true); // the scan was closed, and its edits with it
    }

    Rocks& rocks_;
    const Engine& engine_;
    std::uint64_t stream_;
    RockByHand before_, after_;
};

constexpr int kRockTurning = 0x40000000; // of QUndoCommand::id(): differs from the drag numbers in Tuning
constexpr qint64 kOneTurnMs = 1000;

QString nameOfTurn(const RockSettings& before, const RockSettings& after) {
    for (const RockParameter& row : rockParameters()) {
        if (row.get(before) != row.get(after)) return QString(row.label) + '\n' + QObject::tr(row.label);
    }
    return stepName("region of interest");
}

/// Changes without a pause between them are one step.
class RockTurn : public QUndoCommand {
public:
    RockTurn(Rocks& rocks, const RockSettings& after)
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
    void turnTo(RockSettings settings) {
        settings.region = rocks_.settings().region;
        rocks_.useSettings(settings);
    }

    Rocks& rocks_;
    RockSettings before_, after_;
    QElapsedTimer since_; // since the last change
};

} // namespace

void Rocks::turn(const RockSettings& settings) {
    if (settings != settings_) undo_.push(new RockTurn(*this, settings));
}

void Rocks::restore(const RockPreset& preset) {
    if (beside_.reading()) {
        restored_ = preset;
        return;
    }
    RockSettings settings = preset.settings.value_or(settings_);
    const RockByHand byHandThen{preset.edits, settings.region};
    turn(settings);
    if (byHandThen == byHand()) return;
    const bool replaces = byHand() != RockByHand{};
    pushByHand(stepName("Open Session"), byHandThen);
    if (replaces)
        notice_.showNotice(
            NoticeBar::Kind::Warning,
            tr("The session's edits of rocks took the place of those that were kept beside the scan; Ctrl+Z brings them back."));
}

void Rocks::setByHand(const RockByHand& byHand) {
    if (byHand == this->byHand()) return;
    edits_ = byHand.edits;
    settings_.region = byHand.region;
    panel_.showSettings(settings_);
    beside_.keep(settings_, edits_);
    ask();
    emit changed();
}

void Rocks::pushByHand(const QString& name, RockByHand after) { undo_.push(new RockEditStep(name, *this, engine_, std::move(after))); }

void Rocks::push(const QString& name, RockEdit edit) {
    RockByHand after = byHand();
    after.edits.push_back(std::move(edit));
    pushByHand(name, std::move(after));
}

void Rocks::mergeSelected() {
    if (!picture_) return;
    RockEdit join{RockEditKind::Join, {}};
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
    push(rock ? stepName("call of a rock") : stepName("call of no rock"), {rock ? RockEditKind::Rock : RockEditKind::NotRock, {cell}});
}

void Rocks::turnSelected() {
    if (picture_ && !selected_.empty()) callSelected(picture_->labelAt(selected_.back()) == 0);
}

} // namespace edgescan::ui
