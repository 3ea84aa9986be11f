// LayerPainter in each of its languages: nothing cut off, no key taken twice, nothing left untranslated; and
// everything within reach of the keyboard, with a name.
#include "layerpainter/ui/testing/painter_under_test.h"
#include "layerpainter/ui/window/film_dialog.h"
#include "layerpainter/ui/window/picture_dialog.h"
#include "widgets/pages/settings_dialog.h"
#include "widgets/testing/language_check.h"

using namespace ductus;
using namespace ductus::testing;

class LanguagesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup() { speak(*qApp, QStringLiteral("en"), {}); }
    void fitsEveryLanguage_data() { addLanguageRows(); }
    void fitsEveryLanguage();
    void everyTextIsTranslated();
    void keysReachEverything();

private:
    QTemporaryDir mCache;
};

namespace {

/// The window as it is at the start, at work, and its dialogs, one after the other.
void visitAll(PainterUnderTest &app, const std::function<void(QWidget &, const char *)> &visit)
{
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    visit(*app.window, "start");
    QVERIFY(app.open("plane-over-clouds"));
    visit(*app.window, "painting");
    PictureDialog picture({640, 480}, app.window.get());
    picture.show();
    visit(picture, "picture");
    picture.close();
    FilmDialog film(std::make_shared<const Painting>(app.painting()), CameraKey{}, app.window.get());
    film.show();
    visit(film, "film");
    film.close();
    app.actions.action(QStringLiteral("edit.settings"))->trigger();
    auto *settings = app.window->findChild<SettingsDialog *>();
    QVERIFY(settings);
    QVERIFY(QTest::qWaitForWindowExposed(settings));
    for (int page = 0; page < settings->pageCount(); ++page) {
        settings->showPage(page);
        QTest::qWait(0); // the page is laid out
        visit(*settings, qPrintable(QStringLiteral("settings-%1").arg(page)));
    }
    settings->close();
}

} // namespace

void LanguagesTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", mCache.path().toUtf8());
}

void LanguagesTest::fitsEveryLanguage()
{
    QFETCH(QString, code);
    QVERIFY(speak(*qApp, code, QStringLiteral("layerpainter")));
    PainterUnderTest app;
    QStringList wrong;
    visitAll(app, [&](QWidget &shown, const char *name) {
        keepPicture(shown, QStringLiteral("layerpainter-%1-%2").arg(code, QLatin1String(name)));
        const QString texts = wrongTexts(shown);
        if (!texts.isEmpty())
            wrong << QLatin1String(name) + QStringLiteral(":\n") + texts;
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void LanguagesTest::everyTextIsTranslated()
{
    MarkingTranslator marks;
    QCoreApplication::installTranslator(&marks);
    PainterUnderTest app;
    QStringList plain;
    visitAll(app, [&](QWidget &shown, const char *name) {
        for (const QString &text :
             unmarkedTexts(shown, {"LayerPainter", "SketchSurfacer", "DoodleStudio", "Noon", "Plane"}))
            plain << QLatin1String(name) + QStringLiteral(": ") + text;
    });
    QCoreApplication::removeTranslator(&marks);
    plain.removeDuplicates();
    QVERIFY2(plain.isEmpty(), qPrintable(plain.join(QLatin1Char('\n'))));
}

void LanguagesTest::keysReachEverything()
{
    PainterUnderTest app;
    QStringList wrong;
    visitAll(app, [&](QWidget &shown, const char *name) {
        for (const QString &problem : walkByKeyboard(shown).problems)
            wrong << QLatin1String(name) + QStringLiteral(": ") + problem;
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

QTEST_MAIN(LanguagesTest)
#include "languages_test.moc"
