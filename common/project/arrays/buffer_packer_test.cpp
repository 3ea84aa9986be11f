#include "project/arrays/buffer_packer.h"

#include "base/random.h"
#include "base/sha256.h"
#include "project/arrays/array_loader.h"

#include <QtTest>

using namespace ductus;

namespace {

// What a document would hold: {"a0": reference, "a1": ...}.
JsonDocument referencesOf(const BufferPacker &packer, std::size_t count)
{
    OrderedJson json = OrderedJson::object();
    for (std::size_t i = 0; i < count; ++i)
        json["a" + std::to_string(i)] = packer.reference(i).toJson();
    return *parsedJson(jsonText(json), "p");
}

BufferStore storeOf(const BufferPacker &packer)
{
    BufferStore store;
    for (const auto &[hash, bytes] : packer.buffers())
        store.add(bytes);
    return store;
}

} // namespace

class BufferPackerTest : public QObject
{
    Q_OBJECT
private slots:
    void arraysOfAllSizesComeBack();
    void smallArraysShareABuffer();
    void allTypesKeepTheirBits();
    void bytesAreLittleEndian();
    void equalMeshesMakeEqualBuffers();
    void storeRefusesOtherNames();
};

void BufferPackerTest::arraysOfAllSizesComeBack()
{
    Random random(9);
    BufferPacker packer;
    std::vector<std::vector<double>> arrays;
    for (int i = 0; i < 300; ++i) {
        std::vector<double> values(std::size_t(i % 50 == 7 ? 200'000 : random.index(400)));
        for (double &value : values)
            value = random.normal();
        packer.add<double>(values, {values.size()}, "m");
        arrays.push_back(std::move(values));
    }
    packer.finish();
    const BufferStore store = storeOf(packer);
    const JsonDocument json = referencesOf(packer, arrays.size());
    const JsonReader reader(json, "p");
    ArrayLoader loader(store, "f");
    for (std::size_t i = 0; i < arrays.size(); ++i)
        QVERIFY(loader.load<double>(reader, "a" + std::to_string(i), 1) == arrays[i]);
    QVERIFY(!reader.failed());
    QCOMPARE(loader.usedBuffers().size(), packer.buffers().size());
}

void BufferPackerTest::smallArraysShareABuffer()
{
    BufferPacker packer;
    const std::vector<double> values(10, 1.5);
    for (int i = 0; i < 1000; ++i)
        packer.add<double>(values, {10});
    packer.finish();
    QCOMPARE(packer.buffers().size(), std::size_t(1));
    QCOMPARE(packer.reference(3).offset, std::uint64_t(240));
}

void BufferPackerTest::allTypesKeepTheirBits()
{
    BufferPacker packer;
    const std::vector<std::uint8_t> bytes = {1, 255, 0};
    const std::vector<std::uint16_t> shorts = {65535, 7};
    const std::vector<std::int32_t> ints = {-1, INT32_MIN};
    const std::vector<std::uint32_t> words = {UINT32_MAX};
    const std::vector<float> floats = {-0.0f, 1e-45f, 3.4e38f};
    packer.add<std::uint8_t>(bytes, {3});
    packer.add<std::uint16_t>(shorts, {2});
    packer.add<std::int32_t>(ints, {1, 2});
    packer.add<std::uint32_t>(words, {1});
    packer.add<float>(floats, {3});
    packer.finish();
    const BufferStore store = storeOf(packer);
    const JsonDocument json = referencesOf(packer, 5);
    const JsonReader reader(json, "p");
    ArrayLoader loader(store, "f");
    QVERIFY(loader.load<std::uint8_t>(reader, "a0", 1) == bytes);
    QVERIFY(loader.load<std::uint16_t>(reader, "a1", 1) == shorts);
    QVERIFY(loader.load<std::int32_t>(reader, "a2", 2) == ints);
    QVERIFY(loader.load<std::uint32_t>(reader, "a3", 1) == words);
    const std::vector<float> back = loader.load<float>(reader, "a4", 1);
    QVERIFY(back == floats && std::signbit(back[0]));
    QVERIFY(!reader.failed());
    loader.load<double>(reader, "a4", 1);
    QCOMPARE(reader.error().place, std::string("p#/a4/type"));
}

void BufferPackerTest::bytesAreLittleEndian()
{
    BufferPacker packer;
    const std::vector<std::int32_t> values = {0x01020304};
    packer.add<std::int32_t>(values, {1});
    packer.finish();
    const Bytes expected = {std::byte(4), std::byte(3), std::byte(2), std::byte(1)};
    QVERIFY(packer.buffers().begin()->second == expected);
    QCOMPARE(packer.buffers().begin()->first, sha256Hex(expected));
}

void BufferPackerTest::equalMeshesMakeEqualBuffers()
{
    const std::vector<double> mesh = {1, 2, 3, 4, 5, 6};
    const std::vector<double> other = {7};
    BufferPacker packer;
    packer.add<double>(mesh, {2, 3});
    packer.startBuffer();
    packer.add<double>(other, {1});
    packer.startBuffer();
    packer.add<double>(mesh, {2, 3});
    packer.finish();
    QCOMPARE(packer.buffers().size(), std::size_t(2));
    QCOMPARE(packer.reference(0).buffer, packer.reference(2).buffer);
}

void BufferPackerTest::storeRefusesOtherNames()
{
    BufferStore store;
    QVERIFY(!store.addEntry(storedEntry("buffers/readme.txt", {})));
    QVERIFY(!store.find("readme"));
    const std::string hash = store.add(asBytes("content"));
    QCOMPARE(hash, sha256Hex(asBytes("content")));
    QCOMPARE(store.add(asBytes("content")), hash);
    QCOMPARE(store.entries().size(), std::size_t(1));
}

QTEST_APPLESS_MAIN(BufferPackerTest)
#include "buffer_packer_test.moc"
