#include "base/random.h"
#include "numeric/alpha_expansion.h"
#include "numeric/expansion_move.h"

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <set>

using namespace ductus;

namespace {

// Owns the columns that a LabelingProblem only points to.
struct TestProblem
{
    std::vector<std::vector<double>> costs;
    LabelingProblem problem;

    const LabelingProblem &get()
    {
        problem.dataCosts.assign(costs.begin(), costs.end());
        return problem;
    }
};

enum class Values { Real, SmallIntegers, MostlyZero, WideRange };

double randomCost(Random &random, Values values)
{
    switch (values) {
    case Values::Real:
        return random.uniform();
    case Values::SmallIntegers: // many ties
        return random.index(4);
    case Values::MostlyZero:
        return random.index(3) ? 0.0 : random.uniform(0.0, 3.0);
    case Values::WideRange:
        return std::exp(random.uniform(-12.0, 12.0));
    }
    return 0.0;
}

TestProblem randomProblem(Random &random, int vertices, int labels, Values values)
{
    TestProblem result;
    result.problem.vertexCount = vertices;
    for (int label = 0; label < labels; ++label) {
        result.costs.emplace_back();
        for (int v = 0; v < vertices; ++v)
            result.costs.back().push_back(randomCost(random, values));
        result.problem.labelCosts.push_back(0.5 * randomCost(random, values));
    }
    for (int u = 0; u < vertices; ++u) {
        for (int v = u + 1; v < vertices; ++v) {
            if (random.index(3) == 0)
                result.problem.edges.push_back({u, v, 0.7 * randomCost(random, values)});
        }
    }
    return result;
}

std::vector<int> randomLabels(Random &random, int vertices, int labels)
{
    std::vector<int> result;
    for (int v = 0; v < vertices; ++v)
        result.push_back(random.index(labels));
    return result;
}

double lowestEnergyOfAllLabelings(const LabelingProblem &problem)
{
    std::vector<int> labels(std::size_t(problem.vertexCount), 0);
    double lowest = labelingEnergy(problem, labels);
    for (;;) {
        int v = 0;
        while (v < problem.vertexCount && ++labels[v] == problem.labelCount())
            labels[v++] = 0;
        if (v == problem.vertexCount)
            return lowest;
        lowest = std::min(lowest, labelingEnergy(problem, labels));
    }
}

double lowestEnergyOfOneExpansion(const LabelingProblem &problem, const std::vector<int> &labels, int alpha)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (int subset = 0; subset < (1 << problem.vertexCount); ++subset) {
        std::vector<int> moved = labels;
        for (int v = 0; v < problem.vertexCount; ++v) {
            if (subset >> v & 1)
                moved[v] = alpha;
        }
        lowest = std::min(lowest, labelingEnergy(problem, moved));
    }
    return lowest;
}

bool about(double a, double b)
{
    return std::abs(a - b) <= 1e-10 * std::max(std::abs(a), std::abs(b));
}

// Grid of width x width with random costs at a few vertices, as on a surface with few strokes.
TestProblem sparseGrid(int width, int labels, double labelCost)
{
    Random random(11);
    TestProblem result;
    result.problem.vertexCount = width * width;
    result.costs.assign(std::size_t(labels), std::vector<double>(std::size_t(width) * width, 0.0));
    for (int v = 0; v < width * width; ++v) {
        if (random.index(10) == 0) {
            for (std::vector<double> &column : result.costs)
                column[v] = random.uniform();
        }
        if (v % width + 1 < width)
            result.problem.edges.push_back({v, v + 1, 0.05});
        if (v + width < width * width)
            result.problem.edges.push_back({v, v + width, 0.05});
    }
    result.problem.labelCosts.assign(std::size_t(labels), labelCost);
    return result;
}

} // namespace

