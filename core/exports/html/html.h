// The parts of which pages are made. Text from outside gets into a page through these alone.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace edgescan::exports {

/// Text as it may stand between tags and in attributes: markup characters as &lt; and the like, controls as printable() writes them.
[[nodiscard]] std::string htmlText(std::string_view text);

/// JSON as it may stand in a script: no "<" that could end it.
[[nodiscard]] std::string scriptJson(const nlohmann::ordered_json& json);

/// A picture within the page, from PNG bytes; a sentence where there are none.
[[nodiscard]] std::string htmlImage(const std::string& png, const std::string& alternative);

/// A whole page. `body` and `script` are markup and code already. The page may load nothing from anywhere: its own policy says so.
[[nodiscard]] std::string htmlPage(const std::string& title, const std::string& body, const std::string& script);

/// Scripts of assets/: they read what stands in the elements "data".
[[nodiscard]] const char* surveyScript();
[[nodiscard]] const char* reportScript();

} // namespace edgescan::exports
