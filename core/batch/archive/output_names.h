// The folder for the results of each scan of an archive: a separate one for each scan (docs/reference/batch.md, "Names").
#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace edgescan::batch {

/// A field in braces in a template, and its value: "path", "folder", "name", "stem", "key".
struct NameField {
    const char* key;
    const char* help;
    std::string (*of)(const std::string& input);
};
[[nodiscard]] const std::vector<NameField>& nameFields();

/// The template filled in for each input: relative paths without "." and "..". Error: an unknown field, or two inputs with the same folder,
/// or with one folder inside the other.
Result<std::vector<std::string>> outputNames(const std::vector<std::string>& inputs, const std::string& pattern);

} // namespace edgescan::batch
