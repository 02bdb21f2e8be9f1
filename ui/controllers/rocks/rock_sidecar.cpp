// Reads and writes the sidecar SCAN.EXT.rocks.json.
#include "ui/controllers/rocks/rock_sidecar.h"

#include "core/base/merged_files.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <filesystem>
#include <mutex>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr int kSoonMs = 400; // a moving slider causes one write

} // namespace

class RockSidecar::Disk {
public:
    /// What is in the file now: what another window changed in it is merged.
    Result<rocks::Preset> write(const Writing& writing) {
        const std::lock_guard lock(mutex_);
        if (writing.number < last_) return writing.preset;
        last_ = writing.number;
        const Scan& scan = *writing.scan;
        const auto read = [&](const std::string& text) {
            return rocks::rockPresetFromText(text, scan.lines(), scan.beams(), scan.sha256, writing.path);
        };
        const auto text = [&](const rocks::Preset& preset) {
            const bool none = preset.edits.empty() && preset.settings->region.empty();
            return none ? std::nullopt : std::optional(rocks::rockPresetText(preset, scan.lines(), scan.beams()));
        };
        return files.write(writing.path, writing.preset, {rocks::kMostPresetBytes, read, text, rocks::mergedPreset});
    }

    MergedFiles<rocks::Preset> files;

private:
    std::mutex mutex_;
    std::uint64_t last_ = 0;
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
            auto preset = isThere ? rocks::readRockPreset(path, *about) : Result<rocks::Preset>(rocks::Preset{});
            if (preset) disk->files.begin(path.string(), *preset);
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
    waiting_ = {++writings_, path_, scan_, {settings, edits, scan_->sha256}};
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
            return [this, disk, writing, written = std::move(written)] {
                failing_ = !written;
                if (!written && !waiting_) waiting_ = writing; // with the next one, or at the end
                if (!written) return emit failed(tr("Edits of rocks are not stored: %1").arg(exactText(written.error().sentence())));
                if (writing.scan != scan_ || *written == writing.preset) return;
                disk->files.begin(writing.path, *written); // what the next edits begin with
                emit merged(writing.preset, *written);
            };
        },
        [this](const QString& what) { emit failed(tr("Edits of rocks are not stored: %1").arg(what)); }, [this] { writing_ = false; });
}

} // namespace edgescan::ui

#include "moc_rock_sidecar.cpp"
