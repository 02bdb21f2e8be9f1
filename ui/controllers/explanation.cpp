// Requests the explanation of a cell off the GUI thread, and shows it.
#include "ui/controllers/explanation.h"

#include "core/edges/explain/why.h"
#include "ui/base/core_words.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/targets/target_words.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"

#include <QMenu>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kSearchCells = 6;  // cells
constexpr double kDrawnPx = 2.5; // a drawn edge covers the pointer up to here

/// The direction of the profile: that of the strongest step or fold; for other methods the direction in which the range changes more.
edges::EdgeProfile profileOf(const edges::Detection& detection, const edges::Why& why) {
    const Scan& scan = *detection.scan;
    const std::size_t k = why.probe.cell;
    if (why.depth && (!why.depth->steps.empty() || !why.depth->folds.empty())) {
        const auto& [steps, folds] = std::tie(why.depth->steps, why.depth->folds);
        const bool byStep = !steps.empty() && (folds.empty() || steps.front().strength >= folds.front().strength);
        return edges::edgeProfile(scan, k, byStep ? steps.front().along : folds.front().along);
    }
    edges::EdgeProfile beams = edges::edgeProfile(scan, k, edges::Along::Beams), lines = edges::edgeProfile(scan, k, edges::Along::Lines);
    const auto deep = [](const edges::EdgeProfile& profile) {
        double most = 0.0;
        for (const edges::ProfilePoint& point : profile.points) most = std::max(most, std::abs(point.awayM));
        return most;
    };
    return deep(lines) > deep(beams) ? lines : beams;
}

/// The nearest edge if the cell is not an edge: a finger rarely hits an edge that is one cell wide.
std::optional<std::size_t> edgeNextTo(const edges::Detection& detection, std::size_t cell) {
    const auto edge = edges::nearestEdge(*detection.mask, cell, kSearchCells);
    if (!edge || *edge == cell) return std::nullopt;
    const auto beams = static_cast<std::size_t>(detection.mask->beams);
    const auto apart = [](std::size_t a, std::size_t b) { return static_cast<double>(a) - static_cast<double>(b); };
    const bool isNear = std::hypot(apart(*edge / beams, cell / beams), apart(*edge % beams, cell % beams)) <= kSearchCells;
    return isNear ? edge : std::nullopt;
}

QString number(double strength) { return shownText(edges::strengthNumber(strength)); }

/// Which number is the cell's, and which are those of the setting.
QString strengths(const edges::Why& why) {
    if (!why.depth) return {}; // in another unit, which the verdict names
    return ' ' + Explanation::tr("Its strength is %1. An edge reaches the Edge strength %2 at one place, and %3 along the rest.")
                     .arg(number(why.strength), number(why.upper), number(why.lower));
}

/// Why a strength is enough: above the threshold, or less where the edge goes on to a strong place.
QString enough(const edges::Why& why) {
    if (!why.depth) return {};
    if (why.level == edges::StrengthLevel::Above || why.chain.empty())
        return ' ' + Explanation::tr("Its strength %1 is above the Edge strength %2.").arg(number(why.strength), number(why.upper));
    const edges::CellStrength& strong = why.chain.back();
    return ' ' + Explanation::tr("Its strength %1 is below the Edge strength %2, but it continues an edge that reaches %3 at line %4, "
                                 "beam %5. Such a cell needs only %6.")
                     .arg(number(why.strength), number(why.upper), number(strong.strength))
                     .arg(strong.line)
                     .arg(strong.beam)
                     .arg(number(why.lower));
}

QString noEdge(const edges::Why& why) {
    switch (edges::noEdgeReason(why)) {
    case edges::NoEdge::NotBorder:
        return Explanation::tr("This is an edge, but it is left out: only borders of rocks are shown.");
    case edges::NoEdge::StrongerNeighbour: {
        const edges::CellStrength& other = *why.suppressedBy;
        const QString where =
            Explanation::tr(
                "The surface changes here, but as much or more in the cell next to it, line %1, beam %2: an edge is one cell wide.")
                .arg(other.line)
                .arg(other.beam);
        if (!why.depth) return where;
        return where + ' ' +
               Explanation::tr("In the direction of that cell their strengths are %1 and %2.")
                   .arg(number(why.compared), number(other.strength));
    }
    case edges::NoEdge::TooWeak:
        return Explanation::tr("The surface changes too little here to be an edge.") + strengths(why);
    case edges::NoEdge::NoStrongPlace:
        return Explanation::tr("The surface changes here, but no place of this change is strong enough for an edge.") + strengths(why);
    case edges::NoEdge::TooShort:
        return Explanation::tr("The surface changes here, but this edge is shorter than the minimum length.");
    case edges::NoEdge::StepOfNeighbour:
        break;
    }
    return Explanation::tr("The surface changes here, but another cell of it is the edge.");
}

