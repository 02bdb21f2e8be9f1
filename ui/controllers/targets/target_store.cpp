// Files of targets.
#include "ui/controllers/targets/target_store.h"

#include "core/base/whole_file.h"
#include "ui/base/shown_text.h"

#include <QDir>

#include <filesystem>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr std::uint64_t kMostNotebookBytes = std::uint64_t{1} << 20U;

} // namespace

TargetStore::Written TargetStore::write(NotebookFiles& files, const Notebooks& notebooks) {
    Written written;
    for (const auto& [path, waiting] : notebooks) {
        std::error_code failed;
        std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
        auto merged = files.write(
            path, waiting.notebook,
            {kMostNotebookBytes, [&](const std::string& text) { return inspect::notebookFromText(text, waiting.scan, path); },
             [&](const inspect::Notebook& notebook) { return inspect::notebookText(notebook, waiting.scan); }, inspect::mergedNotebook});
        if (!merged)
            written.troubles[path] = merged.error().sentence();
        else if (*merged != waiting.notebook)
            written.merged[path] = std::move(*merged);
    }
    return written;
}

TargetStore::TargetStore(const QString& folder)
    : folder_(folder), files_(std::make_shared<NotebookFiles>()),
      written_(
          Urgency::Soon, [files = files_](const Notebooks& notebooks) { return write(*files, notebooks); },
          [this](const Notebooks& notebooks, const std::shared_ptr<const Written>& written) { wrote(notebooks, *written); },
          [this](const QString& what) { emit failed(tr("The targets could not be stored (%1).").arg(what)); }, Older::Delivered) {}

TargetStore::~TargetStore() {
    written_.end(); // older targets must not be written after the last ones
    if (!waiting_.empty()) (void)write(*files_, waiting_);
}

QString TargetStore::pathOf(const inspect::NotebookScan& scan) const {
    const std::string name = inspect::notebookFileName(scan);
    return folder_.isEmpty() || name.empty() ? QString() : folder_ + "/" + exactText(name);
}

Result<inspect::Notebook> TargetStore::peek(const inspect::NotebookScan& scan) const {
    const std::string path = exactBytes(pathOf(scan));
    if (const auto waits = waiting_.find(path); waits != waiting_.end()) return waits->second.notebook;
    std::error_code ignored;
    if (path.empty() || !std::filesystem::exists(path, ignored)) return inspect::Notebook{};
    const auto bytes = readWholeFile(path, kMostNotebookBytes);
    return bytes ? inspect::notebookFromText(textOf(*bytes), scan, path) : Result<inspect::Notebook>(bytes.error());
}

Result<inspect::Notebook> TargetStore::load(const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    auto notebook = peek(scan);
    if (path.empty() || waiting_.contains(path)) return notebook;
    if (!notebook) {
        refused_.insert(path);
        return notebook;
    }
    refused_.erase(path);
    files_->begin(path, *notebook);
    return notebook;
}

bool TargetStore::openElsewhere(const inspect::NotebookScan& scan) {
    open_.reset();
    const QString path = pathOf(scan);
    if (path.isEmpty() || !QDir().mkpath(folder_)) return false;
    open_ = std::make_unique<QLockFile>(path + ".open");
    open_->setStaleLockTime(0); // only a program that has ended leaves it behind
    return !open_->tryLock() && open_->error() == QLockFile::LockFailedError;
}

void TargetStore::save(const inspect::Notebook& notebook, const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    if (path.empty() || refused_.contains(path)) return;
    waiting_[path] = {notebook, scan};
    written_.ask(waiting_);
}

void TargetStore::wrote(const Notebooks& notebooks, const Written& written) {
    for (const auto& [path, waiting] : notebooks) {
        if (const auto waits = waiting_.find(path);
            waits != waiting_.end() && waits->second.notebook == waiting.notebook && !written.troubles.contains(path))
            waiting_.erase(waits);
        if (const auto merged = written.merged.find(path); merged != written.merged.end()) {
            files_->begin(path, merged->second); // what the next notebook begins with
            emit this->merged(exactText(path), waiting.notebook, merged->second);
        }
    }
    failing_ = !written.troubles.empty();
    if (failing_) emit failed(tr("Your targets are not stored: %1").arg(exactText(written.troubles.begin()->second)));
}

} // namespace edgescan::ui

#include "moc_target_store.cpp"
