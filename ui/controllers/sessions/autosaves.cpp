// Session files that the viewer saves itself.
#include "ui/controllers/sessions/autosaves.h"

#include "core/inspect/session_file/session_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr int kMostLeftBehind = 3; // older ones are deleted
const char* const kRunningStart = "running-";
const char* const kOfferedStart = "crashed-"; // after a crash, offered at a later start

QString lockOf(const QString& path) { return path + ".lock"; }

} // namespace

Autosaves::Autosaves(const QString& folder) : folder_(folder) {
    if (folder.isEmpty() || !QDir().mkpath(folder)) return;
    // A number separates several windows of one process.
    for (int n = 0; n < 100 && own_.isEmpty(); ++n) {
        const QString path = folder + "/" + kRunningStart + QString::number(QCoreApplication::applicationPid()) + "-" + QString::number(n) +
                             inspect::kSessionEnding;
        auto lock = std::make_unique<QLockFile>(lockOf(path));
        lock->setStaleLockTime(0);
        if (QFile::exists(path) || !lock->tryLock(0)) continue; // of a former process with the same number
        lock_ = std::move(lock);
        own_ = path;
    }
    const QStringList left = afterCrash();
    for (const QString& old : left.mid(kMostLeftBehind)) QFile::remove(old);
}

Autosaves::~Autosaves() = default;

bool Autosaves::isRunning(const QString& path) const {
    if (path == own_) return true;
    QLockFile lock(lockOf(path));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) return true; // a lock of a dead process can be taken
    lock.unlock();
    return false;
}

QStringList Autosaves::afterCrash() const {
    QStringList left;
    if (folder_.isEmpty()) return left;
    for (const QFileInfo& file : QDir(folder_).entryInfoList(
             {QString(kRunningStart) + "*" + inspect::kSessionEnding, QString(kOfferedStart) + "*" + inspect::kSessionEnding}, QDir::Files,
             QDir::Time)) {
        const QString path = file.absoluteFilePath();
        if (!takenUp_.contains(path) && !isRunning(path)) left << path;
    }
    return left;
}

QString Autosaves::toOffer() {
    const auto wasOffered = [](const QString& path) { return !QFileInfo(path).fileName().startsWith(kRunningStart); };
    offered_ = afterCrash();
    offered_.erase(std::remove_if(offered_.begin(), offered_.end(), wasOffered), offered_.end());
    return offered_.isEmpty() ? QString() : offered_.front();
}

QString Autosaves::last() const {
    const QString path = folder_ + "/last" + inspect::kSessionEnding;
    return !folder_.isEmpty() && QFile::exists(path) ? path : QString();
}

void Autosaves::markContinued(const QString& path) {
    if (afterCrash().contains(QFileInfo(path).absoluteFilePath())) takenUp_ << QFileInfo(path).absoluteFilePath();
}

void Autosaves::end() {
    for (const QString& path : offered_) {
        const QFileInfo file(path);
        if (!takenUp_.contains(path)) QFile::rename(path, file.path() + "/" + file.fileName().replace(kRunningStart, kOfferedStart));
    }
    if (own_.isEmpty() || !QFile::exists(own_)) return;
    const QString last = folder_ + "/last" + inspect::kSessionEnding;
    // Another window may end at the same time: the last one's session stays. Without a move, the next start offers this one.
    std::error_code failed;
    std::filesystem::rename(own_.toStdString(), last.toStdString(), failed);
    if (failed) return;
    for (const QString& path : takenUp_) QFile::remove(path);
}

} // namespace edgescan::ui
