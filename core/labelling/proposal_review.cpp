// SPDX-License-Identifier: MIT
#include "core/labelling/proposal_review.h"

#include <algorithm>
#include <cmath>

#include "core/annotation/bone_lengths.h"
#include "core/annotation/reconstruction.h"
#include "core/numeric/median.h"

namespace core {

namespace {

constexpr double kUnknownDoubt = 0.5; ///< of a proposal that came without a likelihood
constexpr int kFewestFrames = 3;      ///< that tell what is usual
constexpr int kNearFrames = 30;       ///< frames farther apart say nothing of each other
// Values at which a sign alone makes a doubt of one half.
constexpr double kHalfLengthChange = 0.25;
constexpr double kHalfMissing = 4;
constexpr double kHalfJumpMm = 40;
constexpr double kHandMissingDoubt = 0.5;

double sign(double value, double half) {
    return 1 - std::exp2(-(value / half) * (value / half));
}

std::ptrdiff_t jointsOf(const JointPoints& points, Side hand) {
    return std::count_if(
        points.begin(), points.end(), [hand](const auto& item) { return item.first.hand == hand; });
}

/// The bone of a hand whose length is least usual.
struct OddBone {
    JointId joint; ///< at its far end
    double change = 0;
};

/// Something that makes a frame doubtful.
struct DoubtSign {
    double doubt = 0;
    DoubtReason reason = DoubtReason::Unsure;
    JointId joint;
    double value = 0;
};

void addSign(ProposedFrame& frame, const DoubtSign& found) {
    if (found.reason != DoubtReason::HandMissing) {
        double& ofHand = frame.openHands.try_emplace(found.joint.hand, 0).first->second;
        ofHand = std::max(ofHand, found.doubt);
    }
    if (found.doubt <= frame.doubt && !frame.joint.joint.empty())
        return;
    frame.doubt = found.doubt;
    frame.reason = found.reason;
    frame.joint = found.joint;
    frame.value = found.value;
}

/// Where the marks of a joint put it, whoever made them; none if fewer than two agree.
std::optional<TriangulatedPoint> pointOf(const AnnotationSet& marks, const std::vector<Camera>& cameras, int frame,
                                         const std::string& rater, const JointId& joint) {
    std::vector<Observation> observations;
    for (const auto& [key, mark] : marksOfJoint(marks, frame, rater, joint))
        for (std::size_t camera = 0; camera < cameras.size(); ++camera)
            if (cameras[camera].name == key.camera && mark.hasPlace())
                observations.push_back({static_cast<int>(camera), mark.px});
    return triangulate(cameras, observations).point;
}

} // namespace

struct ProposalReview::Usual {
    BoneLengths lengths;
    std::map<Side, int> joints;  ///< of a hand, in most frames
    std::map<Side, bool> isSeen; ///< the hand, in most frames
};

ProposalReview::ProposalReview(std::vector<Camera> cameras, std::string rater)
    : m_cameras(std::move(cameras))
    , m_rater(std::move(rater)) {}

void ProposalReview::look(const AnnotationSet& set, const AnnotationSet& proposed, int frame) {
    SeenFrame seen;
    std::map<JointId, double> doubts;
    for (const auto& [key, mark] : marksOfFrame(proposed, frame, m_rater)) {
        double& doubt = doubts[key.joint];
        doubt = std::max(doubt, std::clamp(mark.likelihood ? 1 - *mark.likelihood : kUnknownDoubt, 0.0, 1.0));
    }
    if (doubts.empty()) {
        m_seen.erase(frame);
        return;
    }
    for (const auto& [joint, doubt] : doubts) {
        seen.doubt = std::max(seen.doubt, doubt);
        const auto guess = pointOf(proposed, m_cameras, frame, m_rater, joint);
        const auto now = reconstruct(set, m_cameras, frame, m_rater, joint, {{}, false, std::nullopt});
        const bool waits = std::any_of(now.views.begin(), now.views.end(), [](const ViewReconstruction& view) {
            return view.mark && view.mark->isProposal();
        });
        if (waits && !now.hasPoint())
            seen.openJoints[joint] = doubt;
        else if (guess && now.hasPoint())
            seen.movedMm.push_back(now.isAccepted ? 0 : (now.result.point->pointInWorld - guess->pointInWorld).norm());
        else if (guess && now.placedViews > now.manualViews)
            seen.movedMm.push_back(0); // accepted as it was
        if (now.hasPoint())
            seen.points[joint] = *now.result.point;
        else if (guess)
            seen.points[joint] = *guess;
    }
    std::map<Side, int> counts;
    for (const auto& [joint, point] : seen.points) {
        auto& sum = seen.handCentre.try_emplace(joint.hand, Eigen::Vector3d::Zero()).first->second;
        sum += point.pointInWorld;
        ++counts[joint.hand];
    }
    for (auto& [hand, sum] : seen.handCentre)
        sum /= counts[hand];
    m_seen[frame] = std::move(seen);
}

ProposalReview::Usual ProposalReview::usual() const {
    Usual usual;
    SequencePoints points;
    std::map<Side, std::map<int, int>> frequencies;
    for (const auto& [frame, seen] : m_seen) {
        points[frame] = seen.points;
        for (const Side hand : {Side::Left, Side::Right})
            ++frequencies[hand][static_cast<int>(jointsOf(seen.points, hand))];
    }
    usual.lengths = medianBoneLengths(points, kFewestFrames);
    for (const auto& [hand, counts] : frequencies) {
        const auto most = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        usual.joints[hand] = most->first;
        const auto without = counts.find(0);
        const std::size_t missing = without == counts.end() ? 0 : static_cast<std::size_t>(without->second);
        usual.isSeen[hand] = m_seen.size() >= kFewestFrames && 2 * missing < m_seen.size();
    }
    return usual;
}

/// How far the hand is from where the frames before and after have it, and how far it goes between these.
double ProposalReview::jumpMm(std::map<int, SeenFrame>::const_iterator at, Side hand, double& travelMm) const {
    const auto here = at->second.handCentre.find(hand);
    if (here == at->second.handCentre.end() || at == m_seen.begin() || std::next(at) == m_seen.end())
        return 0;
    const auto before = std::prev(at), after = std::next(at);
    const auto from = before->second.handCentre.find(hand), to = after->second.handCentre.find(hand);
    if (from == before->second.handCentre.end() || to == after->second.handCentre.end() ||
        at->first - before->first > kNearFrames || after->first - at->first > kNearFrames)
        return 0;
    const double share = double(at->first - before->first) / (after->first - before->first);
    travelMm = (to->second - from->second).norm();
    return (from->second + share * (to->second - from->second) - here->second).norm();
}

ProposedFrame ProposalReview::judged(std::map<int, SeenFrame>::const_iterator at, const Usual& usual) const {
    const SeenFrame& seen = at->second;
    ProposedFrame result;
    result.frame = at->first;
    result.isReviewed = seen.openJoints.empty();
    if (result.isReviewed) {
        result.doubt = seen.doubt;
        if (!seen.movedMm.empty())
            result.movedMm = meanOf(seen.movedMm);
        return result;
    }
    std::map<Side, OddBone> odd;
    for (const auto& [joint, doubt] : seen.openJoints) {
        addSign(result, {doubt, DoubtReason::Unsure, joint, 0});
        const auto length = boneLength(seen.points, joint);
        const auto median = usual.lengths.find(joint);
        OddBone& bone = odd.try_emplace(joint.hand, OddBone{joint, 0}).first->second;
        if (length && median != usual.lengths.end() && std::abs(*length / median->second - 1) > std::abs(bone.change))
            bone = {joint, *length / median->second - 1};
    }
    for (const auto& [hand, bone] : odd) {
        if (hand == result.joint.hand && seen.openJoints.at(bone.joint) >= result.doubt)
            result.joint = bone.joint; // joints of one doubt: the oddest one deserves the first look
        addSign(result, {sign(bone.change, kHalfLengthChange), DoubtReason::BoneLength, bone.joint, bone.change});
    }
    for (const Side hand : {Side::Left, Side::Right}) {
        const auto joints = static_cast<int>(jointsOf(seen.points, hand));
        const JointId any{hand, odd.contains(hand) ? odd.at(hand).joint.joint : "wrist"};
        const int missing = usual.joints.at(hand) - joints;
        if (joints == 0 && usual.isSeen.at(hand))
            addSign(result, {kHandMissingDoubt, DoubtReason::HandMissing, any, 0});
        else if (joints > 0 && missing > 0)
            addSign(result, {sign(missing, kHalfMissing), DoubtReason::JointsMissing, any, double(missing)});
        double travelMm = 0;
        if (const double jump = jumpMm(at, hand, travelMm); odd.contains(hand) && jump > 0)
            addSign(result, {sign(jump, kHalfJumpMm + travelMm), DoubtReason::Jump, any, jump});
    }
    return result;
}

std::vector<ProposedFrame> ProposalReview::frames() const {
    std::vector<ProposedFrame> list;
    if (m_seen.empty())
        return list;
    const Usual common = usual();
    for (auto at = m_seen.begin(); at != m_seen.end(); ++at)
        list.push_back(judged(at, common));
    return list;
}

std::vector<ReviewFrame> reviewFrames(const std::vector<ProposedFrame>& frames) {
    std::vector<ReviewFrame> list;
    for (const ProposedFrame& frame : frames)
        list.push_back({frame.frame, frame.doubt, frame.isReviewed, frame.movedMm});
    return list;
}

void followProposals(AnnotationSet& proposed, const Edit& edit) {
    for (const MarkChange& change : edit.marks)
        if (change.after && change.after->isProposal())
            proposed.marks[change.key] = *change.after;
        else if (!change.after)
            proposed.marks.erase(change.key);
}

} // namespace core
