// Compares values of a setting in small pictures.
#include "ui/controllers/contact_sheets.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/tuning.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/contact_card.h"
#include "ui/panels/tuning/edges_panel.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr std::size_t kPictures = 12;
constexpr int kPicturePx = 200;

// Edge lines are one cell wide and must stay visible: a pixel is white if one of its cells is an edge.
QImage smallMap(const edges::Detection& detection) {
    const Scan& scan = *detection.scan;
    const int every = std::max(1, (std::max(scan.lines(), scan.beams()) + kPicturePx - 1) / kPicturePx);
    QImage image((scan.beams() + every - 1) / every, (scan.lines() + every - 1) / every, QImage::Format_RGB32);
    image.fill(Qt::black);
    for (const std::uint32_t k : *detection.edges) {
        const int line = static_cast<int>(k) / scan.beams();
        const int beam = static_cast<int>(k) % scan.beams();
        image.setPixel(beam / every, line / every, qRgb(255, 255, 255));
    }
    return every > 1 || image.width() >= kPicturePx ? image : image.scaled(kPicturePx, kPicturePx, Qt::KeepAspectRatio);
}

} // namespace

ContactSheets::ContactSheets(Engine& engine, Tuning& tuning, NoticeBar& notice, QObject* parent)
    : QObject(parent), engine_(engine), tuning_(tuning), notice_(notice),
      sheet_(
          Urgency::Soon, [this](const Question& question, const Asker& asker) { return run(question, asker); },
          [this](const Question&, const std::shared_ptr<const std::vector<edges::SheetEntry>>& entries) { take(*entries); },
          [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Error, what); }) {}

void ContactSheets::show() {
    const auto picture = engine_.picture();
    if (picture == nullptr) return notice_.showHint(tr("Open a scan first."));
    if (card_ == nullptr) {
        card_ = new ContactCard(notice_.window());
        connect(card_, &ContactCard::givenUp, this, [this] { sheet_.giveUp(); });
        connect(card_, &ContactCard::chosen, this,
                [this](int place) { tuning_.setParameter(shown_.parameter->key, shown_.values[static_cast<std::size_t>(place)]); });
    }
    const edges::Parameter& parameter = tuning_.lastChanged();
    const edges::Settings& settings = engine_.settings();
    double now = parameter.get(settings);
    if (std::isnan(now) && parameter.automatic != nullptr)
        now = edges::snapped(parameter, parameter.automatic(settings, edges::measuredOf(*picture->detection)));
    shown_ = {settings, &parameter, edges::sheetValues(parameter, now, kPictures)};
    entries_.clear();
    card_->begin(QObject::tr(parameter.label), static_cast<int>(shown_.values.size()));
    sheet_.ask({picture->detection->scan, shown_});
}

std::vector<edges::SheetEntry> ContactSheets::run(const Question& question, const Asker& asker) {
    return edges::contactSheet(question.scan, question.sheet.settings, *question.sheet.parameter, question.sheet.values,
                               [&](const edges::SheetEntry& entry, const edges::Detection& detection) {
                                   return asker.waits() &&
                                          asker.show([this, entry, picture = smallMap(detection)] { add(entry, picture); });
                               });
}

void ContactSheets::add(const edges::SheetEntry& entry, const QImage& picture) {
    entries_.push_back(entry);
    const edges::Parameter& p = *shown_.parameter;
    edges::Settings with = shown_.settings;
    p.set(with, entry.value);
    const QString value =
        p.choices.empty() ? QString::number(entry.value, 'f', p.decimals) + " " + QObject::tr(p.unit) : choiceWords(p, with);
    card_->add(picture, tr("%1 edge cells · %2").arg(countText(entry.edges), value.trimmed()));
}

void ContactSheets::take(const std::vector<edges::SheetEntry>& entries) {
    if (entries.size() != shown_.values.size()) return;
    entries_ = entries;
    std::vector<bool> steady;
    for (const edges::SheetEntry& entry : entries_) steady.push_back(entry.steady);
    const double now = shown_.parameter->get(shown_.settings);
    const auto inUse = std::ranges::find(shown_.values, now);
    card_->end(steady, inUse == shown_.values.end() ? -1 : static_cast<int>(inUse - shown_.values.begin()));
}

} // namespace edgescan::ui

#include "moc_contact_sheets.cpp"
