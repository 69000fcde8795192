// SPDX-License-Identifier: MIT
// How long pictures of several videos take to come, as in the window: steps, jumps, playback, scrubbing.
// handlens_footage_trial VIDEO [VIEWS]: the same video in all views (8). Times in ms: least, median and largest; on a
// busy machine the least and the processor time say more than the others.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include "core/io/dataset/dataset.h"
#include "core/io/footage/video_file.h"
#include "tests/support/temporary_folder.h"
#include "widgets/jobs/frame_loader.h"
#include "widgets/presenters/playback.h"

namespace {

double nowMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void wait(int ms) {
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Of one request: when the first camera, and all, show something; and when they show the whole picture of that frame.
struct Times {
    double firstSeen = 0, allSeen = 0, firstWhole = 0, allWhole = 0;
    double processor = 0; ///< of all threads, those that fetch ahead among them
};

class Trial {
public:
    Trial(const std::string& video, int views)
        : m_loader(m_pool) {
        const core::VideoInfo info = core::VideoFile(video, {}).info();
        auto dataset = std::make_shared<core::Dataset>();
        dataset->folder = m_folder.path();
        core::Sequence sequence;
        sequence.name = "trial";
        sequence.frameCount = m_frames = info.frames;
        for (int v = 0; v < views; ++v) {
            core::Camera camera;
            camera.name = "cam" + std::to_string(v);
            camera.size = info.size;
            dataset->cameras.push_back(camera);
            sequence.views.push_back({camera.name, core::ViewKind::Video, video, 0});
        }
        dataset->sequences.push_back(sequence);
        m_dataset = dataset;
        m_views = views;
        m_loader.setFirstCamera(0);
        m_loader.setSequence(m_dataset, &m_dataset->sequences[0], std::make_shared<core::Motion>());
        const auto see = [this](int camera) {
            if (m_seen.insert(camera).second && camera == 0)
                m_times.firstSeen = nowMs() - m_start;
            if (static_cast<int>(m_seen.size()) == m_views && m_times.allSeen == 0)
                m_times.allSeen = nowMs() - m_start;
        };
        QObject::connect(&m_loader, &widgets::FrameLoader::standInLoaded, see);
        QObject::connect(
            &m_loader, &widgets::FrameLoader::pictureLoaded,
            [this, see](int camera, const widgets::ImagePyramid& picture) {
                see(camera);
                if (camera == 0 && !picture.isDraft())
                    m_times.firstWhole = nowMs() - m_start;
            });
        QObject::connect(
            &m_loader, &widgets::FrameLoader::pictureFailed,
            [](int camera, const QString& message) {
                std::fprintf(stderr, "cam%d: %s\n", camera, qPrintable(message));
            });
        QObject::connect(&m_loader, &widgets::FrameLoader::frameCompleted, [this] { ++m_completed; });
    }

    int frames() const { return m_frames; }
    widgets::FrameLoader& loader() { return m_loader; }
    int completed() const { return m_completed; }
    std::uintmax_t bytesOfSmallPictures() const {
        std::uintmax_t bytes = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path()))
            bytes += entry.path().extension() == ".smallpictures" ? entry.file_size() : 0;
        return bytes;
    }

    Times go(int frame) {
        m_seen.clear();
        m_times = {};
        m_start = nowMs();
        const std::clock_t processor = std::clock();
        m_loader.request(frame);
        while (!m_loader.isComplete())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
        m_times.allWhole = nowMs() - m_start;
        m_times.processor = 1000.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
        return m_times;
    }

private:
    test::TemporaryFolder m_folder; ///< of the videos' indices
    widgets::JobPool m_pool;
    widgets::FrameLoader m_loader;
    std::shared_ptr<const core::Dataset> m_dataset;
    int m_frames = 0, m_views = 0, m_completed = 0;
    std::set<int> m_seen;
    Times m_times;
    double m_start = 0;
};

void print(const char* what, const std::vector<Times>& all) {
    const auto show = [&](double Times::*member) {
        std::vector<double> values;
        for (const Times& one : all)
            values.push_back(one.*member);
        std::sort(values.begin(), values.end());
        std::printf(" %6.0f %5.0f %5.0f", values.front(), values[values.size() / 2], values.back());
    };
    std::printf("%-34s", what);
    show(&Times::firstSeen), show(&Times::allSeen), show(&Times::firstWhole), show(&Times::allWhole);
    show(&Times::processor);
    std::printf("\n");
    std::fflush(stdout);
}

