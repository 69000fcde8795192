// SPDX-License-Identifier: MIT
#include "core/io/detector/pass_source.h"

#include <algorithm>

#include "core/contour/side_by_side.h"

namespace core {

namespace {

constexpr int kSearchEvery = 25; ///< looks after which a second hand is looked for again

/// The pictures of all cameras, read side by side; empty where there is none.
std::vector<cv::Mat> readPictures(const FrameSource& source, std::size_t cameras, int frame) {
    std::vector<cv::Mat> pictures(cameras);
    forEachSideBySide(cameras, [&](std::size_t c) {
        if (const int camera = static_cast<int>(c); source.hasPicture(camera, frame))
            pictures[c] = source.read(camera, frame);
    });
    return pictures;
}

} // namespace

DatasetPassSource::DatasetPassSource(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks* networks,
                                     DetectionJournal* journal)
    : m_dataset(dataset)
    , m_sequence(sequence)
    , m_frames(dataset, sequence, readMotion(dataset, sequence))
    , m_journal(journal) {
    if (networks)
        m_detector = std::make_unique<FrameDetector>(*networks, dataset.cameras);
}

const std::vector<cv::Mat>& DatasetPassSource::pictures(int frame) {
    if (m_last.first != frame)
        m_last = {frame, readPictures(m_frames, m_dataset.cameras.size(), frame)};
    return m_last.second;
}

int DatasetPassSource::viewCount() const {
    const auto masks = std::count_if(m_dataset.cameras.begin(), m_dataset.cameras.end(), [this](const Camera& camera) {
        return !maskPattern(m_sequence, camera.name).empty();
    });
    return std::max(countViews(m_sequence), static_cast<int>(masks));
}

FrameEvidence DatasetPassSource::evidence(int frame) {
    FrameEvidence evidence;
    if (hasMasks(m_sequence)) {
        evidence.masks = readFrameMasks(m_dataset.folder, m_sequence, m_dataset.cameras, frame);
        if (std::all_of(evidence.masks.begin(), evidence.masks.end(), [](const cv::Mat& mask) { return mask.empty(); }))
            evidence.masks.clear();
    }
    if (evidence.masks.empty())
        evidence.pictures = pictures(frame);
    return evidence;
}

ViewDetections DatasetPassSource::detect(int frame, const KnownHands& hands) {
    if (m_journal)
        if (const auto known = m_journal->frames().find(frame); known != m_journal->frames().end())
            return known->second;
    if (!m_detector)
        return ViewDetections(m_dataset.cameras.size());
    const bool searchAnyway = hands.hands.size() == 1 && ++m_sinceSearch >= kSearchEvery;
    if (searchAnyway)
        m_sinceSearch = 0;
    ViewDetections found = m_detector->detect(pictures(frame), hands, searchAnyway);
    if (m_journal)
        m_journal->append(frame, found);
    return found;
}

std::optional<FrameFit> DatasetPassSource::recall(const std::string& step, int frame) {
    if (!m_journal)
        return std::nullopt;
    const auto known = m_journal->fits().find({step, frame});
    return known == m_journal->fits().end() ? std::nullopt : std::optional(known->second);
}

void DatasetPassSource::remember(const std::string& step, int frame, const FrameFit& fit) {
    if (m_journal)
        m_journal->append({step, frame}, fit);
}

} // namespace core
