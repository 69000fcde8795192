// SPDX-License-Identifier: MIT
#include "core/detection/frame_detection.h"

#include <algorithm>
#include <mutex>

#include <opencv2/core/utility.hpp>

namespace core {

namespace {

constexpr std::size_t kMostHands = 2;
constexpr std::size_t kViewsAtOnce = 2;   ///< that are searched before their agreement is asked for
constexpr double kAroundShare = 0.9;      ///< of a hand's square, that hands which were known are searched around
constexpr double kSettledResidual = 0.03; ///< median, share of the square's side

/// An order of the views in which neighbours of a ring come late: they tell least of each other.
std::vector<std::size_t> searchOrder(std::size_t count) {
    const std::size_t step = std::max<std::size_t>(1, (count + 3) / 4);
    std::vector<std::size_t> order;
    for (std::size_t first = 0; first < step; ++first)
        for (std::size_t i = first; i < count; i += step)
            order.push_back(i);
    return order;
}

/// Lends the detectors to the threads that ask for one.
class Lender {
public:
    explicit Lender(std::vector<HandDetector>& detectors) {
        for (HandDetector& detector : detectors)
            m_free.push_back(&detector);
    }
    HandDetector& borrow() {
        const std::lock_guard lock(m_mutex);
        HandDetector* detector = m_free.back();
        m_free.pop_back();
        return *detector;
    }
    void giveBack(HandDetector& detector) {
        const std::lock_guard lock(m_mutex);
        m_free.push_back(&detector);
    }

private:
    std::mutex m_mutex;
    std::vector<HandDetector*> m_free;
};

/// Calls body(i, detector) for every i below `count`. OpenCV runs what its own loops nest on one thread, so that the
/// results do not depend on how many there are.
template <typename Body>
void forEachView(std::size_t count, std::vector<HandDetector>& detectors, Body body) {
    Lender lender(detectors);
    const int total = static_cast<int>(count);
    cv::parallel_for_(
        cv::Range(0, total),
        [&](const cv::Range& range) {
            HandDetector& detector = lender.borrow();
            for (int i = range.start; i < range.end; ++i)
                body(static_cast<std::size_t>(i), detector);
            lender.giveBack(detector);
        },
        total);
}

/// The part of a picture around where hands were; empty if they are not seen there.
cv::Rect windowAround(const Camera& camera, const std::vector<SpatialHand>& hands, cv::Size picture) {
    cv::Rect2d box;
    for (const SpatialHand& hand : hands)
        if (const auto px = projectHand(camera, hand)) {
            const HandPlace place = placeOf(*px);
            const double reach = kAroundShare * place.sidePx;
            box |= cv::Rect2d(place.centrePx.x() - reach, place.centrePx.y() - reach, 2 * reach, 2 * reach);
        }
    return cv::Rect(box) & cv::Rect({0, 0}, picture);
}

} // namespace

FrameDetector::FrameDetector(const DetectorNetworks& networks, std::vector<Camera> cameras, DetectorOptions options)
    : m_cameras(std::move(cameras)) {
    const std::size_t atOnce = std::max(1, cv::getNumThreads());
    for (std::size_t i = 0; i < std::min(atOnce + 1, std::max<std::size_t>(1, m_cameras.size())); ++i)
        m_detectors.emplace_back(networks, options);
}

bool FrameDetector::isSettled(const std::vector<SpatialHand>& hands, const Pictures& pictures,
                              std::size_t wanted) const {
    const auto views = static_cast<std::size_t>(std::count_if(
        pictures.begin(), pictures.end(), [](const cv::Mat& picture) { return !picture.empty(); }));
    return hands.size() >= wanted && std::all_of(hands.begin(), hands.end(), [&](const SpatialHand& hand) {
               return 2 * hand.views.size() >= views && hand.medianResidual() < kSettledResidual;
           });
}

void FrameDetector::lookFor(const std::vector<SpatialHand>& hands, const Pictures& pictures, int passes,
                            ViewDetections& found) {
    forEachView(
        pictures.size(), m_detectors,
        [&](std::size_t view, HandDetector& detector) {
            if (pictures[view].empty())
                return;
            std::vector<DetectedHand>& list = found[view];
            for (const SpatialHand& hand : hands) {
                const auto px = hand.views.count(static_cast<int>(view)) > 0 && passes > 1
                                    ? std::nullopt // it has been seen there
                                    : projectHand(m_cameras[view], hand);
                const auto seen = px ? detector.findLandmarks(pictures[view], placeOf(*px), passes) : std::nullopt;
                if (seen)
                    list.push_back(*seen);
            }
            list = withoutDuplicates(std::move(list));
        });
}

void FrameDetector::search(const std::vector<std::size_t>& views, const Pictures& pictures,
                           const std::vector<SpatialHand>& around, ViewDetections& found) {
    forEachView(
        views.size(), m_detectors,
        [&](std::size_t i, HandDetector& detector) {
            const std::size_t view = views[i];
            if (pictures[view].empty())
                return;
            const cv::Rect window = windowAround(m_cameras[view], around, pictures[view].size());
            if (window.empty() && !around.empty())
                return;
            for (DetectedHand& hand :
                 around.empty() ? detector.search(pictures[view], true) : detector.searchIn(pictures[view], window))
                found[view].push_back(hand);
            found[view] = withoutDuplicates(std::move(found[view]));
        });
}

bool FrameDetector::searchViews(const Pictures& pictures, const std::vector<SpatialHand>& around,
                                ViewDetections& found) {
    const std::vector<std::size_t> order = searchOrder(pictures.size());
    for (std::size_t begin = 0; begin < order.size(); begin += kViewsAtOnce) {
        const std::vector<std::size_t> views(
            order.begin() + static_cast<std::ptrdiff_t>(begin),
            order.begin() + static_cast<std::ptrdiff_t>(std::min(begin + kViewsAtOnce, order.size())));
        search(views, pictures, around, found);
        lookFor(groupDetections(m_cameras, found), pictures, 2, found);
        if (isSettled(groupDetections(m_cameras, found), pictures, kMostHands))
            return true;
    }
    return false;
}

ViewDetections FrameDetector::detect(const std::vector<cv::Mat>& pictures, const KnownHands& known, bool searchAnyway) {
    ViewDetections found(pictures.size());
    if (!known.hands.empty() && known.isRecent) {
        lookFor(known.hands, pictures, 1, found);
        if (!searchAnyway && isSettled(groupDetections(m_cameras, found), pictures, known.hands.size()))
            return found;
    }
    if (known.hands.size() < kMostHands || searchAnyway || !searchViews(pictures, known.hands, found))
        searchViews(pictures, {}, found);
    return found;
}

} // namespace core
