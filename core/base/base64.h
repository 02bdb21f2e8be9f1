// Bytes as text of 64 signs (RFC 4648), for pages and JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

[[nodiscard]] std::string base64(std::string_view bytes);
/// Empty when the text is none: another sign, or a length that is no multiple of four.
[[nodiscard]] std::optional<std::string> bytesOfBase64(std::string_view text);

} // namespace edgescan
