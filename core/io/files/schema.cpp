// SPDX-License-Identifier: MIT
#define VALIJSON_USE_EXCEPTIONS 1

#include <algorithm>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "core/error.h"
#include "core/io/files/embedded_schemas.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

/// {"<root>", "[cameras]", "[0]", "[K]"} -> cameras[0].K
std::string fieldName(const std::vector<std::string>& context) {
    std::string name;
    for (std::size_t i = 1; i < context.size(); ++i) {
        const std::string part = context[i].substr(1, context[i].size() - 2);
        const bool isIndex =
            !part.empty() && std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
        name += isIndex ? "[" + part + "]" : (name.empty() ? "" : ".") + part;
    }
    return name;
}

/// The error that lies deepest says best what is wrong.
valijson::ValidationResults::Error deepest(valijson::ValidationResults& results) {
    valijson::ValidationResults::Error best, next;
    while (results.popError(next))
        if (next.context.size() >= best.context.size())
            best = next;
    return best;
}

/// The part of the schema that a value was checked against, if it can be told from where the value lies.
const json* partOf(const json& schema, const std::vector<std::string>& context) {
    const json* part = &schema;
    const auto follow = [&] {
        while (part && part->contains("$ref")) {
            const std::string target = (*part)["$ref"].get<std::string>();
            const json::json_pointer pointer(target.substr(1)); // "#/$defs/..."
            part = schema.contains(pointer) ? &schema[pointer] : nullptr;
        }
    };
    follow();
    for (std::size_t i = 1; i < context.size() && part; ++i) {
        const std::string name = context[i].substr(1, context[i].size() - 2);
        const json* next = nullptr;
        if (part->contains("properties") && (*part)["properties"].contains(name))
            next = &(*part)["properties"][name];
        else if (part->contains("items") && (*part)["items"].is_object())
            next = &(*part)["items"];
        part = next;
        follow();
    }
    return part;
}

/// What is wrong, for people: the validator speaks of its own constraints.
std::string readable(const std::string& description, const json* part) {
    const auto has = [&](const char* words) { return description.find(words) != std::string::npos; };
    if (part && has("'const'") && part->contains("const"))
        return "must be " + (*part)["const"].dump();
    if (part && has("'type'") && part->contains("type") && (*part)["type"].is_string()) {
        const std::string type = (*part)["type"];
        return "must be " + std::string(type == "integer"   ? "a whole number"
                                        : type == "array"   ? "a list"
                                        : type == "boolean" ? "true or false"
                                        : type == "string"  ? "a text"
                                                            : "a" + std::string(type == "object" ? "n " : " ") + type);
    }
    if (part && has("enum") && part->contains("enum")) {
        std::string values;
        for (const json& value : (*part)["enum"])
            values += (values.empty() ? "" : ", ") + value.dump();
        return "must be one of " + values;
    }
    constexpr std::string_view kMissing = "Missing required property ", kNumber = "Expected number ",
                               kArray = "Array should contain ";
    if (description.starts_with(kMissing))
        return "lacks " + description.substr(kMissing.size(), description.find_last_not_of('.') + 1 - kMissing.size());
    if (description.starts_with(kNumber))
        return "must be " + description.substr(kNumber.size());
    if (description.starts_with(kArray))
        return "must hold " + description.substr(kArray.size(), description.find_last_not_of('.') + 1 - kArray.size());
    return description;
}

} // namespace

void checkSchema(const json& value, std::string_view kind, const std::string& file) {
    const std::string_view text = embeddedSchema(kind);
    const json document = json::parse(text);
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema);
    valijson::ValidationResults results;
    if (!valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(value), &results)) {
        const auto error = deepest(results);
        throw Error(ErrorCode::BadInput, file, fieldName(error.context),
                    readable(error.description, partOf(document, error.context)));
    }
}

} // namespace core
