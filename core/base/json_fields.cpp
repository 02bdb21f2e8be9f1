// Checks of JSON values.
#include "core/base/json_fields.h"
#include "core/base/translated_text.h"

#include "core/base/bounded_json.h"
#include "core/base/number_text.h"
#include "core/base/utc_time.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

using PlainJson = nlohmann::json;

/// A key without its unit, for the hint "did you mean".
std::string withoutUnit(const std::string& key) {
    static const std::vector<std::string> units{"_deg", "_mil", "_rad", "_mm", "_cm", "_m", "_s", "_ms"};
    for (const std::string& unit : units) {
        if (key.size() > unit.size() && key.ends_with(unit)) return key.substr(0, key.size() - unit.size());
    }
    return key;
}

/// What a value is, in the words of a person.
std::string plainType(const PlainJson& value) {
    if (value.is_string()) return "text";
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    return value.is_null() ? "nothing (null)" : value.is_array() ? "a list [...]" : "an object {...}";
}

} // namespace

JsonFields::JsonFields(const PlainJson& object, std::string where, std::string hint)
    : object_(object), where_(std::move(where)), hint_(std::move(hint)), problem_(std::make_shared<std::optional<Error>>()) {}

JsonFields::JsonFields(PlainJson object, std::string prefix, const JsonFields& parent)
    : object_(std::move(object)), where_(parent.where_), hint_(parent.hint_), prefix_(std::move(prefix)), problem_(parent.problem_) {}

void JsonFields::refuse(const std::string& key, const std::string& what) {
    if (!*problem_) *problem_ = Error{"\"" + prefix_ + key + "\" " + what, where_, hint_};
}

bool JsonFields::has(const char* key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return object_.contains(key) && !at(key).is_null();
}

double JsonFields::checked(const PlainJson& value, const std::string& key, NumberLimits limits) {
    if (!value.is_number()) return refuse(key, withValues("holds %1 where a number is needed", {plainType(value)})), 0.0;
    const auto number = value.get<double>();
    if (!physical::kCoordinate.hold(number)) return refuse(key, "holds a number out of all reason"), 0.0;
    if (number < limits.least || number > limits.most) {
        const auto shown = [](double n) { return significantText(n, 12); };
        const std::string range = std::isinf(limits.most)    ? withValues("%1 or more", {shown(limits.least)})
                                  : std::isinf(limits.least) ? withValues("%1 or less", {shown(limits.most)})
                                                             : withValues("from %1 to %2", {shown(limits.least), shown(limits.most)});
        return refuse(key, withValues("is %1 and must be %2", {shown(number), range})), limits.least;
    }
    return number;
}

double JsonFields::number(const char* key, double missing, NumberLimits limits) {
    return has(key) ? checked(at(key), key, limits) : missing;
}

double JsonFields::neededNumber(const char* key, NumberLimits limits) {
    if (!has(key)) return refuse(key, "is missing"), 0.0;
    return checked(at(key), key, limits);
}

std::uint64_t JsonFields::wholeNumber(const char* key, std::uint64_t least, std::uint64_t most) {
    const double number = neededNumber(key);
    if (number == std::floor(number) && number >= static_cast<double>(least) && number <= static_cast<double>(most))
        return static_cast<std::uint64_t>(number);
    return refuse(key, withValues("must be a whole number from %1 to %2", {least, most})), least;
}

bool JsonFields::boolean(const char* key, bool missing) {
    if (!has(key)) return missing;
    if (!at(key).is_boolean()) return refuse(key, "must be true or false"), missing;
    return at(key).get<bool>();
}

std::string JsonFields::text(const char* key, const std::string& missing) {
    if (!has(key)) return missing;
    if (!at(key).is_string()) return refuse(key, "must be text"), missing;
    return at(key).get<std::string>();
}

std::size_t JsonFields::choice(const char* key, const std::vector<std::string>& words) {
    if (!has(key)) return 0;
    const auto found = at(key).is_string() ? std::find(words.begin(), words.end(), at(key).get<std::string>()) : words.end();
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : " or ") + ("\"" + word + "\"");
    return refuse(key, withValues("must be %1", {list})), 0;
}

std::vector<double> JsonFields::numbers(const char* key, NumberLimits limits) {
    std::vector<double> list;
    if (!has(key)) return list;
    if (!at(key).is_array()) return refuse(key, "must be a list of numbers"), list;
    list.reserve(at(key).size());
    for (const PlainJson& item : at(key)) list.push_back(checked(item, key, limits));
    return list;
}

std::vector<double> JsonFields::numbers(const char* key, std::size_t count, NumberLimits limits) {
    if (!has(key)) refuse(key, "is missing");
    std::vector<double> list = numbers(key, limits);
    if (list.size() != count) refuse(key, withValues("must hold %1 numbers", {count}));
    list.resize(count, 0.0);
    return list;
}

