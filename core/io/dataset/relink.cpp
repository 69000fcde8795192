// SPDX-License-Identifier: MIT
#include "core/io/dataset/relink.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/dataset/footage_presence.h"
#include "core/io/files/file_pattern.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// A place in the dataset that names footage.
struct Place {
    std::size_t sequence = 0;
    std::optional<std::size_t> view; ///< none: the masks of all cameras
    bool isMask = false;
};

std::string& pathAt(Dataset& dataset, const Place& place) {
    Sequence& sequence = dataset.sequences[place.sequence];
    return !place.view    ? sequence.masks
           : place.isMask ? sequence.views[*place.view].masks
                          : sequence.views[*place.view].path;
}

std::vector<Place> placesOf(const Dataset& dataset) {
    std::vector<Place> places;
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        const Sequence& sequence = dataset.sequences[s];
        for (std::size_t v = 0; v < sequence.views.size(); ++v) {
            const ViewSource& view = sequence.views[v];
            if (view.kind == ViewKind::Images || view.kind == ViewKind::Video)
                places.push_back({s, v, false});
            if (!view.masks.empty())
                places.push_back({s, v, true});
        }
        if (!sequence.masks.empty())
            places.push_back({s, std::nullopt, true});
    }
    return places;
}

/// Footage to be found: its path's parts; those from `tail` on are matched as they stand or with numbers and camera
/// names filled in.
struct Wanted {
    std::vector<std::string> parts;
    std::size_t tail = 0;
    std::vector<std::string> tails; ///< the joined tail, one per camera that it may be of
};

Wanted wantedFor(const Dataset& dataset, const Place& place, const std::string& path) {
    Wanted wanted;
    wanted.parts = pathParts(path);
    const auto isPattern = [](const std::string& part) { return part.find('{') != std::string::npos; };
    const auto first = std::find_if(wanted.parts.begin(), wanted.parts.end(), isPattern);
    wanted.tail = std::min(static_cast<std::size_t>(first - wanted.parts.begin()),
                           wanted.parts.size() - (wanted.parts.empty() ? 0 : 1));
    std::string tail = joinParts(wanted.parts, wanted.tail);
    for (const Camera& camera : dataset.cameras) {
        if (!place.view || dataset.sequences[place.sequence].views[*place.view].camera == camera.name) {
            std::string filled = tail;
            for (std::size_t at = filled.find("{camera}"); at != std::string::npos;
                 at = filled.find("{camera}", at + camera.name.size()))
                filled.replace(at, 8, camera.name);
            wanted.tails.push_back(filled);
        }
    }
    return wanted;
}

/// A folder below the root that holds what a piece of footage is called.
struct Candidate {
    fs::path base;         ///< the tail follows
    std::size_t score = 0; ///< how many of the folders before the tail are called the same
};

/// All files below the root, as parts of their paths.
std::vector<std::vector<std::string>> filesBelow(const fs::path& root, const std::stop_token& stop) {
    std::error_code failure;
    if (!fs::is_directory(root, failure))
        throw Error(ErrorCode::NotFound, root.string(), "", "no such folder");
    std::vector<std::vector<std::string>> files;
    fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, failure), end;
    for (; !failure && entry != end && !stop.stop_requested(); entry.increment(failure)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored) && !entry->path().filename().string().starts_with("._"))
            files.push_back(pathParts(entry->path().lexically_relative(root)));
    }
    return files;
}

std::size_t commonEnding(const std::vector<std::string>& a, std::size_t aEnd, const std::vector<std::string>& b,
                         std::size_t bEnd) {
    std::size_t count = 0;
    while (count < aEnd && count < bEnd && a[aEnd - 1 - count] == b[bEnd - 1 - count])
        ++count;
    return count;
}

/// The candidates that agree best, one per folder.
std::vector<Candidate> candidatesFor(const Wanted& wanted, const fs::path& root,
                                     const std::vector<std::string>& rootParts,
                                     const std::vector<std::vector<std::string>>& files) {
    const std::size_t length = wanted.parts.size() - wanted.tail;
    std::map<fs::path, std::size_t> scores;
    for (const std::vector<std::string>& file : files) {
        if (file.size() < length)
            continue;
        const std::string name = joinParts(file, file.size() - length);
        if (std::none_of(wanted.tails.begin(), wanted.tails.end(),
                         [&](const std::string& tail) { return numberIn(tail, name).has_value(); }))
            continue;
        std::vector<std::string> base = rootParts;
        base.insert(base.end(), file.begin(), file.end() - static_cast<std::ptrdiff_t>(length));
        fs::path folder = root;
        for (std::size_t i = rootParts.size(); i < base.size(); ++i)
            folder /= base[i];
        scores[folder] = commonEnding(base, base.size(), wanted.parts, wanted.tail);
    }
    std::vector<Candidate> best;
    for (const auto& [folder, score] : scores) {
        if (!best.empty() && score > best.front().score)
            best.clear();
        if (best.empty() || score == best.front().score)
            best.push_back({folder, score});
    }
    return best;
}

