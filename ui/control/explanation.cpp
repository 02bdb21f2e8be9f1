// Asks off the GUI thread why a cell is an edge, and tells it.
#include "ui/control/explanation.h"

#include "core/explain/why.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/dialogs/why_card.h"
#include "ui/image/image_view.h"

#include <QMenu>

namespace edgescan::ui {

Explanation::Explanation(const Session& session, LinkedViews& views, NoticeBar& notice)
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
    // The chain belongs to the picture that it was asked of.
    connect(&session, &Session::pictureReady, this, &Explanation::forgetTrail);
}

void Explanation::explain(std::size_t cell) {
    const std::shared_ptr<const Picture> picture = views_.shown();
    if (!picture) return;
    if (card_ == nullptr) {
        card_ = new WhyCard(notice_.window());
        connect(card_, &QDialog::finished, this, &Explanation::forgetTrail);
    }
    card_->tell(tr("Working out why …"));
    worker_.post({picture, cell});
}

bool Explanation::closeCard() {
    if (card_ == nullptr || !card_->isVisible()) return false;
    card_->reject();
    return true;
}

void Explanation::tell(const Answer& answer) {
    if (!card_->isVisible()) return; // closed meanwhile: nobody waits for it any more
    const auto& [picture, given] = answer;
    const Why& why = *given;
    QString text = shownText(whyText(why, picture->detection->settings));
    const bool still = picture == views_.shown();
    if (still && !why.chainMembers.empty()) text += tr("\nIts chain is framed in both pictures, the strongest cell ringed.");
    card_->tell(text);
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
