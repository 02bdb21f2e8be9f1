// Sentences of the core that the window shows in its own language.
#pragma once

#include <initializer_list>
#include <string>

namespace edgescan {

/// A text in another language; asWritten() is English.
using Translated = std::string (*)(const char* text);
[[nodiscard]] inline std::string asWritten(const char* text) { return text; }

/// `words` with the values in place of %1, %2 ...
[[nodiscard]] std::string withValues(const std::string& words, std::initializer_list<std::string> values);

} // namespace edgescan
