// The preview of a recently opened scan: a small picture and a line of text, stored in a cache folder.
#pragma once

#include <QImage>
#include <QString>

#include <functional>

namespace edgescan::ui {

struct RecentScan {
    QString path;
    bool exists = false; ///< the file exists
    QString words;       ///< "2026-11-19 08:12 UTC · 1,000 lines · RECORDED"; for an unreadable file the reason
    QImage picture;      ///< null: no picture

    bool operator==(const RecentScan&) const = default;
};

inline constexpr int kThumbnailPx = 132; ///< longest side

/// Reads the scan if `cache` has no picture of it, or the file changed since. `goOn` returning false cancels. For any thread.
[[nodiscard]] RecentScan recentScan(const QString& path, const QString& cache, const std::function<bool()>& goOn);
/// Deletes the oldest pictures until at most `most` are left.
void trimThumbnails(const QString& cache, int most);

} // namespace edgescan::ui
