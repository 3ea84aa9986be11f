#include "project/uuid.h"

#include <QtTest>
#include <set>

using namespace ductus;

class UuidTest : public QObject
{
    Q_OBJECT
private slots:
    void textComesBack();
    void otherTextsAreRefused();
    void newOnesDiffer();
};

void UuidTest::textComesBack()
{
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Uuid uuid = Uuid::from(random);
        QCOMPARE(uuid.text().size(), std::size_t(36));
        QCOMPARE(uuid.text()[14], '4'); // version
        QVERIFY(std::string("89ab").find(uuid.text()[19]) != std::string::npos);
        QVERIFY(Uuid::parse(uuid.text()) == uuid);
    }
    QCOMPARE(Uuid().text(), std::string("00000000-0000-0000-0000-000000000000"));
    QVERIFY(Uuid().isNull());
}

void UuidTest::otherTextsAreRefused()
{
    const std::string good = "01234567-89ab-4cde-8f01-23456789abcd";
    QVERIFY(Uuid::parse(good).has_value());
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = bad[i] == '-' ? '0' : 'G';
        QVERIFY(!Uuid::parse(bad));
    }
    QVERIFY(!Uuid::parse("01234567-89AB-4cde-8f01-23456789abcd"));
    QVERIFY(!Uuid::parse(good + "0"));
    QVERIFY(!Uuid::parse(""));
}

void UuidTest::newOnesDiffer()
{
    std::set<Uuid> seen;
    for (int i = 0; i < 1000; ++i)
        seen.insert(Uuid::create());
    QCOMPARE(seen.size(), std::size_t(1000));
    QCOMPARE(seen.begin()->text()[14], '4');
}

QTEST_APPLESS_MAIN(UuidTest)
#include "uuid_test.moc"
