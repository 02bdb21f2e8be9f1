// Names and notes of targets, and their menu.
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kPinPx = 9.0; // the pointer is on a pin up to here

} // namespace

/// The target on the rock at this cell that has its name, else any target on it; null: the rock has no target.
const inspect::PinnedTarget* Targets::onRockAt(std::size_t cell) const {
    const std::uint32_t label = rocks_.picture() ? rocks_.picture()->labelAt(cell) : 0;
    const inspect::PinnedTarget* found = nullptr;
    for (const inspect::PinnedTarget& target : notebook_.targets) {
        if (label == 0 || rocks_.picture()->labelAt(target.cell) != label) continue;
        if (found == nullptr || (found->name.empty() && !target.name.empty())) found = &target;
    }
    return found;
}

/// The target of the cell, else the nearest one whose pin is under the pointer; null: there is none.
const inspect::PinnedTarget* Targets::at(const inspect::ClickedCell& click) const {
    const inspect::PinnedTarget* found = nullptr;
    double nearestPx = kPinPx;
    for (const std::uint32_t cell : {click.clicked, click.cell}) {
        const auto on = std::ranges::find(notebook_.targets, cell, &inspect::PinnedTarget::cell);
        if (on != notebook_.targets.end()) return &*on;
    }
    for (const inspect::PinnedTarget& target : notebook_.targets) {
        const auto apart = views_.pixelsBetween(click.clicked, target.cell);
        if (!apart || *apart > nearestPx) continue;
        nearestPx = *apart;
        found = &target;
    }
    return found;
}

void Targets::addToMenu(QMenu& menu, const inspect::ClickedCell& click) {
    if (auto* rock = menu.findChild<QMenu*>(kRockMenu); rock != nullptr) {
        rock->addAction(tr("Na&me…"), this, [this, click] { askName(click); });
        rock->addAction(tr("Meas&ure from Here"), this, [this, click] { emit measureRequested(click.cell); });
    }
    if (const inspect::PinnedTarget* target = at(click)) addEntriesOf(menu, target->number);
}

void Targets::addEntriesOf(QMenu& menu, int number) {
    const inspect::PinnedTarget* target = numbered(notebook_, number);
    if (target == nullptr) return;
    const bool locked = target->locked;
    menu.addAction(tr("Na&me of Target %1…").arg(number), this, [this, number] { askNameOf(number); });
    menu.addAction(tr("No&te on Target %1…").arg(number), this, [this, number] { askNote(number); });
    menu.addAction((locked ? tr("Unloc&k Target %1") : tr("Loc&k Target %1")).arg(number), this,
                   [this, number, locked] { lock(number, !locked); });
    menu.addAction(tr("Remo&ve Target %1").arg(number), this, [this, number] { remove(number); })->setEnabled(!locked);
}

// In a dialog of its own: the card may be behind the rock table or folded.
std::optional<QString> Targets::askText(const QString& title, const QString& label, const QString& text, int mostLetters) const {
    QInputDialog dialog(panel_.window());
    dialog.setWindowTitle(title);
    dialog.setLabelText(label);
    dialog.setTextValue(text);
    if (auto* field = dialog.findChild<QLineEdit*>()) field->setMaxLength(mostLetters);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.textValue().simplified();
}

/// A rock without a target gets one with its name, not before.
void Targets::askName(const inspect::ClickedCell& click) {
    const std::size_t cell = rocks_.rockCellAt(click).value_or(click.cell);
    const inspect::PinnedTarget* target = onRockAt(cell);
    const int number = target != nullptr ? target->number : inspect::nextNumber(notebook_);
    const auto name = askText(tr("Name of a rock"),
                              target != nullptr ? tr("Name of target %1, which is on this rock:").arg(number)
                                                : tr("Name of this rock. A new target on it, number %1, holds the name:").arg(number),
                              target != nullptr ? shownName(exactText(target->name)) : QString(), panel_.card().name()->maxLength());
    if (!name) return;
    if (onRockAt(cell) == nullptr && !name->isEmpty()) views_.pinByClick(cell == click.cell ? click : inspect::exactly(cell));
    if (const inspect::PinnedTarget* named = onRockAt(cell)) rename(named->number, *name);
}

void Targets::askNameOf(int number) {
    const inspect::PinnedTarget* target = numbered(notebook_, number);
    if (target == nullptr) return;
    const auto name = askText(tr("Name of a target"), tr("Name of target %1:").arg(number), shownName(exactText(target->name)),
                              panel_.card().name()->maxLength());
    if (name) rename(number, *name);
}

void Targets::editName() {
    const inspect::PinnedTarget* target = active();
    const auto& rocks = rocks_.selected();
    if (target == nullptr && !rocks.empty() && rocks_.picture() && rocks_.picture()->labelAt(rocks.back()) != 0)
        return askName(inspect::exactly(rocks.back()));
    if (target == nullptr) return notice_.showHint(tr("Nothing to name yet: pin a cell, or choose a target."));
    if (panel_.card().name()->visibleRegion().isEmpty()) return askNameOf(target->number);
    panel_.card().editName();
}

void Targets::askNote(int number) {
    const inspect::PinnedTarget* target = numbered(notebook_, number);
    if (target == nullptr) return;
    const int most = panel_.card().note()->maxLength();
    const auto note = askText(tr("Note on a target"), tr("Note on target %1:").arg(number), shownName(exactText(target->note), most), most);
    if (note) setNote(number, *note);
}

void Targets::rename(int number, const QString& name) {
    setText(number, name, &inspect::PinnedTarget::name, inspect::kLongestTargetName, stepName("name of target %1", number));
}

void Targets::setNote(int number, const QString& note) {
    setText(number, note, &inspect::PinnedTarget::note, inspect::kLongestTargetNote, stepName("note of target %1", number));
}

void Targets::setText(int number, const QString& text, std::string inspect::PinnedTarget::*member, std::size_t mostBytes,
                      const QString& step) {
    inspect::Notebook after = notebook_;
    inspect::PinnedTarget* target = numbered(after, number);
    if (target == nullptr || text.toStdString().size() > mostBytes) return;
    target->*member = text.toStdString();
    if (after != notebook_) change(step, std::move(after));
}

} // namespace edgescan::ui
