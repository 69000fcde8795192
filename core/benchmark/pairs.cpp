// SPDX-License-Identifier: MIT
#include "core/benchmark/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/error.h"
#include "core/numeric/random.h"

namespace core {

namespace {

void requireSensible(const PairOptions& options) {
    if (!(options.fraction > 0 && options.fraction <= 1))
        throw Error(ErrorCode::Usage, "", "fraction", "must be above 0 and at most 1");
    if (options.differences.empty())
        throw Error(ErrorCode::Usage, "", "differences", "must name at least one difference");
    std::set<int> seen;
    for (const int difference : options.differences) {
        if (difference < 1)
            throw Error(ErrorCode::Usage, "", "differences", "must be positive, not " + std::to_string(difference));
        if (!seen.insert(difference).second)
            throw Error(ErrorCode::Usage, "", "differences", std::to_string(difference) + " is named twice");
    }
}

std::vector<int> drawTestFrames(const PairFrames& sequence, const PairOptions& options) {
    const int largest = *std::max_element(options.differences.begin(), options.differences.end());
    const auto first = std::lower_bound(sequence.frames.begin(), sequence.frames.end(), largest);
    const std::vector<int> candidates(first, sequence.frames.end());
    const auto wanted = std::lround(options.fraction * static_cast<double>(sequence.frames.size()));
    const int count = static_cast<int>(std::min<long>(wanted, static_cast<long>(candidates.size())));
    RandomGenerator random(options.seed ^ stableHash(sequence.sequence));
    std::vector<int> frames;
    for (const int i : sampleWithoutReplacement(static_cast<int>(candidates.size()), count, random))
        frames.push_back(candidates[static_cast<std::size_t>(i)]);
    std::sort(frames.begin(), frames.end());
    return frames;
}

} // namespace

std::vector<FramePair> drawPairs(const std::vector<PairFrames>& sequences, const PairOptions& options) {
    requireSensible(options);
    std::vector<FramePair> pairs;
    for (const PairFrames& sequence : sequences) {
        for (const int test : drawTestFrames(sequence, options))
            for (const int difference : options.differences)
                pairs.push_back({sequence.sequence, test - difference, test});
    }
    return pairs;
}

std::vector<FramePair> pairsOfShard(const std::vector<FramePair>& pairs, const Shard& shard) {
    if (shard.count < 1 || shard.index < 0 || shard.index >= shard.count)
        throw Error(ErrorCode::Usage, "", "shard", "must be i/n with 0 <= i < n");
    std::map<std::pair<std::string, int>, int> numberOf;
    std::vector<FramePair> mine;
    for (const FramePair& pair : pairs) {
        const auto next = static_cast<int>(numberOf.size());
        const int number = numberOf.try_emplace({pair.sequence, pair.test}, next).first->second;
        if (number % shard.count == shard.index)
            mine.push_back(pair);
    }
    return mine;
}

} // namespace core