class AlphaExpansionTest : public QObject
{
    Q_OBJECT
private slots:
    void energyIsTheSumOfItsTerms();
    void twoLabelsReachTheGlobalOptimum_data();
    void twoLabelsReachTheGlobalOptimum();
    void oneExpansionIsTheBestOfAllSubsets_data();
    void oneExpansionIsTheBestOfAllSubsets();
    void endsWhereNoExpansionImproves_data();
    void endsWhereNoExpansionImproves();
    void longPathMatchesDynamicProgramming();
    void hardCostsAreObeyed();
    void labelCostsReduceTheNumberOfLabels();
    void componentsAreSolvedTogether();
    void emptyProblemHasAnEmptyLabeling();
    void zeroEnergyIsLeftAlone();
    void malformedProblemsAreRefused_data();
    void malformedProblemsAreRefused();
    void malformedOptionsAreRefused();
    void noCycleReturnsTheStart();
    void cancelStops();
    void sameInputSameLabels();
};

namespace {

void addValueRows()
{
    QTest::addColumn<int>("values");
    QTest::newRow("real") << int(Values::Real);
    QTest::newRow("small integers") << int(Values::SmallIntegers);
    QTest::newRow("mostly zero") << int(Values::MostlyZero);
    QTest::newRow("wide range") << int(Values::WideRange);
}

} // namespace

void AlphaExpansionTest::energyIsTheSumOfItsTerms()
{
    TestProblem test;
    test.costs = {{1, 2, 4}, {8, 16, 32}};
    test.problem.vertexCount = 3;
    test.problem.edges = {{0, 1, 64}, {1, 2, 128}};
    test.problem.labelCosts = {256, 512};
    QCOMPARE(labelingEnergy(test.get(), {0, 0, 0}), 1.0 + 2 + 4 + 256);
    QCOMPARE(labelingEnergy(test.get(), {0, 0, 1}), 1.0 + 2 + 32 + 128 + 256 + 512);
}

void AlphaExpansionTest::twoLabelsReachTheGlobalOptimum_data()
{
    addValueRows();
}

void AlphaExpansionTest::twoLabelsReachTheGlobalOptimum()
{
    QFETCH(int, values);
    Random random(100 + std::uint64_t(values));
    int bothUsed = 0;
    for (int run = 0; run < 300; ++run) {
        TestProblem test = randomProblem(random, 1 + random.index(9), 2, Values(values));
        const Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl());
        QVERIFY(result.ok());
        QCOMPARE(result->energy, labelingEnergy(test.get(), result->labels));
        // From one label everywhere, one expansion on the other reaches every labeling.
        QVERIFY(about(result->energy, lowestEnergyOfAllLabelings(test.get())));
        bothUsed += std::set<int>(result->labels.begin(), result->labels.end()).size() == 2;
    }
    QVERIFY(bothUsed > 20);
}

void AlphaExpansionTest::oneExpansionIsTheBestOfAllSubsets_data()
{
    addValueRows();
}

void AlphaExpansionTest::oneExpansionIsTheBestOfAllSubsets()
{
    QFETCH(int, values);
    Random random(200 + std::uint64_t(values));
    int improved = 0;
    for (int run = 0; run < 150; ++run) {
        const int vertices = 1 + random.index(9);
        TestProblem test = randomProblem(random, vertices, 4, Values(values));
        const std::vector<int> labels = randomLabels(random, vertices, 4);
        // One object for all moves: nothing may leak from one into the next.
        ExpansionMove move(test.get(), labels);
        for (int step = 0; step < 6; ++step) {
            const int alpha = random.index(4);
            const std::vector<int> before = move.labels();
            const double energyBefore = move.energy();
            const double best = lowestEnergyOfOneExpansion(test.get(), before, alpha);
            const ExpansionMove::Outcome outcome = move.expand(alpha, 1e-12, JobControl());
            QVERIFY(about(move.energy(), best));
            QCOMPARE(move.energy(), labelingEnergy(test.get(), move.labels()));
            if (outcome == ExpansionMove::Outcome::Improved) {
                ++improved;
                QVERIFY(move.energy() < energyBefore);
                for (int v = 0; v < vertices; ++v)
                    QVERIFY(move.labels()[v] == before[v] || move.labels()[v] == alpha);
            } else {
                QCOMPARE(move.labels(), before);
                QCOMPARE(move.energy(), energyBefore);
            }
        }
    }
    QVERIFY(improved > 100);
}

