// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>

#include "core/annotation/edit.h"

namespace test {

/// Draws edits of a small world, so that they often meet: marks of two frames, two raters, four joints, two cameras;
/// notes.
class RandomEdits {
public:
    explicit RandomEdits(std::mt19937_64::result_type seed)
        : m_random(seed) {}

    int draw(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    core::Edit next(const core::AnnotationSet& set) {
        core::Edit edit{{.text = "random " + std::to_string(draw(1000))}, {}, {}};
        std::map<core::MarkKey, std::optional<core::Mark>> wanted;
        for (int i = draw(5); i >= 0; --i)
            wanted[key()] = mark();
        for (const auto& [key, mark] : wanted)
            if (core::markAt(set, key) != mark)
                edit.marks.push_back({key, core::markAt(set, key), mark});
        if (draw(4) == 0) {
            const int frame = draw(3);
            const auto note = set.notes.find(frame);
            const std::string before = note == set.notes.end() ? "" : note->second,
                              after = draw(2) ? "" : "note " + std::to_string(draw(9));
            if (before != after)
                edit.notes.push_back({frame, before, after});
        }
        return edit;
    }

private:
    core::MarkKey key() {
        return {draw(2),
                draw(2) ? "ann" : "bob",
                {draw(2) ? core::Side::Left : core::Side::Right, draw(2) ? "wrist" : "thumb_ip"},
                "cam" + std::to_string(draw(2))};
    }
    std::optional<core::Mark> mark() {
        if (draw(3) == 0)
            return std::nullopt;
        return core::Mark{{draw(4000) / 7.0, draw(4000) / 3.0},
                          static_cast<core::Placement>(draw(2)),
                          static_cast<core::MarkState>(draw(3))};
    }

    std::mt19937_64 m_random;
};

} // namespace test
