// SPDX-License-Identifier: MIT
#include "core/benchmark/findings.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/benchmark/metrics.h"
#include "core/benchmark/sweep.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr double kTieMm = 0.02;
constexpr double kTieSeconds = 0.02; ///< share by which times differ from run to run

/// Clearly smaller; a tie does not count.
bool beats(double mm, double otherMm) {
    return mm < otherMm - kTieMm;
}

/// Looks up what the claims need, and remembers what was missing.
class Evidence {
public:
    Evidence(const BenchmarkResults& results, Schedule schedule)
        : m_results(results)
        , m_schedule(schedule) {}

    bool has(const std::string& method) const { return statistics(method).pairs > 0; }
    double mm(const std::string& method) const { return statistics(method).meanMm; }
    double seconds(const std::string& method) const { return statistics(method).meanSeconds; }
    double roughness(const std::string& method) const { return statistics(method).costRisesPerIteration; }

    /// "name 1.23, name 4.56"
    std::string list(const std::vector<std::string>& methods) const {
        std::string text;
        for (const std::string& method : methods)
            text += (text.empty() ? "" : ", ") + shortName(method) + " " + fixedText(mm(method), 2);
        return text;
    }

    /// The finding if all methods were run, else "not measured" and the first one that was not.
    template <typename Holds>
    Finding judge(const std::string& claim, const std::vector<std::string>& methods, const Holds& holds) const {
        for (const std::string& method : methods)
            if (!has(method))
                return {claim, Verdict::NotMeasured, "needs " + underSchedule(method, m_schedule)};
        return {claim, holds() ? Verdict::Reproduced : Verdict::NotReproduced, list(methods)};
    }

private:
    const ErrorStatistics& statistics(const std::string& method) const {
        const std::string name = underSchedule(method, m_schedule);
        const auto [at, isNew] = m_known.try_emplace(name);
        if (isNew)
            at->second = errorStatistics(m_results, name);
        return at->second;
    }

    static std::string shortName(const std::string& method) {
        return method.starts_with("dch-") ? method.substr(4) : method;
    }

    const BenchmarkResults& m_results;
    Schedule m_schedule;
    mutable std::map<std::string, ErrorStatistics> m_known;
};

std::vector<std::string> variants(const std::string& method, const std::string& option,
                                  const std::vector<std::string>& values) {
    std::vector<std::string> names;
    for (const std::string& value : values)
        names.push_back(method + ":" + option + "=" + value);
    return names;
}

std::string least(const Evidence& evidence, const std::vector<std::string>& methods) {
    return *std::min_element(
        methods.begin(), methods.end(),
        [&](const std::string& a, const std::string& b) { return evidence.mm(a) < evidence.mm(b); });
}

Finding signedBeatsUnsigned(const Evidence& evidence, const std::string& method, const std::string& name) {
    return evidence.judge(
        "signed orientation beats unsigned (" + name + ")", {method, method + ":signed=0"},
        [&] { return beats(evidence.mm(method), evidence.mm(method + ":signed=0")); });
}

Finding bestTau(const Evidence& evidence) {
    const std::vector<std::string> taus = variants("dch-thres", "tau", {"11.25", "22.5", "45", "90"});
    return evidence.judge("tau = 22.5 deg is best", taus, [&] {
        return std::all_of(taus.begin(), taus.end(), [&](const std::string& tau) {
            return tau == taus[1] || beats(evidence.mm(taus[1]), evidence.mm(tau));
        });
    });
}

Finding lambdaSaturates(const Evidence& evidence) {
    const std::vector<std::string> all = variants("dch-dt3", "lambda", {"0", "5", "15", "25", "35", "50"});
    return evidence.judge("lambda saturates in [15, 35] px/rad", all, [&] {
        const auto [low, high] = std::minmax({evidence.mm(all[2]), evidence.mm(all[3]), evidence.mm(all[4])});
        const double best = evidence.mm(least(evidence, all));
        return high - low <= 0.1 * high + kTieMm && low <= best + 0.05 * best + kTieMm && evidence.mm(all[0]) > high;
    });
}

Finding dt3Bins(const Evidence& evidence) {
    const std::vector<std::string> bins = variants("dch-dt3", "bins", {"4", "8", "16", "32"});
    return evidence.judge("DT3 needs more than 8 bins, and 16 suffice", bins, [&] {
        return evidence.mm(bins[1]) > evidence.mm(bins[2]) + kTieMm &&
               evidence.mm(bins[2]) <= 1.1 * evidence.mm(bins[3]) + kTieMm;
    });
}

