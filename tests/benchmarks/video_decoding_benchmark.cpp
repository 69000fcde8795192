// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "core/io/footage/video_file.h"
#include "tests/support/recordings/numbered_video.h"
#include "tests/support/temporary_folder.h"

// A video read frame by frame on two threads, beside ffmpeg on two threads, which shows nothing. HANDLENS_VIDEO names
// the video; without it, a small one is made.
namespace {

constexpr int kThreads = 2;

/// Empty if there is none and none can be made.
std::string videoToRead() {
    if (const char* named = std::getenv("HANDLENS_VIDEO"))
        return named;
    static const test::TemporaryFolder folder;
    static const bool isMade =
        test::hasFfmpeg() &&
        test::encodeNumbered(folder / "numbered.mp4", "-c:v libx264 -g 30 -pix_fmt yuv420p", test::countTo(60));
    return isMade ? (folder / "numbered.mp4").string() : std::string();
}

void sayMissing(benchmark::State& state) {
    for (auto _ : state)
        state.SetLabel("ffmpeg is not installed");
}

void readVideo(benchmark::State& state) {
    const std::string file = videoToRead();
    if (file.empty()) {
        sayMissing(state);
        return;
    }
    const test::TemporaryFolder folder;
    core::VideoFile(file, folder / "index"); // made once, as for a dataset
    int frames = 0;
    for (auto _ : state) {
        core::VideoFile video(file, folder / "index", kThreads);
        for (int frame = 0; frame < video.info().frames; ++frame, ++frames)
            benchmark::DoNotOptimize(video.read(frame).data);
    }
    state.counters["frames per second"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

void decodeWithFfmpeg(benchmark::State& state) {
    const std::string file = videoToRead();
    if (file.empty()) {
        sayMissing(state);
        return;
    }
    const std::string command =
        "ffmpeg -v quiet -threads " + std::to_string(kThreads) + " -i '" + file + "' -f null - </dev/null";
    const int each = core::readVideoInfo(file).frames;
    int frames = 0;
    for (auto _ : state)
        frames += std::system(command.c_str()) == 0 ? each : 0;
    state.counters["frames per second"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

BENCHMARK(readVideo)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(decodeWithFfmpeg)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
