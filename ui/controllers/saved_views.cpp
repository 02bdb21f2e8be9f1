// Stores and gives back cameras.
#include "ui/controllers/saved_views.h"

#include "ui/base/notice_bar.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"

#include <QStringList>

#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kNumbersOfView = 12; // number of the view, position, focus, up, angle, parallel

std::optional<CameraPose> poseOf(const QStringList& words) {
    std::array<double, kNumbersOfView> n{};
    for (int i = 0; i < kNumbersOfView; ++i) {
        bool good = false;
        n[static_cast<std::size_t>(i)] = words[i].toDouble(&good);
        if (!good || !std::isfinite(n[static_cast<std::size_t>(i)])) return std::nullopt;
    }
    CameraPose pose{{n[1], n[2], n[3]}, {n[4], n[5], n[6]}, {n[7], n[8], n[9]}, n[10], n[11] != 0.0};
    const bool usable =
        pose.distance() > 0.0 && std::abs(pose.up.norm() - 1.0) < 1e-3 && pose.viewAngleDeg > 0.0 && pose.viewAngleDeg < 180.0;
    return usable ? std::optional(pose) : std::nullopt;
}

} // namespace

SavedViews::SavedViews(LinkedViews& views, NoticeBar& notice) : linked_(views), notice_(notice) {
    connect(&views, &LinkedViews::newScanShown, this, [this](bool atSamePlaces) {
        if (!atSamePlaces) views_ = {};
    });
}

void SavedViews::store(int number) {
    if (!linked_.shown()) return;
    views_[static_cast<std::size_t>(number - 1)] = linked_.cloud().camera();
    notice_.showNotice(NoticeBar::Kind::Done, tr("View %1 is stored.").arg(number));
    emit changed();
}

void SavedViews::recall(int number) {
    if (!linked_.shown()) return;
    if (const auto& pose = view(number)) {
        linked_.cloud().setParallel(pose->parallel); // also for the switch in the menu
        return linked_.cloud().setCamera(*pose);
    }
    notice_.showHint(tr("There is no view %1 yet: Ctrl+%1 stores the present one.").arg(number));
}

QString SavedViews::text() const {
    QStringList words;
    for (int number = 1; number <= kMost; ++number) {
        if (!view(number)) continue;
        const CameraPose& pose = *view(number);
        words << QString::number(number);
        for (const Eigen::Vector3d* each : {&pose.position, &pose.focus, &pose.up}) {
            for (const double value : *each) words << QString::number(value, 'g', 9);
        }
        words << QString::number(pose.viewAngleDeg, 'g', 9) << (pose.parallel ? "1" : "0");
    }
    return words.join(' ');
}

void SavedViews::use(const QString& text) {
    views_ = {};
    const QStringList words = text.split(' ', Qt::SkipEmptyParts);
    for (int from = 0; from + kNumbersOfView <= words.size(); from += kNumbersOfView) {
        const int number = words[from].toInt();
        if (number < 1 || number > kMost) continue;
        views_[static_cast<std::size_t>(number - 1)] = poseOf(words.mid(from, kNumbersOfView));
    }
}

} // namespace edgescan::ui

#include "moc_saved_views.cpp"
