// Runs work on its own thread.
#include "ui/engine/worker_bridge/in_background.h"

#include <QMetaObject>

#include <exception>
#include <thread>
#include <utility>

namespace edgescan::ui {
namespace {

/// A child of the caller's parent: the parent's destructor waits for the work.
class Job : public QObject {
public:
    Job(QObject* parent, std::function<void(Job*)> run) : QObject(parent), thread_([this, run = std::move(run)] { run(this); }) {}
    ~Job() override { thread_.join(); }

private:
    std::thread thread_;
};

} // namespace

void inBackground(QObject* parent, std::function<std::function<void()>()> work, std::function<void(const QString& what)> crashed,
                  std::function<void()> ended) {
    new Job(parent, [work = std::move(work), crashed = std::move(crashed), ended = std::move(ended)](Job* job) {
        std::function<void()> deliver;
        try {
            deliver = work();
        } catch (const std::exception& error) {
            deliver = [crashed, what = QString::fromUtf8(error.what())] { crashed(what); };
        }
        QMetaObject::invokeMethod(
            job,
            [job, deliver = std::move(deliver), ended] {
                if (deliver) deliver();
                ended();
                job->deleteLater();
            },
            Qt::QueuedConnection);
    });
}

} // namespace edgescan::ui
