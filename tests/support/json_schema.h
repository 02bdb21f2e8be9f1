// The part of JSON Schema that docs/reference/export-record.schema.json uses. An unknown keyword is a failure, so that every keyword is
// checked.
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <string>

namespace edgescan::test {

using SchemaJson = nlohmann::ordered_json;

inline bool isOfType(const SchemaJson& value, const std::string& type) {
    if (type == "integer")
        return value.is_number_integer() || (value.is_number() && std::floor(value.get<double>()) == value.get<double>());
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "null") return value.is_null();
    if (type == "array") return value.is_array();
    return type == "object" && value.is_object();
}

/// The fault of `value`, or empty. `root` is the whole schema, for references.
inline std::string schemaProblem(const SchemaJson& value, const SchemaJson& schema, const SchemaJson& root, const std::string& at = "$");

inline std::string objectProblem(const SchemaJson& value, const std::string& key, const SchemaJson& rule, const SchemaJson& schema,
                                 const SchemaJson& root, const std::string& at) {
    if (!value.is_object()) return {};
    if (key == "required") {
        for (const auto& name : rule) {
            if (!value.contains(name.get<std::string>())) return at + "." + name.get<std::string>() + " is missing";
        }
    } else if (key == "properties") {
        for (const auto& [name, item] : value.items()) {
            if (!rule.contains(name)) continue;
            if (auto wrong = schemaProblem(item, rule[name], root, at + "." + name); !wrong.empty()) return wrong;
        }
    } else if (key == "additionalProperties") {
        for (const auto& [name, item] : value.items()) {
            if (schema.contains("properties") && schema["properties"].contains(name)) continue;
            if (rule.is_boolean()) return at + "." + name + " is not foreseen";
            if (auto wrong = schemaProblem(item, rule, root, at + "." + name); !wrong.empty()) return wrong;
        }
    } else if (key == "minProperties" && value.size() < rule.get<std::size_t>()) {
        return at + " has too few members";
    }
    return {};
}

inline std::string listProblem(const SchemaJson& value, const std::string& key, const SchemaJson& rule, const SchemaJson& root,
                               const std::string& at) {
    if (!value.is_array()) return {};
    if (key == "minItems" && value.size() < rule.get<std::size_t>()) return at + " is too short";
    if (key == "maxItems" && value.size() > rule.get<std::size_t>()) return at + " is too long";
    if (key != "items") return {};
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (auto wrong = schemaProblem(value[i], rule, root, at + "[" + std::to_string(i) + "]"); !wrong.empty()) return wrong;
    }
    return {};
}

inline std::string schemaProblem(const SchemaJson& value, const SchemaJson& schema, const SchemaJson& root, const std::string& at) {
    for (const auto& [key, rule] : schema.items()) {
        std::string wrong;
        if (key == "$schema" || key == "title" || key == "description" || key == "$defs" || key == "then" || key == "else") continue;
        if (key == "$ref") {
            wrong = schemaProblem(value, root.at(SchemaJson::json_pointer(rule.get<std::string>().substr(1))), root, at);
        } else if (key == "type") {
            bool any = false;
            for (const auto& type : rule.is_array() ? rule : SchemaJson::array({rule}))
                any = any || isOfType(value, type.get<std::string>());
            if (!any) wrong = at + " is of another type than " + rule.dump();
        } else if (key == "const") {
            if (value != rule) wrong = at + " is not " + rule.dump();
        } else if (key == "enum") {
            if (std::find(rule.begin(), rule.end(), value) == rule.end()) wrong = at + " is none of " + rule.dump();
        } else if (key == "pattern") {
            if (value.is_string() && !std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())))
                wrong = at + " does not look right";
        } else if (key == "minLength") {
            if (value.is_string() && value.get<std::string>().size() < rule.get<std::size_t>()) wrong = at + " is too short";
        } else if (key == "minimum") {
            if (value.is_number() && value.get<double>() < rule.get<double>()) wrong = at + " is too small";
        } else if (key == "required" || key == "properties" || key == "additionalProperties" || key == "minProperties") {
            wrong = objectProblem(value, key, rule, schema, root, at);
        } else if (key == "items" || key == "minItems" || key == "maxItems") {
            wrong = listProblem(value, key, rule, root, at);
        } else if (key == "anyOf") {
            bool any = false;
            for (const auto& one : rule) any = any || schemaProblem(value, one, root, at).empty();
            if (!any) wrong = at + " fits none of the forms it may have";
        } else if (key == "allOf") {
            for (const auto& one : rule) {
                if (wrong.empty()) wrong = schemaProblem(value, one, root, at);
            }
        } else if (key == "if") {
            const char* branch = schemaProblem(value, rule, root, at).empty() ? "then" : "else";
            if (schema.contains(branch)) wrong = schemaProblem(value, schema[branch], root, at);
        } else {
            wrong = "the schema's \"" + key + "\" is not known to this test";
        }
        if (!wrong.empty()) return wrong;
    }
    return {};
}

} // namespace edgescan::test
