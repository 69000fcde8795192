// SPDX-License-Identifier: MIT
#include "core/fitting/method.h"

#include <array>
#include <charconv>
#include <functional>

#include "core/error.h"

namespace core {

namespace {

struct NamedKind {
    const char* name;
    MethodKind kind;
};

constexpr std::array<NamedKind, 6> kKinds{{{"ch", MethodKind::Ch},
                                           {"dch-dt3", MethodKind::DchDt3},
                                           {"dch-quant", MethodKind::DchQuant},
                                           {"dch-quant2", MethodKind::DchQuant2},
                                           {"dch-thres", MethodKind::DchThres},
                                           {"best", MethodKind::Best}}};

[[noreturn]] void fail(std::string_view text, std::string_view field, const std::string& detail) {
    throw Error(ErrorCode::Usage, "--method " + std::string(text), std::string(field), detail);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

/// Shortest text that reads back as the same number.
std::string shortest(double value) {
    std::array<char, 32> buffer;
    const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    (void)code;
    return {buffer.data(), end};
}

double number(std::string_view text, std::string_view key, std::string_view value, double low, double high) {
    double result = 0;
    const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), result);
    if (code != std::errc() || end != value.data() + value.size() || !(result >= low && result <= high)) {
        fail(text, key,
             "'" + std::string(value) + "' is not a number from " + shortest(low) + " to " + shortest(high));
    }
    return result;
}

int integer(std::string_view text, std::string_view key, std::string_view value, int low, int high) {
    const double result = number(text, key, value, low, high);
    if (result != static_cast<int>(result)) {
        fail(text, key, "must be a whole number");
    }
    return static_cast<int>(result);
}

bool flag(std::string_view text, std::string_view key, std::string_view value) {
    if (value != "0" && value != "1") {
        fail(text, key, "must be 0 or 1");
    }
    return value == "1";
}

std::string_view oneOf(std::string_view text, std::string_view key, std::string_view value,
                       std::initializer_list<std::string_view> allowed) {
    std::string list;
    for (std::string_view candidate : allowed) {
        if (candidate == value) {
            return value;
        }
        list += (list.empty() ? "" : " or ") + std::string(candidate);
    }
    fail(text, key, "must be " + list);
}

struct NamedIdea {
    const char* name;
    bool BestIdeas::*field;
};

constexpr std::array<NamedIdea, 9> kIdeas{{{"palm", &BestIdeas::palm},
                                           {"coarse", &BestIdeas::coarse},
                                           {"wide", &BestIdeas::wide},
                                           {"across", &BestIdeas::across},
                                           {"prior", &BestIdeas::prior},
                                           {"restarts", &BestIdeas::restarts},
                                           {"polish", &BestIdeas::polish},
                                           {"both", &BestIdeas::bothWays},
                                           {"within", &BestIdeas::withinTau}}};

/// False if the key names no idea of `best`.
bool setIdea(BestIdeas& ideas, std::string_view text, std::string_view key, std::string_view value) {
    if (key == "robust") {
        ideas.robustMm = number(text, key, value, 0, 1000);
        return true;
    }
    for (const NamedIdea& idea : kIdeas) {
        if (key == idea.name) {
            ideas.*idea.field = flag(text, key, value);
            return true;
        }
    }
    return false;
}

std::string optionNames(MethodKind kind) {
    if (kind == MethodKind::Best) {
        std::string names = "live, robust";
        for (const NamedIdea& idea : kIdeas) {
            names += ", " + std::string(idea.name);
        }
        return names + ", epsilon, tangent";
    }
    const std::string all = "gate, truncate, epsilon, tangent, iterations, damping, schedule";
    switch (kind) {
    case MethodKind::DchThres:
        return "tau, signed, " + all;
    case MethodKind::DchDt3:
        return "lambda, bins, centre, signed, backend, " + all;
    case MethodKind::DchQuant:
        return "bins, centre, signed, " + all;
    case MethodKind::DchQuant2:
        return "bins, centre, signed, weights, " + all;
    default:
        return all;
    }
}

void setOption(Method& m, std::string_view text, std::string_view key, std::string_view value) {
    const bool best = m.kind == MethodKind::Best;
    const bool quant = m.kind == MethodKind::DchQuant || m.kind == MethodKind::DchQuant2;
    if (key == "tau" && m.kind == MethodKind::DchThres) {
        m.tauDeg = number(text, key, value, 0, 180);
    } else if (key == "signed" && !best && m.kind != MethodKind::Ch) {
        m.signedOrientation = flag(text, key, value);
    } else if (key == "lambda" && m.kind == MethodKind::DchDt3) {
        m.lambdaPxPerRad = number(text, key, value, 0, 1000);
    } else if (key == "bins" && (quant || m.kind == MethodKind::DchDt3)) {
        m.bins = integer(text, key, value, 1, 256);
    } else if (key == "centre" && (quant || m.kind == MethodKind::DchDt3)) {
        m.binCentre = number(text, key, value, 0, 0.999);
    } else if (key == "weights" && m.kind == MethodKind::DchQuant2) {
        m.binWeights = flag(text, key, value);
    } else if (key == "backend" && m.kind == MethodKind::DchDt3) {
        m.backend = oneOf(text, key, value, {"tensor", "direct"}) == "tensor" ? Dt3Backend::Tensor : Dt3Backend::Direct;
    } else if (key == "live" && best) {
        m.live = flag(text, key, value);
    } else if (best && setIdea(m.ideas, text, key, value)) {
        return;
    } else if (key == "gate" && !best) {
        m.gatePx = number(text, key, value, 0, 1e6);
    } else if (key == "truncate" && !best) {
        m.truncatePx2 = number(text, key, value, 0, 1e9);
    } else if (key == "epsilon") {
        m.polygonEpsilonPx = number(text, key, value, 0.1, 20);
    } else if (key == "tangent") {
        m.chordTangent = oneOf(text, key, value, {"polygon", "chord"}) == "chord";
    } else if (key == "iterations" && !best) {
        m.maxIterations = integer(text, key, value, 1, 1000);
    } else if (key == "damping" && !best) {
        m.damping = number(text, key, value, 0, 10);
    } else if (key == "schedule" && !best) {
        m.schedule = oneOf(text, key, value, {"rigid", "paper"}) == "paper" ? Schedule::Paper : Schedule::RigidFirst;
    } else {
        fail(text, key, "is no option of this method, which has " + optionNames(m.kind));
    }
}

} // namespace

