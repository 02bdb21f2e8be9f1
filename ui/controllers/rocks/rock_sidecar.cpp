// Reads and writes the sidecar SCAN.rocks.json.
#include "ui/controllers/rocks/rock_sidecar.h"

#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr int kSoonMs = 400; // a moving slider causes one write

} // namespace

class RockSidecar::Disk {
public:
    Result<Done> write(const Writing& writing) {
        const std::lock_guard lock(mutex_);
        if (writing.number < last_) return Done{};
        last_ = writing.number;
        if (writing.text.empty()) return remove(writing.path);
        auto written = writeWholeFile(writing.path, writing.text);
        if (written) known_[writing.path] = sha256Hex(std::as_bytes(std::span(writing.text)));
        return written;
    }

    /// The file was read.
    void read(const std::string& path) {
        const auto hash = sha256OfFile(path);
        const std::lock_guard lock(mutex_);
        if (hash) known_[path] = *hash;
    }

private:
    Result<Done> remove(const std::string& path) {
        std::error_code problem;
        if (!std::filesystem::exists(path, problem)) return Done{};
        if (const auto hash = sha256OfFile(path); !hash || known_[path] != *hash)
            return Error{"another program has changed this file, so it was not removed", path, "open the scan again to see its edits"};
        std::filesystem::remove(path, problem);
        if (problem) return Error{"the file cannot be removed (" + problem.message() + ")", path, "check the rights of its folder"};
        return Done{};
    }

    std::mutex mutex_;
    std::uint64_t last_ = 0;
    std::map<std::string, std::string> known_; ///< hashes of the files as this window read or wrote them last
};

RockSidecar::RockSidecar(QObject* parent) : QObject(parent), disk_(std::make_shared<Disk>()) {
    soon_.setSingleShot(true);
    soon_.setInterval(kSoonMs);
    connect(&soon_, &QTimer::timeout, this, &RockSidecar::writeInBackground);
}

RockSidecar::~RockSidecar() { writeNow(); }

void RockSidecar::follow(std::shared_ptr<const Scan> scan) {
    writeNow();
    scan_ = std::move(scan);
    ++number_;
    path_.clear();
    ours_ = false;
    reading_ = false;
    if (!scan_) return;
    reading_ = true;
    inBackground(
        this,
        [this, about = scan_, number = number_, disk = disk_]() -> std::function<void()> {
            std::error_code none;
            const std::filesystem::path path = rocks::rockPresetPath(about->path);
            const bool isFile = std::filesystem::is_regular_file(about->path, none);
            const bool isThere = isFile && std::filesystem::exists(path, none);
            if (isThere) disk->read(path.string()); // before: what is written meanwhile counts as another program's
            auto preset = isThere ? rocks::readRockPreset(path, *about) : Result<rocks::Preset>(rocks::Preset{});
            return [this, number, isFile, isThere, path = path.string(), preset = std::move(preset)] {
                if (number != number_) return; // another scan is on the screen
                reading_ = false;
                if (isFile && preset) path_ = path;
                ours_ = isThere && preset;
                if (!preset)
                    emit failed(tr("%1 Edits of rocks are not stored until then.").arg(exactText(preset.error().sentence())));
                else if (isThere)
                    emit found(*preset);
                emit readEnded();
            };
        },
        [this](const QString& what) {
            reading_ = false;
            emit failed(what);
            emit readEnded();
        });
}

void RockSidecar::keep(const rocks::RockSettings& settings, const std::vector<rocks::Edit>& edits) {
    if (!scan_ || path_.empty()) return;
    const bool any = !edits.empty() || !settings.region.empty();
    if (!any && !ours_) return;
    waiting_ = {++writings_, path_,
                any ? rocks::rockPresetText({settings, edits, scan_->sha256}, scan_->lines(), scan_->beams()) : std::string()};
    ours_ = any;
    soon_.start();
}

// Called when another scan comes or the program ends: the last chance to write this small file.
void RockSidecar::writeNow() {
    soon_.stop();
    if (!waiting_) return;
    const auto written = disk_->write(*std::exchange(waiting_, std::nullopt));
    if (!written) emit failed(tr("Edits of rocks are not stored: %1").arg(exactText(written.error().sentence())));
}

void RockSidecar::writeInBackground() {
    if (writing_) {
        soon_.start(); // wait for the running write
        return;
    }
    if (!waiting_) return;
    writing_ = true;
    inBackground(
        this,
        [this, disk = disk_, writing = *std::exchange(waiting_, std::nullopt)]() -> std::function<void()> {
            auto written = disk->write(writing);
            return [this, written = std::move(written)] {
                if (!written) emit failed(tr("Edits of rocks are not stored: %1").arg(exactText(written.error().sentence())));
            };
        },
        [this](const QString& what) { emit failed(tr("Edits of rocks are not stored: %1").arg(what)); }, [this] { writing_ = false; });
}

} // namespace edgescan::ui

#include "moc_rock_sidecar.cpp"
