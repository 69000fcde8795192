// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/benchmark/comparison/pair_table.h"

namespace core {

enum class Comparison { Less, LessOrEqual, Equal, NotEqual, GreaterOrEqual, Greater };

/// One part of a filter; a pair without the value fails it.
struct PairCondition {
    PairQuantity quantity;
    Comparison comparison = Comparison::Greater;
    double value = 0;
    std::string text; ///< of a sequence
};

/// A pair passes if it meets every condition.
using PairFilter = std::vector<PairCondition>;

/// Why a text is not a filter.
struct PairFilterProblem {
    enum class Kind {
        UnknownQuantity, ///< `word` is neither a field nor a method of the results
        NotANumber,      ///< `word` stands where a number is expected
        NoComparison     ///< `word` has none of < <= = != >= >, and no sequence has that name
    };
    Kind kind;
    std::string word;
};

/// The two methods that A and B stand for, as indices into the table's methods.
struct ComparedMethods {
    std::size_t a = 0;
    std::size_t b = 0;
    bool operator==(const ComparedMethods&) const = default;
};

/// What a name means, as it stands left of a comparison (parsePairFilter); empty if it means nothing.
std::optional<PairQuantity> parsePairQuantity(const std::string& name, const PairTable& table,
                                              const ComparedMethods& compared);

/// Reads conditions with blanks between them: "A-B>1 difference>=10 sequence=01". Left of the comparison stands a
/// method's name or A or B (its error, mm), two of them with a minus between, either with ".seconds" or ".iterations",
/// or one of sequence, start, test, difference, initial (error of the start pose, mm). A sequence's name alone means
/// that sequence. Blanks around signs do not matter; a comma in a number is a point.
std::variant<PairFilter, PairFilterProblem> parsePairFilter(const std::string& text, const PairTable& table,
                                                            const ComparedMethods& compared);

/// Indices of the pairs that pass, in their order.
std::vector<std::size_t> filteredPairs(const PairTable& table, const PairFilter& filter);

} // namespace core
