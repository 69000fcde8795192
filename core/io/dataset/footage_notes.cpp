// SPDX-License-Identifier: MIT
#include "core/io/dataset/footage_notes.h"

#include <cmath>

namespace core {

namespace {

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

/// Missing instants as numbers of the view's images.
std::vector<InstantRange> numbersOfMissing(const ViewSource& view) {
    std::vector<InstantRange> numbers = view.missing;
    for (InstantRange& range : numbers)
        range.first += view.offsetFrames;
    return numbers;
}

class Notes {
public:
    explicit Notes(const Sequence& sequence, const std::map<std::string, MeasuredFootage>& measured)
        : m_sequence(sequence)
        , m_measured(measured) {}

    std::vector<FootageNote> all() {
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
            m_notes.push_back({FootageNoteKind::UnevenTimes, {view.camera}});
        } else if (!view.missing.empty()) {
            m_notes.push_back({FootageNoteKind::LostFrames, {view.camera}, view.missing});
        } else if (const auto lost = lostByNumber(view, footage, m_sequence.frameCount); !lost.empty()) {
            m_notes.push_back({timeProblem(m_measured).empty() ? FootageNoteKind::LostFramesByChoice
                                                               : FootageNoteKind::LostFramesByNumber,
                               {view.camera},
                               lost});
        }
    }

    void noteImages(const ViewSource& view) {
        if (view.missing.empty())
            return;
        m_notes.push_back({FootageNoteKind::MissingPictures, {view.camera}, numbersOfMissing(view)});
        if (view.offsetFrames > 0)
            note(FootageNoteKind::FirstPicture, view, view.offsetFrames);
    }

    void noteLength(const ViewSource& view, const MeasuredFootage& footage) {
        const int more = layOut(footage, view.offsetFrames, isByTime(view, footage)).instants - m_sequence.frameCount;
        const bool isTimed = view.kind == ViewKind::Video && !view.missing.empty();
        if (more > 0)
            note(isTimed ? FootageNoteKind::LongerThanTheInstants : FootageNoteKind::LongerThanTheShortest, view, more);
    }

    void noteRate(const ViewSource& view, const MeasuredFootage& footage) {
        if (footage.framesPerSecond > 0 &&
            std::abs(footage.framesPerSecond - m_sequence.framesPerSecond) > 0.01 * footage.framesPerSecond)
            note(FootageNoteKind::OtherRate, view, m_sequence.framesPerSecond);
    }

    void note(FootageNoteKind kind, const ViewSource& view, double number) {
        m_notes.push_back({kind, {view.camera}, {}, {number}});
    }

    const Sequence& m_sequence;
    const std::map<std::string, MeasuredFootage>& m_measured;
    std::vector<FootageNote> m_notes;
};

} // namespace

std::vector<FootageNote> footageNotes(const Sequence& sequence,
                                      const std::map<std::string, MeasuredFootage>& measured) {
    return Notes(sequence, measured).all();
}

} // namespace core
