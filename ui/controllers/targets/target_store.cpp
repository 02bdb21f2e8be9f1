// Files of targets.
#include "ui/controllers/targets/target_store.h"

#include "core/base/whole_file.h"
#include "ui/base/shown_text.h"

#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr std::uint64_t kMostNotebookBytes = std::uint64_t{1} << 20U;

} // namespace

class TargetStore::Disk {
public:
    void read(const std::string& path, const inspect::Notebook& notebook) {
        const std::lock_guard lock(mutex_);
        last_[path] = notebook;
    }

    Written write(const Notebooks& notebooks) {
        const std::lock_guard lock(mutex_);
        Written written;
        for (const auto& [path, waiting] : notebooks) {
            std::error_code failed;
            std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
            inspect::Notebook merged = waiting.notebook;
            const auto done = changeWholeFile(path, kMostNotebookBytes,
                                              [&](const std::optional<std::string>& text) -> Result<std::optional<std::string>> {
                                                  if (text) {
                                                      const auto theirs = inspect::notebookFromText(*text, waiting.scan, path);
                                                      if (!theirs) return theirs.error();
                                                      merged = inspect::mergedNotebook(last_[path], waiting.notebook, *theirs);
                                                  }
                                                  return std::optional(inspect::notebookText(merged, waiting.scan));
                                              });
            if (!done) {
                written.trouble = done.error().sentence();
                continue;
            }
            last_[path] = waiting.notebook;
            if (merged != waiting.notebook) written.merged[path] = std::move(merged);
        }
        return written;
    }

private:
    std::mutex mutex_;
    std::map<std::string, inspect::Notebook> last_; // as this window read or wrote it
};

TargetStore::TargetStore(const QString& folder)
    : folder_(folder), disk_(std::make_shared<Disk>()),
      written_(
          Urgency::Soon, [disk = disk_](const Notebooks& notebooks) { return disk->write(notebooks); },
          [this](const Notebooks& notebooks, const std::shared_ptr<const Written>& written) { wrote(notebooks, *written); },
          [this](const QString& what) { emit failed(tr("The targets could not be stored (%1).").arg(what)); }, Older::Delivered) {}

TargetStore::~TargetStore() {
    written_.end(); // older targets must not be written after the last ones
    if (!waiting_.empty()) (void)disk_->write(waiting_);
}

QString TargetStore::pathOf(const inspect::NotebookScan& scan) const {
    const std::string name = inspect::notebookFileName(scan);
    return folder_.isEmpty() || name.empty() ? QString() : folder_ + "/" + exactText(name);
}

Result<inspect::Notebook> TargetStore::load(const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    if (path.empty()) return inspect::Notebook{};
    if (const auto waits = waiting_.find(path); waits != waiting_.end()) return waits->second.notebook;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        disk_->read(path, {});
        return inspect::Notebook{};
    }
    const auto bytes = readWholeFile(path, kMostNotebookBytes);
    auto notebook = bytes ? inspect::notebookFromText(textOf(*bytes), scan, path) : Result<inspect::Notebook>(bytes.error());
    if (!notebook) {
        refused_.insert(path);
        return notebook;
    }
    refused_.erase(path);
    disk_->read(path, *notebook);
    return notebook;
}

void TargetStore::save(const inspect::Notebook& notebook, const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    if (path.empty() || refused_.contains(path)) return;
    waiting_[path] = {notebook, scan};
    written_.ask(waiting_);
}

void TargetStore::wrote(const Notebooks& notebooks, const Written& written) {
    for (const auto& [path, waiting] : notebooks) {
        if (const auto waits = waiting_.find(path); waits != waiting_.end() && waits->second.notebook == waiting.notebook)
            waiting_.erase(waits);
        if (const auto merged = written.merged.find(path); merged != written.merged.end()) {
            disk_->read(path, merged->second); // what the next notebook begins with
            emit this->merged(exactText(path), waiting.notebook, merged->second);
        }
    }
    if (!written.trouble.empty()) emit failed(exactText(written.trouble));
}

} // namespace edgescan::ui

#include "moc_target_store.cpp"
