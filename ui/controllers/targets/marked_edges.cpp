// Marks, proposals, previews.
#include "ui/controllers/targets/marked_edges.h"

#include "core/edges/settings/method_traits.h"
#include "ui/base/cell_marks.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/proposals_card.h"

#include <QMenu>

#include <algorithm>

namespace edgescan::ui {
MarkedEdges::MarkedEdges(Engine& engine, LinkedViews& views, Targets& targets, QUndoStack& undo, NoticeBar& notice)
    : engine_(engine), views_(views), targets_(targets), undo_(undo), notice_(notice),
      found_(
          Urgency::Later, [this](const Question& question, const Asker& asker) { return run(question, asker); },
          [this](const Question& question, const std::shared_ptr<const std::vector<edges::EdgeProposal>>& proposals) {
              showProposals(question, *proposals);
          },
          [this](const QString& what) {
              card_->hide();
              notice_.showNotice(NoticeBar::Kind::Warning, tr("Nothing could be proposed (%1).").arg(what));
          }) {
    connect(&views_, &LinkedViews::cellMenuOpens, this, [this](QMenu& menu, const inspect::ClickedCell& click) {
        const std::size_t cell = click.clicked; // what an edge is was asked of the very cell
        menu.addAction(tr("This &is an edge"), this, [this, cell] { mark(cell, true); });
        menu.addAction(tr("This is &not an edge"), this, [this, cell] { mark(cell, false); });
    });
}

void MarkedEdges::followPicture() {
    if (std::exchange(stream_, engine_.picture()->source.stream) != engine_.picture()->source.stream) use({});
}

void MarkedEdges::mark(std::optional<std::size_t> cell, bool isEdge) {
    if (!cell) {
        notice_.showHint(tr("Point at a cell or click one first; then say whether an edge is there."));
        return;
    }
    const auto k = static_cast<std::uint32_t>(*cell);
    edges::EdgeMarks after = marks_;
    std::vector<std::uint32_t>& these = isEdge ? after.wanted : after.unwanted;
    std::vector<std::uint32_t>& others = isEdge ? after.unwanted : after.wanted;
    std::erase(others, k);
    const bool removes = std::erase(these, k) > 0;
    if (!removes) these.push_back(k);
    if (after.wanted.size() > edges::kMostMarks || after.unwanted.size() > edges::kMostMarks) {
        notice_.showHint(tr("This cell was not marked: there are %1 marks, clear some first.").arg(edges::kMostMarks));
        return;
    }
    change(isEdge ? stepName("Mark as an Edge") : stepName("Mark as Not an Edge"), after);
    const QPoint at = views_.placeOf(k);
    if (removes)
        notice_.showRemoved(undo_, (isEdge ? tr("the mark “edge” at line %1, beam %2") : tr("the mark “not an edge” at line %1, beam %2"))
                                       .arg(at.y())
                                       .arg(at.x()));
}

void MarkedEdges::clear() {
    if (marks_.empty()) return;
    const edges::EdgeMarks gone = marks_;
    change(stepName("Clear the Marks"), {});
    notice_.showRemoved(undo_, tr("all marks, %1 “edge” and %2 “not an edge”").arg(gone.wanted.size()).arg(gone.unwanted.size()));
}

void MarkedEdges::setPart(const edges::EdgeMarks& marks) { change(stepName("Open Session"), marks); }

void MarkedEdges::change(const QString& what, const edges::EdgeMarks& after) {
    if (after == marks_) return;
    undo_.push(new UndoStep<edges::EdgeMarks>(
        what, marks_, after, [this](const edges::EdgeMarks& value) { return use(value), true; },
        [this, stream = stream_] { return stream_ == stream; }));
}

void MarkedEdges::use(const edges::EdgeMarks& marks) {
    marks_ = marks;
    if (marks_.empty()) {
        found_.giveUp();
        putBack();
        proposals_.clear();
        if (card_ != nullptr) card_->hide();
    }
    show();
    emit changed();
}

void MarkedEdges::show() {
    std::vector<TargetMark> tags;
    for (const std::uint32_t k : marks_.wanted) tags.push_back({k, tr("✓ edge"), tr("✓"), false, {}, false});
    for (const std::uint32_t k : marks_.unwanted) tags.push_back({k, tr("✕ not an edge"), tr("✕"), false, {}, false});
    targets_.showExtraMarks(std::move(tags));
}

void MarkedEdges::propose() {
    if (marks_.empty() || engine_.picture() == nullptr) {
        notice_.showHint(tr("Nothing is marked yet: right-click a cell and mark it as an edge, or as not an edge."));
        return;
    }
    if (engine_.picture()->source.growth.growing) {
        notice_.showHint(tr("The sweep is still growing: wait for its end, or hold it."));
        return;
    }
    if (card_ == nullptr) makeCard();
    const edges::Settings before = before_.value_or(engine_.settings());
    putBack();
    card_->begin();
    showStage(0);
    found_.ask({engine_.picture()->detection->scan, before, marks_});
}

// One question per method: what it asks says how far the work is.
std::vector<edges::EdgeProposal> MarkedEdges::run(const Question& question, const Asker& asker) {
    int method = 0;
    return edges::edgeProposals(question.scan, question.settings, question.marks,
                                [&] { return asker.show([this, method = method++] { showStage(method); }); });
}

void MarkedEdges::showStage(int method) {
    if (!card_->working()) return;
    const auto methods = static_cast<int>(edges::methodTraits().size());
    card_->showStage(tr("Finding settings for these marks: method %1 of %2 …").arg(std::min(method + 1, methods)).arg(methods), method,
                     methods);
}

void MarkedEdges::makeCard() {
    card_ = new ProposalsCard(notice_.window());
    connect(card_, &ProposalsCard::previewRequested, this, [this](int row) {
        if (!before_ || engine_.settings() != previewed_) before_ = engine_.settings();
        previewed_ = proposals_[static_cast<std::size_t>(row)].settings;
        engine_.setSettings(previewed_);
    });
    connect(card_, &ProposalsCard::adoptRequested, this, [this](int row) {
        const edges::Settings adopted = proposals_[static_cast<std::size_t>(row)].settings;
        putBack(); // undo then leads to the settings before the preview
        undo_.push(new UndoStep<edges::Settings>(stepName("Settings for These Marks"), engine_.settings(), adopted,
                                                 [this](const edges::Settings& value) {
                                                     engine_.setSettings(value);
                                                     return true;
                                                 }));
        card_->hide();
    });
    connect(card_, &QDialog::rejected, this, [this] {
        if (card_->working()) found_.giveUp();
        putBack();
    });
}

void MarkedEdges::showProposals(const Question& question, const std::vector<edges::EdgeProposal>& proposals) {
    if (marks_.empty() || engine_.picture()->detection->scan != question.scan) return card_->hide();
    putBack();
    proposals_ = proposals;
    QStringList rows;
    for (const edges::EdgeProposal& proposal : proposals_) rows << shownText(edges::proposalText(proposal, question.marks));
    const auto fit = std::ranges::count_if(proposals_, &edges::EdgeProposal::meetsAllMarks);
    card_->showProposals(fit > 0 ? tr("%1 of %2 methods agree with all marks.").arg(fit).arg(proposals_.size())
                                 : tr("No setting separates these marks. Those that get most of them right come first."),
                         rows);
}

void MarkedEdges::putBack() {
    const auto before = std::exchange(before_, std::nullopt);
    if (before && engine_.settings() == previewed_) engine_.setSettings(*before); // later changes by the operator stay
}

} // namespace edgescan::ui

#include "moc_marked_edges.cpp"
