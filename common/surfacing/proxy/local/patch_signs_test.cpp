#include "surfacing/proxy/local/patch_signs.h"

#include "base/random.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

double sumOf(const std::vector<PatchAgreement> &agreements, const std::vector<double> &rough,
             const std::vector<int> &signs)
{
    double sum = 0.0;
    for (const PatchAgreement &edge : agreements)
        sum += signs[std::size_t(edge.a)] * signs[std::size_t(edge.b)] * edge.agreement;
    for (std::size_t a = 0; a < rough.size(); ++a)
        sum += signs[a] * rough[a];
    return sum;
}

// A ring of patches that agree with their neighbours as \a truth says.
std::vector<PatchAgreement> ringOf(const std::vector<int> &truth)
{
    std::vector<PatchAgreement> ring;
    const int n = int(truth.size());
    for (int a = 0; a < n; ++a)
        for (int step : {1, 2}) {
            const int b = (a + step) % n;
            ring.push_back(
                {std::min(a, b), std::max(a, b), 10.0 * truth[std::size_t(a)] * truth[std::size_t(b)], 0.9});
        }
    return ring;
}

} // namespace

class PatchSignsTest : public QObject
{
    Q_OBJECT
private slots:
    void agreementDecides();
    void roughIdeaDecidesWhatAgreementLeaves();
    void unreliableAgreementIsOutvoted();
    void bestOfAllOnSmallGraphs();
};

void PatchSignsTest::agreementDecides()
{
    Random random(3);
    std::vector<int> truth;
    std::vector<double> rough;
    for (int a = 0; a < 40; ++a) {
        truth.push_back(random.index(2) ? 1 : -1);
        rough.push_back((a % 3 == 0 ? -1.0 : 1.0) * truth.back()); // wrong for every third
    }
    QCOMPARE(consistentSigns(ringOf(truth), rough), truth);
}

void PatchSignsTest::roughIdeaDecidesWhatAgreementLeaves()
{
    // Two separate pairs.
    const std::vector<PatchAgreement> pairs{{0, 1, 5.0, 0.9}, {2, 3, -5.0, 0.9}};
    QCOMPARE(consistentSigns(pairs, {1.0, -0.2, -0.1, 1.0}), (std::vector<int>{1, 1, -1, 1}));
    QCOMPARE(consistentSigns(pairs, {-1.0, 0.2, 0.1, -1.0}), (std::vector<int>{-1, -1, 1, -1}));
    QCOMPARE(consistentSigns({}, {-1.0, 2.0}), (std::vector<int>{-1, 1}));
    QVERIFY(consistentSigns({}, {}).empty());
}

// Two well agreeing halves joined by bridges of which the most reliable one is wrong: the rough idea brings
// the proposal that turns one half back.
void PatchSignsTest::unreliableAgreementIsOutvoted()
{
    std::vector<PatchAgreement> edges;
    for (int half : {0, 10})
        for (int a = 0; a < 9; ++a)
            edges.push_back({half + a, half + a + 1, 10.0, 0.95});
    edges.push_back({9, 10, -4.0, 0.9});
    for (int a = 0; a < 3; ++a)
        edges.push_back({a, 10 + a, 3.0, 0.5});
    const std::vector<int> all(20, 1);
    QCOMPARE(consistentSigns(edges, std::vector<double>(20, 0.1)), all);
}

void PatchSignsTest::bestOfAllOnSmallGraphs()
{
    int optimal = 0;
    constexpr int graphs = 60, n = 9;
    for (int g = 0; g < graphs; ++g) {
        Random random(std::uint64_t(100 + g));
        std::vector<int> truth;
        std::vector<double> rough;
        for (int a = 0; a < n; ++a) {
            truth.push_back(random.index(2) ? 1 : -1);
            rough.push_back(truth.back() * random.uniform(-0.5, 1.0));
        }
        std::vector<PatchAgreement> edges = ringOf(truth);
        for (PatchAgreement &edge : edges) { // some of them disturbed
            edge.agreement *= random.uniform(-0.3, 1.0);
            edge.reliability = std::abs(edge.agreement) / 12.0;
        }
        double best = -1e300;
        for (int mask = 0; mask < (1 << n); ++mask) {
            std::vector<int> signs;
            for (int a = 0; a < n; ++a)
                signs.push_back(mask >> a & 1 ? 1 : -1);
            best = std::max(best, sumOf(edges, rough, signs));
        }
        const double found = sumOf(edges, rough, consistentSigns(edges, rough));
        QVERIFY(found <= best + 1e-9);
        optimal += found > best - 1e-9;
    }
    qInfo("%d of %d are optimal", optimal, graphs);
    QVERIFY(optimal >= graphs * 9 / 10);
}

QTEST_APPLESS_MAIN(PatchSignsTest)
#include "patch_signs_test.moc"
