// The source and time of the picture on the screen, as shown in its badge (docs/reference/rules.md, "S4").
#pragma once

#include "ui/panels/live/state_badge.h"

#include <QString>
#include <QStringList>

#include <string>

namespace edgescan::ui {

class Engine;
class ScannerLink;
struct Picture;

/// "2026-11-19 08:12:05 UTC"; empty if unknown.
[[nodiscard]] QString timeWords(const std::string& utc);

struct PictureOrigin {
    StateBadge::Sign sign = StateBadge::Sign::Off;
    QString badge; ///< "RECORDED 2026-11-19 08:12:05 UTC"
    QString more;  ///< a tool tip
};

/// Values missing in the file are shown as unknown; none are guessed. While another scan is opened or a scanner is connected, the picture
/// is called an old one.
[[nodiscard]] PictureOrigin originOf(const Engine& engine, const ScannerLink& scanner);

/// The same of what is drawn. `a`: the picture that the engine's is compared with; null: it is not compared. `drawn`: A is on the screen.
[[nodiscard]] PictureOrigin originOfDrawn(const Engine& engine, const ScannerLink& scanner, const Picture* a, bool drawn);

/// The warnings of the scan. That lines are still to come is none: a growing sweep becomes INCOMPLETE when it ends too early.
[[nodiscard]] QStringList warningsOf(const Picture& picture);

} // namespace edgescan::ui
