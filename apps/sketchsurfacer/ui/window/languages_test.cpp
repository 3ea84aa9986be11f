// SketchSurfacer in each of its languages: nothing cut off, no key taken twice, nothing left untranslated;
// and everything within reach of the keyboard, with a name.
#include "sketchsurfacer/ui/testing/app_under_test.h"
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
void visitAll(App &app, const Visit &visit)
{
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    visit(*app.window, "start");
    QVERIFY(app.open("bevelled-box"));
    visit(*app.window, "sketch");
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
    QCOMPARE(wrongInLanguage<App>(code, QStringLiteral("sketchsurfacer"), visitAll), QString());
}

void LanguagesTest::everyTextIsTranslated()
{
    QCOMPARE(untranslated<App>({"SketchSurfacer", "LayerPainter"}, visitAll), QString());
}

void LanguagesTest::keysReachEverything()
{
    QCOMPARE(outOfReach<App>(visitAll), QString());
}

QTEST_MAIN(LanguagesTest)
#include "languages_test.moc"