Finding quant2BeatsQuant(const Evidence& evidence) {
    const std::vector<std::string> quant = variants("dch-quant", "bins", {"4", "8", "16", "32"});
    const std::vector<std::string> quant2 = variants("dch-quant2", "bins", {"4", "8", "16", "32"});
    std::vector<std::string> all = quant;
    all.insert(all.end(), quant2.begin(), quant2.end());
    return evidence.judge("Quant2 beats Quant (each at its best number of bins)", all, [&] {
        return beats(evidence.mm(least(evidence, quant2)), evidence.mm(least(evidence, quant)));
    });
}

Finding fewerBins(const Evidence& evidence, const std::string& method, const std::string& name) {
    const std::vector<std::string> bins = variants(method, "bins", {"4", "8", "16", "32"});
    return evidence.judge("fewer bins are better for " + name, bins, [&] {
        return beats(std::min(evidence.mm(bins[0]), evidence.mm(bins[1])),
                     std::min(evidence.mm(bins[2]), evidence.mm(bins[3])));
    });
}

/// Thres first.
const std::vector<std::string> kPapersMethods = {"dch-thres", "ch", "dch-dt3", "dch-quant"};

Finding thresIsBest(const Evidence& evidence) {
    return evidence.judge(
        "Thres has the smallest error", kPapersMethods,
        [&] {
            return std::all_of(
                kPapersMethods.begin() + 1, kPapersMethods.end(),
                [&](const std::string& method) { return beats(evidence.mm("dch-thres"), evidence.mm(method)); });
        });
}

Finding thresIsFastest(const Evidence& evidence) {
    Finding finding = evidence.judge("Thres is the fastest", kPapersMethods, [&] {
        return std::all_of(kPapersMethods.begin() + 1, kPapersMethods.end(), [&](const std::string& method) {
            return evidence.seconds("dch-thres") < (1 - kTieSeconds) * evidence.seconds(method);
        });
    });
    if (finding.verdict != Verdict::NotMeasured) {
        finding.numbers = "seconds per pair:";
        for (const std::string& method : kPapersMethods)
            finding.numbers += " " + method + " " + fixedText(evidence.seconds(method), 3);
    }
    return finding;
}

Finding dt3IsSmooth(const Evidence& evidence) {
    Finding finding = evidence.judge("DT3 converges more smoothly", kPapersMethods, [&] {
        return std::all_of(kPapersMethods.begin(), kPapersMethods.end(), [&](const std::string& method) {
            return method == "dch-dt3" || evidence.roughness("dch-dt3") < evidence.roughness(method);
        });
    });
    if (finding.verdict != Verdict::NotMeasured) {
        finding.numbers = "share of iterations that raised the cost:";
        for (const std::string& method : kPapersMethods)
            finding.numbers += " " + method + " " + fixedText(100 * evidence.roughness(method), 1) + " %";
    }
    return finding;
}

Finding chOnRealData(const Evidence& evidence, BenchmarkSetup setup) {
    const std::string claim = "CH is good on synthetic data and worst on real data";
    if (setup == BenchmarkSetup::Synthetic) {
        return {claim, Verdict::NotMeasured,
                evidence.has("ch") ? "synthetic: " + evidence.list({"ch"}) + "; the other half needs a realistic run"
                                   : "needs ch, and a realistic run"};
    }
    return evidence.judge(claim + " (the real half)", kPapersMethods, [&] {
        return std::all_of(kPapersMethods.begin(), kPapersMethods.end(), [&](const std::string& method) {
            return method == "ch" || beats(evidence.mm(method), evidence.mm("ch"));
        });
    });
}

} // namespace

std::string_view verdictName(Verdict verdict) {
    switch (verdict) {
    case Verdict::Reproduced:
        return "reproduced";
    case Verdict::NotReproduced:
        return "not reproduced";
    case Verdict::NotMeasured:
        return "not measured";
    }
    return "";
}

std::vector<Finding> findings(const BenchmarkResults& results, BenchmarkSetup setup, Schedule schedule) {
    const Evidence evidence(results, schedule);
    return {
        signedBeatsUnsigned(evidence, "dch-thres", "Thres"),
        signedBeatsUnsigned(evidence, "dch-dt3", "DT3"),
        bestTau(evidence),
        lambdaSaturates(evidence),
        dt3Bins(evidence),
        quant2BeatsQuant(evidence),
        fewerBins(evidence, "dch-quant", "Quant"),
        fewerBins(evidence, "dch-quant2", "Quant2"),
        thresIsBest(evidence),
        thresIsFastest(evidence),
        dt3IsSmooth(evidence),
        chOnRealData(evidence, setup),
    };
}

} // namespace core
