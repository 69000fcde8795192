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
#include "core/io/embedded_schemas.h"
#include "core/io/json_file.h"

namespace core {

using nlohmann::json;

namespace {

/// {"<root>", "[cameras]", "[0]", "[K]"} -> cameras[0].K
std::string fieldName(const std::vector<std::string>& context) {
    std::string name;
    for (std::size_t i = 1; i < context.size(); ++i) {
        const std::string part = context[i].substr(1, context[i].size() - 2);
        const bool isIndex = !part.empty() && std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
        name += isIndex ? "[" + part + "]" : (name.empty() ? "" : ".") + part;
    }
    return name;
}

/// The error that lies deepest says best what is wrong.
valijson::ValidationResults::Error deepest(valijson::ValidationResults& results) {
    valijson::ValidationResults::Error best, next;
    while (results.popError(next)) {
        if (next.context.size() >= best.context.size()) {
            best = next;
        }
    }
    return best;
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
        throw Error(ErrorCode::BadInput, file, fieldName(error.context), error.description);
    }
}

} // namespace core
