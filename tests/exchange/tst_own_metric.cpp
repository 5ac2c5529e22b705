// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics by a formula: values and σ against numbers computed by hand, by differences and by random draws.
#include "core/exchange/internal/formula.h"
#include "core/exchange/own_metric.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace odo;

namespace {

double valueOf(const char *text, std::vector<double> values = {})
{
    const auto formula = Formula::parse(text);
    const auto outcome = formula ? formula->evaluate(values) : std::nullopt;
    return outcome ? outcome->value : std::nan("");
}

/// Two runs of a robot of 0.4 kg, one of a robot whose mass nobody knows, an untracked trial.
ResultTable example()
{
    ResultTable table;
    table.variables = {"mass", "surface"};
    table.columns = {{"max_speed", "m/s"}, {"path_length", "m"}};
    const auto add = [&table](const char *mass, std::optional<Metric> speed, std::optional<Metric> path) {
        TrialTableRow row;
        row.robot = "Red";
        if (*mass)
            row.trial.variables = {{"mass", mass}, {"surface", "carpet"}};
        row.metrics = {std::move(speed), std::move(path)};
        table.rows.push_back(std::move(row));
    };
    add("0.4", Metric{"max_speed", "m/s", 2, 0.05}, Metric{"path_length", "m", 10, {}});
    add("0.4", Metric{"max_speed", "m/s", 3, 0.05, true}, Metric{"path_length", "m", 12, 0.1});
    add("", Metric{"max_speed", "m/s", 2, 0.05}, Metric{"path_length", "m", 10, 0.1});
    add("0.4", std::nullopt, std::nullopt);
    return table;
}

const OwnMetric energy{"energy", "J", "0.5 * mass * max_speed^2"};

} // namespace

