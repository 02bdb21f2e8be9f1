// Sentences of the core that the window shows in its own language.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <utility>

namespace edgescan {

/// A text in another language; asWritten() is English.
using Translated = std::string (*)(const char* text);
[[nodiscard]] inline std::string asWritten(const char* text) { return text; }

/// A value in a sentence: a text or a whole number.
struct ValueText {
    ValueText(std::string words) : text(std::move(words)) {}
    ValueText(const char* words) : text(words) {}
    template <std::integral Number>
    requires(!std::same_as<Number, char> && !std::same_as<Number, bool>) ValueText(Number number) : text(std::to_string(number)) {}

    std::string text;
};

/// A sentence of the core: `words` with the values in place of %1, %2 ... The window finds its pattern among those that
/// resources/languages/collect collects, and says it in its language.
[[nodiscard]] std::string withValues(const std::string& words, std::initializer_list<ValueText> values);

} // namespace edgescan
