// SPDX-License-Identifier: MIT
#include "core/io/hdf5/sleap_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/io/hdf5/hdf5_file.h"

namespace core {

namespace {

using nlohmann::json;

json parsed(const Hdf5File& file, const std::string& path, const std::string& text) {
    json value = json::parse(text, nullptr, false);
    if (value.is_discarded())
        file.refuse(path, "is not JSON");
    return value;
}

/// One field of a table, a number per record.
std::vector<double> column(const Hdf5File& file, const std::string& table, const std::string& field) {
    Hdf5Numbers numbers = file.numbers(table, field);
    if (numbers.shape[1] != 1)
        file.refuse(table + ", " + field, "one number per record is expected");
    return std::move(numbers.values);
}

/// A range of records, checked against their number.
struct Range {
    std::size_t first = 0, last = 0;
};
Range rangeOf(const Hdf5File& file, const std::string& field, double first, double last, std::size_t count) {
    if (!(first >= 0 && first <= last && last <= static_cast<double>(count)))
        file.refuse(field, "refers to records that are not there");
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

/// The file that a video entry names, whatever kind of footage it is.
std::string videoPath(const json& video) {
    const json backend = video.value("backend", json::object());
    for (const json* place : {&video, &backend}) {
        for (const char* member : {"filename", "filenames"}) {
            if (!place->is_object() || !place->contains(member))
                continue;
            const json& name = (*place)[member];
            if (name.is_string() && name != ".")
                return name.get<std::string>();
            if (name.is_array() && !name.empty() && name[0].is_string())
                return name[0].get<std::string>();
        }
    }
    return {};
}

/// The number in "video3/video", where a project holds the pictures itself; empty for other footage.
std::optional<int> embeddedNumber(const json& video) {
    const json backend = video.value("backend", json::object());
    const std::string dataset =
        backend.is_object() && backend.contains("dataset") && backend["dataset"].is_string() ? backend["dataset"] : "";
    const std::string digits = dataset.starts_with("video") ? dataset.substr(5, dataset.find('/') - 5) : "";
    const bool isNumber =
        !digits.empty() && digits.size() < 7 && digits.find_first_not_of("0123456789") == std::string::npos;
    return isNumber ? std::optional(std::stoi(digits)) : std::nullopt;
}

/// Names of the videos by the number that frames give.
std::map<int, std::string> videoNames(const Hdf5File& file) {
    std::map<int, std::string> names;
    int index = 0;
    for (const std::string& text : file.texts("videos_json")) {
        json video = parsed(file, "videos_json", text);
        if (!video.is_object())
            file.refuse("videos_json", "an object per video is expected");
        const auto embedded = embeddedNumber(video);
        if (embedded) {
            const std::string source = "video" + std::to_string(*embedded) + "/source_video";
            if (const auto origin = file.textAttribute(source, "json"))
                video = parsed(file, source, *origin);
            else if (video.contains("source_video") && video["source_video"].is_object())
                video = video["source_video"];
        }
        names[embedded.value_or(index)] = sleapVideoName(videoPath(video));
        ++index;
    }
    return names;
}

/// Names of the nodes of every skeleton, in the order of its points; that of the list of all nodes may differ.
std::vector<std::vector<std::string>> skeletons(const Hdf5File& file) {
    const auto text = file.textAttribute("metadata", "json");
    if (!text)
        file.refuse("metadata", "has no attribute \"json\"");
    const json metadata = parsed(file, "metadata, json", *text);
    std::vector<std::vector<std::string>> list;
    try {
        for (const json& skeleton : metadata.at("skeletons")) {
            std::vector<std::string>& nodes = list.emplace_back();
            for (const json& node : skeleton.at("nodes")) {
                const json& id = node.at("id").is_object() ? node.at("id").at("id") : node.at("id");
                nodes.push_back(metadata.at("nodes").at(id.get<std::size_t>()).at("name"));
            }
        }
    } catch (const json::exception&) {
        file.refuse("metadata, json", "does not describe skeletons and their nodes");
    }
    return list;
}

/// Coordinates of all labels, or of all guesses.
struct Points {
    std::string path;
    std::vector<double> x, y, visible, score;
};

Points readPoints(const Hdf5File& file, const std::string& path, bool isGuess) {
    Points points{path, column(file, path, "x"), column(file, path, "y"), column(file, path, "visible"), {}};
    if (isGuess)
        points.score = column(file, path, "score");
    return points;
}

/// The tables of a project.
struct Project {
    explicit Project(const Hdf5File& file)
        : labels(readPoints(file, "points", false))
        , guesses(readPoints(file, "pred_points", true))
        , kind(column(file, "instances", "instance_type"))
        , skeleton(column(file, "instances", "skeleton"))
        , track(column(file, "instances", "track"))
        , corrected(column(file, "instances", "from_predicted"))
        , firstPoint(column(file, "instances", "point_id_start"))
        , lastPoint(column(file, "instances", "point_id_end"))
        , nodes(skeletons(file)) {
        if (file.numberAttribute("metadata", "format_id").value_or(0) < 1.1) {
            for (double& x : labels.x)
                x -= 0.5;
            for (double& y : labels.y)
                y -= 0.5;
        }
        for (const std::string& text :
             file.has("tracks_json") ? file.texts("tracks_json") : std::vector<std::string>()) {
            const json entry = parsed(file, "tracks_json", text);
            tracks.push_back(entry.is_array() && entry.size() > 1 && entry[1].is_string() ? entry[1] : "");
        }
        for (const double instance : corrected)
            superseded.insert(instance);
    }
    Points labels, guesses;
    std::vector<double> kind, skeleton, track, corrected, firstPoint, lastPoint;
    std::vector<std::vector<std::string>> nodes;
    std::vector<std::string> tracks;
    std::set<double> superseded; ///< guesses that a person has corrected
};

/// Adds the points of one instance.
void addPoints(const Hdf5File& file, const Project& project, std::size_t i, SleapInstance& instance,
               SleapFile& result) {
    const Points& points = instance.isGuess ? project.guesses : project.labels;
    const std::string field = "instances[" + std::to_string(i) + "]";
    const Range range = rangeOf(file, field, project.firstPoint[i], project.lastPoint[i], points.x.size());
    if (!(project.skeleton[i] >= 0 && project.skeleton[i] < static_cast<double>(project.nodes.size())))
        file.refuse(field, "is of a skeleton that is not there");
    const auto& nodes = project.nodes[static_cast<std::size_t>(project.skeleton[i])];
    if (range.last - range.first != nodes.size()) {
        file.refuse(field, "has " + std::to_string(range.last - range.first) + " points, its skeleton has " +
                               std::to_string(nodes.size()) + " nodes");
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const std::size_t at = range.first + node;
        if (!std::isfinite(points.x[at]) || !std::isfinite(points.y[at]))
            continue;
        if (points.visible[at] == 0) {
            result.hiddenPoints += instance.isGuess ? 0 : 1;
            continue;
        }
        SleapPoint point{nodes[node], points.x[at], points.y[at], std::nullopt};
        if (instance.isGuess && std::isfinite(points.score[at]))
            point.score = points.score[at];
        instance.points.push_back(std::move(point));
    }
}

SleapFile readProject(const Hdf5File& file) {
    const Project project(file);
    const std::map<int, std::string> videos = videoNames(file);
    const std::vector<double> number = column(file, "frames", "frame_idx"), video = column(file, "frames", "video"),
                              first = column(file, "frames", "instance_id_start"),
                              last = column(file, "frames", "instance_id_end");
    SleapFile result;
    for (std::size_t f = 0; f < number.size(); ++f) {
        const std::string field = "frames[" + std::to_string(f) + "]";
        const auto name = videos.find(video[f] < 1e6 ? static_cast<int>(video[f]) : -1);
        if (name == videos.end() || !(number[f] < 1e9))
            file.refuse(field, "is of a video that is not there");
        const Range range = rangeOf(file, field, first[f], last[f], project.kind.size());
        for (std::size_t i = range.first; i < range.last; ++i) {
            SleapInstance instance{name->second, static_cast<int>(number[f]), "", project.kind[i] != 0, {}};
            if (instance.isGuess && project.superseded.contains(static_cast<double>(i)))
                continue;
            if (project.track[i] >= 0 && project.track[i] < static_cast<double>(project.tracks.size()))
                instance.track = project.tracks[static_cast<std::size_t>(project.track[i])];
            addPoints(file, project, i, instance, result);
            result.instances.push_back(std::move(instance));
        }
    }
    return result;
}

/// An array whose axes are named, read by name.
struct Axes {
    Axes(const Hdf5File& file, const std::string& path, std::vector<std::string> usual)
        : numbers(file.numbers(path))
        , names(std::move(usual)) {
        if (const auto dims = file.textAttribute(path, "dims")) {
            const json list = parsed(file, path + ", dims", *dims);
            if (list.is_array() && std::all_of(list.begin(), list.end(), [](const json& n) { return n.is_string(); }))
                names = list.get<std::vector<std::string>>();
            areNamed = true;
        }
        if (names.size() != numbers.shape.size())
            file.refuse(path, std::to_string(names.size()) + " axes are expected");
    }
    /// The axes turned round, as an export that is not laid out for MATLAB has them.
    void reverse() { std::reverse(names.begin(), names.end()); }
    std::size_t size(const std::string& axis) const {
        const auto at = std::find(names.begin(), names.end(), axis);
        return at == names.end() ? 0 : numbers.shape[static_cast<std::size_t>(at - names.begin())];
    }
    double at(const std::map<std::string, std::size_t>& where) const {
        std::size_t index = 0;
        for (std::size_t axis = 0; axis < names.size(); ++axis)
            index = index * numbers.shape[axis] + where.at(names[axis]);
        return numbers.values[index];
    }
    Hdf5Numbers numbers;
    std::vector<std::string> names;
    bool areNamed = false; ///< by the file
};

void requireSize(const Hdf5File& file, const std::string& path, const Axes& array, const std::string& axis,
                 std::size_t size) {
    if (array.size(axis) != size) {
        file.refuse(path, "has " + std::to_string(array.size(axis)) + " along its axis \"" + axis + "\", " +
                              std::to_string(size) + " are expected: are the axes turned?");
    }
}

/// True if only frame, node, xy, track fits the numbers of nodes and tracks, not track, xy, node, frame.
bool isOtherWayRound(const Axes& places, std::size_t nodes, std::size_t tracks) {
    const auto fits = [&](std::size_t track, std::size_t xy, std::size_t node) {
        return xy == 2 && node == nodes && (tracks == 0 || track == tracks);
    };
    const std::vector<std::size_t>& shape = places.numbers.shape;
    return !fits(shape[0], shape[1], shape[2]) && fits(shape[3], shape[2], shape[1]);
}

/// What the exporter of SLEAP writes is laid out for MATLAB: track, xy, node, frame. sleap-io names the axes.
SleapFile readAnalysis(const Hdf5File& file) {
    const std::vector<std::string> nodes = file.texts("node_names");
    const std::vector<std::string> tracks =
        file.has("track_names") ? file.texts("track_names") : std::vector<std::string>();
    Axes places(file, "tracks", {"track", "xy", "node", "frame"});
    const bool isTurned = !places.areNamed && isOtherWayRound(places, nodes.size(), tracks.size());
    if (isTurned)
        places.reverse();
    requireSize(file, "tracks", places, "xy", 2);
    requireSize(file, "tracks", places, "node", nodes.size());
    const std::size_t trackCount = places.size("track"), frameCount = places.size("frame");
    std::optional<Axes> scores;
    if (file.has("point_scores")) {
        scores.emplace(file, "point_scores", std::vector<std::string>{"track", "node", "frame"});
        if (isTurned && !scores->areNamed)
            scores->reverse();
        for (const char* axis : {"track", "node", "frame"})
            requireSize(file, "point_scores", *scores, axis, places.size(axis));
    }
    const auto path = file.has("video_path") ? file.texts("video_path") : std::vector<std::string>();
    const std::string video = path.empty() ? "" : sleapVideoName(path.front());
    SleapFile result;
    for (std::size_t frame = 0; frame < frameCount; ++frame) {
        for (std::size_t track = 0; track < trackCount; ++track) {
            SleapInstance instance{
                video, static_cast<int>(frame), track < tracks.size() ? tracks[track] : "", true, {}};
            for (std::size_t node = 0; node < nodes.size(); ++node) {
                std::map<std::string, std::size_t> where{{"track", track}, {"xy", 0}, {"node", node}, {"frame", frame}};
                SleapPoint point{nodes[node], places.at(where), 0, std::nullopt};
                if (scores && std::isfinite(scores->at(where)))
                    point.score = scores->at(where);
                where["xy"] = 1;
                point.y = places.at(where);
                if (std::isfinite(point.x) && std::isfinite(point.y))
                    instance.points.push_back(std::move(point));
            }
            if (!instance.points.empty())
                result.instances.push_back(std::move(instance));
        }
    }
    return result;
}

} // namespace

std::string sleapVideoName(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::filesystem::path file(path);
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::set<std::string> pictures{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp"};
    return pictures.contains(ending) ? file.parent_path().filename().string() : file.stem().string();
}

SleapFile readSleapFile(const std::filesystem::path& path) {
    const Hdf5File file(path);
    if (file.has("tracks") && file.has("node_names"))
        return readAnalysis(file);
    if (!file.has("metadata") || !file.has("instances")) {
        file.refuse("", "is neither a SLEAP project (metadata, frames, instances) nor an analysis export (tracks, "
                        "node_names)");
    }
    return readProject(file);
}

} // namespace core
