// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/trajectory/contradictory_runs.h"

#include <QTest>
#include <cstdio>
#include <map>

using namespace odo;
using namespace odo::test;

namespace {

/// How many runs of each kind: a sample, or with ODOGRAPH_CONTRADICTIONS=40 what is claimed
/// (docs/testing.md).
int runsOfEach()
{
    const int told = qEnvironmentVariableIntValue("ODOGRAPH_CONTRADICTIONS");
    return told > 0 ? told : 1;
}

struct Measured
{
    bool isRefused = false, isDoubted = false, isNamed = false, isNamedFirst = false;
    bool isHeightKept = true;      ///< the given one, however wrong it seems
    double errorM = 0, sigmaM = 0; ///< root mean square of a coordinate; median
    double insideShare = 0;        ///< of the frames, in which the stated 95 % hold both coordinates
    std::string words;
};

bool isRight(const DrawnRun &run, const std::vector<ContradictionCause> &causes)
{
    using Kind = ContradictionCause::Kind;
    return std::ranges::any_of(causes, [&](const ContradictionCause &cause) {
        switch (run.wrong) {
        case Wrong::CameraBefore:
            return cause.kind == Kind::CameraMoved && cause.view == run.movedView && !cause.since;
        case Wrong::CameraDuring:
            return cause.kind == Kind::CameraMoved && cause.view == run.movedView && cause.since &&
                   std::abs(toSeconds(*cause.since) - run.movedAtS) < 0.5;
        case Wrong::BothCameras:
            return cause.kind == Kind::CameraMoved || cause.kind == Kind::CamerasMoved;
        case Wrong::Offset:
            return cause.kind == Kind::Offset;
        case Wrong::Height:
            return cause.kind == Kind::Height;
        case Wrong::Exchanged:
        case Wrong::Nothing:
            break;
        }
        return false;
    });
}

std::string wordsOf(const ViewsContradiction &contradiction)
{
    static const char *const names[] = {"camera", "cameras", "offset", "rate", "height"};
    std::string words;
    for (const ContradictionCause &cause : contradiction.causes) {
        char text[80];
        std::snprintf(text, sizeof text, "%s%s %c %.4g%s", words.empty() ? "" : " | ", names[int(cause.kind)],
                      cause.view == 0 ? 'A' : 'B', cause.size, cause.since ? " since " : "");
        words += text;
        if (cause.since)
            words += std::to_string(toSeconds(*cause.since)).substr(0, 4);
    }
    return words.empty() ? "not explained" : words;
}

Measured measured(const DrawnRun &run)
{
    Measured result;
    const auto profile = analyse(run.views, run.told, {});
    if (!profile) {
        result.isRefused = result.isDoubted = true;
        result.isNamed =
            run.wrong == Wrong::Exchanged && profile.error().message().find("exchanged") != std::string::npos;
        result.words = profile.error().message();
        return result;
    }
    result.isHeightKept = profile->heightEstimated != run.told.heightM.has_value() &&
                          (profile->heightEstimated || !profile->contradiction ||
                           std::abs(profile->heightM - *run.told.heightM) < 1e-4);
    double squares = 0, count = 0, inside = 0;
    std::vector<double> sigmas;
    for (std::size_t i = 0; i < profile->points.size(); ++i) {
        const ProfilePoint &point = profile->points[i];
        if (!point.valid)
            continue;
        const Eigen::Vector2d off = point.position - run.course(toSeconds(profile->samples[i].time)).position;
        squares += off.squaredNorm() / 2;
        inside += std::abs(off.x()) < 1.96 * point.sigmaXM && std::abs(off.y()) < 1.96 * point.sigmaYM;
        count += 1;
        sigmas.push_back((point.sigmaXM + point.sigmaYM) / 2);
    }
    std::ranges::nth_element(sigmas, sigmas.begin() + std::ssize(sigmas) / 2);
    result.errorM = std::sqrt(squares / count);
    result.sigmaM = sigmas[sigmas.size() / 2];
    result.insideShare = inside / count;
    result.isDoubted = profile->contradiction.has_value();
    if (profile->contradiction) {
        result.isNamed = isRight(run, profile->contradiction->causes);
        if (!profile->contradiction->causes.empty())
            result.isNamedFirst = isRight(run, {profile->contradiction->causes.front()});
        result.words = wordsOf(*profile->contradiction);
    }
    return result;
}

struct Totals
{
    int runs = 0, wrong = 0, doubtedWrong = 0, doubted = 0, named = 0, namedFirst = 0, refused = 0;
    double inside = 0; ///< sum over doubted, not refused runs

