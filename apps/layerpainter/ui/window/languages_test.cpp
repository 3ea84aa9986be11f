// LayerPainter in each of its languages: nothing cut off, no key taken twice, nothing left untranslated; and
// everything within reach of the keyboard, with a name.
#include "layerpainter/ui/testing/painter_under_test.h"
#include "layerpainter/ui/window/film_dialog.h"
#include "layerpainter/ui/window/picture_dialog.h"
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
void visitAll(PainterUnderTest &app, const Visit &visit)
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
    visitSettings(
        *app.window, [&] { app.actions.action(QStringLiteral("edit.settings"))->trigger(); }, visit);
}

} // namespace

void LanguagesTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", mCache.path().toUtf8());
}

void LanguagesTest::fitsEveryLanguage()
{
    QFETCH(QString, code);
    QCOMPARE(wrongInLanguage<PainterUnderTest>(code, QStringLiteral("layerpainter"), visitAll), QString());
}

void LanguagesTest::everyTextIsTranslated()
{
    QCOMPARE(untranslated<PainterUnderTest>(
                 {"LayerPainter", "SketchSurfacer", "DoodleStudio", "Noon", "Plane"}, visitAll),
             QString());
}

void LanguagesTest::keysReachEverything()
{
    QCOMPARE(outOfReach<PainterUnderTest>(visitAll), QString());
}

QTEST_MAIN(LanguagesTest)
#include "languages_test.moc"