void steps(Trial& trial, const char* what, int from, int direction, int pauseMs) {
    trial.go(from);
    wait(pauseMs);
    std::vector<Times> times;
    for (int i = 1; i <= 12; ++i)
        times.push_back(trial.go(from + direction * i));
    print(what, times);
}

void jumps(Trial& trial, const char* what) {
    std::mt19937 random(5);
    std::vector<Times> times;
    for (int i = 0; i < 10; ++i)
        times.push_back(trial.go(static_cast<int>(random() % static_cast<unsigned>(trial.frames()))));
    print(what, times);
}

/// Until every picture is kept small, as while nothing else is done.
void waitForSurvey(const Trial& trial) {
    const double start = nowMs();
    std::uintmax_t bytes = 0, before = 1;
    while (bytes != before) {
        wait(3000);
        before = std::exchange(bytes, trial.bytesOfSmallPictures());
    }
    std::printf("small pictures of everything: within %.0f s, %.0f MB\n", (nowMs() - start) / 1000,
                static_cast<double>(bytes) / (1 << 20));
}

void play(Trial& trial) {
    constexpr int kSeconds = 5;
    widgets::Selection selection;
    selection.setFrameCount(trial.frames());
    QObject::connect(&selection, &widgets::Selection::frameChanged, &trial.loader(), &widgets::FrameLoader::request);
    trial.go(0);
    widgets::Playback playback(selection, trial.loader());
    playback.setFramesPerSecond(50);
    const int before = trial.completed();
    playback.play();
    wait(1000 * kSeconds);
    std::printf("playback at 50/s: %.1f frames shown a second, %.1f frames of the recording a second\n",
                (trial.completed() - before) / double(kSeconds), selection.frame() / double(kSeconds));
    const double stopped = nowMs();
    playback.stop();
    while (!trial.loader().isComplete())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    std::printf("whole pictures after stopping: %.0f ms\n", nowMs() - stopped);
}

void scrub(Trial& trial) {
    constexpr int kMoves = 180;
    int shown = 0, last = -1;
    const auto connection = QObject::connect(
        &trial.loader(), &widgets::FrameLoader::standInLoaded, [&](int camera) { shown += camera == 7; });
    const auto other = QObject::connect(&trial.loader(), &widgets::FrameLoader::pictureLoaded,
                                        [&](int camera, const widgets::ImagePyramid&) { shown += camera == 7; });
    for (int i = 0; i < kMoves; ++i) {
        const int frame = i * (trial.frames() - 1) / kMoves;
        if (frame != last)
            trial.loader().request(last = frame);
        wait(16);
    }
    std::printf("scrubbing, 60 moves a second: the last view changes %.1f times a second\n", shown / (kMoves * 0.016));
    QObject::disconnect(connection);
    QObject::disconnect(other);
}

double residentMb() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return std::atof(line.c_str() + 6) / 1024;
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: handlens_footage_trial VIDEO [VIEWS]\n");
        return 2;
    }
    const QCoreApplication application(argc, argv);
    Trial trial(argv[1], argc > 2 ? std::atoi(argv[2]) : 8);
    std::printf("%-34s %18s %18s %18s %18s %18s\n", "least, median and largest, ms", "current: any", "all: any",
                "current: whole", "all: whole", "processor");
    print("first frame", {trial.go(trial.frames() / 2)});
    const int middle = trial.frames() / 100 * 50 + 20; // within a group of 50
    steps(trial, "forward, neighbourhood decoded", middle, 1, 4000);
    trial.go(middle + 100);
    trial.go(middle + 20);
    steps(trial, "back, neighbourhood decoded", middle + 19, -1, 4000);
    trial.loader().setFetchingAhead(false);
    steps(trial, "forward, nothing decoded ahead", middle + 65, 1, 0);
    steps(trial, "back, nothing decoded ahead", middle + 5, -1, 0);
    trial.loader().setFetchingAhead(true);
    jumps(trial, "jump anywhere");
    scrub(trial);
    play(trial);
    waitForSurvey(trial);
    jumps(trial, "jump, all pictures kept small");
    scrub(trial);
    play(trial);
    std::printf("memory: %.0f MB\n", residentMb());
    return 0;
}
