// The parts of HTML pages. Text from outside enters a page only through these functions.
#pragma once

#include "core/base/rgb.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace edgescan::exports {

/// Text for use between tags and in attributes: markup characters become &lt; and the like, control characters become what printable()
/// writes.
[[nodiscard]] std::string htmlText(std::string_view text);

/// "1,136,154", as the window writes counts in English.
[[nodiscard]] std::string groupedText(std::size_t count);

[[nodiscard]] std::string legendEntry(const Rgb& colour, const std::string& words);

/// JSON for use in a script: without "<", which could end the script.
[[nodiscard]] std::string scriptJson(const nlohmann::ordered_json& json);

/// "2026-11-20 10:00:40 UTC" for a time in ISO 8601; any other text as it is.
[[nodiscard]] std::string plainUtc(const std::string& time);

/// A picture inside the page, from PNG bytes; a sentence if `png` is empty.
[[nodiscard]] std::string htmlImage(const std::string& png, const std::string& alternative);

/// A whole page. `body` and `script` must already be markup and code. The page's own policy forbids loading anything.
[[nodiscard]] std::string htmlPage(const std::string& title, const std::string& body, const std::string& script);

/// Scripts of assets/: they read the elements "data".
[[nodiscard]] const char* surveyScript();
[[nodiscard]] const char* reportScript();

} // namespace edgescan::exports
