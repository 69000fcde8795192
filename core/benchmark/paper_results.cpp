// SPDX-License-Identifier: MIT
#include "core/benchmark/paper_results.h"

#include <algorithm>
#include <set>

namespace core {

namespace {

const std::set<std::string>& papersJoints() {
    static const std::set<std::string> joints = [] {
        std::set<std::string> names = {"forearm", "thumb_cmc", "thumb_mcp", "thumb_ip"};
        for (const char* finger : {"index", "middle", "ring", "little"})
            for (const char* part : {"_cmc", "_mcp", "_pip", "_dip"})
                names.insert(std::string(finger) + part);
        return names;
    }();
    return joints;
}

} // namespace

bool isPapersJoint(const std::string& joint) {
    return papersJoints().contains(joint);
}

bool isPapersHands(const std::vector<HandModel>& hands) {
    return hands.size() == 2 && std::all_of(
                                    hands.begin(), hands.end(),
                                    [](const HandModel& hand) {
                                        std::set<std::string> names;
                                        for (const Bone& bone : hand.skeleton.bones)
                                            names.insert(bone.name);
                                        return names == papersJoints();
                                    });
}

std::vector<PublishedRow> publishedRows(BenchmarkSetup setup) {
    using E = PublishedError;
    if (setup == BenchmarkSetup::Synthetic) {
        return {
            {"CH", "ch", {E{1.0, 1.0}, E{2.5, 2.5}, E{4.3, 4.6}, E{6.4, 6.1}}, E{3.5, 4.5}, 103},
            {"DCH-DT3", "dch-dt3", {E{2.0, 1.3}, E{2.3, 1.3}, E{3.8, 2.9}, E{6.2, 5.8}}, E{3.6, 3.8}, 115},
            {"DCH-Quant", "dch-quant", {E{4.0, 1.6}, E{4.2, 1.7}, E{5.4, 2.5}, E{7.0, 4.0}}, E{5.1, 2.9}, 161},
            {"DCH-Thres", "dch-thres", {E{1.1, 0.8}, E{1.3, 1.1}, E{2.5, 2.4}, E{4.1, 4.5}}, E{2.2, 2.9}, 77},
        };
    }
    return {
        {"initial", "initial", {E{6.4, 2.0}, E{10.5, 5.6}, E{16.5, 11.5}, E{22.6, 16.9}}, E{14.0, 12.3}, {}},
        {"full tracker (Ballan et al.)", "", {E{5.9, 1.9}, {}, {}, {}}, {}, {}},
        {"CH", "ch", {E{7.1, 1.9}, E{7.8, 2.4}, E{9.3, 4.3}, E{10.9, 5.9}}, E{8.8, 4.2}, {}},
        {"DCH-DT3", "dch-dt3", {E{6.3, 1.5}, E{6.7, 2.0}, E{8.7, 5.1}, E{11.1, 7.9}}, E{8.3, 5.4}, {}},
        {"DCH-Quant", "dch-quant", {E{6.8, 1.6}, E{7.2, 2.1}, E{9.0, 4.4}, E{10.7, 7.3}}, E{8.4, 4.7}, {}},
        {"DCH-Thres", "dch-thres", {E{6.1, 1.3}, E{6.4, 1.8}, E{7.6, 3.3}, E{9.4, 5.3}}, E{7.4, 3.6}, {}},
    };
}

} // namespace core