/// The outcome for one path; several places may share it.
struct Answer {
    bool isThere = false;
    std::string to;
    std::size_t score = 0;
    RelinkReason reason = RelinkReason::None;
    std::vector<std::string> places{};
};

Answer answerFor(const Dataset& dataset, const Wanted& wanted, const std::vector<Candidate>& candidates) {
    Answer answer;
    if (candidates.size() > 1) {
        answer.reason = RelinkReason::SeveralFit;
        answer.places = {candidates[0].base.string(), candidates[1].base.string()};
        if (candidates.size() > 2)
            answer.places.emplace_back("...");
    } else if (candidates.size() == 1) {
        answer.to = pathFromDataset(dataset.folder, candidates.front().base / joinParts(wanted.parts, wanted.tail));
        answer.score = candidates.front().score;
    }
    return answer;
}

/// No file is two pieces of footage: of different paths that lead to the same place, only the one that agrees best
/// keeps it.
void dropSharedTargets(std::map<std::string, Answer>& answers) {
    std::map<std::string, std::size_t> best;
    std::map<std::string, int> holders;
    std::set<std::string> taken;
    for (const auto& [path, answer] : answers) {
        if (answer.isThere) {
            taken.insert(fs::path(path).lexically_normal().generic_string());
        } else if (!answer.to.empty()) {
            int& count = holders[answer.to];
            count =
                count == 0 || answer.score > best[answer.to] ? 1 : count + (answer.score == best[answer.to] ? 1 : 0);
            best[answer.to] = std::max(best[answer.to], answer.score);
        }
    }
    for (auto& [path, answer] : answers) {
        const bool isShared = !answer.to.empty() &&
                              (taken.count(answer.to) > 0 || answer.score < best[answer.to] || holders[answer.to] > 1);
        if (isShared) {
            answer.reason = RelinkReason::OtherFootage;
            answer.places = {answer.to};
            answer.to.clear();
        }
    }
}

bool isThere(const Dataset& dataset, const Place& place) {
    const Sequence& sequence = dataset.sequences[place.sequence];
    if (place.isMask)
        return hasAnyMask(dataset, sequence, place.view ? sequence.views[*place.view].camera : "");
    return hasAnyPicture(dataset, sequence, sequence.views[*place.view]);
}

FootageProblem problemAt(const Dataset& dataset, const Place& place) {
    const Sequence& sequence = dataset.sequences[place.sequence];
    return place.isMask ? FootageProblem{} : footageProblem(dataset, sequence, sequence.views[*place.view]);
}

} // namespace

RelinkResult relinkFootage(Dataset& dataset, const fs::path& root, std::stop_token stop) {
    const std::vector<std::vector<std::string>> files = filesBelow(root, stop);
    const std::vector<std::string> rootParts = pathParts(fs::absolute(root).lexically_normal());
    const std::vector<Place> places = placesOf(dataset);
    std::map<std::string, Answer> answers;
    for (const Place& place : places) {
        const std::string& path = pathAt(dataset, place);
        if (answers.count(path) > 0 || stop.stop_requested())
            continue;
        const Wanted wanted = wantedFor(dataset, place, path);
        const bool isInPlace = isThere(dataset, place);
        answers[path] =
            isInPlace ? Answer{true, "", 0} : answerFor(dataset, wanted, candidatesFor(wanted, root, rootParts, files));
    }
    RelinkResult result;
    if (stop.stop_requested())
        return result;
    dropSharedTargets(answers);
    for (const Place& place : places) {
        const Sequence& sequence = dataset.sequences[place.sequence];
        std::string& path = pathAt(dataset, place);
        const Answer& answer = answers[path];
        RelinkFinding finding{sequence.name,
                              place.view ? sequence.views[*place.view].camera : "",
                              path,
                              answer.to,
                              answer.reason,
                              answer.places,
                              {},
                              place.isMask};
        if (answer.isThere) {
            finding.to = path;
            result.unchanged.push_back(finding);
        } else if (answer.to.empty()) {
            result.notFound.push_back(finding);
        } else {
            path = answer.to;
            finding.problem = problemAt(dataset, place);
            result.found.push_back(finding);
        }
    }
    return result;
}

std::string relinkNoteText(const RelinkFinding& finding) {
    if (finding.reason == RelinkReason::OtherFootage)
        return finding.places.front() + " has that name, but is other footage of this dataset";
    if (finding.reason == RelinkReason::None)
        return footageProblemText(finding.problem);
    std::string text;
    for (const std::string& place : finding.places)
        text += (text.empty() ? "several fit: " : ", ") + place;
    return text;
}

} // namespace core
