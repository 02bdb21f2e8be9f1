// The words that comments and documents do not use (CONTRIBUTING.md, "Words").
#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <utility>

namespace edgescan::test {

/// A banned word of a text and its line, counted from the first one; an empty word if there is none. Text in quotes or backquotes is a
/// message or an identifier, and does not count.
inline std::pair<std::string, std::size_t> bannedWord(const std::string& written) {
    static const std::regex quoted("\"[^\"]*\"|`[^`]*`");
    static const std::regex banned(
        R"(\b(told|tells?|stands?|lies|sits?|sittings?|beside|anew|nobody|somebody|whoever|none\s+of|(there\s+)?(is|are)\s+no(?!\s+longer)|or\s+none)\b(?!-))",
        std::regex::icase);
    std::string text = written;
    for (std::smatch match; std::regex_search(text, match, quoted);) {
        const std::size_t at = static_cast<std::size_t>(match.position());
        for (std::size_t i = at; i < at + static_cast<std::size_t>(match.length()); ++i)
            if (text[i] != '\n') text[i] = '_';
    }
    for (std::sregex_iterator it(text.begin(), text.end(), banned), end; it != end; ++it) {
        if ((*it)[2].matched) continue; // "there is no" is plain English
        const auto until = text.begin() + it->position();
        return {it->str(), static_cast<std::size_t>(std::count(text.begin(), until, '\n'))};
    }
    return {};
}

} // namespace edgescan::test
