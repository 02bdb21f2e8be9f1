// Sets targets, and shows them.
#include "ui/controllers/targets/targets.h"

#include "core/base/utc_time.h"
#include "core/scan/grid/scan_time.h"
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
Targets::Targets(Engine& engine, LinkedViews& views, Rocks& rocks, TargetsPanel& panel, NoticeBar& notice, Preferences& preferences,
                 QUndoStack& undo)
    : engine_(engine), views_(views), rocks_(rocks), panel_(panel), notice_(notice), undo_(undo),
      store_(preferences.dataFolder().isEmpty() ? QString() : preferences.dataFolder() + "/targets"),
      worked_(
          Urgency::Now, [this](const Question& question) { return workOut(question); },
          [this](const Question&, const std::shared_ptr<const KnownTargets>& known) { storeKnown(*known); },
          [this](const QString& what) {
              notice_.showNotice(NoticeBar::Kind::Warning, tr("The targets could not be computed (%1).").arg(what));
          },
          Older::Delivered) { // while a sweep grows
    connect(&views_, &LinkedViews::pinChanged, this, &Targets::followPin);
    connect(&views_, &LinkedViews::cellMenuOpens, this, &Targets::addToMenu);
    connect(&views_, &LinkedViews::measureClicked, this, [this](std::size_t place) { chooseMeasure(place); });
    connect(&engine_, &Engine::placePendingChanged, this, &Targets::show);
    connect(&rocks_, &Rocks::rocksShown, this, &Targets::show);
    connect(&rocks_, &Rocks::shownChanged, this, &Targets::show);
    connect(&rocks_, &Rocks::selectionChanged, this, [this] {
        if (!rocks_.selected().empty()) chooseMeasure(std::nullopt);
    });
    connect(&rocks_, &Rocks::nameRequested, this, &Targets::editName);
    connect(&store_, &TargetStore::merged, this, &Targets::adopt);
    connect(&store_, &TargetStore::failed, this, [this](const QString& why) { notice_.showNotice(NoticeBar::Kind::Error, why); });
    connectPanel();
}

void Targets::connectPanel() {
    connect(&panel_, &TargetsPanel::targetChosen, this, [this](int place) {
        if (place >= static_cast<int>(notebook_.targets.size())) return;
        views_.pin(notebook_.targets[static_cast<std::size_t>(place)].cell);
        rocks_.selectPinned(); // if it was chosen already
    });
    connect(&panel_, &TargetsPanel::nameRequested, this, [this](int place) {
        if (place >= static_cast<int>(notebook_.targets.size())) return;
        views_.pin(notebook_.targets[static_cast<std::size_t>(place)].cell);
        editName();
    });
    connect(&panel_, &TargetsPanel::targetMenuRequested, this, [this](int place, const QPoint& position) {
        if (place < static_cast<int>(notebook_.targets.size()))
            views_.openMenu(position, inspect::exactly(notebook_.targets[static_cast<std::size_t>(place)].cell));
    });
    connect(&panel_, &TargetsPanel::copyAllRequested, this, &Targets::copyAll);
    connect(&panel_, &TargetsPanel::removeAllRequested, this, &Targets::removeAll);
    connect(&panel_, &TargetsPanel::measureChosen, this, [this](int place) { chooseMeasure(static_cast<std::size_t>(place)); });
    connect(&panel_, &TargetsPanel::measureRemoved, this, [this](int place) { removeMeasure(static_cast<std::size_t>(place)); });
    TargetCard& card = panel_.card();
    const auto ofActive = [this](auto act) {
        return [this, act](const auto&... given) {
            if (const inspect::PinnedTarget* target = active()) act(*target, given...);
        };
    };
    connect(&card, &TargetCard::closeRequested, this, ofActive([this](const inspect::PinnedTarget& target) { remove(target.number); }));
    connect(&card, &TargetCard::lockRequested, this,
            ofActive([this](const inspect::PinnedTarget& target, bool on) { lock(target.number, on); }));
    connect(&card, &TargetCard::renamed, this,
            ofActive([this](const inspect::PinnedTarget& target, const QString& name) { rename(target.number, name); }));
    connect(&card, &TargetCard::noted, this,
            ofActive([this](const inspect::PinnedTarget& target, const QString& note) { setNote(target.number, note); }));
    connect(card.why(), &QPushButton::clicked, this,
            ofActive([this](const inspect::PinnedTarget& target, bool) { emit explanationRequested(target.cell); }));
    connect(card.measure(), &QPushButton::clicked, this,
            ofActive([this](const inspect::PinnedTarget& target, bool) { emit measureRequested(target.cell); }));
    connect(card.copy(), &QPushButton::clicked, this, &Targets::copyCard);
}

