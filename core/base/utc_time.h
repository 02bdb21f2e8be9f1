// Times as text: ISO 8601 in UTC, "2026-11-20T10:15:30.250Z". As numbers: seconds since 1970-01-01T00:00:00Z.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// Times in nanoseconds since 1970 have these bounds, from 13 days before 1970 to 2262-03-29, so that every difference of two fits 64 bits.
inline constexpr std::int64_t kEarliestNs = -(std::int64_t{1} << 50U);
inline constexpr std::int64_t kLatestNs = std::numeric_limits<std::int64_t>::max() + kEarliestNs;

/// Empty if the text is not such a time. Digits after the second are optional, the Z is not.
[[nodiscard]] std::optional<double> parseUtc(std::string_view text);

/// With milliseconds; empty for a number that is not a time.
[[nodiscard]] std::string utcText(double seconds);

/// Now, by the computer's clock.
[[nodiscard]] double utcNow();

} // namespace edgescan
