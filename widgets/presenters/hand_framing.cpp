// SPDX-License-Identifier: MIT
#include "widgets/presenters/hand_framing.h"

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {

constexpr double kRoom = 0.06;        // around the hands, of the box's longer side
constexpr double kAwayScreenPx = 24;  // from where the arm begins to the label
constexpr double kLargeEnough = 0.5;  // of a view's longer side, from which on hands are shown well
constexpr double kDirectionPx = 1e-3; // a shorter way has no direction

QRectF withRoom(const QRectF& box) {
    const double room = kRoom * std::max(box.width(), box.height());
    return box.adjusted(-room, -room, room, room);
}

/// Whether a view of `shown` holds the hands, and not small ones.
bool showsWell(const QRectF& shown, const QRectF& hands) {
    return shown.contains(hands) &&
           std::max(hands.width(), hands.height()) > kLargeEnough * std::max(shown.width(), shown.height());
}

/// Beside the place where the arm begins, away from the fingers; empty if that is not in the picture.
std::optional<HandLabel> labelIn(const core::Camera& camera, const HandPlace& hand) {
    const auto inView = [&](const Eigen::Vector3d& point) { return core::project(camera, point); };
    Eigen::Vector3d middleInWorld = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : hand.pointsInWorld)
        middleInWorld += point / static_cast<double>(hand.pointsInWorld.size());
    const auto middle = inView(middleInWorld);
    const auto start = hand.startsAtRoot ? inView(hand.pointsInWorld.front()) : middle;
    if (!middle || !start)
        return std::nullopt;
    const Eigen::Vector2d way = *start - *middle;
    const bool hasWay = way.norm() > kDirectionPx;
    const Eigen::Vector2d away =
        hasWay ? Eigen::Vector2d(way.normalized() * kAwayScreenPx) : Eigen::Vector2d(0, kAwayScreenPx);
    const Eigen::Vector2d at =
        core::isInside(camera.size, *start) ? *start : *middle; // an arm may begin outside of the picture
    if (!core::isInside(camera.size, at))
        return std::nullopt;
    return HandLabel{hand.side, {at.x(), at.y()}, {away.x(), away.y()}, {}};
}

} // namespace

