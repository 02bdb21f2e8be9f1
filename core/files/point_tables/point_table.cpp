// What every reader of points needs of the table it fills.
#include "core/files/point_tables/point_table.h"

namespace edgescan::files {

bool addToDescription(std::string_view comment, std::string& description) {
    while (comment.starts_with(' ')) comment.remove_prefix(1);
    while (comment.ends_with(' ') || comment.ends_with('\r')) comment.remove_suffix(1);
    constexpr std::string_view kOurs = "edgescan ";
    if (!comment.starts_with(kOurs)) return false;
    comment.remove_prefix(kOurs.size());
    if (description.empty() && !comment.starts_with('{')) return false;
    description += comment;
    return true;
}

} // namespace edgescan::files
