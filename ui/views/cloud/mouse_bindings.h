// Actions of mouse buttons and the wheel in the cloud view.
#pragma once

#include <Qt>

namespace edgescan::ui {

enum class MousePreset { Default, CloudCompare };
enum class DragAction { None, Rotate, Pan, Zoom, Roll, Select };
enum class WheelAction { Zoom, PointSize, NearClip, FarClip };

[[nodiscard]] DragAction dragAction(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, MousePreset preset = MousePreset::Default);
[[nodiscard]] WheelAction wheelAction(Qt::KeyboardModifiers modifiers);

} // namespace edgescan::ui
