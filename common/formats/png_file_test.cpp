#include "formats/png_file.h"

#include "base/random.h"

#include <QtTest>
#include <algorithm>
#include <fstream>

using namespace ductus;

namespace {

Image noise(int width, int height)
{
    Image image(width, height);
    Random random(9);
    for (std::uint8_t &value : image.pixels)
        value = std::uint8_t(random.index(256));
    return image;
}

/// A PNG made byte by byte: stored (uncompressed) deflate, so the test needs no other encoder.
class PngMaker
{
public:
    PngMaker(std::uint32_t width, std::uint32_t height, int depth, int colourType)
    {
        mBytes = "\x89PNG\r\n\x1a\n";
        std::string header = number(width) + number(height);
        header += char(depth);
        header += char(colourType);
        header += std::string(3, '\0');
        add("IHDR", header);
    }
    void add(const std::string &type, const std::string &content)
    {
        mBytes += number(std::uint32_t(content.size())) + type + content + number(crc(type + content));
    }
    std::string finish(const std::string &rows)
    {
        std::string data = "\x78\x01\x01";
        const std::uint16_t size = std::uint16_t(rows.size());
        for (const std::uint16_t n : {size, std::uint16_t(~size)})
            data += {char(n & 255), char(n >> 8)};
        std::uint32_t a = 1, b = 0;
        for (const unsigned char c : rows) {
            a = (a + c) % 65521;
            b = (b + a) % 65521;
        }
        add("IDAT", data + rows + number(b << 16 | a));
        add("IEND", "");
        return mBytes;
    }

private:
    static std::string number(std::uint32_t n)
    {
        return {char(n >> 24), char(n >> 16 & 255), char(n >> 8 & 255), char(n & 255)};
    }
    static std::uint32_t crc(const std::string &text)
    {
        std::uint32_t value = 0xffffffff;
        for (const unsigned char c : text) {
            value ^= c;
            for (int k = 0; k < 8; ++k)
                value = value >> 1 ^ (value & 1 ? 0xedb88320 : 0);
        }
        return ~value;
    }
    std::string mBytes;
};

Result<Image> decode(const std::string &bytes)
{
    return decodePng(std::as_bytes(std::span(bytes)));
}

} // namespace

class PngFileTest : public QObject
{
    Q_OBJECT
private slots:
    void comesBackBitForBit();
    void sameImageSameBytes();
    void otherColourTypesBecomeRgba();
    void damageIsRefused();
    void hugeHeadersAreRefusedBeforeAllocation();
    void wrongImagesAreNotWritten();
    void filesAreToldApart();
};

void PngFileTest::comesBackBitForBit()
{
    for (const auto &[width, height] : {std::pair(1, 1), std::pair(37, 11), std::pair(300, 200)}) {
        const Image image = noise(width, height);
        const auto bytes = encodePng(image);
        QVERIFY(bytes.ok());
        const auto back = decodePng(*bytes);
        QVERIFY2(back, back ? "" : back.error().message().c_str());
        QCOMPARE(back->width, width);
        QCOMPARE(back->height, height);
        QVERIFY(back->pixels == image.pixels);
    }
}

void PngFileTest::sameImageSameBytes()
{
    QVERIFY(*encodePng(noise(64, 64)) == *encodePng(noise(64, 64)));
    // Nothing in the file may depend on the day or the program's run: no time or text chunks.
    const auto bytes = encodePng(noise(64, 64));
    const std::string text(reinterpret_cast<const char *>(bytes->data()), bytes->size());
    QVERIFY(text.find("tIME") == std::string::npos && text.find("tEXt") == std::string::npos);
}