QString surfaceWords(const edges::Why& why) {
    if (why.probe.state != CellState::Valid && !why.probe.filled) return Explanation::tr("Nothing was measured here.");
    if (!why.probe.edge) return noEdge(why);
    switch (why.probe.kind) {
    case edges::DepthEdge::Jump:
        return Explanation::tr("One surface ends here in front of another.") + enough(why);
    case edges::DepthEdge::Convex:
        return Explanation::tr("The surface bends outwards here, as at the corner of a rock.") + enough(why);
    case edges::DepthEdge::Concave:
        return Explanation::tr("The surface bends inwards here, as where two rocks meet.") + enough(why);
    case edges::DepthEdge::Border:
    case edges::DepthEdge::VoidRim:
    case edges::DepthEdge::Silhouette:
        return Explanation::tr("The measured surface ends here.") + ' ' +
               Explanation::tr("Edges of this class do not depend on Edge strength.");
    case edges::DepthEdge::None:
        break;
    }
    return Explanation::tr("The surface changes strongly here.");
}

/// For readers who do not know the terms of the verdict.
QString plainWords(const edges::Why& why) {
    const QString border = shownText(edges::whyBorder(why, inLanguage));
    return border.isEmpty() ? surfaceWords(why) : surfaceWords(why) + ' ' + border;
}

} // namespace

Explanation::Explanation(LinkedViews& views, NoticeBar& notice)
    : views_(views), notice_(notice),
      why_(
          Urgency::Now, [](const Question& question) { return edges::whyCell(*question.picture->detection, question.click.cell); },
          [this](const Question& question, const std::shared_ptr<const edges::Why>& why) {
              show(question, question.picture == views_.shown(), *why);
          },
          [this](const QString& what) {
              const QString sentence = tr("The reason could not be found (%1).").arg(what);
              notice_.showNotice(NoticeBar::Kind::Warning, sentence);
              if (card_ != nullptr && card_->isVisible()) card_->showExplanation(sentence);
          }) {
    connect(&views, &LinkedViews::clicked, this, [this](const inspect::ClickedCell& click) {
        if (views_.tool() == Tool::Why || (card_ != nullptr && card_->isVisible())) explain(click, Subject::Click);
    });
    connect(&views, &LinkedViews::newScanShown, this, [this] {
        if (card_ != nullptr) card_->reject(); // its cell is of the scan before
    });
    connect(&views, &LinkedViews::toolChanged, this, [this] {
        if (views_.tool() != Tool::Why && std::exchange(waits_, false)) emit asked(QString());
    });
    connect(&views, &LinkedViews::cellMenuOpens, this, [this](QMenu& menu, const inspect::ClickedCell& click) {
        menu.addAction(tr("&Why is this cell an edge or not?"), this, [this, click] { explain(click, Subject::Click); });
    });
}

void Explanation::explain(const inspect::ClickedCell& click, Subject subject) {
    const std::shared_ptr<const Picture> picture = views_.shown();
    if (!picture) return;
    if (views_.flipped()) return notice_.showHint(LinkedViews::onlyOfB()); // the card outlasts A on the screen
    if (card_ == nullptr) {
        card_ = new WhyCard(notice_.window());
        connect(card_, &QDialog::finished, this, &Explanation::forgetTrail);
        connect(card_, &QDialog::finished, this, &Explanation::endWait);
        connect(card_, &QDialog::finished, this, [this] {
            asked_.reset(); // the picture is freed
            mark({});
        });
        connect(card_, &WhyCard::nearestEdgeRequested, this, [this] {
            if (nearestEdge_) explain(inspect::exactly(*nearestEdge_), Subject::NearestEdge);
        });
    }
    if (subject == Subject::Click && click.moved() && (*picture->detection->mask)[click.clicked] != 0)
        return explain(inspect::exactly(click.clicked), Subject::Click); // an edge was clicked, so it is meant and not its near side
    // Edges are drawn wider than a cell: a pointer on one of them means it, whatever cell is under its tip. Zoomed in, it does not.
    // A target is the very cell.
    const bool isExact = subject == Subject::NearestEdge || views_.isTarget(click.cell);
    const auto edge = isExact ? std::nullopt : edgeNextTo(*picture->detection, click.cell);
    const auto apart = edge ? views_.pixelsBetween(click.cell, *edge) : std::nullopt;
    if (apart && *apart <= kDrawnPx) return explain(inspect::exactly(*edge), Subject::NearestEdge);
    const Question question{picture, click, subject};
    asked_ = question;
    card_->offerNearestEdge(0);
    mark({});
    QVector<QPoint> others;
    for (const TargetMark& target : views_.cloud().marks().targets) {
        if (target.cell != click.cell) others << views_.onScreen(target.cell);
    }
    card_->showCell(subjectText(question), views_.onScreen(click.cell), others);
    card_->showPlain(QString());
    card_->showExplanation(tr("Finding the reason …"));
    why_.ask(question);
}

