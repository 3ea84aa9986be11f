#include "widgets/testing/widget_test_main.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/style_sheet.h"

#include <QIcon>
#include <QRegularExpression>
#include <QTemporaryDir>

using namespace ductus;

namespace {

const QList<AppKind> apps{AppKind::SketchSurfacer, AppKind::LayerPainter, AppKind::DoodleStudio};

// Share of the pixels of \a image that are neither empty nor full.
double softShare(const QImage &image)
{
    int soft = 0;
    int inked = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int alpha = qAlpha(image.pixel(x, y));
            inked += alpha > 0;
            soft += alpha > 0 && alpha < 255;
        }
    }
    return inked == 0 ? 1.0 : double(soft) / inked;
}

} // namespace

class ThemeTest : public QObject
{
    Q_OBJECT
private slots:
    void contrastIsThatOfTheStandard();
    void allWordsCanBeRead_data();
    void allWordsCanBeRead();
    void marksStandOut();
    void theDesignsColoursAreKept();
    void coloursAreFoundAgainInThePalette();
    void theStyleSheetNamesNoUnknownColour();
    void choicesAreRemembered();
    void everyIconDraws_data();
    void everyIconDraws();
    void iconsFollowTheTheme();
    void breezeIsSharp();
    void theListOfIconsIsThere();
};

void ThemeTest::contrastIsThatOfTheStandard()
{
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-9);
    QVERIFY(std::abs(contrast(QColor("#767676"), Qt::white) - 4.54) < 0.01); // the known limit on white
    QCOMPARE(contrast(Qt::red, Qt::red), 1.0);
}

void ThemeTest::allWordsCanBeRead_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("app");
    for (AppKind app : apps) {
        for (bool dark : {true, false})
            QTest::addRow("%s app %d", dark ? "dark" : "light", int(app)) << dark << int(app);
    }
}

void ThemeTest::allWordsCanBeRead()
{
    QFETCH(bool, dark);
    QFETCH(int, app);
    const ThemeColours c = themeColours(dark, AppKind(app));
    const QPalette palette = qtPalette(c);
    const QColor selected = palette.color(QPalette::Highlight);
    const QList<QColor> grounds{c.window, c.panel, c.raised, c.hover, palette.color(QPalette::Base)};
    const auto check = [&](const char *what, const QColor &words, const QColor &ground) {
        QVERIFY2(contrast(words, ground) >= 4.5, qPrintable(QString("%1 %2 on %3: %4")
                                                                .arg(what, words.name(), ground.name())
                                                                .arg(contrast(words, ground))));
    };
    for (const QColor &ground : grounds) {
        check("text", c.text, ground);
        check("dim", c.dim, ground);
        check("accent", c.accentText, ground);
        check("success", c.successText, ground);
        check("warning", c.warningText, ground);
        check("error", c.errorText, ground);
    }
    check("text, pressed", c.text, c.pressed);
    check("text, selected", c.text, selected);
    for (const QColor &ground : {c.infoGround, c.successGround, c.warningGround, c.errorGround})
        check("message", c.text, ground);
    check("dim in a message", c.dim, c.infoGround);
    check("button", c.onAccent, c.button);
    check("placeholder", palette.color(QPalette::PlaceholderText), palette.color(QPalette::Base));
    check("tooltip", palette.color(QPalette::ToolTipText), palette.color(QPalette::ToolTipBase));
}

void ThemeTest::marksStandOut()
{
    // What is no word but must be seen: 3:1 (WCAG 2.1, 1.4.11), as focus rings and the filled part of
    // sliders.
    for (AppKind app : apps) {
        const ThemeColours dark = themeColours(true, app);
        QVERIFY(contrast(dark.accent, dark.panel) >= 3.0);
        const ThemeColours light = themeColours(false, app);
        QVERIFY(contrast(light.accentText, light.panel) >= 3.0);
    }
}

void ThemeTest::theDesignsColoursAreKept()
{
    const ThemeColours dark = themeColours(true, AppKind::LayerPainter);
    QCOMPARE(dark.window.name(), QString("#1e2125"));
    QCOMPARE(dark.panel.name(), QString("#26292e"));
    QCOMPARE(dark.text.name(), QString("#e8eaed"));
    QCOMPARE(dark.dim.name(), QString("#a2a9b3"));
    QCOMPARE(dark.accent.name(), QString("#a071ff"));
    const ThemeColours light = themeColours(false, AppKind::DoodleStudio);
    QCOMPARE(light.window.name(), QString("#f3f4f6"));
    QCOMPARE(light.line.name(), QString("#d9dce1"));
    QCOMPARE(light.accent.name(), QString("#ff7d5c"));
}

