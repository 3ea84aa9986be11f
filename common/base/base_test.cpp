#include "base/job_control.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/result.h"
#include "base/sha256.h"
#include "base/typed_id.h"

#include <QtTest>
#include <algorithm>
#include <set>
#include <type_traits>

using namespace ductus;

class BaseTest : public QObject
{
    Q_OBJECT
private slots:
    void resultHoldsValueOrError();
    void messageNamesPlaceAttemptProblemRemedy();
    void jobPartsMapProgressIntoTheirShare();
    void cancelReachesParts();
    void randomIsTheSameEverywhere();
    void shuffleIsAPermutation();
    void parallelSumIsBitIdenticalToItsFixedOrder();
    void parallelForVisitsEachIndexOnce();
    void sha256KnowsTheStandardVectors();
    void idsOfDifferentKindsDoNotMix();
};

void BaseTest::resultHoldsValueOrError()
{
    const Result<int> good = 7;
    QVERIFY(good.ok());
    QCOMPARE(*good, 7);
    const Result<int> bad = Error{ErrorCode::Malformed, "Reading", "no", "", ""};
    QVERIFY(!bad);
    QCOMPARE(bad.error().code, ErrorCode::Malformed);
    QVERIFY(Result<void>().ok());
}

void BaseTest::messageNamesPlaceAttemptProblemRemedy()
{
    const Error error{ErrorCode::Malformed, "Reading the sketch", "the count is negative", "Export it again", "a:3"};
    QCOMPARE(error.message(), std::string("a:3: Reading the sketch failed: the count is negative. Export it again."));
    QCOMPARE(cancelledError("Surfacing").message(), std::string("Surfacing was cancelled."));
}

void BaseTest::jobPartsMapProgressIntoTheirShare()
{
    std::vector<double> seen;
    const JobControl control(nullptr, [&](double f, std::string_view) { seen.push_back(f); });
    const JobControl half = control.part(0.5, 1.0);
    half.progress(0.5, "x");
    half.part(0.0, 0.5).progress(1.0, "x");
    half.progress(7.0, "beyond the end");
    QCOMPARE(seen, (std::vector<double>{0.75, 0.75, 1.0}));
}

void BaseTest::cancelReachesParts()
{
    std::atomic<bool> flag = false;
    const JobControl part = JobControl(&flag, {}).part(0.1, 0.2);
    QVERIFY(!part.isCancelled());
    flag = true;
    QVERIFY(part.isCancelled());
}

void BaseTest::randomIsTheSameEverywhere()
{
    // First outputs of SplitMix64 with seed 1234567, as published with the algorithm.
    Random random(1234567);
    QCOMPARE(random.next(), 6457827717110365317ull);
    QCOMPARE(random.next(), 3203168211198807973ull);
    double mean = 0.0, square = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double x = random.normal();
        mean += x / 20000;
        square += x * x / 20000;
    }
    QVERIFY(std::abs(mean) < 0.03);
    QVERIFY(std::abs(square - 1.0) < 0.05);
}

void BaseTest::shuffleIsAPermutation()
{
    std::vector<int> items{1, 2, 3, 4, 5, 6, 7, 8};
    Random(3).shuffle(items);
    QVERIFY(!std::is_sorted(items.begin(), items.end()));
    QCOMPARE(std::set<int>(items.begin(), items.end()).size(), std::size_t(8));
}

void BaseTest::parallelSumIsBitIdenticalToItsFixedOrder()
{
    const auto term = [](std::size_t i) { return 1.0 / double(i + 1); };
    double expected = 0.0;
    for (std::size_t chunk = 0; chunk < 100000; chunk += 1024) {
        double partial = 0.0;
        for (std::size_t i = chunk; i < std::min<std::size_t>(100000, chunk + 1024); ++i)
            partial += term(i);
        expected += partial;
    }
    for (int run = 0; run < 5; ++run)
        QVERIFY(parallelSum(100000, term) == expected);
}

void BaseTest::parallelForVisitsEachIndexOnce()
{
    std::vector<int> visits(5000, 0);
    parallelFor(0, visits.size(), [&](std::size_t i) { ++visits[i]; }, 16);
    QVERIFY(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
}

void BaseTest::sha256KnowsTheStandardVectors()
{
    QCOMPARE(sha256Hex({}), std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    const std::string abc = "abc";
    QCOMPARE(sha256Hex(std::as_bytes(std::span(abc))),
             std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

void BaseTest::idsOfDifferentKindsDoNotMix()
{
    using A = TypedId<struct ATag>;
    using B = TypedId<struct BTag>;
    static_assert(!std::is_convertible_v<A, B> && !std::is_convertible_v<int, A>);
    QVERIFY(!A().isValid());
    QVERIFY(A{1} < A{2});
}

QTEST_APPLESS_MAIN(BaseTest)
#include "base_test.moc"
