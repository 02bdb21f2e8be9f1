// How targets and measurements are shown and named.
#include "core/inspect/measure/click_remarks.h"
#include "core/rocks/segmentation/cuts.h"
#include "core/scan/grid/assumed_mounting.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>

#include <algorithm>

namespace edgescan::ui {
namespace {

/// "M2": next to the others at one place, and in the list.
QString briefOf(const inspect::StoredMeasure& measure) { return exactText(inspect::measureName(measure)); }

} // namespace

const std::optional<inspect::MeasuredCells>* KnownTargets::of(const inspect::StoredMeasure& measure) const {
    const auto found = std::ranges::find(measures, measure, [](const auto& each) { return each.first; });
    return found == measures.end() ? nullptr : &found->second;
}

const inspect::CellTarget* Targets::knownOf(std::uint32_t cell) const {
    const auto found = known_.targets.find(cell);
    return found == known_.targets.end() ? nullptr : &found->second;
}

const inspect::MeasuredCells* Targets::knownOf(const inspect::StoredMeasure& measure) const {
    const auto* known = known_.of(measure);
    return placePending() || known == nullptr || !*known ? nullptr : &**known;
}

TargetSurroundings Targets::around(std::size_t cell) const {
    TargetSurroundings around;
    around.rocksShown = rocks_.shown();
    around.rocksKnown = rocks_.picture() != nullptr;
    around.rock = rocks_.picture() ? rocks_.picture()->rockAt(cell) : nullptr;
    around.source = source_;
    around.placePending = placePending();
    around.confidence.state = confidence_.otherwise;
    if (confidence_.made && cell < confidence_.made->percent.size() && confidence_.made->percent[cell] > 0)
        around.confidence = {ShownConfidence::State::Known, confidence_.made->percent[cell], confidence_.made->settings};
    return around;
}

QString Targets::tagOf(const inspect::PinnedTarget& target) const {
    const inspect::CellTarget* now = knownOf(target.cell);
    QString tag = QString::number(target.number);
    if (!target.name.empty()) tag += " " + shownName(exactText(target.name), 20);
    if (now != nullptr && now->probe.state == CellState::Valid) tag += " · " + distanceText(*now); // the digits of the card
    const rocks::Rock* rock = &target == active() ? around(target.cell).rock : nullptr; // a small window has no room for the card
    return rock == nullptr ? tag : tag + " · " + tr("rock %1").arg(rock->label);
}

std::vector<inspect::PinnedTarget> Targets::withRocks() const {
    std::vector<inspect::PinnedTarget> all = notebook_.targets;
    for (inspect::PinnedTarget& each : all) each.rock = rocks_.picture() ? rocks_.picture()->labelAt(each.cell) : 0;
    return all;
}

QString Targets::nameAt(std::uint32_t cell) const {
    const auto found = std::ranges::find(notebook_.targets, cell, &inspect::PinnedTarget::cell);
    return found == notebook_.targets.end() ? QString() : nameOf(*found).simplified();
}

/// "end 1 is target 3"; a click near a target took its cell. Not for ends that the method finds.
QString Targets::atTargetsText(const inspect::StoredMeasure& measure) const {
    if (measure.kind == inspect::MeasureKind::Throat) return {};
    QStringList ends;
    for (std::size_t n = 0; n < measure.cells.size(); ++n) {
        const QString target = nameAt(measure.cells[n]);
        if (!target.isEmpty()) ends << tr("end %1 is target %2").arg(QString::number(n + 1), target);
    }
    return ends.join(" · ");
}

QString Targets::nameOf(const inspect::PinnedTarget& target) {
    return QString::number(target.number) + (target.name.empty() ? QString() : "  " + shownName(exactText(target.name)));
}

/// Number and name, distance, rock: what is known of it.
QStringList Targets::wordsOf(const inspect::PinnedTarget& target) const {
    QStringList words{nameOf(target)};
    if (const inspect::CellTarget* now = knownOf(target.cell)) words << distanceText(*now);
    if (const rocks::Rock* rock = around(target.cell).rock) words << tr("rock %1").arg(rock->label);
    return words;
}

QString Targets::inWords(const inspect::PinnedTarget& target) const {
    const inspect::CellTarget* now = knownOf(target.cell);
    const QString place = placePending() ? QStringLiteral("…") : now != nullptr ? positionText(*now).simplified() : QString();
    return (wordsOf(target) + (place.isEmpty() ? QStringList() : QStringList(place))).join(" · ");
}

QString Targets::clickOf(const inspect::PinnedTarget& target) const {
    if (!engine_.picture()) return {};
    const edges::Detection& detection = *engine_.picture()->detection;
    const std::uint32_t clicked = target.clicked.value_or(target.cell);
    if (clicked >= detection.scan->cells()) return {};
    for (const inspect::ClickedCell& click :
         {inspect::nearSideEdge(*detection.scan, *detection.mask, clicked), inspect::nearSideCell(*detection.scan, clicked)}) {
        if (click.cell == target.cell) return clickText(click, detection);
    }
    if (!target.clicked) return {};                                         // the operator chose this very cell
    const auto beams = static_cast<std::uint32_t>(detection.scan->beams()); // by other settings
    return tr("moved here from line %1, beam %2").arg(clicked / beams).arg(clicked % beams);
}

/// Of a length along the surface: the cells under its line, of many only some.
std::vector<std::size_t> Targets::wayOf(const inspect::StoredMeasure& measure) const {
    constexpr std::size_t kMost = 64;
    if (measure.kind != inspect::MeasureKind::Path || !engine_.picture() || measure.cells.size() != 2) return {};
    const Scan& scan = *engine_.picture()->detection->scan;
    if (std::ranges::any_of(measure.cells, [&](std::uint32_t k) { return k >= scan.cells(); })) return {};
    std::vector<std::uint32_t> under = rocks::strokeCells({measure.cells[0], measure.cells[1]}, scan.lines(), scan.beams());
    std::erase_if(under, [&](std::uint32_t k) { return scan.state[k] != CellState::Valid; });
    std::vector<std::size_t> way;
    const std::size_t step = std::max<std::size_t>(1, under.size() / kMost);
    for (std::size_t n = 0; n + 1 < under.size(); n += step) way.push_back(under[n]);
    if (!under.empty()) way.push_back(under.back());
    return way;
}

CellMarks Targets::marks() const {
    CellMarks marks;
    const inspect::PinnedTarget* shown = active();
    const bool measuring = draft_.active; // labels are short then: they would cover what is clicked
    for (const inspect::PinnedTarget& target : notebook_.targets) {
        const QString number = QString::number(target.number);
        marks.targets.push_back({target.cell, measuring ? number : tagOf(target), number, &target == shown, target.clicked});
    }
    for (std::size_t n = 0; n < notebook_.measures.size(); ++n) {
        const inspect::StoredMeasure& measure = notebook_.measures[n];
        const inspect::MeasuredCells* now = knownOf(measure);
        const bool warned = now != nullptr && (now->isWarned() || mountingAssumed(*known_.picture->detection->scan) ||
                                               inspect::isDoubtful(*known_.picture->detection->scan, measure));
        const bool assumesUp = now != nullptr && now->upAssumed && measure.kind == inspect::MeasureKind::Vertical;
        const bool ofSection = measure.kind == inspect::MeasureKind::Section; // its points are shown at the nearest cells
        marks.measures.push_back(
            {ofSection ? std::vector<std::size_t>{measure.cells[0], measure.cells[2]}
                       : std::vector<std::size_t>(measure.cells.begin(), measure.cells.end()),
             inspect::linksOf(ofSection ? inspect::MeasureKind::Distance : measure.kind),
             measuring && n != chosen_
                 ? briefOf(measure)
                 : (warned ? "▲ " : "") + briefOf(measure) + " " + (now != nullptr ? coreWords(inspect::measureText(*now)) : QString("–")) +
                       (assumesUp ? " · " + tr("up is assumed") : QString()),
             measure.isByOneClick() ? std::vector<std::size_t>() : std::vector<std::size_t>(measure.clicked.begin(), measure.clicked.end()),
             n == chosen_, briefOf(measure), wayOf(measure)});
    }
    if (!draft_.cells.empty()) marks.measures.push_back(draft_);
    marks.targets.insert(marks.targets.end(), beside_.begin(), beside_.end());
    return marks;
}

MeasureWords Targets::wordsOf(const inspect::StoredMeasure& measure) const {
    const bool known = !placePending() && known_.of(measure) != nullptr;
    MeasureWords words{tr(inspect::traitsOf(measure.kind).label), known ? tr("a cell of it has no range") : "…", {}, {}, {}};
    const inspect::MeasuredCells* now = knownOf(measure);
    QStringList all;
    if (now != nullptr) {
        words.value = coreWords(inspect::measureText(*now));
        for (const std::string& remark : inspect::measureRemarks(*now, inLanguage)) all << shownText(remark);
    }
    all << atTargetsText(measure);
    if (now != nullptr) {
        const edges::Detection& detection = *known_.picture->detection;
        words.offEdge = shownText(inspect::offEdgeText(*detection.mask, measure, inLanguage));
        for (const std::string& remark : inspect::clickRemarks(*detection.scan, *detection.mask, measure, inLanguage))
            all << shownText(remark);
        all << assumedText(*detection.scan);
    }
    for (const QString& remark : all) {
        if (!remark.isEmpty()) (remark.startsWith("▲") ? words.warnings : words.remarks) << remark;
    }
    return words;
}

std::vector<QString> Targets::measuresInWords() const {
    std::vector<QString> all;
    for (const inspect::StoredMeasure& measure : notebook_.measures) {
        const MeasureWords words = wordsOf(measure);
        all.push_back(briefOf(measure) + "  " + words.kind + "  " + words.value);
    }
    return all;
}

void Targets::show() {
    views_.setMarks(marks());
    const inspect::PinnedTarget* shown = active();
    std::vector<TargetLine> lines;
    RockNames all;
    for (const inspect::PinnedTarget& target : notebook_.targets) {
        all.emplace_back(target.cell, nameOf(target).simplified());
        const inspect::CellTarget* now = knownOf(target.cell);
        QStringList known = wordsOf(target);
        if (now != nullptr) known << edgeText(*now);
        QString words = known.join("   ");
        const QString note = target.note.empty() ? QString() : "   " + shownName(exactText(target.note), 80);
        words += note;
        const QString first = words; // shortened in the list
        const QString locked = target.locked ? "   " + tr("locked") : QString();
        const QString place = placePending() ? QStringLiteral("…") : now != nullptr ? briefPositionText(*now) : QString();
        words += "\n" + (place.isEmpty() ? QString(" ") : place); // two rows before it is known: the card below the list stays where it is
        QStringList shortened;                                    // the class of its edge and the second row last
        if (!note.isEmpty()) shortened << note;
        if (const rocks::Rock* rock = around(target.cell).rock) shortened << "   " + tr("rock %1").arg(rock->label);
        if (!target.name.empty()) shortened << "  " + shownName(exactText(target.name));
        lines.push_back(
            {words, first + locked + "\n" + tr("Pinned %1").arg(shownText(target.pinnedUtc)), &target == shown, shortened, target.locked});
    }
    rocks_.setTargets(all, notebook_.targets);
    panel_.showTargets(lines);
    lines.clear();
    for (const inspect::StoredMeasure& measure : notebook_.measures) {
        const MeasureWords words = wordsOf(measure);
        QString line = (words.warnings.empty() ? "" : "▲ ") + briefOf(measure) + "  " + words.value + "\n"; // this row is never shortened
        line += words.kind;
        if (words.warnings.empty() && !words.offEdge.isEmpty()) line += " · " + words.offEdge;
        if (words.warnings.size() == 1) line += " · " + words.warnings.front();
        if (words.warnings.size() > 1) line += " · ▲ " + tr("%1 warnings").arg(words.warnings.size());
        lines.push_back({line, (words.warnings + words.remarks).join('\n'), lines.size() == chosen_});
    }
    panel_.showMeasures(lines);
    showCard();
}

void Targets::showCard() {
    if (const inspect::PinnedTarget* shown = active()) {
        TargetSurroundings near = around(shown->cell);
        near.clicked = clickOf(*shown);
        panel_.card().show(*shown, knownOf(shown->cell), near);
    } else {
        panel_.card().hide();
    }
    emit cardChanged();
}

void Targets::showDraft(const MeasureMark& draft) {
    draft_ = draft;
    views_.setMarks(marks());
}

void Targets::showExtraMarks(std::vector<TargetMark> marks) {
    if (beside_ == marks) return;
    beside_ = std::move(marks);
    views_.setMarks(this->marks());
}

void Targets::setSource(const QString& source) {
    if (std::exchange(source_, source) != source) showCard();
}

void Targets::copyCard() {
    if (active() == nullptr) return;
    QGuiApplication::clipboard()->setText(panel_.card().text());
    notice_.showNotice(NoticeBar::Kind::Done, tr("Target %1 is on the clipboard, as text.").arg(active()->number));
}

void Targets::copyAll() {
    QStringList rows{tableHeading()};
    for (const inspect::PinnedTarget& target : notebook_.targets) rows << tableRow(target, placePending() ? nullptr : knownOf(target.cell));
    QGuiApplication::clipboard()->setText(rows.join('\n') + "\n");
    notice_.showNotice(NoticeBar::Kind::Done,
                       tr("On the clipboard, as a table for a spreadsheet: %1.").arg(targetCount(notebook_.targets.size())));
}

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