void PngFileTest::otherColourTypesBecomeRgba()
{
    const auto gray16 = decode(PngMaker(2, 1, 16, 0).finish(std::string("\0\x80\x00\xff\xff", 5)));
    QVERIFY2(gray16, gray16 ? "" : gray16.error().message().c_str());
    QCOMPARE(gray16->at(0, 0), (Rgba{128, 128, 128, 255}));
    QCOMPARE(gray16->at(1, 0), (Rgba{255, 255, 255, 255}));
    const auto oneBit = decode(PngMaker(3, 1, 1, 0).finish(std::string("\0\xa0", 2)));
    QVERIFY(oneBit.ok());
    QCOMPARE(oneBit->at(0, 0), (Rgba{255, 255, 255, 255}));
    QCOMPARE(oneBit->at(1, 0), (Rgba{0, 0, 0, 255}));
    PngMaker palette(2, 1, 8, 3);
    palette.add("PLTE", std::string("\x0a\x14\x1e\x28\x32\x3c", 6));
    palette.add("tRNS", std::string("\x80", 1));
    const auto coloured = decode(palette.finish(std::string("\0\x01\x00", 3)));
    QVERIFY2(coloured, coloured ? "" : coloured.error().message().c_str());
    QCOMPARE(coloured->at(0, 0), (Rgba{40, 50, 60, 255}));
    QCOMPARE(coloured->at(1, 0), (Rgba{10, 20, 30, 128}));
    const auto rgb = decode(PngMaker(1, 2, 8, 2).finish(std::string("\0\x01\x02\x03\0\x04\x05\x06", 8)));
    QVERIFY(rgb.ok());
    QCOMPARE(rgb->at(0, 1), (Rgba{4, 5, 6, 255}));
}

void PngFileTest::damageIsRefused()
{
    const auto bytes = encodePng(noise(20, 20));
    QVERIFY(bytes.ok());
    for (std::size_t length = 0; length < bytes->size(); ++length) {
        const auto image = decodePng(std::span(*bytes).first(length));
        QVERIFY2(!image.ok(), std::to_string(length).c_str());
        QVERIFY(!image.error().problem.empty() && !image.error().remedy.empty());
    }
    std::vector<std::byte> damaged = *bytes;
    damaged[damaged.size() / 2] ^= std::byte(1);
    QVERIFY(!decodePng(damaged).ok());
    QVERIFY(!decode("not a picture at all").ok());
}

void PngFileTest::hugeHeadersAreRefusedBeforeAllocation()
{
    const auto huge = decode(PngMaker(32000, 32000, 8, 6).finish("\0"));
    QVERIFY(!huge.ok());
    QCOMPARE(huge.error().code, ErrorCode::TooLarge);
    const auto wide = decode(PngMaker(2'000'000'000, 1, 8, 6).finish("\0"));
    QVERIFY(!wide.ok());
    const auto short_ = decode(PngMaker(10000, 10000, 8, 6).finish("\0"));
    QVERIFY(!short_.ok());
    QVERIFY2(short_.error().problem.find("too short") != std::string::npos, short_.error().problem.c_str());
}

void PngFileTest::wrongImagesAreNotWritten()
{
    QCOMPARE(encodePng(Image()).error().code, ErrorCode::InvalidArgument);
    Image wrong = noise(4, 4);
    wrong.pixels.pop_back();
    QCOMPARE(encodePng(wrong).error().code, ErrorCode::InvalidArgument);
}

void PngFileTest::filesAreToldApart()
{
    QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    QVERIFY(writePng(noise(8, 8), path / "a.png").ok());
    const auto image = readPng(path / "a.png");
    QVERIFY(image.ok());
    QVERIFY(image->pixels == noise(8, 8).pixels);
    QCOMPARE(readPng(path / "none.png").error().code, ErrorCode::FileNotFound);
    QCOMPARE(readPng(path).error().code, ErrorCode::NotAFile);
    std::ofstream(path / "text.png") << "hello";
    QCOMPARE(readPng(path / "text.png").error().place, std::string("text.png"));
    QVERIFY(!writePng(noise(2, 2), path / "none" / "a.png").ok());
}

QTEST_APPLESS_MAIN(PngFileTest)
#include "png_file_test.moc"
