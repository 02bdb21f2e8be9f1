// The source and time of the picture on the screen, as shown in its badge (docs/reference/rules.md, "S4").
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

/// `picture`: null = no picture yet. Values missing in the file are shown as unknown; none are guessed.
[[nodiscard]] PictureOrigin originOf(const Picture* picture, const ScannerLink& scanner);

} // namespace edgescan::ui
