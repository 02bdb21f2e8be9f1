// One piece of work on a thread of its own.
#include "ui/session/background_job.h"

#include <QMetaObject>

#include <chrono>
#include <exception>

namespace edgescan::ui {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBetweenProgress = std::chrono::milliseconds(40);

} // namespace

BackgroundJob::BackgroundJob(Work work, QObject* parent) : QObject(parent), cancelled_(std::make_shared<std::atomic<bool>>(false)) {
    const auto cancelled = cancelled_;
    thread_ = std::thread([this, cancelled, work = std::move(work)] {
        QString lastStage;
        Clock::time_point lastTold;
        const Progress progress = [&](const char* stage, double fraction) {
            const Clock::time_point now = Clock::now();
            const QString name = QString::fromUtf8(stage);
            if (name != lastStage || now - lastTold >= kBetweenProgress) {
                lastStage = name;
                lastTold = now;
                QMetaObject::invokeMethod(
                    this, [this, name, fraction] { emit progressed(name, fraction); }, Qt::QueuedConnection);
            }
            return !*cancelled;
        };
        std::function<void()> deliver;
        try {
            deliver = work(progress);
        } catch (const std::exception& error) {
            deliver = [this, what = QString::fromUtf8(error.what())] { emit crashed(what); };
        }
        QMetaObject::invokeMethod(
            this,
            [this, cancelled, deliver] {
                if (!*cancelled && deliver) deliver();
                emit ended();
            },
            Qt::QueuedConnection);
    });
}

BackgroundJob::~BackgroundJob() {
    *cancelled_ = true;
    thread_.join();
}

void BackgroundJob::cancel() { *cancelled_ = true; }

} // namespace edgescan::ui