Eigen::Vector3d JsonFields::vector(const char* key, const Eigen::Vector3d& missing, NumberLimits limits) {
    return has(key) ? neededVector(key, limits) : missing;
}

Eigen::Vector3d JsonFields::neededVector(const char* key, NumberLimits limits) {
    if (!has(key)) return refuse(key, "is missing"), Eigen::Vector3d::Zero();
    if (!at(key).is_array() || at(key).size() != 3) return refuse(key, "must hold three numbers"), Eigen::Vector3d::Zero();
    return {checked(at(key)[0], key, limits), checked(at(key)[1], key, limits), checked(at(key)[2], key, limits)};
}

const PlainJson& JsonFields::value(const char* key) {
    static const PlainJson kNull;
    return has(key) ? at(key) : kNull;
}

Eigen::Matrix3d JsonFields::rotation(const char* key) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    if (!has(key)) return refuse(key, "is missing"), matrix;
    const PlainJson& rows = at(key);
    const bool shaped = rows.is_array() && rows.size() == 3 &&
                        std::all_of(rows.begin(), rows.end(), [](const PlainJson& row) { return row.is_array() && row.size() == 3; });
    if (!shaped) return refuse(key, "must hold three rows of three numbers"), matrix;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) matrix(i, j) = checked(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], key, {-2, 2});
    }
    const double skew = (matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (skew > 1e-6) return refuse(key, "is not a rotation: its rows are not perpendicular and of length 1"), Eigen::Matrix3d::Identity();
    if (matrix.determinant() < 0) return refuse(key, "mirrors instead of turning: its determinant is -1"), Eigen::Matrix3d::Identity();
    return matrix;
}

double JsonFields::time(const char* key) {
    if (!has(key)) return std::numeric_limits<double>::quiet_NaN();
    const auto seconds = at(key).is_string() ? parseUtc(at(key).get<std::string>()) : std::nullopt;
    if (seconds) return *seconds;
    return refuse(key, "must be a time in UTC like \"2026-11-20T10:15:30.250Z\""), std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> JsonFields::texts(const char* key) {
    std::vector<std::string> list;
    if (!has(key)) return list;
    if (!at(key).is_array()) return refuse(key, "must be a list of texts"), list;
    for (const PlainJson& item : at(key)) {
        if (!item.is_string()) return refuse(key, "must be a list of texts"), list;
        list.push_back(item.get<std::string>());
    }
    return list;
}

JsonFields JsonFields::object(const char* key) {
    if (!has(key)) return {PlainJson::object(), prefix_ + key + ".", *this};
    if (!at(key).is_object()) {
        refuse(key, "must be an object {...}");
        return {PlainJson::object(), prefix_ + key + ".", *this};
    }
    return {at(key), prefix_ + key + ".", *this};
}

std::vector<JsonFields> JsonFields::objects(const char* key) {
    std::vector<JsonFields> list;
    if (!has(key)) return list;
    if (!at(key).is_array()) return list.push_back(object(key)), list;
    std::size_t number = 0;
    for (const PlainJson& item : at(key)) {
        const std::string prefix = prefix_ + key + "[" + std::to_string(number++) + "].";
        if (!item.is_object()) return refuse(key, "must be a list of objects {...}"), list;
        list.push_back(JsonFields(item, prefix, *this));
    }
    return list;
}

std::vector<std::string> JsonFields::unknown() const {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object_.items()) {
        if (std::find(known_.begin(), known_.end(), key) == known_.end()) keys.push_back(key);
    }
    return keys;
}

void JsonFields::done() {
    for (const std::string& key : unknown()) {
        const auto meant = std::find_if(known_.begin(), known_.end(), [&](const std::string& known) {
            return withoutUnit(known) == withoutUnit(key) || withoutUnit(known) == key;
        });
        const std::string shown = key.substr(0, 60);
        if (meant != known_.end()) return refuse(shown, withValues("is not a key here, but \"%1\" is: units belong to the name", {*meant}));
        std::string list;
        for (const std::string& known : known_) list += (list.empty() ? "" : ", ") + known;
        return refuse(shown, withValues("is not a key here; known are %1", {list}));
    }
}

Result<PlainJson> parseJsonObject(std::string_view text, const std::string& format, const std::string& where) {
    const std::string wanted = withValues("\"format\": \"%1\"", {format});
    auto parsed = parseJson(text, where);
    if (!parsed) return parsed.error();
    PlainJson& object = *parsed;
    if (!object.is_object()) return Error{"the JSON holds no object", where, withValues("choose a file with %1", {wanted})};
    const std::string found =
        object.contains("format") && object["format"].is_string() ? object["format"].get<std::string>() : std::string();
    if (found != format) {
        return Error{found.empty() ? "\"format\" is missing"
                                   : withValues("\"format\" is \"%1\", not \"%2\"", {found.substr(0, 60), format}),
                     where, withValues("choose a file with %1", {wanted})};
    }
    object.erase("format");
    return parsed;
}

} // namespace edgescan
