// The window's colours: dark, so that the pictures are the brightest thing on the screen.
#pragma once

class QApplication;

namespace edgescan::ui {

void useTheme(QApplication& application);

} // namespace edgescan::ui
