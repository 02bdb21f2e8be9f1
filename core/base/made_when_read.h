// A value that is made when it is first read: not everyone who gets it needs it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace edgescan {

/// Copies share the value. Any thread. Equal: the same value, made or not.
template <class T>
class MadeWhenRead {
public:
    MadeWhenRead() = default; ///< nothing to read
    explicit MadeWhenRead(std::function<T()> make) : state_(std::make_shared<State>(std::move(make))) {}

    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(state_); }
    [[nodiscard]] bool isMade() const { return state_->made.load(std::memory_order_acquire) != nullptr; }
    [[nodiscard]] const T& operator*() const {
        if (const T* made = state_->made.load(std::memory_order_acquire)) return *made;
        std::call_once(state_->once, [this] {
            state_->made.store(&state_->value.emplace(state_->make()), std::memory_order_release);
            state_->make = nullptr;
        });
        return *state_->value;
    }
    [[nodiscard]] const T* operator->() const { return &**this; }
    [[nodiscard]] bool operator==(const MadeWhenRead& other) const { return state_.get() == other.state_.get(); }

private:
    struct State {
        explicit State(std::function<T()> how) : make(std::move(how)) {}
        std::function<T()> make;
        std::once_flag once;
        std::optional<T> value;
        std::atomic<const T*> made{nullptr};
    };
    std::shared_ptr<State> state_;
};

} // namespace edgescan
