// Reads a JSON object that a person wrote: every key is checked, and the first fault becomes one sentence.
#pragma once

#include "core/base/physical_limits.h"
#include "core/base/result.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// One object. A key that the reader asked for is a known key; done() refuses all others. Nested objects share the first error.
class JsonFields {
public:
    /// `where` is the path of the file; `hint` says what to do about any error.
    JsonFields(const nlohmann::json& object, std::string where, std::string hint);

    [[nodiscard]] bool has(const char* key);
    [[nodiscard]] double number(const char* key, double missing, NumberLimits limits = {});
    [[nodiscard]] double neededNumber(const char* key, NumberLimits limits = {});
    /// A whole number from `least` to `most`. The key is required.
    [[nodiscard]] std::uint64_t wholeNumber(const char* key, std::uint64_t least, std::uint64_t most);
    [[nodiscard]] bool boolean(const char* key, bool missing);
    [[nodiscard]] std::string text(const char* key, const std::string& missing = {});
    /// The index of one of the words; of the first word if the key is missing.
    [[nodiscard]] std::size_t choice(const char* key, const std::vector<std::string>& words);
    [[nodiscard]] Eigen::Vector3d vector(const char* key, const Eigen::Vector3d& missing, NumberLimits limits = {});
    [[nodiscard]] Eigen::Vector3d neededVector(const char* key, NumberLimits limits = {});
    /// A list of any length; empty if the key is missing.
    [[nodiscard]] std::vector<double> numbers(const char* key, NumberLimits limits = {});
    /// Exactly `count` numbers in a list.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count, NumberLimits limits = {});
    /// Three rows of three numbers. Refused if they are not a proper rotation.
    [[nodiscard]] Eigen::Matrix3d rotation(const char* key);
    /// Seconds since 1970, or NaN if the key is missing.
    [[nodiscard]] double time(const char* key);
    [[nodiscard]] std::vector<std::string> texts(const char* key);
    /// The object under a key; an empty object if the key is missing.
    [[nodiscard]] JsonFields object(const char* key);
    /// The object under a key, or each object of a list of them.
    [[nodiscard]] std::vector<JsonFields> objects(const char* key);

    /// The value under a key, for callers that read it themselves; null if the key is missing.
    [[nodiscard]] const nlohmann::json& value(const char* key);

    /// Reports "stepper.axis must ..." unless an error was found before.
    void refuse(const std::string& key, const std::string& what);
    /// Keys that the reader did not ask for.
    [[nodiscard]] std::vector<std::string> unknown() const;
    /// Refuses them.
    void done();
    [[nodiscard]] const std::optional<Error>& problem() const { return *problem_; }

private:
    JsonFields(nlohmann::json object, std::string prefix, const JsonFields& parent);
    [[nodiscard]] const nlohmann::json& at(const char* key) const { return object_[key]; }
    [[nodiscard]] double checked(const nlohmann::json& value, const std::string& key, NumberLimits limits);

    nlohmann::json object_;
    std::string where_, hint_, prefix_;
    std::vector<std::string> known_;
    std::shared_ptr<std::optional<Error>> problem_;
};

/// Text as a JSON object. Error: an error of parseJson(), not an object, another format than `format`.
Result<nlohmann::json> parseJsonObject(std::string_view text, const std::string& format, const std::string& where);

} // namespace edgescan
