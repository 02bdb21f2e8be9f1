// One piece of work on a thread of its own, with progress, cancel and a result that arrives on the GUI thread.
#pragma once

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace edgescan::ui {

/// GUI thread only. Destroying it cancels and waits for the work to notice.
class BackgroundJob : public QObject {
    Q_OBJECT
public:
    /// Tells stage and share done (0..1); false = stop as soon as possible.
    using Progress = std::function<bool(const char* stage, double fraction)>;
    /// Runs on the job's thread; what it returns is called on the GUI thread, unless the job was cancelled.
    using Work = std::function<std::function<void()>(const Progress&)>;

    BackgroundJob(Work work, QObject* parent);
    ~BackgroundJob() override;

    void cancel();
    [[nodiscard]] bool cancelled() const { return *cancelled_; }

signals:
    void progressed(const QString& stage, double fraction);
    /// The work threw; there is no result.
    void crashed(const QString& what);
    /// After the result was delivered or dropped; the job may be deleted.
    void ended();

private:
    std::shared_ptr<std::atomic<bool>> cancelled_;
    std::thread thread_;
};

} // namespace edgescan::ui
