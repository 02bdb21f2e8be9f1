// Files that several programs change: none loses what another one wrote.
#pragma once

#include "core/base/whole_file.h"

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace edgescan {

/// How a value is stored, and how what two programs made of one value becomes one.
template <class Value>
struct MergedForm {
    std::uint64_t mostBytes = 0;
    std::function<Result<Value>(const std::string& text)> read;
    std::function<std::optional<std::string>(const Value& value)> text; ///< nothing: the file is removed
    std::function<Value(const Value& base, const Value& mine, const Value& theirs)> merge;
};

/// For several threads. `Value` has a default, of a file that is not there.
template <class Value>
class MergedFiles {
public:
    /// From now on the work on the file begins with `value`.
    void begin(const std::string& path, const Value& value) {
        const std::lock_guard lock(mutex_);
        base_[path] = value;
    }

    /// Writes `mine`, merged with what another program wrote since begin() or the last write(). What is in the file then. Error: as
    /// changeWholeFile().
    Result<Value> write(const std::string& path, const Value& mine, const MergedForm<Value>& form) {
        const std::lock_guard lock(mutex_);
        Value merged = mine;
        const auto change = [&](const std::optional<std::string>& text) -> Result<std::optional<std::string>> {
            if (text) {
                const auto theirs = form.read(*text);
                if (!theirs) return theirs.error();
                merged = form.merge(base_[path], mine, *theirs);
            }
            return form.text(merged);
        };
        if (const auto written = changeWholeFile(path, form.mostBytes, change); !written) return written.error();
        base_[path] = mine;
        return merged;
    }

private:
    std::mutex mutex_;
    std::map<std::string, Value> base_;
};

} // namespace edgescan
