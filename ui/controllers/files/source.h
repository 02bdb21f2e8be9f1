// Where the picture on the screen comes from, and of when: what its badge says (docs/operator.md, "S4").
#pragma once

#include "ui/panels/live/state_badge.h"

#include <QString>

namespace edgescan::ui {

class ScannerLink;
struct Picture;

struct PictureOrigin {
    StateBadge::Sign sign = StateBadge::Sign::Off;
    QString badge; ///< "RECORDED 2026-11-19 08:12:05 UTC"
    QString more;  ///< a tool tip
};

/// `picture`: null = none yet. Nothing is made up: what the file does not say is told as not known.
[[nodiscard]] PictureOrigin originOf(const Picture* picture, const ScannerLink& scanner);

} // namespace edgescan::ui
