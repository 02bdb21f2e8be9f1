// What is shown of a scan that was open before: a small picture and a line of words, kept in a folder of their own.
#pragma once

#include <QImage>
#include <QString>

#include <functional>

namespace edgescan::ui {

struct RecentScan {
    QString path;
    bool there = false; ///< the file
    QString words;      ///< "2026-11-19 08:12 UTC · 1,000 lines · RECORDED"; of one that cannot be read, why
    QImage picture;     ///< null where there is none

    bool operator==(const RecentScan&) const = default;
};

inline constexpr int kThumbnailPx = 132; ///< longest side

/// Reads the scan where its picture is not kept in `cache` yet, or the file is another one since; false from `goOn` ends it. For any
/// thread.
[[nodiscard]] RecentScan recentScan(const QString& path, const QString& cache, const std::function<bool()>& goOn);
/// The oldest pictures go away until no more than `most` are kept.
void trimThumbnails(const QString& cache, int most);

} // namespace edgescan::ui