HandFraming::HandFraming(const HandSources& sources, CameraGrid& grid, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_sources(sources)
    , m_grid(grid)
    , m_maskJob(pool) {
    connect(&grid, &CameraGrid::maximisedChanged, this, &HandFraming::frameMaximised);
    connect(&sources.selection, &Selection::frameChanged, this, &HandFraming::refreshLabels);
    connect(&sources.reconstructions, &Reconstructions::changed, this, &HandFraming::refreshLabels);
    connect(&sources.model, &HandModelFit::changed, this, &HandFraming::refreshLabels);
}

/// What is known of this very frame and costs nothing.
std::vector<HandPlace> HandFraming::handsOfThisFrame() const {
    const auto& dataset = m_sources.datasets.dataset();
    const auto& motion = m_sources.datasets.motion();
    const int frame = m_sources.selection.frame();
    if (!dataset)
        return {};
    if (motion && frame < static_cast<int>(motion->size()))
        return handsInPose(dataset->hands, (*motion)[static_cast<std::size_t>(frame)]);
    if (const auto& model = m_sources.model.fit(); model && model->frame == frame)
        return handsInPose(dataset->hands, model->poses);
    std::vector<HandPlace> hands{{core::Side::Left, {}, false}, {core::Side::Right, {}, false}};
    for (const auto& [joint, found] : m_sources.reconstructions.joints()) {
        auto& points = hands[joint.hand == core::Side::Left ? 0 : 1].pointsInWorld;
        if (found.hasPoint())
            points.push_back(found.result.point->pointInWorld);
        else if (found.proposal)
            points.push_back(*found.proposal);
    }
    std::erase_if(hands, [](const HandPlace& hand) { return hand.pointsInWorld.empty(); });
    return hands;
}

std::vector<HandPlace> HandFraming::knownHands() const {
    const auto hands = handsOfThisFrame();
    const auto& dataset = m_sources.datasets.dataset();
    const bool whole = !hands.empty() && hands.front().startsAtRoot;
    return whole || !dataset
               ? hands
               : handsOfMarks(m_sources.document.annotations(), dataset->cameras, m_sources.selection.frame());
}

std::optional<QRectF> HandFraming::boxIn(int camera, const std::vector<HandPlace>& hands) const {
    const core::Camera& seenBy = m_grid.view(camera)->camera();
    auto box = handsInView(seenBy, hands);
    if (!box && hands.empty())
        box = marksInView(seenBy, m_sources.document.annotations(), m_sources.selection.frame());
    return box ? withinImage(seenBy, withRoom(*box)) : std::nullopt;
}

bool HandFraming::frameHands() {
    m_maskJob.stop();
    const auto hands = knownHands();
    std::vector<int> unknown;
    for (int camera = 0; camera < m_grid.count(); ++camera) {
        CameraView* view = m_grid.view(camera);
        const auto box = boxIn(camera, hands);
        view->setHome(box.value_or(QRectF()));
        view->fitImage();
        if (!box)
            unknown.push_back(camera);
    }
    refreshLabels();
    const core::Sequence* sequence = m_sources.datasets.sequence();
    const bool masksTell = hands.empty() && !unknown.empty() && sequence && core::hasMasks(*sequence);
    if (masksTell)
        frameByMasks(unknown);
    return masksTell || static_cast<int>(unknown.size()) < m_grid.count();
}

void HandFraming::showHands() {
    const auto hands = handsOfThisFrame();
    if (hands.empty())
        return;
    for (int camera = 0; camera < m_grid.count(); ++camera) {
        CameraView* view = m_grid.view(camera);
        const auto box = boxIn(camera, hands);
        if (box && view->isFitted() && !showsWell(view->home(), *box))
            view->setHome(*box);
    }
}

/// The views that were zoomed by hand meanwhile stay as they are.
void HandFraming::frameByMasks(const std::vector<int>& cameras) {
    const auto dataset = m_sources.datasets.dataset();
    const core::Sequence sequence = *m_sources.datasets.sequence();
    m_maskJob.start(
        [this, dataset, sequence, cameras, frame = m_sources.selection.frame()](const JobContext&) -> Job::Delivery {
            return [this, cameras, boxes = handsOfMasks(*dataset, sequence, frame)] {
                for (const int camera : cameras) {
                    const auto at = static_cast<std::size_t>(camera);
                    if (camera >= m_grid.count() || at >= boxes.size() || boxes[at].isNull())
                        continue;
                    if (const auto box = withinImage(m_grid.view(camera)->camera(), withRoom(boxes[at])))
                        m_grid.view(camera)->setHome(*box);
                }
            };
        });
}

/// A view that shows the hands shows those of the current frame when it fills the window.
void HandFraming::frameMaximised(int camera) {
    if (camera < 0 || m_grid.view(camera)->home().isEmpty() || !m_grid.view(camera)->isFitted())
        return;
    if (const auto box = boxIn(camera, knownHands()))
        m_grid.view(camera)->setHome(*box);
}

void HandFraming::setLabelsShown(bool shown) {
    m_labelsShown = shown;
    refreshLabels();
}

void HandFraming::setHandShown(core::Side hand, bool shown) {
    m_handShown[hand == core::Side::Left ? 0 : 1] = shown;
    refreshLabels();
}

void HandFraming::refreshLabels() {
    const auto hands = m_labelsShown ? handsOfThisFrame() : std::vector<HandPlace>{};
    for (CameraView* view : m_grid.views()) {
        std::vector<HandLabel> labels;
        for (const HandPlace& hand : hands) {
            if (!m_handShown[hand.side == core::Side::Left ? 0 : 1])
                continue;
            if (auto label = labelIn(view->camera(), hand)) {
                label->text = hand.side == core::Side::Left ? tr("L", "left hand, one letter beside it")
                                                            : tr("R", "right hand, one letter beside it");
                labels.push_back(*label);
            }
        }
        view->setHandLabels(labels);
    }
}

} // namespace widgets
