// Computes and shows the colours of the points and the window of the range image.
#include "ui/controllers/scan_look.h"

#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/scale_plate.h"

#include <utility>

namespace edgescan::ui {
namespace {

constexpr const char* kLocked = "view/range-window"; // "near far" if it is locked
constexpr const char* kColourBy = "view/colour-by";

} // namespace

ScanLook::ScanLook(Engine& engine, LinkedViews& views, ScalePlate& plate, RangeWindow& window, Preferences& preferences)
    : engine_(engine), views_(views), plate_(plate), window_(window), preferences_(preferences),
      colours_(
          Urgency::Now,
          [](const Asked& asked) {
              auto histogram =
                  asked.counted || asked.coarse ? asked.counted : std::make_shared<const RangeHistogram>(rangeHistogram(*asked.scan));
              return Answer{std::move(histogram), cloudColours(*asked.scan, asked.cloud, asked.by)};
          },
          [this](const Asked& asked, const std::shared_ptr<const Answer>& answer) {
              if (!asked.coarse && !views_.flipped()) own_ = answer;
              show(*answer);
          },
          [](const QString&) {}) { // gray is true as well
    by_ = colourOfKey(preferences_.text(kColourBy).toStdString()).value_or(ColourBy::Nothing);
    const QStringList kept = preferences_.text(kLocked).split(' ');
    if (kept.size() == 2 && kept[1].toDouble() > kept[0].toDouble()) {
        views_.setRangeWindow(RangeSpan{kept[0].toDouble(), kept[1].toDouble()});
        views_.keepRangeWindow(true);
        window_.setLocked(true);
    }
    const auto remember = [this] {
        const auto span = window_.locked() ? views_.rangeWindow() : std::nullopt;
        preferences_.keep(kLocked, span ? QString("%1 %2").arg(span->nearM).arg(span->farM) : QString());
    };
    connect(&window_, &RangeWindow::windowRequested, this, [this](double nearM, double farM) {
        views_.setRangeWindow(RangeSpan{nearM, farM});
    });
    connect(&window_, &RangeWindow::automaticRequested, this, [this] { views_.setRangeWindow(std::nullopt); });
    connect(&window_, &RangeWindow::lockRequested, this, [this, remember](bool on) {
        // A locked window needs numbers, also if it was automatic.
        if (on && !views_.rangeWindow()) views_.setRangeWindow(views_.rangesShown());
        views_.keepRangeWindow(on);
        remember();
        emit changed();
    });
    connect(&views_, &LinkedViews::flippedChanged, this, &ScanLook::followPicture);
    connect(&engine_, &Engine::coarseChanged, this, &ScanLook::followCoarse);
    connect(&views_, &LinkedViews::rangeWindowChanged, this, [this, remember] {
        showWindow();
        remember();
    });
}

void ScanLook::setColourBy(ColourBy by) {
    if (by == by_) return;
    by_ = by;
    coloured_.reset();
    preferences_.keep(kColourBy, QString(colourKey(by)));
    followPicture();
    emit colourByChanged(by);
    emit changed();
}

const std::optional<RangeSpan>& ScanLook::rangeWindow() const { return views_.rangeWindow(); }

void ScanLook::setRangeWindow(const std::optional<RangeSpan>& window, bool locked) {
    window_.setLocked(false); // the window still belongs to the previous scan
    views_.setRangeWindow(window);
    window_.setLocked(locked && window);
}

void ScanLook::followPicture() {
    showWindow();
    const auto& picture = views_.shown();
    if (!picture) return followCoarse();
    if (coloured_.lock() == picture->cloud) return;
    coloured_ = picture->cloud;
    if (!views_.flipped()) emit intensityKnown(picture->detection->scan->intensity.size() > 0);
    const bool own = own_ && own_->colours.of == picture->cloud;
    if (own && own_->colours.by == by_) {
        colours_.giveUp(); // what was asked about A
        return show(*own_);
    }
    colours_.ask({picture->detection->scan, picture->cloud, by_, false, own ? own_->histogram : nullptr});
}

void ScanLook::followCoarse() {
    if (const auto& coarse = engine_.coarse()) colours_.ask({coarse->detection->scan, coarse->cloud, by_, true});
}

void ScanLook::show(const Answer& answer) {
    if (answer.histogram) {
        window_.showHistogram(*answer.histogram);
        showWindow();
    }
    views_.cloud().setColours(answer.colours.of, answer.colours.points);
    plate_.showColours(answer.colours);
}

void ScanLook::showWindow() {
    const RangeSpan shown = views_.rangesShown();
    window_.showWindow({shown.nearM, shown.farM}, !views_.rangeWindow());
}

} // namespace edgescan::ui

#include "moc_scan_look.cpp"
