// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_filter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/text/number_text.h"

namespace core {

namespace {

using Problem = PairFilterProblem;

constexpr std::string_view kSigns = "<>=!";

/// Blanks beside a sign of comparison or a minus join what they stand between.
std::string withoutInnerBlanks(const std::string& text) {
    const auto isJoint = [](char c) { return kSigns.find(c) != std::string_view::npos || c == '-'; };
    const auto isBlank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    std::string joined;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isBlank(text[i])) {
            joined += text[i];
            continue;
        }
        std::size_t next = i;
        while (next < text.size() && isBlank(text[next]))
            ++next;
        const bool joins = (!joined.empty() && isJoint(joined.back())) || (next < text.size() && isJoint(text[next]));
        if (!joins && !joined.empty() && next < text.size())
            joined += ' ';
        i = next - 1;
    }
    return joined;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    const std::string joined = withoutInnerBlanks(text);
    for (std::size_t begin = 0; begin < joined.size();) {
        const std::size_t end = std::min(joined.find(' ', begin), joined.size());
        words.push_back(joined.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

/// A word in three parts. A method's options have an equals sign, too: the last sign of a word compares.
struct Parts {
    std::string left;
    Comparison comparison = Comparison::Equal;
    std::string right;
};

std::optional<Parts> partsOf(const std::string& word) {
    const std::size_t last = word.find_last_of(kSigns);
    if (last == std::string::npos || last == 0)
        return std::nullopt;
    const bool isDouble = word[last] == '=' && std::string_view("<>!=").find(word[last - 1]) != std::string_view::npos;
    const std::size_t first = isDouble ? last - 1 : last;
    static const std::array<std::pair<std::string_view, Comparison>, 7> kComparisons{
        {{"<", Comparison::Less},
         {"<=", Comparison::LessOrEqual},
         {"=", Comparison::Equal},
         {"==", Comparison::Equal},
         {"!=", Comparison::NotEqual},
         {">=", Comparison::GreaterOrEqual},
         {">", Comparison::Greater}}};
    const std::string sign = word.substr(first, last - first + 1);
    for (const auto& [text, comparison] : kComparisons)
        if (sign == text)
            return Parts{word.substr(0, first), comparison, word.substr(last + 1)};
    return std::nullopt;
}

std::optional<std::size_t> methodOf(const std::string& name, const PairTable& table, const ComparedMethods& compared) {
    const auto found = std::find(table.methods.begin(), table.methods.end(), name);
    if (found != table.methods.end())
        return static_cast<std::size_t>(found - table.methods.begin());
    if (name == "A" || name == "a")
        return compared.a < table.methods.size() ? std::optional(compared.a) : std::nullopt;
    if (name == "B" || name == "b")
        return compared.b < table.methods.size() ? std::optional(compared.b) : std::nullopt;
    return std::nullopt;
}

std::optional<PairQuantity> fieldOf(const std::string& name) {
    static const std::array<std::pair<std::string_view, PairField>, 6> kFields{{{"sequence", PairField::Sequence},
                                                                                {"seq", PairField::Sequence},
                                                                                {"start", PairField::Start},
                                                                                {"test", PairField::Test},
                                                                                {"difference", PairField::Difference},
                                                                                {"initial", PairField::StartErrorMm}}};
    for (const auto& [text, field] : kFields)
        if (name == text)
            return PairQuantity{field, 0, 0};
    return std::nullopt;
}

std::optional<double> numberOf(std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    return parseNumber(text, value) ? std::optional(value) : std::nullopt;
}

std::variant<PairCondition, Problem> conditionOf(const std::string& word, const PairTable& table,
                                                 const ComparedMethods& compared) {
    const std::optional<Parts> parts = partsOf(word);
    if (!parts) {
        const bool isSequence = std::any_of(table.pairs.begin(), table.pairs.end(),
                                            [&](const FramePair& pair) { return pair.sequence == word; });
        if (!isSequence)
            return Problem{Problem::Kind::NoComparison, word};
        return PairCondition{{PairField::Sequence, 0, 0}, Comparison::Equal, 0, word};
    }
    const auto quantity = parsePairQuantity(parts->left, table, compared);
    if (!quantity)
        return Problem{Problem::Kind::UnknownQuantity, parts->left};
    if (quantity->field == PairField::Sequence)
        return PairCondition{*quantity, parts->comparison, 0, parts->right};
    const auto value = numberOf(parts->right);
    if (!value)
        return Problem{Problem::Kind::NotANumber, parts->right};
    return PairCondition{*quantity, parts->comparison, *value, {}};
}

template <typename T>
bool holds(const T& a, Comparison comparison, const T& b) {
    switch (comparison) {
    case Comparison::Less:
        return a < b;
    case Comparison::LessOrEqual:
        return a <= b;
    case Comparison::Equal:
        return a == b;
    case Comparison::NotEqual:
        return a != b;
    case Comparison::GreaterOrEqual:
        return a >= b;
    case Comparison::Greater:
        return a > b;
    }
    return false;
}

bool meets(const PairTable& table, const PairCondition& condition, std::size_t pair) {
    if (condition.quantity.field == PairField::Sequence)
        return holds(table.pairs[pair].sequence, condition.comparison, condition.text);
    const double value = pairValue(table, condition.quantity, pair);
    return !std::isnan(value) && holds(value, condition.comparison, condition.value);
}

} // namespace

std::optional<PairQuantity> parsePairQuantity(const std::string& name, const PairTable& table,
                                              const ComparedMethods& compared) {
    if (const auto field = fieldOf(name))
        return field;
    if (const auto method = methodOf(name, table, compared))
        return PairQuantity{PairField::ErrorMm, *method, 0};
    for (const auto& [ending, field] :
         {std::pair(std::string_view(".seconds"), PairField::Seconds), {".iterations", PairField::Iterations}})
        if (name.ends_with(ending))
            if (const auto method = methodOf(name.substr(0, name.size() - ending.size()), table, compared))
                return PairQuantity{field, *method, 0};
    for (std::size_t minus = name.find('-'); minus != std::string::npos; minus = name.find('-', minus + 1)) {
        const auto a = methodOf(name.substr(0, minus), table, compared);
        const auto b = methodOf(name.substr(minus + 1), table, compared);
        if (a && b)
            return PairQuantity{PairField::ErrorDifferenceMm, *a, *b};
    }
    return std::nullopt;
}

std::variant<PairFilter, PairFilterProblem> parsePairFilter(const std::string& text, const PairTable& table,
                                                            const ComparedMethods& compared) {
    PairFilter filter;
    for (const std::string& word : wordsOf(text)) {
        const auto condition = conditionOf(word, table, compared);
        if (const auto* problem = std::get_if<Problem>(&condition))
            return *problem;
        filter.push_back(std::get<PairCondition>(condition));
    }
    return filter;
}

std::vector<std::size_t> filteredPairs(const PairTable& table, const PairFilter& filter) {
    std::vector<std::size_t> pairs;
    for (std::size_t pair = 0; pair < table.pairs.size(); ++pair)
        if (std::all_of(filter.begin(), filter.end(),
                        [&](const PairCondition& condition) { return meets(table, condition, pair); }))
            pairs.push_back(pair);
    return pairs;
}

} // namespace core
