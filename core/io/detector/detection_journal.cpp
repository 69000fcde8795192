// SPDX-License-Identifier: MIT
#include "core/io/detector/detection_journal.h"

#include <cerrno>
#include <cstring>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"

namespace core {

using nlohmann::json;

namespace {

constexpr int kDeepest = 8; ///< lists in lists of a journal's line

json handToJson(const DetectedHand& hand) {
    json px = json::array();
    for (const Eigen::Vector2d& at : hand.px) {
        px.push_back(at.x());
        px.push_back(at.y());
    }
    return {{"px", px}, {"presence", hand.presence}, {"rightness", hand.rightness}, {"sidePx", hand.sidePx}};
}

json frameToJson(int frame, const ViewDetections& detections) {
    json views = json::array();
    for (const std::vector<DetectedHand>& hands : detections) {
        json list = json::array();
        for (const DetectedHand& hand : hands)
            list.push_back(handToJson(hand));
        views.push_back(list);
    }
    return {{"frame", frame}, {"views", views}};
}

DetectedHand handFromJson(const json& value) {
    DetectedHand hand;
    const json& px = value.at("px");
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        hand.px[i] = {px.at(2 * i).get<double>(), px.at(2 * i + 1).get<double>()};
    hand.presence = value.at("presence");
    hand.rightness = value.at("rightness");
    hand.sidePx = value.at("sidePx");
    return hand;
}

/// False if the line is not one of this journal.
bool readLine(const std::string& line, std::size_t cameras, std::map<int, ViewDetections>& frames) {
    try {
        const json value = json::parse(line, [](int depth, json::parse_event_t, json&) { return depth < kDeepest; });
        ViewDetections detections;
        for (const json& view : value.at("views")) {
            auto& hands = detections.emplace_back();
            for (const json& hand : view)
                hands.push_back(handFromJson(hand));
        }
        if (detections.size() != cameras)
            return false;
        frames[value.at("frame").get<int>()] = std::move(detections);
        return true;
    } catch (const json::exception&) {
        return false;
    }
}

} // namespace

DetectionJournal::DetectionJournal(std::filesystem::path file, const std::string& work, std::size_t cameras)
    : m_file(std::move(file)) {
    const std::string header = json{{"work", work}}.dump() + "\n";
    std::string kept = header;
    std::error_code error;
    if (std::filesystem::exists(m_file, error)) {
        const std::string content = readTextFile(m_file);
        std::size_t at = content.compare(0, header.size(), header) == 0 ? header.size() : content.size();
        for (std::size_t end; (end = content.find('\n', at)) != std::string::npos; at = end + 1) {
            const std::string line = content.substr(at, end - at);
            if (!readLine(line, cameras, m_frames))
                break;
            kept += line + "\n";
        }
    }
    writeFileAtomically(m_file, kept);
    m_stream = std::fopen(m_file.c_str(), "ab");
    if (!m_stream)
        throw Error(ErrorCode::Io, m_file.string(), "", std::string("cannot be written: ") + std::strerror(errno));
}

DetectionJournal::~DetectionJournal() {
    if (m_stream)
        std::fclose(m_stream);
}

void DetectionJournal::append(int frame, const ViewDetections& detections) {
    const std::string line = frameToJson(frame, detections).dump() + "\n";
    if (!m_stream || std::fwrite(line.data(), 1, line.size(), m_stream) != line.size() || std::fflush(m_stream) != 0)
        throw Error(ErrorCode::Io, m_file.string(), "", std::string("cannot be written: ") + std::strerror(errno));
    m_frames[frame] = detections;
}

void DetectionJournal::remove() {
    if (m_stream)
        std::fclose(m_stream);
    m_stream = nullptr;
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
}

} // namespace core
