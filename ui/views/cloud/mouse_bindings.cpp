// Actions of mouse buttons and the wheel in the cloud view.
#include "ui/views/cloud/mouse_bindings.h"

namespace edgescan::ui {

DragAction dragAction(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, MousePreset preset) {
    if (button == Qt::LeftButton) {
        if (modifiers & Qt::ShiftModifier) return DragAction::Pan;
        if (modifiers & Qt::ControlModifier) return DragAction::Roll;
        return DragAction::Rotate;
    }
    const bool cloudCompare = preset == MousePreset::CloudCompare;
    if (button == Qt::MiddleButton) return cloudCompare ? DragAction::Zoom : DragAction::Pan;
    if (button == Qt::RightButton) return cloudCompare ? DragAction::Pan : DragAction::Zoom;
    return DragAction::None;
}

WheelAction wheelAction(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return modifiers & Qt::ShiftModifier ? WheelAction::FarClip : WheelAction::NearClip;
    if (modifiers & Qt::AltModifier) return WheelAction::PointSize;
    return WheelAction::Zoom;
}

} // namespace edgescan::ui