    double insideShare() const { return inside / std::max(1, doubted - refused); }
    void operator+=(const Totals &more)
    {
        runs += more.runs;
        wrong += more.wrong;
        doubtedWrong += more.doubtedWrong;
        doubted += more.doubted;
        named += more.named;
        namedFirst += more.namedFirst;
        refused += more.refused;
        inside += more.inside;
    }
};

bool isWrong(const Measured &as, const Measured &untouched)
{
    return as.isRefused || as.errorM > 3 * untouched.sigmaM;
}

void add(Totals &totals, const Measured &as, const Measured &untouched)
{
    const bool wrong = isWrong(as, untouched);
    ++totals.runs;
    totals.wrong += wrong;
    totals.doubted += as.isDoubted;
    totals.doubtedWrong += as.isDoubted && wrong;
    totals.named += as.isNamed && wrong;
    totals.namedFirst += as.isNamedFirst && wrong;
    totals.refused += as.isRefused;
    totals.inside += as.isDoubted && !as.isRefused ? as.insideShare : 0;
}

void print(const DrawnRun &run, int i, const Measured &as, const Measured &untouched)
{
    const bool wrong = isWrong(as, untouched);
    const char *const level = as.isRefused   ? "refused"
                              : as.isDoubted ? "doubtful"
                                             : "pass",
                      *const fault = !wrong || as.isNamed ? ""
                                     : as.isDoubted       ? " MISNAMED"
                                                          : " MISSED";
    std::printf(
        "%-20s %3d %9.4f at %.2f: error %7.2f mm, untouched %.2f mm, stated %7.2f mm, inside %3.0f %%, "
        "%s%s %s\n",
        nameOf(run.wrong).c_str(), i, run.size, run.movedAtS, 1e3 * as.errorM, 1e3 * untouched.sigmaM,
        1e3 * as.sigmaM, 100 * as.insideShare, level, fault, as.words.c_str());
}

} // namespace

class TestContradictionRuns : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Runs with one thing wrong: where the error exceeds 3 σ of the same run untouched, it is doubted, the
    /// cause is named, and the stated error holds the truth. Untouched runs are not doubted.
    void whatIsWrongIsDoubtedAndNamed()
    {
        const int runs = runsOfEach();
        std::map<Wrong, Totals> all;
        std::map<unsigned, Measured> untouchedOf; // by the seed
        for (const Wrong wrong : {Wrong::Nothing, Wrong::CameraBefore, Wrong::CameraDuring,
                                  Wrong::BothCameras, Wrong::Offset, Wrong::Height, Wrong::Exchanged}) {
            for (int i = 0; i < runs; ++i) {
                // the sample has one run, with one thing or another wrong
                const unsigned seed = runs > 1 ? unsigned(1000 * int(wrong) + i + 1) : 1;
                const auto [untouched, isNew] = untouchedOf.try_emplace(seed);
                if (isNew) {
                    untouched->second = measured(RunDrawer(seed).draw(Wrong::Nothing, 0));
                    add(all[Wrong::Nothing], untouched->second, untouched->second);
                }
                const DrawnRun run = RunDrawer(seed).draw(wrong, (i + 0.5) / runs);
                const Measured as = wrong == Wrong::Nothing ? untouched->second : measured(run);
                print(run, i, as, untouched->second);
                QVERIFY(as.isHeightKept);
                if (wrong != Wrong::Nothing)
                    add(all[wrong], as, untouched->second);
            }
        }
        Totals total;
        for (const auto &[wrong, its] : all) {
            std::printf("%-20s %3d runs, %3d beyond 3 sigma, %3d of them doubted, %3d named (%d first), "
                        "%3d doubted, %3d refused, %.0f %% inside\n",
                        nameOf(wrong).c_str(), its.runs, its.wrong, its.doubtedWrong, its.named,
                        its.namedFirst, its.doubted, its.refused, 100 * its.insideShare());
            if (wrong != Wrong::Nothing)
                total += its;
        }
        QVERIFY(100 * all[Wrong::Nothing].doubted <= all[Wrong::Nothing].runs);
        QVERIFY(100 * total.doubtedWrong >= 99 * total.wrong);
        QVERIFY(10 * total.named >= 9 * total.wrong);
        QVERIFY(total.insideShare() > 0.9);
    }
};

ODOGRAPH_TEST(TestContradictionRuns, QCoreApplication)
#include "tst_contradiction_runs.moc"
