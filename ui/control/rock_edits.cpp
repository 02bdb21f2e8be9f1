// Edits of rocks by hand: merge, split, rock or not, undo.
#include "ui/base/notice_bar.h"
#include "ui/control/rocks.h"

#include <QUndoCommand>
#include <QUndoStack>

#include <algorithm>

namespace edgescan::ui {
namespace {

class RockEditStep : public QUndoCommand {
public:
    RockEditStep(const QString& name, Rocks& rocks, const Session& session, std::vector<RockEdit> after)
        : QUndoCommand(name), rocks_(rocks), session_(session), stream_(streamNow()), before_(rocks.edits()), after_(std::move(after)) {}

    void undo() override { apply(before_); }
    void redo() override { apply(after_); }

private:
    [[nodiscard]] std::uint64_t streamNow() const { return session_.picture() ? session_.picture()->source.stream : 0; }
    void apply(const std::vector<RockEdit>& edits) {
        if (streamNow() == stream_)
            rocks_.setEdits(edits);
        else
            setObsolete(true); // the scan is gone, and its edits with it
    }

    Rocks& rocks_;
    const Session& session_;
    std::uint64_t stream_;
    std::vector<RockEdit> before_, after_;
};

} // namespace

void Rocks::setEdits(const std::vector<RockEdit>& edits) {
    if (edits == edits_) return;
    edits_ = edits;
    ask();
}

void Rocks::push(const QString& name, RockEdit edit) {
    std::vector<RockEdit> after = edits_;
    after.push_back(std::move(edit));
    undo_.push(new RockEditStep(name, *this, session_, std::move(after)));
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

void Rocks::setSplitting(bool on) {
    if (on && (!on_ || !picture_)) return emit splittingChanged(false);
    if (splitting_ == on) return;
    splitting_ = on;
    emit splittingChanged(on);
}

void Rocks::splitAt(std::size_t cell) {
    setSplitting(false);
    if (picture_->labelAt(cell) == 0) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("Nothing was split: click on a rock, on the part that is a rock of its own."));
        return;
    }
    const RockStudy& study = picture_->study;
    std::optional<RockEdit> part = edgescan::splitAt(*study.leaves, *study.tree, study.settings.level, static_cast<std::uint32_t>(cell));
    if (!part) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("Nothing was split: this rock is one piece with nothing to tell its parts by."));
        return;
    }
    select({cell});
    push(tr("split of a rock"), std::move(*part));
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
