// Choices in the menu View: theme, language, mouse, colours of the cloud, sizes of the views and Cab Mode.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

/// A property of the application: the operator closed the window to start the program again; in the end the arguments of that start.
inline constexpr const char* kStartsAgain = "starts-again";

class CabMode;
class CloudView;
class NoticeBar;
class PanePlaces;
class Preferences;
class ScanLook;

/// One entry per theme; the choice is remembered and applied at once.
[[nodiscard]] Command themeMenu(QObject& parent, Preferences& preferences);

/// One entry per language; the choice is remembered for the next start, which is offered.
[[nodiscard]] Command languageMenu(QWidget& window, Preferences& preferences, NoticeBar& notice);
[[nodiscard]] Command mouseMenu(QObject& parent, CloudView& cloud, Preferences& preferences);

/// The colour scales of the cloud.
[[nodiscard]] Command colourMenu(QObject& parent, ScanLook& look);

/// Balanced, images large, cloud large; one key goes to the next.
[[nodiscard]] Command shareMenu(QObject& parent, PanePlaces& places);

/// View > Cab Mode: this command switches it on; only its button, when held, switches it off.
[[nodiscard]] Command cabCommand(CabMode& cab, Preferences& preferences);

} // namespace edgescan::ui