class TestOwnMetric : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void formulas_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("order") << "2 + 3 * 4 - 6 / 2" << 11.0;
        QTest::newRow("brackets") << "(2 + 3) * -(4 - 6)" << 10.0;
        QTest::newRow("power first") << "-2^2" << -4.0;
        QTest::newRow("power from the right") << "2^3^2" << 512.0;
        QTest::newRow("negative exponent") << "2^-1" << 0.5;
        QTest::newRow("numbers") << "1.5e3 + .5" << 1500.5;
        QTest::newRow("functions") << "sqrt(16) + abs(-3) + max(2, 7) + min(2, 7) + hypot(3, 4)" << 21.0;
        QTest::newRow("transcendental") << "ln(exp(2)) + log10(1000) + cos(pi) + sin(pi/2) + tan(0)" << 5.0;
        QTest::newRow("from left") << "12 / 3 / 2 - 1 - 1" << 0.0;
    }
    void formulas()
    {
        QFETCH(QString, text);
        QFETCH(double, value);
        QCOMPARE(valueOf(text.toUtf8().constData()), value);
    }

    void namesOfAnyAlphabet()
    {
        const auto formula = Formula::parse("{robot mass} * höhe_1 + {robot mass}");
        QVERIFY(formula);
        QCOMPARE(formula->names(), (std::vector<std::string>{"robot mass", "höhe_1"}));
        QCOMPARE(valueOf("{robot mass} * höhe_1 + {robot mass}", {2, 5}), 12.0);
    }

    void mistakesAreNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << ""
                               << "missing at its end";
        QTest::newRow("open") << "(1 + 2"
                              << "closing bracket";
        QTest::newRow("brace") << "{mass * 2"
                               << "closing brace";
        QTest::newRow("two signs") << "2 * * 3"
                                   << "'*' is not expected at character 5";
        QTest::newRow("two numbers") << "2 3"
                                     << "'3' is not expected at character 3";
        QTest::newRow("function") << "root(2)"
                                  << "there is no function 'root'";
        QTest::newRow("one value") << "max(2)"
                                   << "takes two values";
        QTest::newRow("deep") << QString(300, u'(') << "too many brackets";
        QTest::newRow("long") << QString(600, u'1') << "too long";
        QTest::newRow("comma") << "1,5"
                               << "',' is not expected";
    }
    void mistakesAreNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, why);
        const auto formula = Formula::parse(text.toStdString());
        QVERIFY(!formula);
        QVERIFY2(formula.error().message().find(why.toStdString()) != std::string::npos,
                 formula.error().message().c_str());
    }

    /// Derivatives are those of central differences.
    void slopes()
    {
        const auto formula = Formula::parse("sqrt(a) * exp(-b/3) + a^b / hypot(a, c) - ln(c) * sin(a*c) + "
                                            "max(a, 9*b) * log10(b) + abs(-c) * cos(b) + tan(a/9) - -c");
        QVERIFY(formula);
        const std::vector<double> at{1.3, 0.7, 2.1};
        const auto outcome = formula->evaluate(at);
        QVERIFY(outcome);
        constexpr double step = 1e-6;
        for (std::size_t i = 0; i < at.size(); ++i) {
            std::vector<double> up = at, down = at;
            up[i] += step;
            down[i] -= step;
            const double slope = (formula->evaluate(up)->value - formula->evaluate(down)->value) / (2 * step);
            QVERIFY2(std::abs(slope - outcome->slopes[i]) < 1e-7 * (1 + std::abs(slope)),
                     qPrintable(QString::number(slope - outcome->slopes[i])));
        }
        QVERIFY(!Formula::parse("1 / (a - a)")->evaluate(std::vector<double>{2.0}));
        QVERIFY(!Formula::parse("sqrt(a)")->evaluate(std::vector<double>{-2.0}));
        QCOMPARE(valueOf("(0 - a)^2", {3.0}), 9.0); // no logarithm of a negative number
    }

    void energyOfRuns()
    {
        ResultTable table = example();
        QVERIFY(addOwnMetrics(table, std::vector{energy}));
        QCOMPARE(table.columns.back().metric, std::string("energy"));
        QCOMPARE(table.columns.back().unit, std::string("J"));
        const auto &first = table.rows[0].metrics[2], &second = table.rows[1].metrics[2];
        QVERIFY(first && second);
        QCOMPARE(first->value, 0.8);
        QCOMPARE(*first->sigma, 0.4 * 2 * 0.05); // m v σ(v)
        QVERIFY(!first->isAtLeast && second->isAtLeast);
        QVERIFY(!table.rows[2].metrics[2] && !table.rows[3].metrics[2]);
    }

    /// One can use another; what is not known of an input is not known of the result.
    void inOrder()
    {
        ResultTable table = example();
        QVERIFY(
            addOwnMetrics(table, std::vector{energy, OwnMetric{"per_metre", "J/m", "energy / path_length"},
                                             OwnMetric{"slowness", "s/m", "1 / max_speed"}}));
        QVERIFY(std::abs(table.rows[0].metrics[3]->value - 0.08) < 1e-12);
        QVERIFY(!table.rows[0].metrics[3]->sigma); // the path has none
        QVERIFY(!table.rows[1].metrics[4]);        // an upper bound, which a table cannot say
        QCOMPARE(table.rows[2].metrics[4]->value, 0.5);
    }

    /// σ is how far results of random draws scatter.
    void uncertaintyAsDrawn()
    {
        const OwnMetric own{"own", "1", "max_speed^2 / path_length + sqrt(path_length)"};
        ResultTable table = example();
        QVERIFY(addOwnMetrics(table, std::vector{own}));
        const double stated = *table.rows[2].metrics[2]->sigma;
        std::mt19937 random(3);
        std::normal_distribution<double> speed(2, 0.05), path(10, 0.1);
        double sum = 0, squares = 0;
        constexpr int draws = 20'000;
        for (int i = 0; i < draws; ++i) {
            const double v = speed(random), s = path(random), value = v * v / s + std::sqrt(s);
            sum += value;
            squares += value * value;
        }
        const double drawn = std::sqrt(squares / draws - sum / draws * (sum / draws));
        QVERIFY2(std::abs(stated / drawn - 1) < 0.03, qPrintable(QString::number(stated / drawn)));
    }

    void whatCannotBe()
    {
        ResultTable table = example();
        const auto refused = [&table](const OwnMetric &own) {
            const auto added = addOwnMetrics(table, std::vector{own});
            return added ? std::string() : added.error().message();
        };
        QCOMPARE(
            refused({"own", "", "weight * 2"}),
            std::string("own metric 'own': no trial has a metric or variable 'weight'; choose from mass, "
                        "max_speed, path_length, surface"));
        QVERIFY(refused({"max_speed", "", "2"}).find("has a metric of that name") != std::string::npos);
        QVERIFY(refused({"two words", "", "2"}).find("not a single word") != std::string::npos);
        QVERIFY(refused({"mass", "", "2"}).find("a metric or variable has that name") != std::string::npos);
        QVERIFY(refused({"own", std::string(61, 'm'), "2"}).find("more than 60 characters") !=
                std::string::npos);
        QCOMPARE(table.columns.size(), std::size_t(2));
        QVERIFY(
            addOwnMetrics(table, std::vector{OwnMetric{"other", "", "surface + 1"}})); // no number: no value
        QVERIFY(!table.rows[0].metrics[2]);
    }
};

ODOGRAPH_TEST(TestOwnMetric, QCoreApplication)
#include "tst_own_metric.moc"
