// SPDX-License-Identifier: MIT
#include "core/fitting/method_options.h"

#include <array>
#include <stdexcept>
#include <type_traits>

#include "core/text/number_text.h"

namespace core {

namespace {

// Sets of methods, one bit each.
constexpr unsigned bit(DistanceKind distance) {
    return 1u << static_cast<unsigned>(distance);
}
template <typename Predicate>
constexpr unsigned kindsThat(Predicate isOne) {
    unsigned kinds = 0;
    for (const DistanceTraits& traits : kDistanceTraits)
        kinds |= isOne(traits) ? bit(traits.kind) : 0;
    return kinds;
}
constexpr unsigned kBest = 1u << kDistanceTraits.size();
constexpr unsigned kThres = kindsThat([](const DistanceTraits& traits) { return traits.isLimited; });
constexpr unsigned kQuant2 = kindsThat([](const DistanceTraits& traits) { return traits.bins > 1; });
constexpr unsigned kDt3 = kindsThat([](const DistanceTraits& traits) { return traits.isOriented; });
constexpr unsigned kBinned = kDt3 | kindsThat([](const DistanceTraits& traits) { return traits.bins > 0; });
constexpr unsigned kDirectional = kThres | kBinned;
constexpr unsigned kPaper = kindsThat([](const DistanceTraits&) { return true; });
constexpr unsigned kAll = kPaper | kBest;

template <typename Owner, typename Value>
struct MemberOf {
    using OwnerType = Owner;
    using ValueType = Value;
};
template <typename Owner, typename Value>
MemberOf<Owner, Value> memberOf(Value Owner::*);

template <auto Field>
using FieldOwner = typename decltype(memberOf(Field))::OwnerType;
template <auto Field>
using FieldValue = typename decltype(memberOf(Field))::ValueType;

/// A field of a method or of its BestOptions, which are there for every option that applies to `best`.
template <auto Field, typename AnyMethod>
auto& valueOf(AnyMethod& method) {
    if constexpr (std::is_same_v<FieldOwner<Field>, Method>)
        return method.*Field;
    else
        return (*method.best).*Field;
}

struct ValueFormat {
    OptionDomain domain;
    std::string (*parse)(Method& method, std::string_view value);
    std::string (*print)(const Method& method);
};

/// A number within [Low, High].
template <auto Field, double Low, double High>
constexpr ValueFormat number() {
    return {{Low, High, std::is_integral_v<FieldValue<Field>>, {}},
            [](Method& method, std::string_view value) -> std::string {
                double parsed = 0;
                if (!parseNumber(value, parsed) || parsed < Low || parsed > High)
                    return "'" + std::string(value) + "' is not a number from " + exactText(Low) + " to " +
                           exactText(High);
                if (std::is_integral_v<FieldValue<Field>> && parsed != static_cast<int>(parsed))
                    return "must be a whole number";
                valueOf<Field>(method) = static_cast<FieldValue<Field>>(parsed);
                return "";
            },
            [](const Method& method) { return exactText(static_cast<double>(valueOf<Field>(method))); }};
}

/// One of two words, for the values 0 and 1 of the field.
template <auto Field, const std::array<std::string_view, 2>& Words>
constexpr ValueFormat choice() {
    return {{0, 0, false, Words},
            [](Method& method, std::string_view value) -> std::string {
                for (int i = 0; i < 2; ++i) {
                    if (value == Words[static_cast<std::size_t>(i)]) {
                        valueOf<Field>(method) = static_cast<FieldValue<Field>>(i);
                        return "";
                    }
                }
                return "must be " + std::string(Words[0]) + " or " + std::string(Words[1]);
            },
            [](const Method& method) { return std::string(Words[static_cast<std::size_t>(valueOf<Field>(method))]); }};
}

constexpr std::array<std::string_view, 2> kNoYes{"0", "1"};
constexpr std::array<std::string_view, 2> kBackends{"direct", "tensor"};
constexpr std::array<std::string_view, 2> kTangents{"polygon", "chord"};
constexpr std::array<std::string_view, 2> kForearms{"cut", "ignore"};
constexpr std::array<std::string_view, 2> kSchedules{"rigid", "paper"};

template <auto Field>
constexpr ValueFormat flag() {
    return choice<Field, kNoYes>();
}

constexpr MethodOption option(std::string_view key, unsigned methods, ValueFormat format, std::string_view meaning,
                              std::string_view defaultText, std::string_view source) {
    return {key, methods, meaning, defaultText, source, format.domain, format.parse, format.print};
}

using B = BestOptions;
using M = Method;

constexpr std::array kOptions{
    option("tau", kThres, number<&M::tauDeg, 0.0, 180.0>(), "a match is kept if the directions differ by less, deg",
           "22.5", "paper: the best of its figure"),
    option("signed", kDirectional, flag<&M::signedOrientation>(), "directions over 360 deg; else lines over 180 deg",
           "1", "paper: signed is better"),
    option("lambda", kDt3, number<&M::lambdaPxPerRad, 0.0, 1000.0>(), "weight of orientation, px per rad", "25",
           "paper: saturates from 15 to 35"),
    option("bins", kBinned, number<&M::bins, 1.0, 256.0>(), "orientation bins", "8 for Quant and Quant2, 16 for DT3",
           "paper: 16 suffice for DT3, fewer are better for Quant"),
    option("centre", kBinned, number<&M::binCentre, 0.0, 0.999>(),
           "where orientation bins are centred: on the x axis, or that share of a bin beside it", "0",
           "own; the paper says nothing"),
    option("weights", kQuant2, flag<&M::binWeights>(), "weigh the two matches of Quant2 by how near their bins are",
           "0", "own; paper: equal weights"),
    option("backend", kDt3, choice<&M::backend, kBackends>(), "DT3 by a tensor or by direct search: equal matches",
           "direct", "own; paper: a tensor"),
    option("live", kBest, flag<&B::live>(), "the real-time variant", "0", "own"),
    option("palm", kBest, flag<&B::palm>(), "the palm is placed before the fingers move", "1", "own"),
    option("coarse", kBest, flag<&B::coarse>(), "coarse levels of the mesh first", "1", "own"),
    option("wide", kBest, flag<&B::wide>(), "tau anneals from 45 deg to 22.5", "1", "own"),
    option("across", kBest, flag<&B::across>(), "the distance along the outline counts a tenth", "1", "own"),
    option("prior", kBest, flag<&B::prior>(), "a weak pull of the angles to those of the start", "1", "own"),
    option("learnt", kBest, flag<&B::learnt>(), "the pull knows how fingers move together; 0 with prior=0 or noise=0",
           "1", "own; learnt from the demo's motion"),
    option("restarts", kBest, flag<&B::restarts>(), "other starts where silhouettes are left unexplained", "1", "own"),
    option("apart", kBest, flag<&B::apart>(),
           "fingers and hands do not penetrate each other on the way from other starts", "1", "own"),
    option("polish", kBest, flag<&B::polish>(), "last iterations on the full mesh", "1", "own"),
    option("noise", kAll, flag<&M::noise>(),
           "small outlines, directions, prior, restarts and last weights are relative to the contour's noise", "1",
           "own; the paper's silhouettes have next to none"),
    option("both", kBest, flag<&B::bothWays>(), "contour points pull the model, too", "0", "own"),
    option("within", kBest, flag<&B::withinTau>(), "only contour points within tau are searched", "0", "own"),
    option("robust", kBest, number<&B::robustMm, 0.0, 1000.0>(), "Cauchy weights with that scale, mm; 0 for none", "0",
           "own"),
    option("gate", kPaper, number<&M::gatePx, 0.0, 1e6>(), "longest distance of a match, px",
           "60 for Quant and Quant2, none for the others", "own; the paper names no gate"),
    option("truncate", kPaper, number<&M::truncatePx2, 0.0, 1e9>(),
           "K of Stenger's truncated penalty, px^2; 0 for none", "0", "Stenger et al. 2006"),
    option("epsilon", kAll, number<&M::polygonEpsilonPx, 0.1, 20.0>(), "epsilon of approxPolyDP for phi(q), px", "1.25",
           "own; the paper names approxPolyDP, no epsilon"),
    option("tangent", kAll, choice<&M::chordTangent, kTangents>(),
           "phi(q) from polygon segments or from a chord of +-7 px", "polygon", "paper: a line representation"),
    option("forearm", kAll, choice<&M::forearm, kForearms>(),
           "contour beyond the end of a hand model, where silhouettes go on there: left out, or as any other", "cut",
           "own; the paper's masks end at the wrist"),
    option("iterations", kPaper, number<&M::maxIterations, 1.0, 1000.0>(), "most iterations of a fit", "25",
           "own; the paper gives none"),
    option("damping", kPaper, number<&M::damping, 0.0, 10.0>(), "damping relative to the diagonal of the normal matrix",
           "0.001", "own; the paper gives none"),
    option("schedule", kPaper, choice<&M::schedule, kSchedules>(),
           "a first phase moves only the six rigid degrees of freedom of each hand", "rigid",
           "own; paper: no such phase"),
};

} // namespace

bool MethodOption::appliesTo(const Method& method) const {
    return (methods & (method.best ? kBest : bit(method.distance))) != 0;
}

std::span<const MethodOption> methodOptions() {
    return kOptions;
}

const MethodOption& methodOption(std::string_view key) {
    for (const MethodOption& candidate : kOptions)
        if (candidate.key == key)
            return candidate;
    throw std::out_of_range("method option " + std::string(key));
}

} // namespace core
