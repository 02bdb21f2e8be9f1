// A worker whose answers arrive on the GUI thread; only the newest answer is delivered.
#pragma once

#include "core/base/worker.h"
#include "ui/base/shown_text.h"

#include <QMetaObject>
#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <utility>

namespace edgescan::ui {

/// A member of `receiver`. It must be declared after all members that `run` uses: its thread is joined before they are destroyed. GUI
/// thread only.
template <class Request, class Answer>
class Newest {
public:
    using Run = std::function<Answer(const Request&)>;
    using Deliver = std::function<void(Answer)>;
    using Failed = std::function<void(const QString& what)>;

    /// `run` is called on the worker's thread; `deliver` and `failed` (with the text of an exception of `run`) are called on the receiver's
    /// thread.
    Newest(QObject* receiver, Run run, Deliver deliver, Failed failed)
        : deliver_(std::move(deliver)), failed_(std::move(failed)), worker_(std::move(run), [this, receiver] {
              if (notified_.exchange(true)) return; // one event is pending at a time; it takes the newest answer when it arrives
              QMetaObject::invokeMethod(
                  receiver, [this] { take(); }, Qt::QueuedConnection);
          }) {}

    void post(Request request) { worker_.post(std::move(request)); }

private:
    void take() {
        notified_ = false;
        if (const std::string what = worker_.takeFailure(); !what.empty()) failed_(shownText(what));
        if (auto answer = worker_.take()) deliver_(std::move(*answer));
    }

    Deliver deliver_;
    Failed failed_;
    std::atomic<bool> notified_{false};
    Worker<Request, Answer> worker_; // last member: its thread uses the members above
};

} // namespace edgescan::ui
