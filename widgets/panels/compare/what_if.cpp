// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/what_if.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/contour/side_by_side.h"
#include "core/simulation/simulated_world.h"
#include "widgets/jobs/fit_pair.h"
#include "widgets/presenters/inspect_columns.h"

namespace widgets {

namespace {

constexpr int kPauseMs = 150; ///< while a setting is dragged, the real-time variant has the processor to itself

} // namespace

/// The noise of a pair's outlines; that of each camera is drawn by whoever needs it first, which takes a moment.
struct WhatIf::PairNoise {
    PairNoise(std::shared_ptr<const FitOutcome> of, int drawOf)
        : outcome(std::move(of))
        , draw(drawOf)
        , m_cameras(outcome->masks.size()) {}

    /// None where there is no mask.
    const std::optional<core::ContourNoise>& of(std::size_t camera) {
        Draw& one = m_cameras[camera];
        std::call_once(one.once, [&] {
            if (!outcome->masks[camera].empty())
                one.noise.emplace(outcome->masks[camera], kMostOutlineNoisePx,
                                  outlineNoiseSeed(draw, camera, outcome->sequence));
            ++m_drawn;
        });
        return one.noise;
    }
    bool isDrawn() const { return m_drawn == m_cameras.size(); }

    const std::shared_ptr<const FitOutcome> outcome;
    const int draw;

private:
    struct Draw {
        std::once_flag once;
        std::optional<core::ContourNoise> noise;
    };
    std::vector<Draw> m_cameras;
    std::atomic<std::size_t> m_drawn = 0;
};

/// The silhouettes of a pair in a case; made by whoever needs them first.
struct WhatIf::CaseMasks {
    std::shared_ptr<const FitOutcome> outcome;
    WhatIfCase what;
    std::shared_ptr<PairNoise> noise;
    std::once_flag once;
    std::vector<cv::Mat> masks;
    std::shared_ptr<const CameraOutlines> outlinesPx; ///< of the noisy ones, also where a camera is left out

    const std::vector<cv::Mat>& get() {
        std::call_once(once, [this] {
            masks = outcome->masks;
            if (what.outlineNoisePx > 0)
                addNoise();
            for (std::size_t camera = 0; camera < masks.size(); ++camera)
                if (what.isLeftOut(camera))
                    masks[camera] = cv::Mat();
        });
        return masks;
    }

private:
    void addNoise() {
        CameraOutlines outlines(masks.size());
        core::forEachSideBySide(masks.size(), [&](std::size_t camera) {
            if (masks[camera].empty())
                return;
            masks[camera] = noise->of(camera)->applied(what.outlineNoisePx);
            outlines[camera] = outlinesOf(masks[camera]);
        });
        outlinesPx = std::make_shared<const CameraOutlines>(std::move(outlines));
    }
};

WhatIf::WhatIf(const FitRunner& fits, const DatasetSession& datasets, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_fits(fits)
    , m_datasets(datasets)
    , m_job(pool)
    , m_preparing(pool, Job::Kind::Background) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &WhatIf::startNext);
    connect(&m_job, &Job::finished, this, &WhatIf::goOn);
    connect(&m_job, &Job::failed, this, [this](const QString& message) {
        m_waiting.clear();
        emit failed(message);
    });
    connect(
        &fits, &FitRunner::cleared, this,
        [this] {
            stop();
            m_noise.reset();
            m_masks.reset();
        });
    connect(
        &fits, &FitRunner::finished, this, [this] { m_awaitsIdle = true; });
    connect(&pool, &JobPool::becameIdle, this, [this] {
        if (std::exchange(m_awaitsIdle, false))
            prepare();
    });
}

void WhatIf::run(std::vector<WhatIfTrial> trials) {
    m_waiting.assign(std::make_move_iterator(trials.begin()), std::make_move_iterator(trials.end()));
    if (m_job.isRunning() && !m_runsLive && !m_waiting.empty() && m_waiting.front().isLive)
        m_job.stop();
    m_pause.stop();
    if (!m_job.isRunning())
        startNext();
}

void WhatIf::stop() {
    m_waiting.clear();
    m_pause.stop();
    m_job.stop();
}

void WhatIf::goOn() {
    if (m_runsLive && !m_waiting.empty() && !m_waiting.front().isLive)
        m_pause.start();
    else
        startNext();
}

std::shared_ptr<WhatIf::PairNoise> WhatIf::noiseOf(const std::shared_ptr<const FitOutcome>& outcome, int draw) {
    if (!m_noise || m_noise->draw != draw || !isSamePair(*m_noise->outcome, *outcome))
        m_noise = std::make_shared<PairNoise>(outcome, draw);
    return m_noise;
}

void WhatIf::prepare() {
    if (!m_fits.outcome())
        return;
    m_preparing.start([noise = noiseOf(m_fits.outcome(), m_noise ? m_noise->draw : 0)](const JobContext& context) {
        for (std::size_t camera = 0; camera < noise->outcome->masks.size() && !context.stop.stop_requested(); ++camera)
            noise->of(camera); // one after the other: the window's other work keeps a processor
        return Job::Delivery();
    });
}

bool WhatIf::isPrepared() const {
    return m_noise && m_fits.outcome() && isSamePair(*m_noise->outcome, *m_fits.outcome()) && m_noise->isDrawn();
}

std::shared_ptr<WhatIf::CaseMasks> WhatIf::masksOf(const std::shared_ptr<const FitOutcome>& outcome,
                                                   const WhatIfCase& what) {
    const std::shared_ptr<PairNoise> noise = noiseOf(outcome, what.draw);
    if (!m_masks || m_masks->outcome != outcome || m_masks->what != what) {
        m_masks = std::make_shared<CaseMasks>();
        m_masks->outcome = outcome;
        m_masks->what = what;
        m_masks->noise = noise;
    }
    return m_masks;
}

void WhatIf::startNext() {
    const auto outcome = m_fits.outcome();
    const auto dataset = m_datasets.dataset();
    if (m_waiting.empty() || !outcome || !dataset) {
        m_waiting.clear();
        emit finished();
        return;
    }
    const WhatIfTrial trial = m_waiting.front();
    m_waiting.pop_front();
    m_runsLive = trial.isLive;
    m_job.start([this, trial, outcome, dataset, masks = masksOf(outcome, trial.what),
                 estimator = m_fits.estimator()](const JobContext& context) {
        const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        FitOutcome pair;
        static_cast<FitPair&>(pair) = *outcome;
        pair.masks = masks->get();
        auto found =
            std::make_shared<MethodOutcome>(runMethod(estimator->get(*dataset), *dataset, pair, trial.method,
                                                      context.stop, threads, {}, !trial.isLive && trial.curve.empty()));
        return Job::Delivery([this, trial, found, outlines = masks->outlinesPx] {
            m_outlines = outlines;
            emit this->found(trial, *found);
        });
    });
}

} // namespace widgets
