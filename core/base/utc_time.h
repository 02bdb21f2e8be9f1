// Times as text: ISO 8601 in UTC, "2026-11-20T10:15:30.250Z". As numbers: seconds since 1970-01-01T00:00:00Z.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// Empty if the text is not such a time. Digits after the second are optional, the Z is not.
[[nodiscard]] std::optional<double> parseUtc(std::string_view text);

/// With milliseconds; empty for a number that is not a time.
[[nodiscard]] std::string utcText(double seconds);

/// Now, by the computer's clock.
[[nodiscard]] double utcNow();

} // namespace edgescan
