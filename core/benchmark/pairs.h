// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace core {

/// A start frame and the test frame to be estimated from it, of one sequence.
struct FramePair {
    std::string sequence;
    int start = 0;
    int test = 0;
    int difference() const { return test - start; }
    auto operator<=>(const FramePair&) const = default;
};

/// The frames of one sequence from which test frames are drawn.
struct PairFrames {
    std::string sequence;
    std::vector<int> frames; ///< ascending; all frames, or the annotated ones
};

struct PairOptions {
    double fraction = 0.1; ///< of the frames of a sequence that become test frames, in (0, 1]
    std::vector<int> differences = {1, 5, 10, 15};
    std::uint64_t seed = 0;
};

/// Draws test frames per sequence: round(fraction * N) of its N frames, among those that are not before the largest
/// difference, without repetition. Every test frame gives a pair per difference, start = test - difference.
/// Ordered by sequence as given, then test frame, then difference as given. What is drawn depends on the seed, the name
/// of the sequence and its frames alone: it is the same on every machine, whatever other sequences there are.
/// Throws Error(Usage) if the fraction or a difference makes no sense.
std::vector<FramePair> drawPairs(const std::vector<PairFrames>& sequences, const PairOptions& options);

/// Which part of the work a run does: test frames (a sequence and a frame) whose number modulo `count` is `index`, so
/// that all pairs of a test frame, which share their target, stay together.
struct Shard {
    int index = 0;
    int count = 1;
    bool operator==(const Shard&) const = default;
};

/// The pairs of a shard, in their order. Throws Error(Usage) unless 0 <= index < count.
std::vector<FramePair> pairsOfShard(const std::vector<FramePair>& pairs, const Shard& shard);

} // namespace core