Method parseMethod(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    Method method;
    bool known = false;
    for (const NamedKind& entry : kKinds) {
        if (parts.front() == entry.name) {
            method.kind = entry.kind;
            known = true;
        }
    }
    if (!known) {
        throw Error(ErrorCode::Usage, "--method", std::string(parts.front()),
                    "no such method; there are ch, dch-thres, dch-quant, dch-quant2, dch-dt3 and best");
    }
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        if (equals == std::string_view::npos) {
            fail(text, parts[i], "options are written as name=value");
        }
        setOption(method, text, parts[i].substr(0, equals), parts[i].substr(equals + 1));
    }
    return method;
}

std::string methodName(const Method& method) {
    const Method plain{.kind = method.kind};
    std::string name;
    for (const NamedKind& entry : kKinds) {
        if (entry.kind == method.kind) {
            name = entry.name;
        }
    }
    const auto add = [&](bool differs, const char* key, const std::string& value) {
        if (differs) {
            name += ":" + std::string(key) + "=" + value;
        }
    };
    add(method.tauDeg != plain.tauDeg, "tau", shortest(method.tauDeg));
    add(method.signedOrientation != plain.signedOrientation, "signed", method.signedOrientation ? "1" : "0");
    add(method.lambdaPxPerRad != plain.lambdaPxPerRad, "lambda", shortest(method.lambdaPxPerRad));
    add(method.bins != plain.bins, "bins", std::to_string(method.bins));
    add(method.binCentre != plain.binCentre, "centre", shortest(method.binCentre));
    add(method.binWeights != plain.binWeights, "weights", method.binWeights ? "1" : "0");
    add(method.backend != plain.backend, "backend", method.backend == Dt3Backend::Tensor ? "tensor" : "direct");
    add(method.live != plain.live, "live", method.live ? "1" : "0");
    for (const NamedIdea& idea : kIdeas) {
        add(method.ideas.*idea.field != plain.ideas.*idea.field, idea.name, method.ideas.*idea.field ? "1" : "0");
    }
    add(method.ideas.robustMm != plain.ideas.robustMm, "robust", shortest(method.ideas.robustMm));
    add(method.gatePx != plain.gatePx, "gate", shortest(method.gatePx));
    add(method.truncatePx2 != plain.truncatePx2, "truncate", shortest(method.truncatePx2));
    add(method.polygonEpsilonPx != plain.polygonEpsilonPx, "epsilon", shortest(method.polygonEpsilonPx));
    add(method.chordTangent != plain.chordTangent, "tangent", method.chordTangent ? "chord" : "polygon");
    add(method.maxIterations != plain.maxIterations, "iterations", std::to_string(method.maxIterations));
    add(method.damping != plain.damping, "damping", shortest(method.damping));
    add(method.schedule != plain.schedule, "schedule", method.schedule == Schedule::Paper ? "paper" : "rigid");
    return name;
}

std::vector<std::string> plainMethodNames() {
    std::vector<std::string> names;
    for (const NamedKind& entry : kKinds) {
        names.emplace_back(entry.name);
    }
    return names;
}

} // namespace core
