// SPDX-License-Identifier: GPL-3.0-or-later
// Pose errors of given pairs of poses, against values that were computed from the definitions with 4×4
// matrices, in double precision, outside this program.
#include "core/analysis/evaluation/internal/pose_errors.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

constexpr double tolerance = 1e-9;

/// Forty poses of a run and a log in other axes, a scale of 1.02, with errors of 10 mm and 0.02 rad.
std::vector<PosePair> somePairs()
{
    std::vector<PosePair> pairs;
    for (int i = 0; i < 40; ++i) {
        const double t = i / 10.0;
        PosePair pair;
        pair.timeS = t;
        const Eigen::Vector2d run(0.9 * std::sin(0.7 * t), 0.6 * std::sin(1.4 * t + 0.3));
        pair.measured.position = run;
        pair.measured.headingRad = 0.4 * t + 0.2 * std::sin(2 * t);
        pair.measured.ownVarianceM2 = 1; // so that the headings are the surer ones
        const double c = std::cos(0.8), s = std::sin(0.8);
        pair.log.timeS = t;
        pair.log.position = {1.02 * (c * run.x() - s * run.y()) + 2 + 0.01 * std::sin(3.0 * i),
                             1.02 * (s * run.x() + c * run.y()) - 1 + 0.01 * std::cos(5.0 * i)};
        pair.log.headingRad = *pair.measured.headingRad + 0.8 + 0.02 * std::sin(7.0 * i);
        pairs.push_back(pair);
    }
    return pairs;
}

void compare(const ErrorStatistics &errors, const ErrorStatistics &expected)
{
    QCOMPARE(errors.count, expected.count);
    for (const auto value : {&ErrorStatistics::rmse, &ErrorStatistics::mean, &ErrorStatistics::median,
                             &ErrorStatistics::std, &ErrorStatistics::least, &ErrorStatistics::most})
        QVERIFY2(std::abs(errors.*value - expected.*value) < tolerance,
                 qPrintable(QString::number(errors.*value, 'f', 12)));
}

/// The measured run at even steps along a line.
std::vector<PosePair> line(int count, double stepM)
{
    std::vector<PosePair> pairs(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        pairs[std::size_t(i)].timeS = i;
        pairs[std::size_t(i)].measured.position.x() = pairs[std::size_t(i)].log.position.x() = i * stepM;
    }
    return pairs;
}

} // namespace

