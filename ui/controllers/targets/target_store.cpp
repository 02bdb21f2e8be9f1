// Files of targets.
#include "ui/controllers/targets/target_store.h"

#include "core/base/whole_file.h"
#include "ui/base/shown_text.h"

#include <filesystem>
#include <string_view>
#include <system_error>

namespace edgescan::ui {
namespace {

constexpr std::uint64_t kMostNotebookBytes = std::uint64_t{1} << 20U;

} // namespace

TargetStore::TargetStore(const QString& folder)
    : folder_(folder),
      written_(
          Urgency::Soon, [](const Texts& texts) { return write(texts); },
          [this](const Texts& texts, const std::shared_ptr<const std::string>& trouble) { take(texts, *trouble); },
          [this](const QString& what) { emit failed(tr("The targets could not be stored (%1).").arg(what)); }, Older::Delivered) {}

TargetStore::~TargetStore() {
    written_.end(); // older targets must not be written after the last ones
    if (!waiting_.empty()) (void)write(waiting_);
}

QString TargetStore::pathOf(const inspect::NotebookScan& scan) const {
    const std::string name = inspect::notebookFileName(scan);
    return folder_.isEmpty() || name.empty() ? QString() : folder_ + "/" + exactText(name);
}

Result<inspect::Notebook> TargetStore::load(const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    if (path.empty()) return inspect::Notebook{};
    std::string text;
    if (const auto waits = waiting_.find(path); waits != waiting_.end()) {
        text = waits->second;
    } else {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) return inspect::Notebook{};
        const auto bytes = readWholeFile(path, kMostNotebookBytes);
        if (!bytes) {
            refused_.insert(path);
            return bytes.error();
        }
        text = textOf(*bytes);
    }
    auto notebook = inspect::notebookFromText(text, scan, path);
    if (!notebook)
        refused_.insert(path);
    else
        refused_.erase(path);
    return notebook;
}

void TargetStore::save(const inspect::Notebook& notebook, const inspect::NotebookScan& scan) {
    const std::string path = exactBytes(pathOf(scan));
    if (path.empty() || refused_.contains(path)) return;
    waiting_[path] = inspect::notebookText(notebook, scan);
    written_.ask(waiting_);
}

std::string TargetStore::write(const Texts& texts) {
    std::string trouble;
    for (const auto& [path, text] : texts) {
        std::error_code failed;
        std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
        if (const auto done = writeWholeFile(path, text); !done) trouble = done.error().sentence();
    }
    return trouble;
}

void TargetStore::take(const Texts& written, const std::string& trouble) {
    for (const auto& [path, text] : written) {
        if (const auto waits = waiting_.find(path); waits != waiting_.end() && waits->second == text) waiting_.erase(waits);
    }
    if (!trouble.empty()) emit failed(exactText(trouble));
}

} // namespace edgescan::ui

#include "moc_target_store.cpp"
