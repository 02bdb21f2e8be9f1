// The heading is the first row that names x, y and z.
#include "core/files/point_tables/row_below_names.h"

#include "core/base/number_text.h"
#include "core/files/point_tables/number_groups.h"
#include "core/files/point_tables/text_words.h"

#include <utility>

namespace edgescan::files {

std::vector<std::string> namesIn(std::string_view header, const TextLayout& layout) {
    std::vector<std::string> names;
    for (const std::string_view cell : cellsIn(header, layout)) {
        const bool unit = layout.separator == ' ' && (cell.starts_with('(') || cell.starts_with('[')) && !names.empty(); // "x (m)"
        if (unit) {
            names.back() += cell;
            continue;
        }
        names.push_back(asciiLower(cell));
    }
    return names;
}

std::optional<RowBelowNames> rowBelowNames(std::string_view text, char separator) {
    TextLayout layout;
    layout.separator = separator;
    RowBelowNames found;
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (std::size_t number = 1; at < text.size() && number <= kSampleRows; ++number) {
        const TextLine line = textLineAt(text, at);
        const std::size_t from = std::exchange(at, line.next);
        if (line.text.size() > kLongestRowLookedAt || trimmed(line.text).empty()) continue;
        if (!found.named.hasPoint()) {
            found.names = namesIn(line.text, layout);
            found.named = columnsNamed(found.names);
            continue;
        }
        found.cells = cellsIn(line.text, layout);
        found.firstByte = from;
        found.firstLine = number;
        return found;
    }
    return std::nullopt;
}

} // namespace edgescan::files
