// Everyday fuzzing: a fixed number of seeded mutations of small files of every format. A crash, an assertion
// or an uncaught exception fails the test; so does a mutation step that stopped reaching the readers' success
// paths.
#include "base/random.h"
#include "check_readers.h"
#include "seeds.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int mutationsPerSeed = 50000;

std::string mutated(std::string bytes, const std::vector<Seed> &seeds, Random &random)
{
    const auto place = [&] {
        return bytes.empty() ? std::size_t(0) : std::size_t(random.index(int(bytes.size())));
    };
    static constexpr std::string_view tokens[] = {
        "nan", "-1",  "1e999", "999999999999",     "0",  ",", "\r",  "\n\n",
        "v 3", "l 1", "f 1 2", "\xff\xff\xff\xff", "{}", "[", "\\\n"};
    for (int step = random.index(4); step >= 0; --step) {
        switch (random.index(7)) {
        case 0: // flip a bit
            if (!bytes.empty())
                bytes[place()] ^= char(1 << random.index(8));
            break;
        case 1: // any byte
            if (!bytes.empty())
                bytes[place()] = char(random.index(256));
            break;
        case 2:
            bytes.resize(place());
            break; // cut off
        case 3: {  // leave a piece out
            const std::size_t begin = place();
            bytes.erase(begin, std::size_t(random.index(16)));
            break;
        }
        case 4: { // repeat a piece
            const std::size_t begin = place();
            const std::string piece = bytes.substr(begin, std::size_t(random.index(64)));
            bytes.insert(place(), piece);
            break;
        }
        case 5: { // a piece of another file
            const std::string &other = seeds[std::size_t(random.index(int(seeds.size())))].bytes;
            const std::size_t begin = std::size_t(random.index(int(other.size())));
            bytes.insert(place(), other.substr(begin, std::size_t(random.index(40))));
            break;
        }
        default:
            bytes.insert(place(), tokens[std::size_t(random.index(int(std::size(tokens))))]);
            break;
        }
    }
    return bytes;
}

} // namespace

class ReadersSurviveMutations : public QObject
{
    Q_OBJECT
private slots:
    void seedsAreValid();
    void survive_data();
    void survive();
};

void ReadersSurviveMutations::seedsAreValid()
{
    for (const Seed &seed : fuzzSeeds()) {
        if (seed.kind == Seed::Sketch)
            QVERIFY2(parseSketch(seed.bytes, seed.name, {}, {}).ok(), seed.name.c_str());
        else if (seed.kind == Seed::Mesh)
            QVERIFY2(parseMesh(seed.bytes, seed.name, {}).ok(), seed.name.c_str());
        else if (seed.kind == Seed::Quill)
            QVERIFY2(checkQuillReader(seed.bytes), seed.name.c_str());
        else if (seed.kind == Seed::Tilt)
            QVERIFY2(checkTiltReader(seed.bytes), seed.name.c_str());
        else
            QVERIFY2(decodePng(std::as_bytes(std::span(seed.bytes))).ok(), seed.name.c_str());
    }
}

void ReadersSurviveMutations::survive_data()
{
    QTest::addColumn<int>("index");
    const std::vector<Seed> seeds = fuzzSeeds();
    for (int s = 0; s < int(seeds.size()); ++s)
        QTest::newRow(seeds[std::size_t(s)].name.c_str()) << s;
}

void ReadersSurviveMutations::survive()
{
    QFETCH(int, index);
    const std::vector<Seed> seeds = fuzzSeeds();
    const Seed &seed = seeds[std::size_t(index)];
    Random random(std::uint64_t(index) + 1);
    int accepted = 0;
    for (int run = 0; run < mutationsPerSeed; ++run) {
        const std::string bytes = mutated(seed.bytes, seeds, random);
        if (seed.kind == Seed::Sketch)
            accepted += checkSketchReader(bytes, seed.name);
        else if (seed.kind == Seed::Mesh && bytes.starts_with("glTF") && run % 2 == 0)
            accepted += checkColouredMeshReader(bytes, seed.name);
        else if (seed.kind == Seed::Mesh)
            accepted += checkMeshReader(bytes, seed.name);
        else if (seed.kind == Seed::Quill)
            accepted += checkQuillReader(bytes);
        else if (seed.kind == Seed::Tilt)
            accepted += checkTiltReader(bytes);
        else
            accepted += checkPngReader(run % 2 == 0 ? bytes : withRightChecksums(bytes));
    }
    // The checks above abort the program; here, that the mutations are neither all harmless nor all fatal.
    QVERIFY2(accepted > mutationsPerSeed / 1000, std::to_string(accepted).c_str());
    QVERIFY2(accepted < mutationsPerSeed * 9 / 10, std::to_string(accepted).c_str());
}

QTEST_APPLESS_MAIN(ReadersSurviveMutations)
#include "readers_survive_mutations.moc"