/// "Cell: line 12, beam 40 (the pinned target)".
QString Explanation::subjectText(const Question& question) const {
    const auto beams = static_cast<std::uint32_t>(question.picture->detection->scan->beams());
    const auto cell = [beams](std::uint32_t k) { return tr("line %1, beam %2").arg(k / beams).arg(k % beams); };
    const inspect::ClickedCell& click = question.click;
    const auto what = [&] {
        switch (question.subject) {
        case Subject::Pointer:
            return !views_.pinned()                ? tr("under the pointer")
                   : views_.pinned() == click.cell ? tr("the pinned target, under the pointer")
                                                   : tr("under the pointer, not the pinned target");
        case Subject::Pin:
            return tr("the pinned target");
        case Subject::NearestEdge:
            return tr("the nearest edge");
        case Subject::Click:
            break;
        }
        if (click.moved()) return tr("the near side of your click at %1").arg(cell(click.clicked));
        return views_.isTarget(click.cell) ? tr("the target that you clicked") : tr("the cell that you clicked");
    };
    const QString place = cell(click.cell);
    return tr("Cell: %1 (%2)").arg(place, what());
}

bool Explanation::closeCard() {
    const bool waited = views_.tool() == Tool::Why;
    endWait();
    if (card_ == nullptr || !card_->isVisible()) return waited;
    card_->reject();
    return true;
}

void Explanation::waitForClicks() {
    views_.setTool(Tool::Why);
    waits_ = true;
    emit asked(tr("Why: click a cell"));
}

void Explanation::endWait() {
    if (views_.tool() == Tool::Why) views_.setTool(Tool::Pin);
}

/// `still`: the picture is on the screen.
void Explanation::show(const Question& question, bool still, const edges::Why& why) {
    const Picture& picture = *question.picture;
    if (!card_->isVisible()) return; // closed meanwhile: the answer is no longer needed
    QString numbers = shownText(edges::whyNumbers(why, picture.detection->settings, inLanguage));
    if (still && !why.chainMembers.empty())
        numbers += tr("\nThe strongest cell of its chain is marked in all views; zoomed in, the chain is framed.");
    if (const QString moved = clickText(question.click, *picture.detection); !moved.isEmpty())
        numbers += "\n" + tr("Clicked") + ": " + moved;
    nearestEdge_ = edgeNextTo(*picture.detection, why.probe.cell);
    const auto away = [&](std::size_t cell) {
        const QPointF way = views_.placeOf(cell) - views_.placeOf(why.probe.cell);
        return static_cast<int>(std::lround(std::hypot(way.x(), way.y())));
    };
    card_->offerNearestEdge(still && nearestEdge_ ? away(*nearestEdge_) : 0);
    card_->showPlain(plainWords(why));
    card_->showExplanation(shownText(edges::whyVerdict(why, picture.detection->settings, edges::Naming::Labels, inLanguage)),
                           profileOf(*picture.detection, why), numbers);
    if (still)
        showTrail(why);
    else
        forgetTrail();
}

void Explanation::showTrail(const edges::Why& why) {
    EdgeTrail trail;
    for (const std::uint32_t k : why.chainMembers) trail.cells.push_back(views_.placeOf(k));
    for (const edges::CellStrength& cell : why.chain) trail.way.emplace_back(cell.beam, cell.line);
    views_.setTrail(trail);
    mark(why.chainTop ? views_.cellAt(why.chainTop->line, why.chainTop->beam) : std::nullopt);
}

void Explanation::forgetTrail() {
    views_.setTrail({});
    mark({});
}

/// The explained cell, unless it has the mark of its target, and the strongest cell of its chain.
void Explanation::mark(std::optional<std::size_t> strongest) {
    std::vector<std::pair<std::size_t, QString>> marks;
    if (asked_ && views_.pinned() != asked_->click.cell) marks.emplace_back(asked_->click.cell, tr("Why"));
    if (strongest && asked_ && strongest != asked_->click.cell) marks.emplace_back(*strongest, tr("strongest"));
    views_.setExplained(marks);
}

/// The lines that a sweep adds change nothing here; a setting does.
void Explanation::followPicture() {
    forgetTrail();
    const std::shared_ptr<const Picture> picture = views_.shown();
    if (card_ == nullptr || !card_->isVisible() || !asked_ || !picture || views_.flipped()) return;
    const bool added = picture->source.growth.growing && picture->detection->settings == asked_->picture->detection->settings;
    if (added || asked_->click.cell >= picture->detection->scan->cells()) return;
    asked_->picture = picture;
    why_.ask(*asked_);
}

void Explanation::explainMarked() {
    const auto cell = views_.marked();
    const bool answered = card_ != nullptr && card_->isVisible() && asked_ && cell == asked_->click.cell;
    if (views_.tool() == Tool::Why && (!cell || answered)) return endWait();            // a second press
    if (!cell || (views_.tool() == Tool::Pin && views_.pinsOnClick())) waitForClicks(); // else another tool is in use
    if (!cell) return;
    explain(inspect::exactly(*cell), views_.hovered() ? Subject::Pointer : Subject::Pin);
}

} // namespace edgescan::ui

#include "moc_explanation.cpp"
