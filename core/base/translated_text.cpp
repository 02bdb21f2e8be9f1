// Places of values in sentences.
#include "core/base/translated_text.h"

#include <cstddef>

namespace edgescan {

std::string withValues(const std::string& words, std::initializer_list<ValueText> values) {
    std::string text;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const char next = at + 1 < words.size() ? words[at + 1] : ' ';
        const bool isPlace = words[at] == '%' && next >= '1' && next <= '9' && static_cast<std::size_t>(next - '1') < values.size();
        if (isPlace)
            text += values.begin()[next - '1'].text, ++at;
        else
            text += words[at];
    }
    return text;
}

} // namespace edgescan