void AlphaExpansionTest::endsWhereNoExpansionImproves_data()
{
    addValueRows();
}

void AlphaExpansionTest::endsWhereNoExpansionImproves()
{
    QFETCH(int, values);
    Random random(300 + std::uint64_t(values));
    for (int run = 0; run < 60; ++run) {
        TestProblem test = randomProblem(random, 9, 5, Values(values));
        const std::vector<int> initial = randomLabels(random, 9, 5);
        const Result<Labeling> result = alphaExpansion(test.get(), {}, initial, JobControl());
        QVERIFY(result.ok());
        QVERIFY(result->energy <= labelingEnergy(test.get(), initial));
        for (int alpha = 0; alpha < 5; ++alpha) {
            const double best = lowestEnergyOfOneExpansion(test.get(), result->labels, alpha);
            QVERIFY(about(result->energy, best));
        }
    }
}

// A path of 3000 vertices, data at every 30th only: the graph must grow far to find the optimum that dynamic
// programming knows.
void AlphaExpansionTest::longPathMatchesDynamicProgramming()
{
    Random random(5);
    for (double labelCost : {0.0, 0.5, 30.0}) {
        TestProblem test;
        const int n = test.problem.vertexCount = 3000;
        test.costs.assign(2, std::vector<double>(std::size_t(n), 0.0));
        test.problem.labelCosts = {labelCost, labelCost};
        std::vector<double> weights;
        for (int v = 0; v < n; ++v) {
            if (v % 30 == 0) {
                test.costs[0][v] = random.uniform();
                test.costs[1][v] = random.uniform();
            }
            weights.push_back(random.uniform(0.05, 0.4));
            if (v + 1 < n)
                test.problem.edges.push_back({v, v + 1, weights.back()});
        }
        const LabelingProblem &problem = test.get();
        double zero = test.costs[0][0], one = test.costs[1][0];
        for (int v = 1; v < n; ++v) {
            const double toZero = std::min(zero, one + weights[v - 1]) + test.costs[0][v];
            const double toOne = std::min(one, zero + weights[v - 1]) + test.costs[1][v];
            zero = toZero;
            one = toOne;
        }
        // With both labels in use (sure on a path of this length), or with one only.
        double best = std::min(zero, one) + 2 * labelCost;
        for (int label : {0, 1})
            best = std::min(best, labelingEnergy(problem, std::vector<int>(std::size_t(n), label)));
        const Result<Labeling> result = alphaExpansion(problem, {}, {}, JobControl());
        QVERIFY(result.ok());
        QVERIFY(about(result->energy, best));
    }
}

void AlphaExpansionTest::hardCostsAreObeyed()
{
    TestProblem test = sparseGrid(40, 3, 0.1);
    for (int v = 0; v < 40; ++v) {
        for (int label : {0, 1})
            test.costs[label][v] = 1e12; // a scribble: the first row must be label 2
    }
    const Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl());
    QVERIFY(result.ok());
    for (int v = 0; v < 40; ++v)
        QCOMPARE(result->labels[v], 2);
    QVERIFY(result->energy < 1e6);
}

void AlphaExpansionTest::labelCostsReduceTheNumberOfLabels()
{
    std::size_t before = 100;
    for (double labelCost : {0.0, 1.0, 1000.0}) {
        TestProblem test = sparseGrid(30, 8, labelCost);
        const Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl());
        QVERIFY(result.ok());
        const std::size_t used = std::set<int>(result->labels.begin(), result->labels.end()).size();
        QVERIFY(used < before);
        before = used;
    }
    QCOMPARE(before, std::size_t(1));
}

