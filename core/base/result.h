// A value, or one sentence for a person that says why there is no value.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace edgescan {

/// The reason why something outside the program failed. `where` is a path, "path:line 12", "path: byte 96" or a host; it may be empty.
struct Error {
    std::string what;  ///< the fault, without a final full stop
    std::string where; ///< the place of the fault
    std::string hint;  ///< the remedy, without a final full stop

    /// "where: what; hint.", printable and short, whatever a file or a name contains (foreign_text.h).
    [[nodiscard]] std::string sentence() const;
};

/// Used wherever something outside the program can fail: files, sockets, telegrams, text of settings.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }
    T& operator*() { return std::get<0>(content_); }
    const T& operator*() const { return std::get<0>(content_); }
    T* operator->() { return &std::get<0>(content_); }
    const T* operator->() const { return &std::get<0>(content_); }
    [[nodiscard]] const Error& error() const { return std::get<1>(content_); }

private:
    std::variant<T, Error> content_;
};

/// The value of a Result that reports only success.
struct Done {};

} // namespace edgescan