class TestPoseErrors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithTheDefinitions_data()
    {
        QTest::addColumn<PlaneSimilarity>("transform");
        QTest::addColumn<ErrorStatistics>("absolute");
        QTest::addColumn<ErrorStatistics>("relative");
        QTest::addColumn<ErrorStatistics>("heading");
        QTest::addColumn<ErrorStatistics>("displacements");
        const auto pairs = somePairs();
        const ErrorStatistics unscaled{33,
                                       0.018075959717,
                                       0.016201823083,
                                       0.013949539753,
                                       0.008015063846,
                                       0.004260385840,
                                       0.033138870702};
        QTest::newRow("none") << PlaneSimilarity{} << ErrorStatistics{40,
                                                                      1.938297055660,
                                                                      1.920773403270,
                                                                      1.925964979054,
                                                                      0.260048090301,
                                                                      1.548743849395,
                                                                      2.273794974410}
                              << unscaled << ErrorStatistics{40,
                                                             0.801501368622,
                                                             0.801379529271,
                                                             0.802733432121,
                                                             0.013974761823,
                                                             0.780056534225,
                                                             0.819990403172}
                              << ErrorStatistics{33,
                                                 0.362299837656,
                                                 0.360739521704,
                                                 0.367460615603,
                                                 0.033588239698,
                                                 0.273559781659,
                                                 0.412539544535};
        QTest::newRow("origin") << originAlignment(pairs).transform << ErrorStatistics{40,
                                                                                       0.018394755583,
                                                                                       0.016339074998,
                                                                                       0.015218009930,
                                                                                       0.008449950365,
                                                                                       0.000000000000,
                                                                                       0.036969403589}
                                << unscaled << ErrorStatistics{40,
                                                               0.014042687386,
                                                               0.012547546550,
                                                               0.013920838988,
                                                               0.006305247385,
                                                               0.000000000000,
                                                               0.019990403172}
                                << ErrorStatistics{33,
                                                   0.016788841493,
                                                   0.014857886850,
                                                   0.013491014469,
                                                   0.007817186004,
                                                   0.000690439179,
                                                   0.031904797471};
        QTest::newRow("se2") << leastSquaresAlignment(pairs, false) << ErrorStatistics{40,
                                                                                       0.014378410974,
                                                                                       0.013108691816,
                                                                                       0.012730372387,
                                                                                       0.005907698452,
                                                                                       0.003283467431,
                                                                                       0.026204516875}
                             << unscaled << ErrorStatistics{40,
                                                            0.014087686992,
                                                            0.012587609262,
                                                            0.013593943843,
                                                            0.006325742474,
                                                            0.000400627120,
                                                            0.020391030292}
                             << ErrorStatistics{33,
                                                0.016769113084,
                                                0.014843379677,
                                                0.013558532847,
                                                0.007802386391,
                                                0.000863771202,
                                                0.031785189009};
        QTest::newRow("sim2") << leastSquaresAlignment(pairs, true) << ErrorStatistics{40,
                                                                                       0.010033631532,
                                                                                       0.009657692051,
                                                                                       0.010081596852,
                                                                                       0.002720798773,
                                                                                       0.002824334213,
                                                                                       0.013793140343}
                              << ErrorStatistics{33,
                                                 0.015384945040,
                                                 0.014105868330,
                                                 0.014730275408,
                                                 0.006141743446,
                                                 0.003328599805,
                                                 0.027125919164}
                              << ErrorStatistics{40,
                                                 0.014087686992,
                                                 0.012587609262,
                                                 0.013593943843,
                                                 0.006325742474,
                                                 0.000400627120,
                                                 0.020391030292}
                              << ErrorStatistics{33,
                                                 0.013858337025,
                                                 0.012765862624,
                                                 0.014038871081,
                                                 0.005393167581,
                                                 0.002243055617,
                                                 0.025043768482};
    }
    void agreesWithTheDefinitions()
    {
        QFETCH(PlaneSimilarity, transform);
        QFETCH(ErrorStatistics, absolute);
        QFETCH(ErrorStatistics, relative);
        QFETCH(ErrorStatistics, heading);
        QFETCH(ErrorStatistics, displacements);
        const auto pairs = somePairs();
        const auto steps = stepsOf(pairs, 0.5);
        compare(absoluteErrors(pairs, transform, 0), absolute);
        compare(*relativeErrors(pairs, steps, transform, true, 0, 0), relative);
        compare(*relativeErrors(pairs, steps, transform, false, 0, 0), displacements);
        compare(*headingErrors(pairs, transform), heading);
    }

    void alignsAsTheClosedFormSays()
    {
        const PlaneSimilarity scaled = leastSquaresAlignment(somePairs(), true);
        QVERIFY(std::abs(scaled.scale - 0.980364670653) < tolerance);
        QVERIFY(std::abs(scaled.headingRad + 0.799599372880) < tolerance);
        QVERIFY(std::abs(scaled.shiftM.x() + 0.663698484713) < tolerance);
        QVERIFY(std::abs(scaled.shiftM.y() - 2.088860305077) < tolerance);
        const PlaneSimilarity rigid = leastSquaresAlignment(somePairs(), false);
        QCOMPARE(rigid.scale, 1.0);
        QVERIFY(std::abs(rigid.shiftM.x() + 0.689414416378) < tolerance);
        QVERIFY(std::abs(rigid.shiftM.y() - 2.130537010641) < tolerance);
    }

    /// A mirrored log is not turned into its mirror image.
    void neverMirrors()
    {
        auto pairs = somePairs();
        for (PosePair &pair : pairs)
            pair.log.position = {pair.measured.position.x(), -pair.measured.position.y()};
        QVERIFY(absoluteErrors(pairs, leastSquaresAlignment(pairs, false), 0).rmse > 0.3);
    }

    void originIsTurnedByTheSurerDirection()
    {
        auto pairs = line(11, 0.1);
        for (PosePair &pair : pairs) {
            pair.log.headingRad = 0;
            pair.measured.headingRad = 0.1; // nowhere near the path
            pair.measured.ownVarianceM2 = 2 * 0.001 * 0.001;
            pair.measured.sigmaHeadingRad = 0.1;
        }
        // √2 mm over the first quarter of the metre, which ends with the position at 0.2 m
        const OriginAlignment byPath = originAlignment(pairs);
        QVERIFY(!byPath.isTurnedByHeading);
        QVERIFY(std::abs(byPath.transform.headingRad) < 1e-12);
        QVERIFY(std::abs(byPath.sigmaHeadingRad - std::sqrt(2.0) * 0.001 / 0.2) < 1e-12);
        for (PosePair &pair : pairs)
            pair.measured.sigmaHeadingRad = 0.001;
        const OriginAlignment byHeading = originAlignment(pairs);
        QVERIFY(byHeading.isTurnedByHeading);
        QVERIFY(std::abs(byHeading.transform.headingRad - 0.1) < 1e-12);
        QCOMPARE(byHeading.sigmaHeadingRad, 0.001);
    }

    void stepsAreOfTheLengthAndCrossNoGap()
    {
        auto pairs = line(21, 0.1);
        QCOMPARE(stepsOf(pairs, 1).size(), std::size_t(11));
        QCOMPARE(stepsOf(pairs, 1).front().to, std::size_t(10));
        // within a tenth of it
        QCOMPARE(stepsOf(pairs, 2.1).size(), std::size_t(2)); // 2.0 m from the first, 1.9 m from the second
        QVERIFY(stepsOf(pairs, 2.3).empty());
        for (std::size_t i = 8; i < pairs.size(); ++i)
            pairs[i].measured.piece = 1;
        QCOMPARE(stepsOf(pairs, 1).size(), std::size_t(3)); // from 0.8, 0.9 and 1.0 m
        // a robot that stands: of poses at one distance the first
        auto standing = line(21, 0.1);
        for (std::size_t i = 11; i < standing.size(); ++i)
            standing[i].measured.position.x() = 1;
        QCOMPARE(stepsOf(standing, 1).front().to, std::size_t(10));
    }

    void saysWhatTheMeasurementAlonePuts()
    {
        auto pairs = line(21, 0.1);
        for (PosePair &pair : pairs) {
            pair.measured.varianceM2 = 2 * (0.003 * 0.003 + 0.004 * 0.004);
            pair.measured.ownVarianceM2 = 2 * 0.003 * 0.003;
            pair.measured.velocity = {0.5, 0};
            pair.measured.headingRad = pair.log.headingRad = 0;
            pair.measured.sigmaHeadingRad = 0.002;
            pair.log.position.y() = 0.010;
        }
        const ErrorStatistics absolute = absoluteErrors(pairs, {}, 0.006);
        // 5 mm in both coordinates, and 3 mm along the path
        QVERIFY(std::abs(absolute.measurementSigma - std::sqrt(50.0 + 9.0) / 1000) < 1e-12);
        QVERIFY(absolute.isWithinUncertainty()); // 10 mm are less than 1.73 times 7.7 mm
        QVERIFY(!absoluteErrors(pairs, {{0, 0.004}, 0, 1}, 0.006).isWithinUncertainty());
        const auto relative = relativeErrors(pairs, stepsOf(pairs, 1), {}, true, 0.001, 0.006);
        // both ends 3 mm in both coordinates, heading 2 mm, scale 1 mm; the time offset displaces both alike
        QVERIFY(std::abs(relative->measurementSigma - std::sqrt(36.0 + 4.0 + 1.0) / 1000) < 1e-12);
        QVERIFY(std::abs(headingErrors(pairs, {})->measurementSigma - 0.002) < 1e-12);
        // Aligned at the first pose: its own 18 mm² in all, and 0.004 rad at 0 to 2 m, 1.367 m² in the mean.
        const OriginAlignment origin{{}, true, 0.004};
        const double distance2 = 0.01 * (20.0 * 21.0 * 41.0 / 6.0) / 21.0;
        QVERIFY(std::abs(absoluteErrors(pairs, {}, 0.006, &origin).measurementSigma -
                         std::sqrt((50.0 + 9.0 + 18.0) * 1e-6 + 16e-6 * distance2)) < 1e-12);
        QVERIFY(std::abs(headingErrors(pairs, {}, &origin)->measurementSigma - std::sqrt(20.0) / 1000) <
                1e-12);
    }

    void namesAHeadingThatIsAlwaysOff()
    {
        auto pairs = somePairs();
        QVERIFY(!lastingHeadingError(pairs, leastSquaresAlignment(pairs, false)));
        for (PosePair &pair : pairs)
            *pair.log.headingRad += 3.141592653589793;
        const auto error = lastingHeadingError(pairs, leastSquaresAlignment(pairs, false));
        QVERIFY(error && std::abs(std::abs(*error) - 3.14159) < 0.02);
        for (PosePair &pair : pairs)
            pair.log.headingRad.reset();
        QVERIFY(!lastingHeadingError(pairs, {}));
        QVERIFY(!headingErrors(pairs, {}));
    }

    void statisticsOfFewErrors()
    {
        const ErrorStatistics two = statisticsOf({3, 1});
        QCOMPARE(two.count, std::size_t(2));
        QCOMPARE(two.rmse, std::sqrt(5.0));
        QCOMPARE(two.mean, 2.0);
        QCOMPARE(two.median, 2.0);
        QCOMPARE(two.std, 1.0);
        QCOMPARE(two.least, 1.0);
        QCOMPARE(two.most, 3.0);
        QCOMPARE(statisticsOf({}).count, std::size_t(0));
    }
};

ODOGRAPH_TEST(TestPoseErrors, QCoreApplication)
#include "tst_pose_errors.moc"