const inspect::PinnedTarget* Targets::active() const {
    const auto cell = views_.pinned();
    if (!cell) return nullptr;
    const auto target = std::ranges::find(notebook_.targets, *cell, &inspect::PinnedTarget::cell);
    return target == notebook_.targets.end() ? nullptr : &*target;
}

inspect::PinnedTarget* Targets::numbered(inspect::Notebook& notebook, int number) {
    const auto target = std::ranges::find(notebook.targets, number, &inspect::PinnedTarget::number);
    return target == notebook.targets.end() ? nullptr : &*target;
}

// For a file: the file and its sweep, for all reading options. For a scanner: the sweep.
QString Targets::keyOf(const Picture& picture) const {
    const std::string name = inspect::notebookFileName(inspect::notebookScan(*picture.detection->scan));
    if (!name.empty()) return exactText(name);
    return QString("%1 %2").arg(picture.source.stream).arg(picture.source.growth.sweep);
}

/// What another scan had: an empty list without a word looks like a loss.
QString Targets::leftBehind(std::size_t entries) {
    if (entries == 0) return {};
    return tr("Targets and measurements of the previous scan: %1. They are stored with it, as its edits of rocks are: open it again to see "
              "them.")
        .arg(entries);
}

void Targets::followPicture() {
    const QString key = keyOf(*engine_.picture());
    if (key != key_) {
        const std::size_t before = stored_ ? notebook_.targets.size() + notebook_.measures.size() : 0;
        if (!key_.isEmpty() && !stored_ && !notebook_.empty())
            sweeps_[key_] = {inspect::scanHead(*scan_), scan_->beams(), startOfScan(*scan_).value_or(0.0), stream_};
        if (!key_.isEmpty()) others_[key_] = std::move(notebook_);
        key_ = key;
        looksForSweep_ = true;
        notebook_ = {};
        chosen_.reset();
        const inspect::NotebookScan scan = inspect::notebookScan(*engine_.picture()->detection->scan);
        const QString path = store_.pathOf(scan);
        stored_ = !path.isEmpty();
        panel_.showNote(stored_ ? leftBehind(before)
                        : store_.isOff()
                            ? tr("Not stored: EdgeScan was started without its settings.")
                            : tr("Not stored yet. Targets of a live sweep are stored when you open its recording, those of a part of "
                                 "a recording when its whole sweep is shown."));
        if (before > 0) notice_.showHint(leftBehind(before));
        if (const auto other = others_.find(key); other != others_.end()) {
            notebook_ = other->second;
        } else if (auto kept = store_.load(scan)) {
            notebook_ = std::move(*kept);
        } else {
            panel_.showNote(tr("▲ Not stored: the targets of this scan were refused."));
            notice_.showError(kept.error());
        }
        if (stored_ && store_.openElsewhere(scan)) {
            const auto warn = [this] {
                notice_.showNotice(NoticeBar::Kind::Warning,
                                   tr("Another window has this scan open, too. Targets and edits of rocks of both are stored together."));
            };
            QTimer::singleShot(0, this, warn); // over the warnings of the file, which come with the picture
        }
        if (!notebook_.empty()) {
            if (stored_) panel_.showNote({}); // its own list, which is not taken for a loss
            emit pinned();
        }
    }
    scan_ = engine_.picture()->detection->scan;
    stream_ = engine_.picture()->source.stream;
    findSweep();
    ask();
    show();
}

