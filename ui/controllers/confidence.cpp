// Requests edge confidence and shows it.
#include "ui/controllers/confidence.h"

#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/memory.h"
#include "ui/panels/confidence/confidence_legend.h"

#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kQuietMs = 250;                   // pause after the last change of a setting
constexpr int kQuietCardMs = 1000;              // pause if only a card needs it: not urgent
constexpr std::size_t kMostForCard = 4'000'000; // cells; for a larger scan it is computed only on request
constexpr const char* kLeast = "view/confidence-least";

} // namespace

Confidence::Confidence(Engine& engine, LinkedViews& views, Targets& targets, ConfidenceLegend& legend, Memory& memory)
    : engine_(engine), views_(views), targets_(targets), legend_(legend), memory_(memory),
      worker_(
          this, [this](const Asked& asked) { return workOut(asked); }, [this](const Answer& answer) { take(answer); },
          [this](const QString& what) { failed(what); }) {
    quiet_.setSingleShot(true);
    connect(&quiet_, &QTimer::timeout, this, &Confidence::ask);
    legend_.setLeast(memory_.text(kLeast).toInt());
    connect(&legend_, &ConfidenceLegend::leastRequested, this, [this](int percent) {
        memory_.keep(kLeast, QString::number(percent));
        if (made_) ask(); // only the images
        emit changed();
    });
    connect(&targets_, &Targets::cardChanged, this, &Confidence::followCard);
    connect(&views_, &LinkedViews::edgeColoursChanged, this, [this] {
        legend_.setColours(bandColours(views_.edgeColours() != kUsualColours));
        if (made_) ask();
    });
}

Confidence::~Confidence() { ++wanted_; } // cancels a running computation

void Confidence::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    made_ = nullptr;
    begin();
    show();
}

void Confidence::setLeast(int percent) { legend_.setLeast(percent); }

int Confidence::least() const { return legend_.least(); }

void Confidence::hideForComparison(bool toAnother) {
    hiddenForComparison_ = toAnother;
    show();
}

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
    ++wanted_;
    quiet_.stop();
    made_ = nullptr;
    known_ = nullptr;
    running_ = failed_ = false;
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
        quiet_.stop();
        if (running_) ++wanted_;
        running_ = false;
    } else if (known_ && on_ && !made_) {
        ask();
    } else if (!known_ && !running_) {
        if (on_) legend_.showWorking(0);
        const int wait = on_ ? kQuietMs : kQuietCardMs;
        if (!quiet_.isActive() || quiet_.interval() > wait) quiet_.start(wait);
    }
    updateCards();
}

void Confidence::ask() {
    if (!needed() || !possible()) return;
    running_ = true;
    failed_ = false;
    worker_.post({++wanted_, engine_.picture(), known_, on_, legend_.least(), bandColours(views_.edgeColours() != kUsualColours)});
}

Confidence::Answer Confidence::workOut(const Asked& asked) {
    Answer answer{asked.number, asked.known, nullptr};
    if (!answer.known) {
        const auto goOn = [&](double done) {
            QMetaObject::invokeMethod(
                this,
                [this, number = asked.number, done] {
                    if (number == wanted_ && on_) legend_.showWorking(static_cast<int>(100 * done));
                },
                Qt::QueuedConnection);
            return asked.number == wanted_;
        };
        auto found = edges::edgeConfidence(*asked.picture->detection, goOn);
        if (!found) return answer;
        answer.known = std::make_shared<const edges::EdgeConfidence>(std::move(*found));
    }
    if (asked.shown) answer.made = confidencePicture(asked.picture, answer.known, asked.leastPercent, asked.colours);
    return answer;
}

void Confidence::take(const Answer& answer) {
    if (!answer.known || answer.number != wanted_) return;
    running_ = false;
    known_ = answer.known;
    if (on_ && !answer.made) return ask(); // it was switched on after the request
    made_ = on_ ? answer.made : nullptr;
    if (made_) legend_.showMade(*made_);
    show();
}

void Confidence::failed(const QString& what) {
    running_ = false;
    failed_ = true;
    legend_.showNone(tr("could not be worked out:\n%1").arg(what));
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
    legend_.setVisible(on_ && !hiddenForComparison_);
    std::shared_ptr<EdgesInstead> instead;
    if (made_ && on_ && !hiddenForComparison_) {
        instead = std::make_shared<EdgesInstead>();
        *instead = {
            made_->cells,       bandColours(views_.edgeColours() != kUsualColours), made_->images[0], made_->images[1], nullptr, true,
            tr("by confidence")};
    }
    // do not replace what another controller shows there
    if (instead || views_.edgesInstead() == shown_) views_.setEdgesInstead(instead);
    shown_ = std::move(instead);
    updateCards();
    emit changed();
}

} // namespace edgescan::ui
