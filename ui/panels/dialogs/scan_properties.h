// What is known of a scan, as a page for a person.
#pragma once

#include <QString>

namespace edgescan {
struct Scan;
}

namespace edgescan::ui {

/// Html: a table of names and values.
[[nodiscard]] QString scanProperties(const Scan& scan);

} // namespace edgescan::ui
