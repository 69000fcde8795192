// SPDX-License-Identifier: MIT
#include "core/fitting/method_name.h"

#include <array>

#include "core/error.h"
#include "core/fitting/method_options.h"

namespace core {

namespace {

struct NamedMethod {
    const char* name;
    DistanceKind distance;
    bool isBest;

    Method plain() const {
        Method method{.distance = distance};
        if (isBest)
            method.best.emplace();
        return method;
    }
};

constexpr std::array<NamedMethod, 6> kMethods{{{"ch", DistanceKind::Ch, false},
                                               {"dch-dt3", DistanceKind::DchDt3, false},
                                               {"dch-quant", DistanceKind::DchQuant, false},
                                               {"dch-quant2", DistanceKind::DchQuant2, false},
                                               {"dch-thres", DistanceKind::DchThres, false},
                                               {"best", DistanceKind::DchThres, true}}};

const NamedMethod& namedAs(std::string_view name) {
    std::string names;
    for (const NamedMethod& method : kMethods) {
        if (name == method.name)
            return method;
        names += (names.empty() ? "" : ", ") + std::string(method.name);
    }
    throw Error(ErrorCode::Usage, "--method", std::string(name), "unknown method; the methods are " + names);
}

const NamedMethod& namedLike(const Method& method) {
    for (const NamedMethod& named : kMethods)
        if (named.distance == method.distance && named.isBest == method.best.has_value())
            return named;
    return kMethods.back(); // `best` over another distance than DCH-Thres does not exist
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

std::string optionKeys(const Method& method) {
    std::string keys;
    for (const MethodOption& option : methodOptions())
        if (option.appliesTo(method))
            keys += (keys.empty() ? "" : ", ") + std::string(option.key);
    return keys;
}

/// What is wrong with one `key=value`; empty if it was set.
std::string setOption(Method& method, const char* name, std::string_view key, std::string_view value) {
    for (const MethodOption& option : methodOptions())
        if (option.key == key && option.appliesTo(method))
            return option.parse(method, value);
    return "unknown option; the options of " + std::string(name) + " are " + optionKeys(method);
}

} // namespace

Method parseMethod(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    const NamedMethod& named = namedAs(parts.front());
    Method method = named.plain();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        const std::string_view key = parts[i].substr(0, equals);
        const std::string problem = equals == std::string_view::npos
                                        ? "options are written as name=value"
                                        : setOption(method, named.name, key, parts[i].substr(equals + 1));
        if (!problem.empty())
            throw Error(ErrorCode::Usage, "--method " + std::string(text), std::string(key), problem);
    }
    return method;
}

std::string methodName(const Method& method) {
    const NamedMethod& named = namedLike(method);
    const Method plain = named.plain();
    std::string name = named.name;
    for (const MethodOption& option : methodOptions())
        if (option.appliesTo(method) && option.print(method) != option.print(plain))
            name += ":" + std::string(option.key) + "=" + option.print(method);
    return name;
}

std::vector<std::string> plainMethodNames() {
    std::vector<std::string> names;
    for (const NamedMethod& method : kMethods)
        names.emplace_back(method.name);
    return names;
}

} // namespace core
