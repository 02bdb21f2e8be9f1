// A value, or one sentence for a person that says why there is none.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace edgescan {

/// Why the outside world said no. `where` is a path, "path:line 12", "path: byte 96" or a host; it may be empty.
struct Error {
    std::string what;  ///< what is wrong, without a final stop
    std::string where; ///< where it is wrong
    std::string hint;  ///< what the person can do about it, without a final stop

    /// "where: what; hint.", printable and short whatever a file or a name put into it (foreign_text.h).
    [[nodiscard]] std::string sentence() const;
};

/// Used wherever the outside world can say no: files, sockets, telegrams, settings text.
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

/// The value of a Result that has nothing to carry but success.
struct Done {};

} // namespace edgescan