/// What was pinned on a live sweep is in its recording too, which has the same ranges.
void Targets::findSweep() {
    if (!looksForSweep_ || !notebook_.empty() || sweeps_.contains(key_)) return;
    bool later = false; // a replayed sweep has too few lines yet
    for (const auto& [key, sweep] : sweeps_) {
        if (scan_->beams() != sweep.beams || stream_ == sweep.stream) continue; // the next sweep of a scanner is another
        later = later || scan_->lines() < sweep.head.lines;
        if (std::abs(startOfScan(*scan_).value_or(0.0) - sweep.startS) > inspect::kSameStartS ||
            inspect::scanHead(*scan_, sweep.head.lines) != sweep.head)
            continue;
        notebook_ = others_[key];
        keep();
        later = false;
        emit pinned();
        break;
    }
    looksForSweep_ = later;
}

void Targets::followPin(std::optional<std::size_t> cell) {
    if (using_) return;
    if (cell) {
        chosen_.reset();
        pin(*cell);
    }
    show();
}

void Targets::pin(std::size_t cell) {
    if (!engine_.picture() ||
        std::ranges::any_of(notebook_.targets, [&](const inspect::PinnedTarget& target) { return target.cell == cell; }))
        return emit pinned();
    const auto& click = views_.pinningClick();
    const auto clicked = click && click->moved() ? std::optional(click->clicked) : std::nullopt;
    if (notebook_.targets.size() >= inspect::kMostTargets) {
        notice_.showHint(tr("This cell was not pinned: there are %1 targets, remove some first.").arg(inspect::kMostTargets));
        return;
    }
    inspect::Notebook after = notebook_;
    inspect::PinnedTarget target;
    target.number = inspect::nextNumber(after);
    target.cell = static_cast<std::uint32_t>(cell);
    target.clicked = clicked;
    target.pinnedUtc = utcText(utcNow());
    after.targets.push_back(target);
    change(stepName("new target %1", target.number), std::move(after));
    emit pinned();
}

void Targets::remove(int number) {
    const inspect::PinnedTarget* target = numbered(notebook_, number);
    if (target == nullptr) return;
    if (target->locked) return notice_.showHint(tr("Target %1 is locked and stays: unlock it to remove it.").arg(number));
    const QString words = inWords(*target);
    inspect::Notebook after = notebook_;
    std::erase_if(after.targets, [&](const inspect::PinnedTarget& each) { return each.number == number; });
    change(stepName("removal of target %1", number), std::move(after));
    notice_.showRemoved(undo_, tr("Target %1").arg(words));
}

void Targets::removeAll() {
    inspect::Notebook after = notebook_;
    QStringList names;
    for (const inspect::PinnedTarget& target : notebook_.targets) {
        if (!target.locked) names << nameOf(target);
    }
    if (names.isEmpty()) return;
    std::erase_if(after.targets, [](const inspect::PinnedTarget& target) { return !target.locked; });
    const std::size_t locked = after.targets.size();
    change(stepName("removal of all targets"), std::move(after));
    notice_.showRemoved(undo_, tr("Targets %1").arg(names.join(", ")),
                        locked == 0   ? QString()
                        : locked == 1 ? tr("1 locked target stays.")
                                      : tr("%1 locked targets stay.").arg(locked));
}

void Targets::lock(int number, bool on) {
    inspect::Notebook after = notebook_;
    inspect::PinnedTarget* target = numbered(after, number);
    if (target == nullptr) return;
    target->locked = on;
    if (after != notebook_)
        change(on ? stepName("lock of target %1", number) : stepName("unlocking of target %1", number), std::move(after));
}

