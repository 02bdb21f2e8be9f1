// The operator's edits of rocks: merge, split, rock or not a rock, undo.
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/rocks/rocks_panel.h"

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr qint64 kOneTurnMs = 1000;

QString nameOfTurn(const RockSettings& before, const RockSettings& after) {
    for (const RockParameter& row : rockParameters()) {
        if (row.get(before) != row.get(after)) return QString(row.label) + '\n' + QObject::tr(row.label);
    }
    return stepName("region of interest");
}

} // namespace

void Rocks::turn(const RockSettings& settings) {
    if (settings == settings_) return;
    const QString name = nameOfTurn(settings_, settings);
    if (turned_ != name || !sinceTurn_.isValid() || sinceTurn_.elapsed() > kOneTurnMs) turn_ = nextDrag();
    turned_ = name;
    sinceTurn_.start();
    undo_.push(new UndoStep<RockSettings>(
        turn_, [name](const RockSettings&, const RockSettings&) { return name; }, settings_, settings,
        [this](RockSettings value) {
            value.region = settings_.region; // it belongs to one scan and has its own undo steps
            useSettings(value);
            return true;
        }));
}

std::optional<RockPreset> Rocks::part() const {
    if (!on_ || !engine_.picture()) return std::nullopt;
    return RockPreset{settings_, edits_, engine_.picture()->detection->scan->sha256};
}

void Rocks::setPart(const std::optional<RockPreset>& part) {
    if (!part) return;
    if (beside_.reading()) {
        restored_ = part;
        return;
    }
    const RockSettings settings = part->settings.value_or(settings_);
    const RockByHand byHandThen{part->edits, settings.region};
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

void Rocks::pushByHand(const QString& name, RockByHand after) {
    undo_.push(new UndoStep<RockByHand>(name, byHand(), std::move(after), [this, stream = stream_](const RockByHand& value) {
        if (stream_ == stream) setByHand(value);
        return stream_ == stream; // else the scan was closed, and its edits with it
    }));
}

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
