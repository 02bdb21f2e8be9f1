// Compares values of a setting in small pictures.
#include "ui/controllers/contact_sheets.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/tuning.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/contact_card.h"

#include <QLocale>

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
      worker_(
          this, [this](const Question& question) { return run(question); }, [](const Answer& /*answer*/) {},
          [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Error, what); }) {}

void ContactSheets::show() {
    const auto picture = engine_.picture();
    if (picture == nullptr) return notice_.showNotice(NoticeBar::Kind::Warning, tr("Open a scan first."));
    if (card_ == nullptr) {
        card_ = new ContactCard(notice_.window());
        connect(card_, &ContactCard::givenUp, this, [this] { wanted_ = 0; });
        connect(card_, &ContactCard::chosen, this,
                [this](int place) { tuning_.setParameter(asked_.parameter->key, asked_.values[static_cast<std::size_t>(place)]); });
    }
    const edges::Parameter& parameter = tuning_.lastChanged();
    const edges::Settings& settings = engine_.settings();
    asked_ = {++sheets_, picture->detection->scan, settings, &parameter, {}};
    double now = parameter.get(settings);
    if (std::isnan(now) && parameter.automatic != nullptr)
        now = edges::snapped(parameter, parameter.automatic(settings, edges::measuredOf(*picture->detection)));
    asked_.values = edges::sheetValues(parameter, now, kPictures);
    entries_.clear();
    card_->begin(QObject::tr(parameter.label), static_cast<int>(asked_.values.size()));
    wanted_ = sheets_;
    worker_.post(asked_);
}

ContactSheets::Answer ContactSheets::run(const Question& question) {
    const auto made = [&](const edges::SheetEntry& entry, const edges::Detection& detection) {
        if (wanted_ != question.number) return false;
        QMetaObject::invokeMethod(
            this, [this, number = question.number, entry, picture = smallMap(detection)] { add(number, entry, picture); },
            Qt::QueuedConnection);
        return true;
    };
    if (wanted_ != question.number) return {};
    Answer answer{question.number, edges::contactSheet(question.scan, question.settings, *question.parameter, question.values, made)};
    // In the queue of the pictures: after the last of them.
    QMetaObject::invokeMethod(
        this, [this, answer] { take(answer); }, Qt::QueuedConnection);
    return answer;
}

void ContactSheets::add(std::uint64_t number, const edges::SheetEntry& entry, const QImage& picture) {
    if (number != wanted_) return;
    entries_.push_back(entry);
    const edges::Parameter& p = *asked_.parameter;
    edges::Settings with = asked_.settings;
    p.set(with, entry.value);
    const QString value = p.choices.empty() ? QString::number(entry.value, 'f', p.decimals) + " " + QObject::tr(p.unit)
                                            : QObject::tr(edges::choiceLabel(p, with).c_str());
    const QString count = QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(entry.edges));
    card_->add(picture, tr("%1 edge cells · %2").arg(count, value.trimmed()));
}

void ContactSheets::take(const Answer& answer) {
    if (answer.number != wanted_ || answer.number == 0 || answer.entries.size() != asked_.values.size()) return;
    entries_ = answer.entries;
    std::vector<bool> steady;
    for (const edges::SheetEntry& entry : entries_) steady.push_back(entry.steady);
    const double now = asked_.parameter->get(asked_.settings);
    const auto inUse = std::ranges::find(asked_.values, now);
    card_->end(steady, inUse == asked_.values.end() ? -1 : static_cast<int>(inUse - asked_.values.begin()));
}

} // namespace edgescan::ui
