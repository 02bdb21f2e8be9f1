// A worker whose answers arrive on the GUI thread: whatever is newest when the event loop comes to it.
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

/// A member of `receiver`, and the last one of those that `run` uses: its thread is joined before they go. GUI thread only.
template <class Request, class Answer>
class Newest {
public:
    using Run = std::function<Answer(const Request&)>;
    using Deliver = std::function<void(Answer)>;
    using Failed = std::function<void(const QString& what)>;

    /// `run` is called on the worker's thread, `deliver` and `failed` (what `run` threw) on the receiver's.
    Newest(QObject* receiver, Run run, Deliver deliver, Failed failed)
        : deliver_(std::move(deliver)), failed_(std::move(failed)), worker_(std::move(run), [this, receiver] {
              if (told_.exchange(true)) return; // one event at a time takes whatever is newest when it arrives
              QMetaObject::invokeMethod(
                  receiver, [this] { take(); }, Qt::QueuedConnection);
          }) {}

    void post(Request request) { worker_.post(std::move(request)); }

private:
    void take() {
        told_ = false;
        if (const std::string what = worker_.takeFailure(); !what.empty()) failed_(shownText(what));
        if (auto answer = worker_.take()) deliver_(std::move(*answer));
    }

    Deliver deliver_;
    Failed failed_;
    std::atomic<bool> told_{false};
    Worker<Request, Answer> worker_; // last: its thread uses the rest
};

} // namespace edgescan::ui
