// Where the targets of scans are kept: a file per scan in a folder beside what the viewer remembers, written off the GUI thread, whole or
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
    /// `folder`: empty = nothing is kept.
    explicit TargetStore(const QString& folder);
    /// What was not written yet is written now.
    ~TargetStore() override;

    /// Where the targets of this scan are; empty where they are not kept.
    [[nodiscard]] QString pathOf(const NotebookScan& scan) const;
    /// An empty one where none is kept. Error: what is kept is damaged or of another scan; it is left as it is, and nothing is written over
    /// it.
    Result<Notebook> load(const NotebookScan& scan);
    void save(const Notebook& notebook, const NotebookScan& scan);

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
