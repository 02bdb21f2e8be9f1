// Finds the rocks of a detection on its own thread.
#include "ui/panels/rocks/rock_finder.h"

namespace edgescan::ui {

RockFinder::RockFinder(QObject* parent)
    : QObject(parent), worker_(
                           this, [this](const Asked& asked) { return run(asked); },
                           [this](const Answer& answer) {
                               behind_ = answer.number != asked_;
                               emit found(answer.picture);
                           },
                           [this](const QString& what) {
                               behind_ = false;
                               emit failed(what);
                           }) {}

void RockFinder::ask(const RockQuestion& question) {
    behind_ = true;
    worker_.post({++asked_, question});
}

RockFinder::Answer RockFinder::run(const Asked& asked) {
    const RockQuestion& question = asked.question;
    try {
        if (detection_ != question.detection) {
            detection_ = nullptr;
            inputs_ = rocks::rockInputs(*question.detection);
            detection_ = question.detection;
        }
        last_ =
            rockPicture(question.detection, rocks::studyRocks(inputs_, question.settings, question.edits, last_ ? &last_->study : nullptr));
    } catch (...) { // an interrupted computation starts again from the beginning
        detection_ = nullptr;
        last_ = nullptr;
        throw;
    }
    return {asked.number, last_};
}

} // namespace edgescan::ui
