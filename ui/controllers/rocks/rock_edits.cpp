// The operator's edits of rocks: merge, split, rock or not a rock, undo.
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/rocks/change_words.h"
#include "ui/panels/rocks/rocks_panel.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr qint64 kOneTurnMs = 1000;

QString nameOfTurn(const rocks::RockSettings& before, const rocks::RockSettings& after) {
    for (const rocks::RockParameter& row : rocks::rockParameters()) {
        if (row.get(before) != row.get(after)) return QString(row.label) + '\n' + QObject::tr(row.label);
    }
    return stepName("region of interest");
}

} // namespace

void Rocks::change(const rocks::RockSettings& settings) {
    if (settings == settings_) return;
    const QString name = nameOfTurn(settings_, settings);
    if (turned_ != name || !sinceTurn_.isValid() || sinceTurn_.elapsed() > kOneTurnMs) turn_ = nextDrag();
    turned_ = name;
    sinceTurn_.start();
    undo_.push(new UndoStep<rocks::RockSettings>(
        turn_, [name](const rocks::RockSettings&, const rocks::RockSettings&) { return name; }, settings_, settings,
        [this](rocks::RockSettings value) {
            value.region = settings_.region; // it belongs to one scan and has its own undo steps
            useSettings(value);
            return true;
        }));
}

void Rocks::reset(const QString& parameter) {
    rocks::RockSettings settings = settings_;
    for (const rocks::RockParameter& row : rocks::rockParameters()) {
        if (on_ && (parameter.isEmpty() || parameter == row.key)) row.set(settings, row.get(rocks::RockSettings{}));
    }
    change(settings);
}

std::optional<rocks::Preset> Rocks::part() const {
    if (!on_ || !engine_.picture()) return std::nullopt;
    return rocks::Preset{settings_, edits_, engine_.picture()->detection->scan->sha256};
}

