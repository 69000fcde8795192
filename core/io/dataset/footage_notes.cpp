// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/io/dataset/instants.h"
#include "core/io/dataset/measured_footage.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr std::size_t kMostPlaces = 6; ///< that a note lists

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// The first few ranges, each in the words of `text`, and how many more there are.
std::string listed(const std::vector<InstantRange>& ranges,
                   const std::function<std::string(const InstantRange&)>& text) {
    std::string list;
    for (std::size_t i = 0; i < std::min(ranges.size(), kMostPlaces); ++i)
        list += (list.empty() ? "" : ", ") + text(ranges[i]);
    const std::size_t more = ranges.size() - std::min(ranges.size(), kMostPlaces);
    return list + (more > 0 ? " and " + std::to_string(more) + " more places" : "");
}

/// "cam1: 8 frames missing after frame 499"
std::string lostFrames(const std::string& camera, const std::vector<InstantRange>& lost) {
    const std::string start = camera + ": " + counted(countInstants(lost), "frame") + " missing";
    if (lost.size() == 1)
        return start + " after frame " + std::to_string(lost.front().first - 1);
    return start + ": " + listed(lost, [](const InstantRange& range) {
               return std::to_string(range.count) + " after frame " + std::to_string(range.first - 1);
           });
}

/// "cam0: 2 pictures missing: 7-8"
std::string missingPictures(const ViewSource& view) {
    return view.camera + ": " + counted(countInstants(view.missing), "picture") + " missing: " +
           listed(
               view.missing,
               [&](const InstantRange& range) {
                   const int first = range.first + view.offsetFrames, last = first + range.count - 1;
                   return std::to_string(first) + (last > first ? "-" + std::to_string(last) : "");
               });
}

/// Lost frames of a video that is taken by number: where they are, in frames of the sequence.
std::vector<InstantRange> lostByNumber(const ViewSource& view, const MeasuredFootage& footage, int frameCount) {
    std::vector<InstantRange> lost;
    for (const FrameGap& gap : footage.timing.gaps) {
        const int next = gap.after + 1 - view.offsetFrames;
        if (next > 0 && next < frameCount)
            lost.push_back({next, gap.count});
    }
    return lost;
}

class Notes {
public:
    explicit Notes(const Sequence& sequence, const std::map<std::string, MeasuredFootage>& measured)
        : m_sequence(sequence)
        , m_measured(measured) {}

    std::vector<std::string> all() {
        for (const ViewSource& view : m_sequence.views) {
            if (const auto found = m_measured.find(view.camera); found != m_measured.end()) {
                view.kind == ViewKind::Video ? noteVideo(view, found->second) : noteImages(view);
                noteLength(view, found->second);
                noteRate(view, found->second);
            }
        }
        return m_notes;
    }

private:
    bool isByTime(const ViewSource& view, const MeasuredFootage& footage) const {
        return view.missing == within(layOut(footage, view.offsetFrames, true).missing, m_sequence.frameCount);
    }

    void noteVideo(const ViewSource& view, const MeasuredFootage& footage) {
        if (!footage.timing.isSane && footage.frames > 2 && m_measured.size() > 1) {
            m_notes.push_back(view.camera + ": its time stamps are uneven or missing, so lost frames cannot be told; "
                                            "its frames are taken by number");
        } else if (!view.missing.empty()) {
            m_notes.push_back(lostFrames(view.camera, view.missing));
        } else if (const auto lost = lostByNumber(view, footage, m_sequence.frameCount); !lost.empty()) {
            m_notes.push_back(
                lostFrames(view.camera, lost) +
                " (its time stamps say so); its frames are taken by number, so the later ones are not of the other "
                "cameras' instants" +
                (timeProblem(m_measured).empty() ? " (new --sync time maps them by time)" : ""));
        }
    }

    void noteImages(const ViewSource& view) {
        if (!view.missing.empty()) {
            m_notes.push_back(missingPictures(view));
            if (view.offsetFrames > 0)
                m_notes.push_back(view.camera + ": frame 0 is picture " + std::to_string(view.offsetFrames));
        }
    }

    void noteLength(const ViewSource& view, const MeasuredFootage& footage) {
        const int more = layOut(footage, view.offsetFrames, isByTime(view, footage)).instants - m_sequence.frameCount;
        const bool isTimed = view.kind == ViewKind::Video && !view.missing.empty();
        if (more > 0 && isTimed)
            m_notes.push_back(view.camera + " goes on for " + counted(more, "frame") + " after the last instant");
        else if (more > 0)
            m_notes.push_back(view.camera + " has " + counted(more, "frame") +
                              " more than the shortest footage: are they all of the same instants?");
    }

    void noteRate(const ViewSource& view, const MeasuredFootage& footage) {
        if (footage.framesPerSecond > 0 &&
            std::abs(footage.framesPerSecond - m_sequence.framesPerSecond) > 0.01 * footage.framesPerSecond) {
            m_notes.push_back(view.camera + " was recorded at another frame rate than the sequence's " +
                              exactText(m_sequence.framesPerSecond));
        }
    }

    const Sequence& m_sequence;
    const std::map<std::string, MeasuredFootage>& m_measured;
    std::vector<std::string> m_notes;
};

} // namespace

std::vector<std::string> footageNotes(const Sequence& sequence,
                                      const std::map<std::string, MeasuredFootage>& measured) {
    return Notes(sequence, measured).all();
}

} // namespace core
