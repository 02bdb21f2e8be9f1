// Stores the targets of scans: one file per scan in a folder next to the settings file. Files are written off the GUI thread, completely or
// not at all. What another window wrote meanwhile is merged.
#pragma once

#include "core/base/merged_files.h"
#include "core/inspect/measure/notebook.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QLockFile>
#include <QObject>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace edgescan::ui {

/// GUI thread only.
class TargetStore : public QObject {
    Q_OBJECT
public:
    /// `folder`: empty = targets are not stored.
    explicit TargetStore(const QString& folder);
    /// Writes pending changes.
    ~TargetStore() override;

    /// No folder was given: nothing is stored.
    [[nodiscard]] bool isOff() const { return folder_.isEmpty(); }
    /// Path of the targets of this scan; empty if they are not stored.
    [[nodiscard]] QString pathOf(const inspect::NotebookScan& scan) const;
    /// An empty notebook if no file exists. Error: the file is damaged or belongs to another scan; it is not changed or overwritten.
    Result<inspect::Notebook> load(const inspect::NotebookScan& scan);
    /// The same of a scan that is not on the screen: it may be read at any time, and what save() merges with stays as it is.
    [[nodiscard]] Result<inspect::Notebook> peek(const inspect::NotebookScan& scan) const;
    void save(const inspect::Notebook& notebook, const inspect::NotebookScan& scan);

    /// Targets wait that could not be written.
    [[nodiscard]] bool failing() const { return failing_; }
    /// The scan comes on the screen. True: another window has it on its own.
    [[nodiscard]] bool openElsewhere(const inspect::NotebookScan& scan);

signals:
    void failed(const QString& sentence);
    /// Another window had changed the file: `theirs`, which has all changes, was written in place of `mine`.
    void merged(const QString& path, const edgescan::inspect::Notebook& mine, const edgescan::inspect::Notebook& theirs);

private:
    struct Waiting {
        inspect::Notebook notebook;
        inspect::NotebookScan scan;
    };
    using Notebooks = std::map<std::string, Waiting>; // by path
    struct Written {
        std::map<std::string, std::string> troubles; // why not, by path
        std::map<std::string, inspect::Notebook> merged;
    };
    using NotebookFiles = MergedFiles<inspect::Notebook>;
    [[nodiscard]] static Written write(NotebookFiles& files, const Notebooks& notebooks);
    void wrote(const Notebooks& notebooks, const Written& written);

    QString folder_;
    std::set<std::string> refused_;   // paths
    Notebooks waiting_;               // not written yet
    bool failing_ = false;            // the last writing failed
    std::unique_ptr<QLockFile> open_; // of the scan on the screen
    std::shared_ptr<NotebookFiles> files_;
    Derived<Notebooks, Written> written_; // last
};

} // namespace edgescan::ui
