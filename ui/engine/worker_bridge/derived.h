// What is worked out off the GUI thread from values that may change: the newest question wins.
#pragma once

#include "core/base/work_pool.h"
#include "ui/base/shown_text.h"

#include <QMetaObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace edgescan::ui {

/// Who asked, for the function that works out the answer. Any thread.
class Asker {
public:
    Asker(QObject& gui, const std::atomic<std::uint64_t>& oldest, std::uint64_t number) : gui_(gui), oldest_(oldest), number_(number) {}

    /// False: a newer question was asked or this one was given up, so the work may end.
    [[nodiscard]] bool waits() const { return number_ >= oldest_; }
    /// Calls `show` on the GUI thread, in the order of the calls and before the answer is delivered, if it is still wanted then. As
    /// waits().
    bool show(std::function<void()> show) const {
        QMetaObject::invokeMethod(
            &gui_,
            [asker = *this, show = std::move(show)] {
                if (asker.waits()) show();
            },
            Qt::QueuedConnection);
        return waits();
    }

private:
    QObject& gui_;
    const std::atomic<std::uint64_t>& oldest_;
    std::uint64_t number_;
};

/// Of an answer that came after a newer question was asked.
enum class Older { Dropped, Delivered };

/// In: a value, what is large in it by shared_ptr<const T>. GUI thread only; the answers are worked out on the shared pool, one at a time,
/// so what `make` uses needs no lock. A member, and the last of those that `make` uses: its destructor waits for what is under way.
template <class In, class Out>
class Derived {
public:
    using Made = std::shared_ptr<const Out>;
    using Deliver = std::function<void(const In& asked, const Made& made)>;
    using Failed = std::function<void(const QString& what)>;

    /// `make`: (const In&) or (const In&, const Asker&), returns Out or Made; a null Made is not delivered. Pool's thread. `deliver` and
    /// `failed`, which gets what `make` threw: GUI thread.
    template <class Make>
    Derived(Urgency urgency, Make make, Deliver deliver, Failed failed, Older older = Older::Dropped)
        : make_(wrapped(std::move(make))), deliver_(std::move(deliver)), failed_(std::move(failed)), older_(older),
          lane_(WorkPool::shared(), urgency) {
        quiet_.setSingleShot(true);
        QObject::connect(&quiet_, &QTimer::timeout, &quiet_, [this] { start(); });
    }
    ~Derived() { end(); }
    Derived(const Derived&) = delete;
    Derived& operator=(const Derived&) = delete;

    /// Starts when no other question was asked for so long.
    void ask(In question, std::chrono::milliseconds quiet = {}) {
        question_ = std::make_shared<const In>(std::move(question));
        ++asked_;
        if (older_ == Older::Dropped) oldest_ = asked_;
        quiet_.stop();
        if (quiet.count() > 0)
            quiet_.start(quiet);
        else
            start();
    }
    /// Where there is no question any more, as for a sweep that grows: nothing that was asked is delivered.
    void giveUp() {
        quiet_.stop();
        question_ = nullptr;
        lane_.drop();
        oldest_ = asked_ + 1;
        settled_ = asked_;
    }

    /// For a destructor that finishes the work itself: nothing runs or is delivered afterwards; behind() stays as it was.
    void end() {
        quiet_.stop();
        oldest_ = std::numeric_limits<std::uint64_t>::max();
        lane_.end();
    }

    /// The newest question has no answer yet: what is shown is older.
    [[nodiscard]] bool behind() const { return asked_ != settled_; }
    /// It has not even started: its quiet time runs.
    [[nodiscard]] bool waiting() const { return quiet_.isActive(); }

private:
    using Make = std::function<Made(const In&, const Asker&)>;
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const In> question;
        Made made;
        std::string failure;
    };

    template <class Given>
    static Make wrapped(Given given) {
        return [given = std::move(given)](const In& question, const Asker& asker) -> Made {
            const auto call = [&]() -> decltype(auto) {
                if constexpr (std::is_invocable_v<const Given&, const In&, const Asker&>)
                    return given(question, asker);
                else
                    return given(question);
            };
            if constexpr (std::is_convertible_v<decltype(call()), Made>)
                return call();
            else
                return std::make_shared<const Out>(call());
        };
    }

    void start() {
        lane_.post([this, number = asked_, question = std::exchange(question_, nullptr)] { work(number, question); });
    }

    // Pool's thread.
    void work(std::uint64_t number, const std::shared_ptr<const In>& question) {
        const Asker asker(quiet_, oldest_, number);
        if (!asker.waits()) return;
        std::optional<Answer> answer(Answer{number, question, nullptr, {}});
        try {
            answer->made = make_(*question, asker);
        } catch (const std::exception& error) {
            answer->failure = error.what();
        }
        {
            const std::lock_guard lock(mutex_);
            std::swap(unread_, answer); // the one before, if it was not read, is freed below
        }
        QMetaObject::invokeMethod(
            &quiet_, [this, number] { deliverAnswer(number); }, Qt::QueuedConnection);
    }

    void deliverAnswer(std::uint64_t number) {
        std::optional<Answer> answer;
        {
            const std::lock_guard lock(mutex_);
            if (!unread_ || unread_->number != number) return; // a newer one follows
            std::swap(unread_, answer);
        }
        if (number < oldest_) return;
        if (number == asked_) settled_ = number;
        if (!answer->failure.empty())
            failed_(shownText(answer->failure));
        else if (answer->made)
            deliver_(*answer->question, answer->made);
    }

    Make make_;
    Deliver deliver_;
    Failed failed_;
    const Older older_;
    QTimer quiet_;                          // also the object that events for the GUI thread are sent to: they end with it
    std::shared_ptr<const In> question_;    // while its quiet time runs: what is large in it is freed with the answer
    std::uint64_t asked_ = 0, settled_ = 0; // numbers of questions: the newest, the newest that has its answer or was given up
    std::atomic<std::uint64_t> oldest_{1};  // number of the oldest question whose answer is wanted
    std::mutex mutex_;
    std::optional<Answer> unread_;
    Lane lane_; // last: what runs in it uses the rest
};

} // namespace edgescan::ui