void Rocks::setPart(const std::optional<rocks::Preset>& part) {
    if (!part) return;
    if (sidecar_.reading()) {
        restored_ = part;
        return;
    }
    const rocks::RockSettings settings = part->settings.value_or(settings_);
    const OperatorEdits byHandThen{part->edits, settings.region};
    change(settings);
    if (byHandThen == operatorEdits()) return;
    const bool replaces = operatorEdits() != OperatorEdits{};
    pushOperatorEdits(stepName("Open Session"), byHandThen);
    if (replaces)
        notice_.showNotice(NoticeBar::Kind::Warning,
                           tr("The session's edits of rocks replaced those that were stored next to the scan; Ctrl+Z brings them back."));
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

void Rocks::pushOperatorEdits(const QString& name, OperatorEdits after, const std::vector<std::size_t>& merged) {
    const auto use = [this, merged, before = operatorEdits(), after](const OperatorEdits& value) {
        const bool isUndo = value != after;
        // What another window changed meanwhile stays.
        setOperatorEdits({rocks::mergedEdits((isUndo ? after : before).edits, value.edits, edits_), value.region});
        if (on_ && !merged.empty()) select(isUndo ? merged : std::vector{merged.back()});
        return true;
    };
    auto* step = new UndoStep<OperatorEdits>(name, operatorEdits(), std::move(after), use,
                                             engine_.hereNow()); // a closed scan takes its edits with it
    newestEdit_ = step;
    undo_.push(step);
}

void Rocks::push(const QString& name, std::vector<rocks::Edit> added, const std::vector<std::size_t>& merged) {
    const rocks::EditKind kind = added.front().kind;
    std::vector<rocks::Edit> edits = edits_;
    std::ranges::move(added, std::back_inserter(edits));
    pushEdits(name, std::move(edits), kind, merged);
}

/// What the step changed is judged when its rocks are known; before, this only is known of those on the screen that have all edits so far.
void Rocks::pushEdits(const QString& name, std::vector<rocks::Edit> edits, rocks::EditKind kind, const std::vector<std::size_t>& merged) {
    const bool known = picture_ && !ofAnotherPicture() && picture_->study.edits == edits_ && picture_->study.settings == settings_;
    judgedFrom_ = known ? picture_ : nullptr;
    judgedKind_ = kind;
    pushOperatorEdits(name, {std::move(edits), settings_.region}, merged);
}

/// Undo takes back the newest edit.
/// A step that changed no rock is taken back. Else it is said which rocks have another number now, and which part is not a rock.
void Rocks::judgeEdit() {
    if (!judgedFrom_ || picture_->study.edits != edits_ || picture_->study.edits == judgedFrom_->study.edits) return;
    const auto before = std::exchange(judgedFrom_, nullptr);
    if (before->detection != picture_->detection || before->study.settings != picture_->study.settings) return;
    const rocks::RegionChanges changes =
        rocks::regionChanges(*before->study.segmentation, before->study.map, *picture_->study.segmentation, picture_->study.map);
    if (!changes.any) {
        if (!isNewest(undo_, newestEdit_)) return;
        newestEdit_->undo();            // the stack calls undo() of no obsolete step,
        newestEdit_->setObsolete(true); // which it only removes
        undo_.undo();
        return notice_.showHint(
            tr("No rock changed, so nothing is to be undone. Click on another part of the rock, or draw across the whole of it, past its "
               "outline."));
    }
    const bool merges = judgedKind_ == rocks::EditKind::Join;
    const QString apart = merges ? apartWords(edits_.back().cells, *before, *picture_) : QString(); // names the merged rock too
    const QString result = apart.isEmpty() ? editWords(judgedKind_, *before, *picture_) : apart;
    const QString words = QStringList{result, changeWords(changes, *picture_)}.join(' ').trimmed();
    if (words.isEmpty()) return;
    if (apart.isEmpty() && !changes.lost.empty())
        notice_.showHint(words); // until the next step, which may be its undo
    else
        notice_.showNotice(apart.isEmpty() ? NoticeBar::Kind::Done : NoticeBar::Kind::Warning, words);
    if (isNewest(undo_, newestEdit_)) notice_.offerUndo(undo_);
}

void Rocks::mergeOffered() {
    const rocks::Rock* rock = picture_ && selected_.size() == 1 ? picture_->rockAt(selected_.front()) : nullptr;
    if (rock == nullptr || rock->maybeOneWith.empty()) return mergeSelected();
    std::vector<std::uint32_t> cells{rock->cell};
    for (const std::uint32_t other : rock->maybeOneWith) cells.push_back(picture_->rock(other)->cell);
    merge(cells);
}

void Rocks::mergeSelected() {
    if (!picture_) return;
    std::vector<std::uint32_t> cells;
    for (const std::size_t cell : selected_) {
        if (picture_->regionAt(cell) != nullptr) cells.push_back(static_cast<std::uint32_t>(cell));
    }
    if (cells.size() < 2) return useTool(RockTool::Join);
    merge(cells);
}

void Rocks::merge(const std::vector<std::uint32_t>& cells) {
    auto join = rocks::joinOf(*picture_->study.segmentation, picture_->study.map, cells);
    if (!join) return notice_.showHint(tr("Nothing was merged: this is one rock already."));
    push(stepName("merge of rocks"), {std::move(*join)}, selected_);
}

void Rocks::callChosen(bool rock) {
    if (!picture_ || !chosen() || picture_->regionAt(*chosen()) == nullptr) return;
    push(rock ? stepName("mark as a rock") : stepName("mark as not a rock"),
         {{rock ? rocks::EditKind::Rock : rocks::EditKind::NotRock, {static_cast<std::uint32_t>(*chosen())}}});
}

void Rocks::toggleChosen() {
    if (!picture_ || !chosen()) return notice_.showHint(tr("Select a rock first: show the rocks and click on the face of one."));
    callChosen(picture_->labelAt(*chosen()) == 0);
}

} // namespace edgescan::ui
