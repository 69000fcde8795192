// SPDX-License-Identifier: MIT
#include "core/hand/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

using Row = std::vector<SkinWeight>;

Row rowOf(const SkinWeights& weights, int vertex) {
    return {weights.entries.begin() + weights.firstEntry[vertex],
            weights.entries.begin() + weights.firstEntry[vertex + 1]};
}

void appendRow(SkinWeights& weights, const Row& row) {
    if (weights.firstEntry.empty())
        weights.firstEntry.push_back(0);
    weights.entries.insert(weights.entries.end(), row.begin(), row.end());
    weights.firstEntry.push_back(static_cast<int>(weights.entries.size()));
}

/// Largest difference of a bone's weight between two rows.
double rowDifference(const Row& a, const Row& b) {
    std::map<int, double> difference;
    for (const SkinWeight& w : a)
        difference[w.bone] += w.weight;
    for (const SkinWeight& w : b)
        difference[w.bone] -= w.weight;
    double largest = 0;
    for (const auto& [bone, value] : difference)
        largest = std::max(largest, std::abs(value));
    return largest;
}

/// For every vertex the first one that it may be joined with (itself if there is none earlier).
std::vector<int> twins(const WeightedSurface& surface, double toleranceMm) {
    constexpr double kSameWeights = 0.02;
    using Cell = std::array<long, 3>;
    std::map<Cell, std::vector<int>> cells;
    std::vector<int> twin(surface.mesh.vertices.size());
    for (int v = 0; v < static_cast<int>(twin.size()); ++v) {
        const Eigen::Vector3d& place = surface.mesh.vertices[v];
        const Eigen::Vector3d scaled = place / (4 * toleranceMm);
        Cell low, high;
        for (int k = 0; k < 3; ++k) { // the neighbours that a twin may lie in
            low[k] = std::lround(std::floor(scaled[k] - 0.25));
            high[k] = std::lround(std::floor(scaled[k] + 0.25));
        }
        twin[v] = v;
        for (long x = low[0]; x <= high[0] && twin[v] == v; ++x) {
            for (long y = low[1]; y <= high[1] && twin[v] == v; ++y) {
                for (long z = low[2]; z <= high[2] && twin[v] == v; ++z) {
                    for (const int other : cells[{x, y, z}]) {
                        if ((surface.mesh.vertices[other] - place).norm() <= toleranceMm &&
                            rowDifference(rowOf(surface.weights, other), rowOf(surface.weights, v)) < kSameWeights) {
                            twin[v] = other;
                            break;
                        }
                    }
                }
            }
        }
        if (twin[v] == v) {
            cells[{std::lround(std::floor(scaled[0])), std::lround(std::floor(scaled[1])),
                   std::lround(std::floor(scaled[2]))}]
                .push_back(v);
        }
    }
    return twin;
}

/// Borders of holes, each in the order in which its edges run; only loops that pass every vertex once.
std::vector<std::vector<int>> borderLoops(const std::vector<std::array<int, 3>>& triangles) {
    std::set<std::pair<int, int>> directed;
    for (const auto& t : triangles)
        for (int k = 0; k < 3; ++k)
            directed.insert({t[k], t[(k + 1) % 3]});
    std::multimap<int, int> next;
    for (const auto& [a, b] : directed)
        if (!directed.count({b, a}))
            next.insert({a, b});
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (const auto& [start, ignored] : next) {
        std::vector<int> loop;
        int at = start;
        while (next.count(at) == 1 && seen.insert(at).second) {
            loop.push_back(at);
            at = next.find(at)->second;
        }
        if (loop.size() >= 3 && at == start)
            loops.push_back(std::move(loop));
    }
    return loops;
}

} // namespace

WeightedSurface welded(const WeightedSurface& surface, double toleranceMm) {
    const std::vector<int> twin = twins(surface, toleranceMm);
    std::vector<int> newIndex(twin.size(), -1);
    std::set<std::array<int, 3>> known;
    WeightedSurface result{{}, {{0}, {}}};
    for (const auto& t : surface.mesh.triangles) {
        std::array<int, 3> triangle{twin[t[0]], twin[t[1]], twin[t[2]]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        if (!known.insert(triangle).second)
            continue;
        for (int& v : triangle) {
            if (newIndex[v] < 0) {
                newIndex[v] = static_cast<int>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(surface.mesh.vertices[v]);
                appendRow(result.weights, rowOf(surface.weights, v));
            }
            v = newIndex[v];
        }
        result.mesh.triangles.push_back(triangle);
    }
    return result;
}

WeightedSurface withHolesClosed(const WeightedSurface& surface) {
    WeightedSurface result = surface;
    for (const std::vector<int>& loop : borderLoops(surface.mesh.triangles)) {
        const double share = 1.0 / static_cast<double>(loop.size());
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        std::map<int, double> weights;
        for (const int v : loop) {
            middle += share * surface.mesh.vertices[v];
            for (const SkinWeight& w : rowOf(surface.weights, v))
                weights[w.bone] += share * w.weight;
        }
        const int centre = static_cast<int>(result.mesh.vertices.size());
        result.mesh.vertices.push_back(middle);
        Row row;
        for (const auto& [bone, weight] : weights)
            row.push_back({bone, weight});
        appendRow(result.weights, row);
        for (std::size_t i = 0; i < loop.size(); ++i) // against the border's direction, as a neighbour's edge runs
            result.mesh.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], centre});
    }
    return result;
}

} // namespace core
