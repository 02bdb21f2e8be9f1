// Bytes as text of 64 characters (RFC 4648), for HTML pages and JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

[[nodiscard]] std::string base64(std::string_view bytes);
/// Empty if the text is not Base64: another character, or a length that is not a multiple of four.
[[nodiscard]] std::optional<std::string> bytesOfBase64(std::string_view text);

} // namespace edgescan
