// Checks how a scan was read, and previews other readings.
#include "ui/controllers/files/opening.h"

#include "core/files/open_save/topics_of_file.h"
#include "core/files/point_tables/repeated_values.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/files.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/opening_card.h"

#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace edgescan::ui {

/// What can be otherwise of a scan; of a bag its topics first.
std::vector<files::OpeningPoint> Opening::checked(const Question& question, const Asker& asker) {
    std::vector<files::OpeningPoint> points = files::openingCheck(*question.scan, question.options);
    if (!question.scan->format.starts_with("ROS ")) return points;
    ReadingOptions whileWanted;
    whileWanted.progress = [&asker](const char*, double) { return asker.waits(); };
    const auto listing = files::topicsOfFile(question.scan->path, whileWanted);
    if (!listing || !*listing) return points;
    std::vector<files::OpeningPoint> ofBag = files::bagCheck(**listing, *question.scan, question.options);
    points.insert(points.begin(), std::make_move_iterator(ofBag.begin()), std::make_move_iterator(ofBag.end()));
    return points;
}

Opening::Opening(Engine& engine, Files& files, NoticeBar& notice)
    : engine_(engine), files_(files), notice_(notice),
      check_(
          Urgency::Later, checked,
          [this](const Question& question, const std::shared_ptr<const std::vector<files::OpeningPoint>>& points) {
              storePoints(question.scan, *points);
          },
          [](const QString&) {}) { // not known: nothing is said
    connect(&engine_, &Engine::streamChanged, this, &Opening::follow);
}

void Opening::follow() {
    const auto& picture = engine_.picture();
    const bool sameFile = path_ == files_.path();
    if (before_ && sameFile && card_ != nullptr && card_->isVisible()) return; // a preview of one of the readings
    before_.reset();
    points_.reset();
    path_ = files_.path();
    if (card_ != nullptr && !sameFile) card_->hide();
    if (path_.isEmpty() || picture->source.growth.growing) return check_.giveUp();
    check_.ask({picture->detection->scan, files_.options()});
}

void Opening::storePoints(const std::shared_ptr<const Scan>& scan, const std::vector<files::OpeningPoint>& points) {
    if (engine_.picture()->detection->scan != scan || before_) return;
    points_ = points;
    if (cardWanted_ || (card_ != nullptr && card_->isVisible())) fillCard();
    const bool displaced = files_.options().straighten || std::ranges::any_of(*points_, [](const files::OpeningPoint& point) {
                               return std::string_view(point.what) == files::kDisplacedPoint;
                           });
    const bool answers = displaced || std::ranges::any_of(scan->warnings, files::isRepeatedWarning); // the warning has its own button
    QStringList against;
    for (const files::OpeningPoint& point : *points_) {
        // The scan's warnings already report beams and lines out of place.
        if (!point.against.empty() && std::string_view(point.what) != files::kDisplacedPoint) against << shownSentence(point.against);
    }
    const bool isWarned = notice_.isVisible() && notice_.kind() == NoticeBar::Kind::Warning; // a warning about guesses is shown
    if (against.isEmpty() && (answers || !isWarned || !files::looksGuessed(*points_))) return;
    if (!against.isEmpty())
        notice_.showNotice(NoticeBar::Kind::Warning, against.join('\n') + (notice_.isVisible() ? '\n' + notice_.text() : QString()));
    notice_.offer(tr("Does this look right?"), [this] { show(); });
}

void Opening::show() {
    if (files_.path().isEmpty())
        return notice_.showHint(tr("There is no file on the screen that could be read in another way: open one first."));
    cardWanted_ = !points_.has_value();
    if (points_) fillCard();
}

void Opening::fillCard() {
    cardWanted_ = false;
    if (card_ == nullptr) {
        card_ = new OpeningCard(notice_.window());
        connect(card_, &OpeningCard::previewRequested, this, &Opening::preview);
        connect(card_, &OpeningCard::adoptRequested, this, &Opening::adopt);
        connect(card_, &QDialog::finished, this, &Opening::closed);
    }
    card_->showPoints(shownName(QFileInfo(path_).fileName()), *points_);
    card_->show();
    card_->raise();
}

const files::OtherReading* Opening::otherAt(int point, int other) const {
    if (!points_ || point < 0 || point >= static_cast<int>(points_->size())) return nullptr;
    const auto& others = (*points_)[static_cast<std::size_t>(point)].others;
    return other >= 0 && other < static_cast<int>(others.size()) ? &others[static_cast<std::size_t>(other)] : nullptr;
}

void Opening::preview(int point, int other) {
    const files::OtherReading* wanted = otherAt(point, other);
    if (wanted == nullptr) return;
    if (!before_) before_ = files_.options();
    files_.look(wanted->options);
    card_->showState(tr("On the screen, not yet adopted: %1").arg(shownSentence(wanted->words)));
}

void Opening::adopt(int point, int other) {
    const files::OtherReading* wanted = otherAt(point, other);
    if (wanted == nullptr) return;
    const ReadingOptions before = before_.value_or(files_.options());
    const ReadingOptions after = wanted->options;
    before_.reset(); // the new reading is checked again
    files_.readAgain(after, stepName("How the Scan Is Read"), before);
}

/// Closing without Adopt restores the former reading.
void Opening::closed() {
    if (!before_) return;
    const ReadingOptions back = *std::exchange(before_, std::nullopt);
    if (path_ == files_.path()) files_.look(back);
}

} // namespace edgescan::ui

#include "moc_opening.cpp"
