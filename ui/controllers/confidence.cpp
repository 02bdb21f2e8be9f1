// Requests edge confidence and shows it.
#include "ui/controllers/confidence.h"

#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/confidence/confidence_legend.h"

#include <utility>

namespace edgescan::ui {
namespace {

constexpr std::chrono::milliseconds kQuiet{250};      // since the last change
constexpr std::chrono::milliseconds kQuietCard{1000}; // where a card alone asks: it has no hurry
constexpr std::size_t kMostForCard = 4'000'000;       // cells; for a larger scan it is computed only on request
constexpr const char* kLeast = "view/confidence-least";

} // namespace

Confidence::Confidence(Engine& engine, LinkedViews& views, Targets& targets, ConfidenceLegend& legend, Preferences& preferences)
    : engine_(engine), views_(views), targets_(targets), legend_(legend), preferences_(preferences),
      confidence_(
          Urgency::Later, [this](const std::shared_ptr<const Picture>& picture, const Asker& asker) { return workOut(*picture, asker); },
          [this](const std::shared_ptr<const Picture>&, const std::shared_ptr<const edges::EdgeConfidence>& known) {
              known_ = known;
              draw();
              show();
          },
          [this](const QString& what) { failed(what); }),
      drawn_(
          Urgency::Now,
          [](const Drawing& asked) { return confidencePicture(asked.picture, asked.known, asked.leastPercent, asked.colours); },
          [this](const Drawing&, const std::shared_ptr<const ConfidencePicture>& made) {
              made_ = made;
              legend_.showMade(*made_);
              show();
          },
          [this](const QString& what) { failed(what); }) {
    legend_.setLeast(preferences_.text(kLeast).toInt());
    connect(&legend_, &ConfidenceLegend::leastRequested, this, [this](int percent) {
        preferences_.keep(kLeast, QString::number(percent));
        draw();
        emit changed();
    });
    connect(&targets_, &Targets::cardChanged, this, &Confidence::followCard);
    connect(&views_, &LinkedViews::picturesChanged, this, [this] { legend_.setVisible(views_.scene().legend == OverlayName::Confidence); });
    connect(&views_, &LinkedViews::edgeColoursChanged, this, [this] {
        legend_.setColours(bandColours(views_.edgeColours() != kUsualColours));
        draw();
    });
}

void Confidence::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    made_ = nullptr;
    drawn_.giveUp();
    begin();
    show();
}

void Confidence::setLeast(int percent) { legend_.setLeast(percent); }

int Confidence::least() const { return legend_.least(); }

std::optional<int> Confidence::at(std::size_t cell) const {
    if (!made_ || cell >= made_->confidence->percent.size()) return std::nullopt;
    const int percent = made_->confidence->percent[cell];
    return percent > 0 ? std::optional(percent) : std::nullopt;
}

bool Confidence::possible() const { return engine_.picture() != nullptr && !engine_.picture()->source.growth.growing; }

bool Confidence::needed() const {
    return on_ || (forCard_ && engine_.picture() && engine_.picture()->detection->mask->size() <= kMostForCard);
}

/// The known values belong to another picture: until the new values are computed, its edges are shown normally.
void Confidence::followPicture() {
    confidence_.giveUp();
    drawn_.giveUp();
    made_ = nullptr;
    known_ = nullptr;
    failed_ = false;
    followCard();
    begin();
    show();
}

/// The card shows another cell, or its cell is an edge now.
void Confidence::followCard() {
    const inspect::PinnedTarget* target = targets_.active();
    const Picture* picture = engine_.picture().get();
    const bool before =
        std::exchange(forCard_, target != nullptr && picture != nullptr && target->cell < picture->detection->mask->size() &&
                                    (*picture->detection->mask)[target->cell] != 0);
    if (forCard_ != before) begin();
}

/// Starts needed work shortly after the last change; cancels work that is no longer needed.
void Confidence::begin() {
    if (on_ && !engine_.picture()) legend_.showNone(tr("open a scan first"));
    if (on_ && engine_.picture() && !possible()) legend_.showNone(tr("when the sweep has ended"));
    if (!needed() || !possible()) {
        confidence_.giveUp();
    } else if (known_) {
        if (!made_) draw();
    } else if (!confidence_.behind() || confidence_.waiting()) {
        if (on_) legend_.showWorking(0);
        failed_ = false;
        if (on_ || !confidence_.waiting()) confidence_.ask(engine_.picture(), on_ ? kQuiet : kQuietCard);
    }
    updateCards();
}

void Confidence::draw() {
    if (on_ && known_) drawn_.ask({engine_.picture(), known_, legend_.least(), bandColours(views_.edgeColours() != kUsualColours)});
}

std::shared_ptr<const edges::EdgeConfidence> Confidence::workOut(const Picture& picture, const Asker& asker) {
    auto found = edges::edgeConfidence(*picture.detection, [&](double done) {
        return asker.show([this, done] {
            if (on_) legend_.showWorking(static_cast<int>(100 * done));
        });
    });
    return found ? std::make_shared<const edges::EdgeConfidence>(std::move(*found)) : nullptr;
}

void Confidence::failed(const QString& what) {
    failed_ = true;
    legend_.showNone(tr("could not be computed:\n%1").arg(what));
    updateCards();
}

void Confidence::updateCards() {
    using State = ShownConfidence::State;
    KnownConfidence told;
    told.of = engine_.picture();
    told.made = known_;
    if (forCard_ && !known_ && !failed_) told.otherwise = !possible() ? State::Growing : needed() ? State::Coming : State::Large;
    targets_.setConfidence(told);
}

void Confidence::show() {
    if (on_) {
        Overlay overlay;
        overlay.name = OverlayName::Confidence;
        overlay.legend = true;
        if (made_) {
            overlay.scan = made_->of->detection->scan;
            overlay.edges =
                std::make_shared<const OverlayEdges>(OverlayEdges{made_->cells, bandColours(views_.edgeColours() != kUsualColours),
                                                                  made_->images[0], made_->images[1], true, tr("by confidence")});
        }
        views_.put(std::move(overlay));
    } else {
        views_.remove(OverlayName::Confidence);
    }
    updateCards();
    emit changed();
}

} // namespace edgescan::ui

#include "moc_confidence.cpp"