void Targets::keepMeasure(const inspect::StoredMeasure& measure) {
    if (notebook_.measures.size() >= inspect::kMostMeasures) {
        notice_.showHint(tr("This was not stored: there are %1 measurements, remove some first.").arg(inspect::kMostMeasures));
        return;
    }
    inspect::Notebook after = notebook_;
    after.measures.push_back(measure);
    after.measures.back().number = inspect::nextMeasureNumber(notebook_);
    change(stepName("new measurement"), std::move(after));
    emit pinned();
    chooseMeasure(notebook_.measures.size() - 1);
}

void Targets::chooseMeasure(std::optional<std::size_t> place) {
    if (place && *place >= notebook_.measures.size()) return;
    if (place) {
        views_.pin(std::nullopt);
        if (!rocks_.selected().empty()) rocks_.select({});
    }
    if (std::exchange(chosen_, place) != place) show();
}

void Targets::removeMeasure(std::size_t place) {
    if (place >= notebook_.measures.size()) return;
    const QString words = measuresInWords()[place];
    inspect::Notebook after = notebook_;
    const int number = after.measures[place].number;
    after.measures.erase(after.measures.begin() + static_cast<std::ptrdiff_t>(place));
    change(stepName("removal of measurement M%1", number), std::move(after));
    notice_.showRemoved(undo_, words.simplified());
}

inspect::TargetsPart Targets::part() const {
    const inspect::PinnedTarget* target = active();
    return {notebook_, target == nullptr ? std::nullopt : std::optional(target->cell)};
}

void Targets::setPart(const inspect::TargetsPart& part) {
    if (part.notebook != notebook_) {
        change(stepName("Open Session"), part.notebook);
        emit pinned();
    }
    views_.pin(part.active);
}

void Targets::change(const QString& what, const inspect::Notebook& after) {
    undo_.push(new UndoStep<inspect::Notebook>(
        what, notebook_, after,
        [this, before = notebook_, after](const inspect::Notebook& value) {
            use(inspect::withOthers(value, value == after ? before : after, notebook_));
            return true;
        },
        [this, key = key_] { return key_ == key; }));
}

void Targets::use(const inspect::Notebook& notebook) {
    if (chosen_) { // another one may have gone: it has another place then
        const auto& measures = notebook.measures;
        const inspect::StoredMeasure chosen = notebook_.measures[*chosen_];
        const auto found = std::ranges::find(measures, chosen);
        if (*chosen_ >= measures.size() || measures[*chosen_] != chosen)
            chosen_ = found == measures.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - measures.begin()));
    }
    const inspect::Notebook before = std::exchange(notebook_, notebook);
    keep();
    ask();
    using_ = true;
    if (views_.pinned() && active() == nullptr) views_.pin(std::nullopt);
    using_ = false;
    chooseWhatCame(before);
    show();
}

/// The target or measurement that a step brought, or brought back.
void Targets::chooseWhatCame(const inspect::Notebook& before) {
    const auto came = [](const auto& all, const auto& earlier) {
        std::vector<std::size_t> places;
        for (std::size_t n = 0; n < all.size(); ++n) {
            if (std::ranges::find(earlier, all[n].number, [](const auto& each) { return each.number; }) == earlier.end())
                places.push_back(n);
        }
        return places;
    };
    const auto targets = came(notebook_.targets, before.targets), measures = came(notebook_.measures, before.measures);
    if (targets.size() + measures.size() != 1) return;
    if (!targets.empty())
        views_.pin(notebook_.targets[targets.front()].cell);
    else
        chooseMeasure(measures.front());
}

void Targets::keep() {
    if (engine_.picture()) store_.save(notebook_, inspect::notebookScan(*engine_.picture()->detection->scan));
}

void Targets::adopt(const QString& path, const inspect::Notebook& mine, const inspect::Notebook& theirs) {
    if (path != notebookFile()) {
        const auto other = others_.find(QFileInfo(path).fileName());
        if (other != others_.end()) other->second = inspect::mergedNotebook(mine, other->second, theirs);
        return;
    }
    use(inspect::mergedNotebook(mine, notebook_, theirs));
    notice_.showHint(
        tr("Another window changed the targets or measurements of this scan. Both are kept; of two with one number, yours has the "
           "next free one."));
    emit pinned();
}

