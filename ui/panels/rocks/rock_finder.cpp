// Finds the rocks of a detection off the GUI thread.
#include "ui/panels/rocks/rock_finder.h"

namespace edgescan::ui {

RockFinder::RockFinder(QObject* parent)
    : QObject(parent), rocks_(
                           Urgency::Soon, [this](const RockQuestion& question) { return run(question); },
                           [this](const RockQuestion&, const std::shared_ptr<const RockPicture>& picture) { emit found(picture); },
                           [this](const QString& what) { emit failed(what); }, Older::Delivered) {}

void RockFinder::ask(const RockQuestion& question) { rocks_.ask(question); }

void RockFinder::forget() { rocks_.ask({}); }

std::shared_ptr<const RockPicture> RockFinder::run(const RockQuestion& question) {
    try {
        if (detection_ != question.detection) {
            detection_ = nullptr;
            inputs_ = question.detection ? rocks::rockInputs(*question.detection) : rocks::Inputs{};
            detection_ = question.detection;
        }
        if (!detection_) return last_ = nullptr;
        last_ =
            rockPicture(question.detection, rocks::studyRocks(inputs_, question.settings, question.edits, last_ ? &last_->study : nullptr),
                        question.filter);
    } catch (...) { // an interrupted computation starts again from the beginning
        detection_ = nullptr;
        last_ = nullptr;
        throw;
    }
    return last_;
}

} // namespace edgescan::ui

#include "moc_rock_finder.cpp"
