// Edits of rocks by hand: merge, split, rock or not, undo.
#include "ui/base/notice_bar.h"
#include "ui/control/rocks.h"
#include "ui/rocks/rocks_panel.h"

#include <QUndoCommand>
#include <QUndoStack>

#include <algorithm>

namespace edgescan::ui {
namespace {

class RockEditStep : public QUndoCommand {
public:
    RockEditStep(const QString& name, Rocks& rocks, const Session& session, RockByHand after)
        : QUndoCommand(name), rocks_(rocks), session_(session), stream_(streamNow()), before_(rocks.byHand()), after_(std::move(after)) {}

    void undo() override { apply(before_); }
    void redo() override { apply(after_); }

private:
    [[nodiscard]] std::uint64_t streamNow() const { return session_.picture() ? session_.picture()->source.stream : 0; }
    void apply(const RockByHand& byHand) {
        if (streamNow() == stream_)
            rocks_.setByHand(byHand);
        else
            setObsolete(true); // the scan is gone, and its edits with it
    }

    Rocks& rocks_;
    const Session& session_;
    std::uint64_t stream_;
    RockByHand before_, after_;
};

} // namespace

void Rocks::setByHand(const RockByHand& byHand) {
    if (byHand == this->byHand()) return;
    edits_ = byHand.edits;
    settings_.region = byHand.region;
    panel_.showSettings(settings_);
    beside_.keep(settings_, edits_);
    ask();
}

void Rocks::pushByHand(const QString& name, RockByHand after) { undo_.push(new RockEditStep(name, *this, session_, std::move(after))); }

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
    push(tr("merge of rocks"), std::move(join));
}

void Rocks::callSelected(bool rock) {
    if (!picture_ || selected_.empty()) return;
    const auto cell = static_cast<std::uint32_t>(selected_.back());
    if (picture_->regionAt(cell) == nullptr) return;
    push(rock ? tr("call of a rock") : tr("call of no rock"), {rock ? RockEditKind::Rock : RockEditKind::NotRock, {cell}});
}

void Rocks::turnSelected() {
    if (picture_ && !selected_.empty()) callSelected(picture_->labelAt(selected_.back()) == 0);
}

} // namespace edgescan::ui
