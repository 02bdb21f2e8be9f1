// The list of what runs.
#include "ui/engine/worker_bridge/works.h"

#include <array>
#include <utility>

namespace edgescan::ui {
namespace {

// Their texts for the translations (tests/ui/languages_test.cpp compares them with the core's).
[[maybe_unused]] constexpr std::array kStages{
    QT_TRANSLATE_NOOP("QObject", "opened"),
    QT_TRANSLATE_NOOP("QObject", "reading"),
    QT_TRANSLATE_NOOP("QObject", "reading points"),
    QT_TRANSLATE_NOOP("QObject", "reading ranges"),
    QT_TRANSLATE_NOOP("QObject", "reading the picture"),
    QT_TRANSLATE_NOOP("QObject", "unpacking"),
    QT_TRANSLATE_NOOP("QObject", "finding telegrams"),
    QT_TRANSLATE_NOOP("QObject", "putting packets together"),
    QT_TRANSLATE_NOOP("QObject", "grid"),
    QT_TRANSLATE_NOOP("QObject", "finding the grid"),
    QT_TRANSLATE_NOOP("QObject", "finding the axis"),
    QT_TRANSLATE_NOOP("QObject", "projecting the points"),
    QT_TRANSLATE_NOOP("QObject", "placing the points"),
    QT_TRANSLATE_NOOP("QObject", "finding edges"),
    QT_TRANSLATE_NOOP("QObject", "drawing"),
};

} // namespace

QString stageWords(const char* stage) { return QObject::tr(stage); }

Works::Running::Running(Works& works, QString its, std::function<void()> cancelled)
    : title(std::move(its)), cancel(std::move(cancelled)), works_(&works) {
    works.running_.push_back(this);
    emit works.changed();
}

Works::Running::~Running() {
    if (works_.isNull()) return;
    std::erase(works_->running_, this);
    emit works_->changed();
}

void Works::Running::progress(const QString& now, double share) {
    stage = now;
    fraction = share;
    if (!works_.isNull()) emit works_->changed();
}

std::unique_ptr<Works::Running> Works::start(const QString& title, std::function<void()> cancel) {
    return std::make_unique<Running>(*this, title, std::move(cancel));
}

bool Works::cancel() {
    if (running_.empty()) return false;
    const std::function<void()> chosen = running_.back()->cancel; // the work may end during the call
    chosen();
    return true;
}

void Works::cancelAll() {
    std::vector<std::function<void()>> all; // work may end during the calls
    for (const Running* work : running_) all.push_back(work->cancel);
    for (const auto& cancel : all) cancel();
}

} // namespace edgescan::ui

#include "moc_works.cpp"