void AlphaExpansionTest::componentsAreSolvedTogether()
{
    // Three pairs, each with its own favourite; the label cost joins what no edge does.
    TestProblem test;
    test.problem.vertexCount = 6;
    test.problem.edges = {{0, 1, 1.0}, {2, 3, 1.0}, {4, 5, 1.0}};
    test.costs = {{0, 0, 1, 1, 1, 1}, {1, 1, 0, 0, 1, 1}, {1, 1, 1, 1, 0, 0}};
    test.problem.labelCosts = {1.5, 1.5, 1.5};
    Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl());
    QVERIFY(result.ok());
    QCOMPARE(result->labels, (std::vector<int>{0, 0, 1, 1, 2, 2}));
    QCOMPARE(result->energy, 4.5);
    test.problem.labelCosts = {1.5, 2.5, 2.5};
    result = alphaExpansion(test.get(), {}, {}, JobControl());
    QVERIFY(result.ok());
    QCOMPARE(result->labels, std::vector<int>(6, 0));
}

void AlphaExpansionTest::emptyProblemHasAnEmptyLabeling()
{
    const Result<Labeling> result = alphaExpansion(LabelingProblem(), {}, {}, JobControl());
    QVERIFY(result.ok());
    QVERIFY(result->labels.empty());
    QCOMPARE(result->energy, 0.0);
}

void AlphaExpansionTest::zeroEnergyIsLeftAlone()
{
    TestProblem test = sparseGrid(10, 2, 0.0);
    std::fill(test.costs[1].begin(), test.costs[1].end(), 0.0);
    const Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl());
    QVERIFY(result.ok());
    QCOMPARE(result->energy, 0.0);
    QCOMPARE(result->labels, std::vector<int>(100, 1));
}

void AlphaExpansionTest::malformedProblemsAreRefused_data()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<std::function<void(TestProblem &, std::vector<int> &)>>("spoil");
    const auto row = [](const char *name, std::function<void(TestProblem &, std::vector<int> &)> spoil) {
        QTest::newRow(name) << spoil;
    };
    row("no label", [](TestProblem &t, auto &) { t.costs.clear(), t.problem.labelCosts.clear(); });
    row("short column", [](TestProblem &t, auto &) { t.costs[1].pop_back(); });
    row("missing label cost", [](TestProblem &t, auto &) { t.problem.labelCosts.pop_back(); });
    row("negative vertex count", [](TestProblem &t, auto &) { t.problem.vertexCount = -1; });
    row("negative data cost", [](TestProblem &t, auto &) { t.costs[0][2] = -1e-9; });
    row("data cost not a number", [=](TestProblem &t, auto &) { t.costs[0][2] = nan; });
    row("infinite data cost", [=](TestProblem &t, auto &) { t.costs[0][2] = infinity; });
    row("negative label cost", [](TestProblem &t, auto &) { t.problem.labelCosts[0] = -1; });
    row("label cost not a number", [=](TestProblem &t, auto &) { t.problem.labelCosts[1] = nan; });
    row("negative weight", [](TestProblem &t, auto &) { t.problem.edges[0].weight = -1; });
    row("infinite weight", [=](TestProblem &t, auto &) { t.problem.edges[0].weight = infinity; });
    row("edge below", [](TestProblem &t, auto &) { t.problem.edges[0].u = -1; });
    row("edge beyond", [](TestProblem &t, auto &) { t.problem.edges[0].v = 9; });
    row("loop", [](TestProblem &t, auto &) { t.problem.edges.push_back({4, 4, 1.0}); });
    row("double edge", [](TestProblem &t, auto &) {
        t.problem.edges.push_back({t.problem.edges[3].v, t.problem.edges[3].u, 1.0});
    });
    row("sum overflows",
        [](TestProblem &t, auto &) { t.costs[0].assign(9, 1e308), t.costs[1] = t.costs[0]; });
    row("weights overflow",
        [](TestProblem &t, auto &) { t.problem.edges[0].weight = t.problem.edges[1].weight = 1e308; });
    row("short initial", [](TestProblem &, std::vector<int> &initial) { initial.assign(8, 0); });
    row("initial beyond", [](TestProblem &, std::vector<int> &initial) { initial.assign(9, 2); });
    row("initial below", [](TestProblem &, std::vector<int> &initial) { initial.assign(9, -1); });
}