QString Targets::notebookFile() const {
    return engine_.picture() ? store_.pathOf(inspect::notebookScan(*engine_.picture()->detection->scan)) : QString();
}

void Targets::ask() {
    if (engine_.picture()) worked_.ask({engine_.picture(), notebook_});
}

bool Targets::placePending() const {
    if (engine_.placePending()) return true;
    // Each picture of a live sweep has a placement of its own, which agrees with the one before.
    if (!known_.picture || engine_.picture()->source.growth.growing) return false;
    return known_.picture->detection->scan->placement != scan_->placement;
}

bool Targets::settled() const {
    if (known_.picture != engine_.picture()) return notebook_.empty() && engine_.picture() == nullptr;
    return std::ranges::all_of(notebook_.targets, [&](const inspect::PinnedTarget& target) { return knownOf(target.cell) != nullptr; }) &&
           known_.measures.size() == notebook_.measures.size();
}

KnownTargets Targets::workOut(const Question& question) {
    const edges::Detection& detection = *question.picture->detection;
    KnownTargets known{question.picture, {}, {}};
    if (question.notebook.empty()) return known;
    if (noiseScan_.lock() != detection.scan) {
        noise_ = inspect::noiseOf(detection);
        noiseScan_ = detection.scan;
        measured_.clear();
    }
    for (const inspect::PinnedTarget& target : question.notebook.targets) {
        if (target.cell < detection.scan->cells()) known.targets.emplace(target.cell, inspect::targetAt(detection, noise_, target.cell));
    }
    for (const inspect::StoredMeasure& measure : question.notebook.measures) {
        const auto before = std::ranges::find(measured_, measure, [](const auto& each) { return each.first; });
        known.measures.emplace_back(measure,
                                    before != measured_.end() ? before->second : inspect::measureStored(*detection.scan, noise_, measure));
    }
    measured_ = known.measures;
    return known;
}

void Targets::storeKnown(const KnownTargets& known) {
    if (!engine_.picture() || known.picture->detection->scan->beams() != engine_.picture()->detection->scan->beams()) return;
    known_ = known;
    // The first content of the card is stored with the target.
    bool more = false;
    for (inspect::PinnedTarget& target : notebook_.targets) {
        const inspect::CellTarget* now = knownOf(target.cell);
        if (!target.asPinned.empty() || now == nullptr || known_.picture != engine_.picture() || placePending()) continue;
        target.asPinned = rowsToStore(*now, around(target.cell));
        pinnedOn_[{target.number, target.cell}] = known_.picture;
        more = true;
    }
    if (more) keep();
    show();
}

void Targets::setConfidence(const KnownConfidence& confidence) {
    if (confidence_ == confidence) return;
    confidence_ = confidence;
    keepConfidence();
    showCard();
}

/// Confidence is known later than the rest of a card: it is added to the stored card if it belongs to the same picture.
void Targets::keepConfidence() {
    bool more = false;
    for (inspect::PinnedTarget& target : notebook_.targets) {
        const auto on = pinnedOn_.find({target.number, target.cell});
        const inspect::CellTarget* now = knownOf(target.cell);
        if (!confidence_.made || on == pinnedOn_.end() || on->second.lock() != confidence_.of || now == nullptr) continue;
        if (known_.picture != confidence_.of) continue;
        const auto isIt = [](const auto& row) { return row.first == kConfidenceRow; };
        const auto rows = rowsToStore(*now, around(target.cell));
        const auto row = std::ranges::find_if(rows, isIt);
        if (row == rows.end() || std::ranges::any_of(target.asPinned, isIt)) continue;
        target.asPinned.push_back(*row);
        more = true;
    }
    if (more) keep();
}

} // namespace edgescan::ui

#include "moc_targets.cpp"
