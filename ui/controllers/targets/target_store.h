// Stores the targets of scans: one file per scan in a folder next to the settings file. Files are written off the GUI thread, completely or
// not at all.
#pragma once

#include "core/inspect/measure/notebook.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>

#include <functional>
#include <map>
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
    void save(const inspect::Notebook& notebook, const inspect::NotebookScan& scan);

signals:
    void failed(const QString& sentence);

private:
    using Texts = std::map<std::string, std::string>;           // by path
    [[nodiscard]] static std::string write(const Texts& texts); // empty, or why not
    void take(const Texts& written, const std::string& trouble);

    QString folder_;
    std::set<std::string> refused_;       // paths
    Texts waiting_;                       // not written yet
    Derived<Texts, std::string> written_; // last
};

} // namespace edgescan::ui
