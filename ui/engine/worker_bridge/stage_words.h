// The stages of reading a scan and making its picture, in the language of the window.
#pragma once

#include <QString>

namespace edgescan::ui {

/// `stage`: as the core names it.
[[nodiscard]] QString stageWords(const char* stage);

} // namespace edgescan::ui
