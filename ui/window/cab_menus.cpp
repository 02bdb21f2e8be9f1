// Menus of the tools and of the title in cab mode.
#include "core/inspect/measure/notebook.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/numbers_side.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QCursor>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr std::size_t kMostRemovals = 4; // newest measurements in the menu
constexpr std::size_t kMostPins = 4;     // newest targets in it

} // namespace

QMenu& CabMode::menuWith(const QString& id) const { return *qobject_cast<QMenu*>(actionOf(keyedCommands(window_.actions()), id).parent()); }

/// A menu, not one tap: a glove must not remove what it did not mean. What is chosen is alone in it, until the operator asks for others.
void CabMode::fillRemoval(QMenu& menu, bool all) {
    menu.clear();
    Targets& targets = window_.viewer().targets;
    const auto& pins = targets.notebook().targets;
    const std::vector<QString> measures = targets.measuresInWords();
    const auto addTarget = [&](const inspect::PinnedTarget& target) {
        const QString words = tr("Target %1").arg(targets.inWords(target));
        QAction* removal = menu.addAction((target.locked ? tr("Locked: %1") : tr("Remove: %1")).arg(words).replace('&', "&&"), &targets,
                                          [&targets, number = target.number] { targets.remove(number); });
        removal->setEnabled(!target.locked);
    };
    const auto addMeasure = [&](std::size_t n) {
        menu.addAction(tr("Remove: %1").arg(measures[n].simplified()), &targets, [&targets, n] { targets.removeMeasure(n); });
    };
    const inspect::PinnedTarget* target = targets.active();
    const auto measure = targets.chosenMeasure();
    if (!all && (measure || target != nullptr)) {
        measure ? addMeasure(*measure) : addTarget(*target);
        if (pins.size() + measures.size() == 1) return;
        const auto showOthers = [this, &menu] {
            fillRemoval(menu, true);
            menu.popup(menu.pos());
        };
        menu.addAction(tr("Others…"), this, [this, showOthers] { QMetaObject::invokeMethod(this, showOthers, Qt::QueuedConnection); });
        return;
    }
    std::for_each(pins.rbegin(), pins.rbegin() + static_cast<std::ptrdiff_t>(std::min(pins.size(), kMostPins)), addTarget);
    for (std::size_t n = measures.size(); n-- > measures.size() - std::min(measures.size(), kMostRemovals);) addMeasure(n);
}

void CabMode::fillMeasures(QMenu& menu) {
    menu.clear();
    Measures& measures = window_.viewer().measures;
    for (const inspect::MeasureTraits& each : inspect::measureTraits()) {
        if (!each.inViews) continue;
        const QString name = QObject::tr(each.label);
        if (measures.kind() == each.kind) // at its place: the other rows do not move
            menu.addAction(tr("End measuring") + ": " + name, &measures, &Measures::stop);
        else
            menu.addAction(name, &measures, [&measures, kind = each.kind] { measures.start(kind); });
    }
    menu.addSeparator();
    for (const char* section : {"Measure/Section through the Measurement", "Measure/Section through the Rock"})
        menu.addAction(&actionOf(keyedCommands(window_.actions()), section));
}

/// Of the target in the title: the entries that a click on it has in the views.
void CabMode::openTitleMenu() {
    if (!numbers().opens) return;
    auto* menu = new QMenu(&window_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    window_.viewer().targets.addEntriesOf(*menu, window_.viewer().targets.active()->number);
    menu->popup(QCursor::pos());
}

} // namespace edgescan::ui
