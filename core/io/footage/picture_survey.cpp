// SPDX-License-Identifier: MIT
#include "core/io/footage/picture_survey.h"

#include <algorithm>
#include <climits>

#include "core/error.h"

namespace core {

PictureSurvey::PictureSurvey(const VideoDemuxer& video, std::shared_ptr<const VideoIndex> index)
    : m_video(video)
    , m_index(std::move(index)) {}

bool PictureSurvey::isWanted(const SmallPictures& pictures, int picture) const {
    return !pictures.has(picture) && !m_damaged.contains(picture);
}

/// Not where every picture is quick to decode by itself.
bool PictureSurvey::isWorthIt() const {
    return m_index->isCounted || std::any_of(
                                     m_index->packets.begin(), m_index->packets.end(),
                                     [](const auto& packet) { return packet.picture >= 0 && !packet.isKey; });
}

/// Going on within a group of pictures comes first, since it was decoded up to there.
std::optional<int> PictureSurvey::next(const SmallPictures& pictures, int focus, int first, int last) const {
    const int onwards = m_last + 1;
    if (m_reader && m_last >= 0 && onwards <= last && isWanted(pictures, onwards) &&
        m_index->startFor(onwards, INT_MAX) == m_index->startFor(m_last, INT_MAX))
        return onwards;
    for (int distance = 0; focus + distance <= last || focus - distance >= first; ++distance)
        for (const int picture : {focus + distance, focus - distance})
            if (picture >= first && picture <= last && isWanted(pictures, picture))
                return picture;
    return std::nullopt;
}

bool PictureSurvey::step(SmallPictures& pictures, int focus, int first, int last, const std::stop_token& stop) {
    if (stop.stop_requested())
        return false;
    const std::optional<int> wanted =
        next(pictures, focus, std::max(0, first), std::min(last, m_index->pictures() - 1));
    if (!wanted || !pictures.hasRoomFor(*wanted, focus) || !isWorthIt()) {
        m_reader.reset();
        return false;
    }
    const auto keep = [&](int picture, const AVFrame& frame) {
        if (frame.width == m_index->size.width && frame.height == m_index->size.height && !pictures.has(picture))
            pictures.keep(picture, m_converter.toBgr(frame, kGlanceShrink), focus);
    };
    m_last = *wanted;
    try {
        if (!m_reader) {
            m_reader = std::make_unique<PictureReader>(m_video.another(), m_index, 1);
            m_reader->setBudget(1); // the last picture alone; those before it are let go of
        }
        m_reader->setOnForgotten(keep);
        const AVFrame* frame = m_reader->read(*wanted, stop);
        if (frame != nullptr)
            keep(*wanted, *frame);
        m_reader->setOnForgotten({});
        if (frame == nullptr)
            return false;    // stopped
    } catch (const Error&) { // it is thrown again when the picture is asked for
        if (m_reader)
            m_reader->setOnForgotten({});
    }
    if (!pictures.has(*wanted))
        m_damaged.insert(*wanted);
    return true;
}

} // namespace core
