// A report in the language of the window.
#pragma once

#include <string>

namespace edgescan::ui {

/// The texts of an HTML page of exports::scanPage() in the language of the window. What an operator wrote, names, numbers and commands
/// stay.
[[nodiscard]] std::string reportInLanguage(const std::string& page, const std::string& language);

} // namespace edgescan::ui
