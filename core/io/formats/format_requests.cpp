// SPDX-License-Identifier: MIT
#include "core/io/formats/format_requests.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/annotation/edits.h"
#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

std::optional<Mark> placedMark(const ExportRequest& job, int frame, const JointId& joint, const std::string& camera) {
    const auto mark = markAt(job.set, {frame, job.rater, joint, camera});
    return mark && mark->isPlaced() ? mark : std::nullopt;
}

bool isSeen(const Mark& mark, const Camera& camera) {
    return mark.state == MarkState::Visible && !isOutside(mark, camera);
}

std::vector<JointId> markedJoints(const ExportRequest& job) {
    std::set<JointId> joints;
    for (const auto& [key, mark] : job.set.marks)
        if (key.rater == job.rater && mark.isSettled())
            joints.insert(key.joint);
    return {joints.begin(), joints.end()};
}

std::map<JointId, JointReconstruction> pointsOf(const ExportRequest& job, int frame) {
    auto joints = reconstructFrame(job.set, job.dataset.cameras, frame, job.rater,
                                   {job.options.triangulationOf(job.rater), false, std::nullopt});
    std::erase_if(joints, [](const auto& item) { return !item.second.hasPoint(); });
    return joints;
}

namespace {

/// False, and it is counted, for a guess below the least likelihood that is wanted.
bool isLikelyEnough(ImportRequest& job, const std::optional<double>& likelihood) {
    const auto& least = job.options.minLikelihood;
    if (!least || !likelihood || *likelihood >= *least)
        return true;
    job.notes.leaveOut(ImportNoteKind::UnlikelyGuesses, {}, *least);
    return false;
}

} // namespace

void addMark(ImportRequest& job, int frame, const JointId& joint, const std::string& camera, const Mark& mark,
             const std::string& rater) {
    const MarkKey key{frame, rater.empty() ? job.options.rater : rater, joint, camera};
    if (job.notes.accepts(key) && isLikelyEnough(job, mark.likelihood) && !job.set.marks.emplace(key, mark).second) {
        throw Error(ErrorCode::BadInput, job.path.string(), "frame " + std::to_string(frame),
                    jointLabel(joint) + " occurs twice in camera \"" + camera + "\"");
    }
}

void addPoint(ImportRequest& job, int frame, const JointId& joint, const Eigen::Vector3d& pointInWorld,
              const std::optional<double>& likelihood) {
    if (job.notes.acceptsFrame(frame) && isLikelyEnough(job, likelihood)) {
        Edit edit = proposeEdit(job.set, job.dataset.cameras, frame, job.options.rater, {{joint, pointInWorld}});
        for (MarkChange& change : edit.marks)
            change.after->likelihood = likelihood;
        apply(job.set, edit);
    }
}

void leaveOutPart(ImportRequest& job, const std::string& part) {
    if (job.map.isIdentity()) {
        job.notes.leaveOutPart(part, "left_index_mcp");
        return;
    }
    const JointMapEntry& first = job.map.entries().front();
    job.notes.leaveOutPart(part, first.hand ? first.name : "left_" + first.name);
}

bool holdsFiles(const fs::path& path, const std::string& extension) {
    return fs::is_directory(path) &&
           std::any_of(
               fs::recursive_directory_iterator(path), fs::recursive_directory_iterator(),
               [&extension](const auto& entry) { return entry.path().extension() == extension; });
}

std::vector<fs::path> viewFiles(const fs::path& path, const std::string& extension) {
    if (!fs::exists(path))
        throw Error(ErrorCode::NotFound, path.string(), "", "there is no such file or folder");
    if (!fs::is_directory(path))
        return {path};
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file() && entry.path().extension() == extension)
            files.push_back(entry.path());
    if (files.empty())
        throw Error(ErrorCode::NotFound, path.string(), "", "holds no file " + ("*" + extension));
    std::sort(files.begin(), files.end());
    return files;
}

namespace {

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// True if `word` occurs in `text` and no letter or digit touches it: cam_1 is not in cam_10.
bool containsWord(const std::string& text, const std::string& word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isWordCharacter(text[at - 1])) && (end == text.size() || !isWordCharacter(text[end])))
            return true;
    }
    return false;
}

} // namespace

std::optional<std::string> cameraIn(const Dataset& dataset, const std::string& text) {
    std::string found;
    for (const Camera& camera : dataset.cameras)
        if (containsWord(text, camera.name) && camera.name.size() > found.size())
            found = camera.name;
    return found.empty() ? std::nullopt : std::optional(found);
}

std::string cameraOfFile(const ImportRequest& job, const fs::path& file) {
    if (!job.options.camera.empty())
        return job.options.camera;
    if (const auto camera = cameraIn(job.dataset, file.stem().string()))
        return *camera;
    if (const auto camera = cameraIn(job.dataset, fs::absolute(file).parent_path().filename().string()))
        return *camera;
    throw Error(ErrorCode::BadInput, file.string(), "camera",
                "neither the file's name nor its folder's says which camera it is for");
}

std::optional<JointId> jointOfPart(const ImportRequest& job, const std::string& part, const std::string& track) {
    const auto joint = job.map.jointOf(part);
    return joint || track.empty() ? joint : job.map.jointOf(track + "_" + part);
}

std::optional<int> trailingNumber(const std::string& name) {
    const std::string stem = fs::path(name).stem().string();
    std::size_t first = stem.size();
    while (first > 0 && std::isdigit(static_cast<unsigned char>(stem[first - 1])))
        --first;
    constexpr std::size_t kMostDigits = 9;
    if (first == stem.size() || stem.size() - first > kMostDigits)
        return std::nullopt;
    return std::stoi(stem.substr(first));
}

} // namespace core