void ThemeTest::coloursAreFoundAgainInThePalette()
{
    for (AppKind app : apps) {
        for (bool dark : {true, false}) {
            const ThemeColours found = coloursOf(qtPalette(themeColours(dark, app)));
            QCOMPARE(found.isDark, dark);
            QCOMPARE(found.accent, themeColours(dark, app).accent);
        }
    }
    QCOMPARE(coloursOf(QPalette(Qt::white)).isDark, false); // of another program's style
}

void ThemeTest::theStyleSheetNamesNoUnknownColour()
{
    for (bool dark : {true, false}) {
        const QString sheet = styleSheet(themeColours(dark, AppKind::SketchSurfacer));
        QVERIFY2(!sheet.contains('@'), qPrintable(sheet.mid(std::max<qsizetype>(0, sheet.indexOf('@')), 30)));
        auto shapes = QRegularExpression("url\\(([^)]+)\\)").globalMatch(sheet);
        QVERIFY(shapes.hasNext());
        while (shapes.hasNext()) {
            const QString file = shapes.next().captured(1);
            QVERIFY2(QFile::exists(file), qPrintable(file));
        }
    }
}

void ThemeTest::choicesAreRemembered()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    QCOMPARE(themeChoice(settings), ThemeChoice::System);
    for (ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::System}) {
        setThemeChoice(settings, choice);
        QCOMPARE(themeChoice(settings), choice);
    }
    QVERIFY(isDark(ThemeChoice::System, QPalette(QColor("#202020"))));
    QVERIFY(!isDark(ThemeChoice::System, QPalette(QColor("#eeeeee"))));
    QVERIFY(isDark(ThemeChoice::Dark, QPalette(QColor("#eeeeee"))));
    QVERIFY(!isDark(ThemeChoice::Light, QPalette(QColor("#202020"))));
}

void ThemeTest::everyIconDraws_data()
{
    QTest::addColumn<QString>("name");
    for (const QString &name : iconNames())
        QTest::newRow(qPrintable(name)) << name;
}

void ThemeTest::everyIconDraws()
{
    QFETCH(QString, name);
    QVERIFY(hasIcon(name));
    for (int side : {16, 24, 36, 48}) {
        const QImage image = icon(name).pixmap(QSize(side, side), 1.0).toImage();
        QCOMPARE(image.size(), QSize(side, side));
        int inked = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x)
                inked += qAlpha(image.pixel(x, y)) > 64;
        }
        QVERIFY2(inked >= side / 2, "empty");
        // Nothing runs over the edge of the grid.
        if (!name.startsWith("app-")) {
            QVERIFY2(inked < side * side * 3 / 4, "a block");
        }
    }
}

void ThemeTest::iconsFollowTheTheme()
{
    const QIcon stroke = icon("stroke");
    const auto brightest = [&] {
        const QImage image = stroke.pixmap(QSize(24, 24), 1.0).toImage();
        int value = 0;
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 24; ++x) {
                if (qAlpha(image.pixel(x, y)) > 200)
                    value = std::max(value, qGray(image.pixel(x, y)));
            }
        }
        return value;
    };
    QVERIFY(brightest() > 180);
    QApplication::setPalette(qtPalette(themeColours(false, AppKind::SketchSurfacer)));
    QVERIFY(brightest() < 80);
    QApplication::setPalette(qtPalette(themeColours(true, AppKind::SketchSurfacer)));
    QVERIFY(icon("no such icon").isNull() && icon("").isNull());
}

void ThemeTest::breezeIsSharp()
{
    // A drawing of straight lines on its own grid has hardly a soft pixel at 1x, 1.5x and 2x.
    for (double scale : {1.0, 2.0}) {
        const QImage image = icon("list-add").pixmap(QSize(24, 24), scale).toImage();
        QCOMPARE(image.width(), int(24 * scale));
        QVERIFY2(softShare(image) < 0.1, qPrintable(QString::number(softShare(image))));
    }
}

void ThemeTest::theListOfIconsIsThere()
{
    for (const char *name : {"stroke", "proxy", "regions", "surface", "deviation", "seam", "merge",
                             "new-region", "lock", "role-brush", "draw-stroke", "measure", "stack",
                             "appearance-layer", "canvas", "pin", "document-open", "edit-undo", "configure"})
        QVERIFY2(hasIcon(name), name);
}

DUCTUS_WIDGET_TEST_MAIN(ThemeTest)
#include "theme_test.moc"
