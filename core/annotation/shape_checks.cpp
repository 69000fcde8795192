// SPDX-License-Identifier: MIT
#include "core/annotation/shape_checks.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/hand/hand_chains.h"
#include "core/text/number_text.h"

namespace core {

namespace {

const Eigen::Vector3d* find(const JointPoints& points, Side hand, const std::string& joint) {
    const auto found = points.find({hand, joint});
    return found == points.end() ? nullptr : &found->second.pointInWorld;
}

std::string joined(std::string_view finger, std::string_view joint) {
    return std::string(finger) + "_" + std::string(joint);
}

/// What one frame is checked with.
struct ShapeCheck {
    int frame;
    const JointPoints& points;
    const QualityOptions& options;
    std::vector<QualityFinding>& findings;

    void report(const JointId& joint, QualityKind kind, double value, const std::string& text) const {
        findings.push_back({frame, joint, kind, value, text, {}});
    }
};

void checkBoneLengths(const ShapeCheck& check, const BoneLengths& lengths) {
    for (const auto& [id, point] : check.points) {
        const auto length = boneLength(check.points, id);
        const auto median = lengths.find(id);
        if (!length || median == lengths.end())
            continue;
        const double share = *length / median->second - 1;
        if (std::abs(share) > check.options.boneLengthShare) {
            check.report(id, QualityKind::BoneLength, 100 * share,
                         "bone from " + *previousJoint(id.joint) + " to " + id.joint + " is " + fixedText(*length, 1) +
                             " mm long, " + fixedText(std::abs(100 * share), 0) + " % " +
                             (share > 0 ? "above" : "below") + " its median of " + fixedText(median->second, 1) +
                             " mm");
        }
    }
}

/// Knuckles of index, middle, ring and little finger must follow each other across the palm.
void checkKnuckles(const ShapeCheck& check, Side hand) {
    const Eigen::Vector3d* first = find(check.points, hand, "index_mcp");
    const Eigen::Vector3d* last = find(check.points, hand, "little_mcp");
    if (!first || !last || (*last - *first).norm() < check.options.knuckleToleranceMm)
        return;
    const Eigen::Vector3d across = (*last - *first).normalized();
    double reached = 0;
    std::string before = "index_mcp";
    for (const char* joint : {"middle_mcp", "ring_mcp", "little_mcp"}) {
        const Eigen::Vector3d* point = find(check.points, hand, joint);
        if (!point)
            continue;
        const double along = across.dot(*point - *first);
        if (along < reached - check.options.knuckleToleranceMm) {
            check.report({hand, joint}, QualityKind::FingerOrder, reached - along,
                         std::string(joint) + " lies before " + before + " across the palm: are fingers exchanged?");
        }
        if (along > reached) {
            reached = along;
            before = joint;
        }
    }
}

/// Two neighbouring fingers whose bones fit their medians only if the outer joints are exchanged.
void checkExchangedFingers(const ShapeCheck& check, const BoneLengths& lengths, Side hand) {
    for (std::size_t f = 1; f + 1 < kFingers.size(); ++f) {
        for (const auto& [inner, outer] : {std::pair("mcp", "pip"), std::pair("pip", "dip"), std::pair("dip", "tip")}) {
            const JointId a{hand, joined(kFingers[f], outer)}, b{hand, joined(kFingers[f + 1], outer)};
            const Eigen::Vector3d *baseA = find(check.points, hand, joined(kFingers[f], inner)),
                                  *endA = find(check.points, hand, a.joint);
            const Eigen::Vector3d *baseB = find(check.points, hand, joined(kFingers[f + 1], inner)),
                                  *endB = find(check.points, hand, b.joint);
            if (!baseA || !baseB || !endA || !endB || !lengths.contains(a) || !lengths.contains(b))
                continue;
            const double medianA = lengths.at(a), medianB = lengths.at(b);
            const auto misfit = [&](const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
                return std::abs((first - *baseA).norm() - medianA) + std::abs((second - *baseB).norm() - medianB);
            };
            const double asTheyAre = misfit(*endA, *endB), exchanged = misfit(*endB, *endA);
            if (asTheyAre > check.options.boneLengthShare * (medianA + medianB) && exchanged < 0.3 * asTheyAre) {
                check.report(a, QualityKind::FingerOrder, asTheyAre - exchanged,
                             a.joint + " and " + b.joint + " seem to be exchanged");
            }
        }
    }
}

/// By how much the fingers of a hand bend towards the back of the hand that its name says, degrees per bend; negative
/// if they bend as they should. Seen with index to little finger across, right fingers bend one way round and left ones
/// the other.
std::optional<double> wrongBendDeg(const JointPoints& points, Side hand) {
    const Eigen::Vector3d* first = find(points, hand, "index_mcp");
    const Eigen::Vector3d* last = find(points, hand, "little_mcp");
    if (!first || !last || (*last - *first).norm() < 1)
        return std::nullopt;
    const Eigen::Vector3d across = (*last - *first).normalized();
    double sum = 0;
    int bends = 0;
    for (std::size_t f = 1; f < kFingers.size(); ++f) {
        const Eigen::Vector3d* chain[4] = {
            find(points, hand, joined(kFingers[f], "mcp")), find(points, hand, joined(kFingers[f], "pip")),
            find(points, hand, joined(kFingers[f], "dip")), find(points, hand, joined(kFingers[f], "tip"))};
        for (int j = 0; j < 2; ++j) {
            if (chain[j] && chain[j + 1] && chain[j + 2]) {
                const Eigen::Vector3d in = (*chain[j + 1] - *chain[j]).normalized(),
                                      out = (*chain[j + 2] - *chain[j + 1]).normalized();
                sum += std::atan2(in.cross(out).dot(across), in.dot(out)) * 180 / M_PI;
                ++bends;
            }
        }
    }
    constexpr int kLeastBends = 2;
    return bends < kLeastBends ? std::nullopt : std::optional((hand == Side::Right ? sum : -sum) / bends);
}

void checkHandedness(const ShapeCheck& check, Side hand) {
    const auto wrong = wrongBendDeg(check.points, hand);
    if (wrong && *wrong > check.options.wrongBendDeg) {
        check.report({hand, "index_mcp"}, QualityKind::HandMixUp, *wrong,
                     "the fingers bend backwards by " + fixedText(*wrong, 0) +
                         " degrees on average: is this the other hand?");
    }
}

/// Mean distance of the joints that two hands in two frames share.
std::optional<double> meanDistance(const JointPoints& now, Side handNow, const JointPoints& before, Side handBefore) {
    double sum = 0;
    int count = 0;
    for (const auto& [id, point] : now) {
        const auto other = id.hand == handNow ? before.find({handBefore, id.joint}) : before.end();
        if (other != before.end()) {
            sum += (point.pointInWorld - other->second.pointInWorld).norm();
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// Both hands lie where the other one was in the frame before.
void checkExchangedHands(const ShapeCheck& check, const JointPoints& previous) {
    const auto left = meanDistance(check.points, Side::Left, previous, Side::Left);
    const auto right = meanDistance(check.points, Side::Right, previous, Side::Right);
    const auto leftToRight = meanDistance(check.points, Side::Left, previous, Side::Right);
    const auto rightToLeft = meanDistance(check.points, Side::Right, previous, Side::Left);
    if (left && right && leftToRight && rightToLeft && *leftToRight + *rightToLeft < 0.5 * (*left + *right)) {
        check.report({Side::Left, "index_mcp"}, QualityKind::HandMixUp, *left + *right,
                     "left and right hand seem to be exchanged since the annotated frame before");
    }
}

} // namespace

void checkShape(int frame, const JointPoints& points, const BoneLengths& lengths, const JointPoints* previous,
                const QualityOptions& options, std::vector<QualityFinding>& findings) {
    const ShapeCheck check{frame, points, options, findings};
    checkBoneLengths(check, lengths);
    for (const Side hand : {Side::Left, Side::Right}) {
        checkKnuckles(check, hand);
        checkExchangedFingers(check, lengths, hand);
        checkHandedness(check, hand);
    }
    if (previous)
        checkExchangedHands(check, *previous);
}

} // namespace core
