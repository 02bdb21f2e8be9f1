// Bytes as text of 64 characters (RFC 4648), for HTML pages and JSON.
#pragma once

#include <string>
#include <string_view>

namespace edgescan {

[[nodiscard]] std::string base64(std::string_view bytes);

} // namespace edgescan
