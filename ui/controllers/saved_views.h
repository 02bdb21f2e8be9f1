// Views of the cloud that the operator stored, for the scan on the screen.
#pragma once

#include "ui/views/cloud/camera_motion.h"

#include <QObject>
#include <QString>

#include <array>
#include <optional>

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;

/// GUI thread only. The objects passed to it must outlive it.
class SavedViews : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 9;

    SavedViews(LinkedViews& views, NoticeBar& notice);

    /// `number`: 1 to kMost.
    void store(int number);
    void recall(int number);
    [[nodiscard]] const std::optional<CameraPose>& view(int number) const { return views_[static_cast<std::size_t>(number - 1)]; }
    /// All views as text for a session, and back; views that the text does not have are forgotten.
    [[nodiscard]] QString text() const;
    void use(const QString& text);

signals:
    void changed();

private:
    LinkedViews& linked_;
    NoticeBar& notice_;
    std::array<std::optional<CameraPose>, kMost> views_;
};

} // namespace edgescan::ui