void AlphaExpansionTest::malformedProblemsAreRefused()
{
    using Spoil = std::function<void(TestProblem &, std::vector<int> &)>;
    QFETCH(Spoil, spoil);
    TestProblem test = sparseGrid(3, 2, 0.1);
    std::vector<int> initial(9, 0);
    QVERIFY(alphaExpansion(test.get(), {}, initial, JobControl()).ok());
    spoil(test, initial);
    const Result<Labeling> result = alphaExpansion(test.get(), {}, initial, JobControl());
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!result.error().problem.empty());
}

void AlphaExpansionTest::malformedOptionsAreRefused()
{
    TestProblem test = sparseGrid(3, 2, 0.1);
    AlphaExpansionOptions options;
    options.maxCycles = -1;
    QVERIFY(!alphaExpansion(test.get(), options, {}, JobControl()));
    options = {};
    options.relativeTolerance = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!alphaExpansion(test.get(), options, {}, JobControl()));
}

void AlphaExpansionTest::noCycleReturnsTheStart()
{
    TestProblem test = sparseGrid(5, 3, 0.1);
    AlphaExpansionOptions options;
    options.maxCycles = 0;
    const std::vector<int> initial(25, 2);
    const Result<Labeling> result = alphaExpansion(test.get(), options, initial, JobControl());
    QVERIFY(result.ok());
    QCOMPARE(result->labels, initial);
    QCOMPARE(result->energy, labelingEnergy(test.get(), initial));
}

void AlphaExpansionTest::cancelStops()
{
    TestProblem test = sparseGrid(30, 8, 0.1);
    std::atomic<bool> cancelled = true;
    Result<Labeling> result = alphaExpansion(test.get(), {}, {}, JobControl(&cancelled, {}));
    QVERIFY(!result);
    QVERIFY(result.error().isCancelled());

    // In the middle, from the progress report.
    cancelled = false;
    int reports = 0;
    double last = 0.0;
    const auto onProgress = [&](double fraction, std::string_view) {
        last = fraction;
        if (++reports == 4)
            cancelled = true;
    };
    result = alphaExpansion(test.get(), {}, {}, JobControl(&cancelled, onProgress));
    QVERIFY(!result);
    QVERIFY(result.error().isCancelled());
    QCOMPARE(reports, 4);
    QVERIFY(last > 0.0 && last < 0.5);
}

void AlphaExpansionTest::sameInputSameLabels()
{
    TestProblem test = sparseGrid(40, 10, 0.2);
    const Result<Labeling> first = alphaExpansion(test.get(), {}, {}, JobControl());
    QVERIFY(first.ok());
    for (int run = 0; run < 3; ++run) {
        TestProblem again = sparseGrid(40, 10, 0.2);
        const Result<Labeling> result = alphaExpansion(again.get(), {}, {}, JobControl());
        QVERIFY(result.ok());
        QCOMPARE(result->labels, first->labels);
        QCOMPARE(result->energy, first->energy);
    }
    // Its own result is stable.
    const Result<Labeling> once = alphaExpansion(test.get(), {}, first->labels, JobControl());
    QVERIFY(once.ok());
    QCOMPARE(once->labels, first->labels);
    QCOMPARE(once->cycles, 1);
}

QTEST_APPLESS_MAIN(AlphaExpansionTest)
#include "alpha_expansion_test.moc"
