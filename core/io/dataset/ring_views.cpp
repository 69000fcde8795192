// SPDX-License-Identifier: MIT
#include "core/io/dataset/ring_views.h"

namespace core {

std::vector<Eigen::Vector3d> recordedVolume(const std::vector<HandModel>& hands, const std::vector<Motion>& motions) {
    constexpr std::size_t kKeepEvery = 20;
    std::vector<HandModel> thinned;
    for (const HandModel& hand : hands) {
        HandModel few{hand.side, {}, hand.skeleton, {{0}, {}}};
        for (std::size_t v = 0; v < hand.mesh.vertices.size(); v += kKeepEvery) {
            few.mesh.vertices.push_back(hand.mesh.vertices[v]);
            few.weights.entries.insert(few.weights.entries.end(),
                                       hand.weights.entries.begin() + hand.weights.firstEntry[v],
                                       hand.weights.entries.begin() + hand.weights.firstEntry[v + 1]);
            few.weights.firstEntry.push_back(static_cast<int>(few.weights.entries.size()));
        }
        thinned.push_back(std::move(few));
    }
    std::vector<Eigen::Vector3d> points;
    for (const Motion& motion : motions) {
        for (std::size_t f = 0; f < motion.size(); f += 2) {
            for (std::size_t h = 0; h < thinned.size(); ++h) {
                const std::vector<Eigen::Vector3d> posed = posedVertices(thinned[h], motion[f][h]);
                points.insert(points.end(), posed.begin(), posed.end());
            }
        }
    }
    return points;
}

void addRenderedViews(Dataset& dataset) {
    for (Sequence& sequence : dataset.sequences)
        for (const Camera& camera : dataset.cameras)
            sequence.views.push_back({camera.name, ViewKind::Rendered, "", 0});
}

} // namespace core
