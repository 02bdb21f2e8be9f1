// Where the results of each scan of an archive go: one folder each, that no other scan can have (docs/batch.md, "Names").
#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace edgescan {

/// What stands in braces in a template, with what it stands for: "path", "folder", "name", "stem", "key".
struct NameField {
    const char* key;
    const char* help;
    std::string (*of)(const std::string& input);
};
[[nodiscard]] const std::vector<NameField>& nameFields();

/// The template filled in for each input: relative paths without "." and "..". Error: an unknown field, or two inputs that would share a
/// folder or lie one inside the other.
Result<std::vector<std::string>> outputNames(const std::vector<std::string>& inputs, const std::string& pattern);

} // namespace edgescan
