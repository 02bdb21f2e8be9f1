// Asking for edge confidence and showing it.
#include "ui/control/confidence.h"

#include "ui/confidence/confidence_legend.h"
#include "ui/linked/linked_views.h"
#include "ui/session/memory.h"

#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kQuietMs = 250; // nobody has turned anything for so long
constexpr const char* kLeast = "view/confidence-least";

} // namespace

Confidence::Confidence(Session& session, LinkedViews& views, ConfidenceLegend& legend, Memory& memory)
    : session_(session), views_(views), legend_(legend), memory_(memory),
      worker_(
          this, [this](const Asked& asked) { return workOut(asked); }, [this](const Answer& answer) { take(answer); },
          [this](const QString& what) { legend_.showNone(tr("could not be worked out:\n%1").arg(what)); }) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(kQuietMs);
    connect(&quiet_, &QTimer::timeout, this, &Confidence::ask);
    legend_.setLeast(memory_.text(kLeast).toInt());
    connect(&legend_, &ConfidenceLegend::leastWanted, this, [this](int percent) {
        memory_.keep(kLeast, QString::number(percent));
        if (made_) ask(); // the images alone
        emit changed();
    });
    connect(&session_, &Session::pictureReady, this, &Confidence::follow);
    connect(&views_, &LinkedViews::edgeColoursChanged, this, [this] {
        legend_.setColours(bandColours(views_.edgeColours() != kUsualColours));
        if (made_) ask();
    });
}

Confidence::~Confidence() { ++wanted_; } // what is under way is given up

void Confidence::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    follow();
}

void Confidence::setLeast(int percent) { legend_.setLeast(percent); }

int Confidence::least() const { return legend_.least(); }

void Confidence::giveWay(bool toAnother) {
    gaveWay_ = toAnother;
    show();
}

std::optional<int> Confidence::at(std::size_t cell) const {
    if (!made_ || cell >= made_->confidence->percent.size()) return std::nullopt;
    const int percent = made_->confidence->percent[cell];
    return percent > 0 ? std::optional(percent) : std::nullopt;
}

/// What was known is of another picture: until the new one is worked out its edges are shown as ever.
void Confidence::follow() {
    ++wanted_;
    quiet_.stop();
    made_ = nullptr;
    if (on_) {
        const auto& picture = session_.picture();
        if (!picture)
            legend_.showNone(tr("open a scan first"));
        else if (picture->source.growth.growing)
            legend_.showNone(tr("when the sweep has ended"));
        else {
            legend_.showWorking(0);
            quiet_.start();
        }
    }
    show();
}

void Confidence::ask() {
    if (!on_ || !session_.picture()) return;
    worker_.post({++wanted_, session_.picture(), legend_.least(), bandColours(views_.edgeColours() != kUsualColours)});
}

Confidence::Answer Confidence::workOut(const Asked& asked) {
    std::shared_ptr<const EdgeConfidence> confidence = last_ && last_->of == asked.picture ? last_->confidence : nullptr;
    if (!confidence) {
        last_ = nullptr; // of a picture that is gone
        const auto goOn = [&](double done) {
            QMetaObject::invokeMethod(
                this,
                [this, number = asked.number, done] {
                    if (number == wanted_) legend_.showWorking(static_cast<int>(100 * done));
                },
                Qt::QueuedConnection);
            return asked.number == wanted_;
        };
        auto found = edgeConfidence(*asked.picture->detection, goOn);
        if (!found) return {asked.number, nullptr};
        confidence = std::make_shared<const EdgeConfidence>(std::move(*found));
    }
    last_ = confidencePicture(asked.picture, confidence, asked.leastPercent, asked.colours);
    return {asked.number, last_};
}

void Confidence::take(const Answer& answer) {
    if (!answer.made || answer.number != wanted_ || !on_) return;
    made_ = answer.made;
    legend_.showMade(*made_);
    show();
}

void Confidence::show() {
    legend_.setVisible(on_ && !gaveWay_);
    std::shared_ptr<EdgesInstead> instead;
    if (made_ && on_ && !gaveWay_) {
        instead = std::make_shared<EdgesInstead>();
        *instead = {made_->cells, bandColours(views_.edgeColours() != kUsualColours), made_->images[0], made_->images[1], nullptr, true};
    }
    // What another one shows there stays.
    if (instead || views_.edgesInstead() == shown_) views_.setEdgesInstead(instead);
    shown_ = std::move(instead);
    emit changed();
}

} // namespace edgescan::ui
