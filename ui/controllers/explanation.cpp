// Requests the explanation of a cell off the GUI thread, and shows it.
#include "ui/controllers/explanation.h"

#include "core/edges/explain/why.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/views/image/image_view.h"

#include <QMenu>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edgescan::ui {
namespace {

constexpr int kBeside = 6; // cells

/// The direction of the profile: that of the strongest step or fold; for other methods the direction in which the range changes more.
EdgeProfile profileOf(const Detection& detection, const Why& why) {
    const Scan& scan = *detection.scan;
    const std::size_t k = why.probe.cell;
    if (why.depth && (!why.depth->steps.empty() || !why.depth->folds.empty())) {
        const auto& [steps, folds] = std::tie(why.depth->steps, why.depth->folds);
        const bool byStep = !steps.empty() && (folds.empty() || steps.front().strength >= folds.front().strength);
        return edgeProfile(scan, k, byStep ? steps.front().along : folds.front().along);
    }
    EdgeProfile beams = edgeProfile(scan, k, Along::Beams), lines = edgeProfile(scan, k, Along::Lines);
    const auto deep = [](const EdgeProfile& profile) {
        double most = 0.0;
        for (const ProfilePoint& point : profile.points) most = std::max(most, std::abs(point.awayM));
        return most;
    };
    return deep(lines) > deep(beams) ? lines : beams;
}

/// The nearest edge if the cell is not an edge: a finger rarely hits an edge that is one cell wide.
std::optional<std::size_t> edgeBeside(const Detection& detection, std::size_t cell) {
    const Grid<std::uint8_t>& mask = *detection.mask;
    if (mask[cell] != 0) return std::nullopt;
    const Scan& scan = *detection.scan;
    const int line = static_cast<int>(cell) / scan.beams(), beam = static_cast<int>(cell) % scan.beams();
    std::optional<std::size_t> nearest;
    int least = kBeside * kBeside + 1;
    for (int y = std::max(0, line - kBeside); y <= std::min(scan.lines() - 1, line + kBeside); ++y) {
        for (int x = std::max(0, beam - kBeside); x <= std::min(scan.beams() - 1, beam + kBeside); ++x) {
            const int away = (y - line) * (y - line) + (x - beam) * (x - beam);
            const std::size_t k = static_cast<std::size_t>(y) * static_cast<std::size_t>(scan.beams()) + static_cast<std::size_t>(x);
            if (away >= least || mask[k] == 0) continue;
            least = away;
            nearest = k;
        }
    }
    return nearest;
}

} // namespace

Explanation::Explanation(LinkedViews& views, NoticeBar& notice)
    : views_(views), notice_(notice),
      worker_(
          this,
          [](const Question& question) {
              const Detection& detection = *question.picture->detection;
              return Answer{question.picture, std::make_shared<const Why>(whyCell(detection, question.cell))};
          },
          [this](const Answer& answer) { tell(answer); },
          [this](const QString& what) {
              const QString sentence = tr("Why could not be worked out (%1).").arg(what);
              notice_.showNotice(NoticeBar::Kind::Warning, sentence);
              if (card_ != nullptr && card_->isVisible()) card_->tell(sentence);
          }) {
    connect(&views, &LinkedViews::cellMenuOpens, this, [this](QMenu& menu, std::size_t cell) {
        menu.addAction(tr("&Why is this cell an edge, or none?"), this, [this, cell] { explain(cell); });
    });
}

void Explanation::explain(std::size_t cell) {
    const std::shared_ptr<const Picture> picture = views_.shown();
    if (!picture) return;
    if (card_ == nullptr) {
        card_ = new WhyCard(notice_.window());
        connect(card_, &QDialog::finished, this, &Explanation::forgetTrail);
        connect(card_, &WhyCard::besideWanted, this, [this] {
            if (beside_) explain(*beside_);
        });
    }
    card_->offerBeside(0);
    card_->tell(tr("Working out why …"));
    worker_.post({picture, cell});
}

bool Explanation::closeCard() {
    if (card_ == nullptr || !card_->isVisible()) return false;
    card_->reject();
    return true;
}

void Explanation::tell(const Answer& answer) {
    if (!card_->isVisible()) return; // closed meanwhile: the answer is no longer needed
    const auto& [picture, given] = answer;
    const Why& why = *given;
    QString numbers = shownText(whyNumbers(why, picture->detection->settings));
    const bool still = picture == views_.shown();
    if (still && !why.chainMembers.empty()) numbers += tr("\nIts chain is framed in both pictures, the strongest cell ringed.");
    beside_ = edgeBeside(*picture->detection, why.probe.cell);
    const auto away = [&](std::size_t cell) {
        const QPointF way = views_.placeOf(cell) - views_.placeOf(why.probe.cell);
        return static_cast<int>(std::lround(std::hypot(way.x(), way.y())));
    };
    card_->offerBeside(still && beside_ ? away(*beside_) : 0);
    card_->tell(shownText(whyVerdict(why, picture->detection->settings, Naming::Labels)), profileOf(*picture->detection, why), numbers);
    if (still)
        showTrail(why);
    else
        forgetTrail();
}

void Explanation::showTrail(const Why& why) {
    EdgeTrail trail;
    for (const std::uint32_t k : why.chainMembers) trail.cells.push_back(views_.placeOf(k));
    for (const CellStrength& cell : why.chain) trail.way.emplace_back(cell.beam, cell.line);
    if (why.chainTop) trail.strongest = QPoint(why.chainTop->beam, why.chainTop->line);
    views_.setTrail(trail);
}

void Explanation::forgetTrail() { views_.setTrail({}); }

void Explanation::explainMarked() {
    if (const auto cell = views_.marked())
        explain(*cell);
    else
        notice_.showNotice(NoticeBar::Kind::Warning, tr("Point at a cell or click one first; then Why says what decides about it."));
}

} // namespace edgescan::ui
