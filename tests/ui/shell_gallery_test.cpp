// The shared window filled with content: walked by keyboard, and looked through for what is cut off, in both
// themes and from the smallest to a large size.
#include "ui/gallery/gallery_window.h"
#include "widgets/controls/number_slider.h"
#include "widgets/shell/message_bar.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/testing/widget_test_main.h"
#include "widgets/theme/theme.h"

#include <QAbstractButton>
#include <QLabel>
#include <QTemporaryDir>

using namespace ductus;

namespace {

// Labels and buttons with less room than their words need.
QStringList cutOff(QWidget &window)
{
    QStringList found;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        const auto *label = qobject_cast<const QLabel *>(widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const QString text = label ? label->text() : button ? button->text() : QString();
        if (text.isEmpty() || !widget->isVisible() || (label && label->wordWrap()))
            continue;
        // Tool buttons of the rail show their icon only; rows of files cut their names with dots.
        if (widget->inherits("ductus::RecentRow") || widget->inherits("ductus::SampleCardButton") ||
            (widget->inherits("QToolButton") && widget->width() == 40))
            continue;
        if (widget->width() < widget->minimumSizeHint().width() ||
            widget->height() < widget->minimumSizeHint().height())
            found << QString("%1 \"%2\": %3 wide, needs %4")
                         .arg(widget->metaObject()->className(), text)
                         .arg(widget->width())
                         .arg(widget->minimumSizeHint().width());
    }
    return found;
}

} // namespace

class ShellGalleryTest : public QObject
{
    Q_OBJECT
private slots:
    void nothingIsCutOff_data();
    void nothingIsCutOff();
    void aDragIsOneStepInTheHistory();
};

void ShellGalleryTest::nothingIsCutOff_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("start");
    for (bool dark : {true, false}) {
        for (const QSize &size : {QSize(800, 560), QSize(1280, 800), QSize(2560, 1440)}) {
            for (bool start : {true, false})
                QTest::addRow("%s %d %s", dark ? "dark" : "light", size.width(), start ? "start" : "canvas")
                    << dark << size << start;
        }
    }
}

void ShellGalleryTest::nothingIsCutOff()
{
    QFETCH(bool, dark);
    QFETCH(QSize, size);
    QFETCH(bool, start);
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    setThemeChoice(settings, dark ? ThemeChoice::Dark : ThemeChoice::Light);
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    GalleryWindow window(AppKind::SketchSurfacer, {&settings, &jobs, &actions});
    window.resize(size);
    window.show();
    if (!start)
        window.showCanvas();
    window.messages()->warning("The file changed on the disk.", "Load it again or keep yours.");
    QTest::qWait(10);
    QCOMPARE(window.size(), size);
    const QStringList cut = cutOff(window);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
    const KeyboardWalk walk = walkByKeyboard(window);
    QVERIFY2(walk.problems.isEmpty(), qPrintable(walk.problems.join("\n")));
    QVERIFY(walk.visited.size() > 8);
    // The corners of the picture are the window's own: nothing was left unpainted.
    const QImage picture = window.grab().toImage();
    const ThemeColours colours = coloursOf(window.palette());
    QCOMPARE(picture.pixelColor(2, 2), colours.panel);
    QCOMPARE(picture.pixelColor(picture.width() - 3, picture.height() - 3), colours.panel);
}

void ShellGalleryTest::aDragIsOneStepInTheHistory()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    GalleryWindow window(AppKind::LayerPainter, {&settings, &jobs, &actions});
    window.resize(1280, 800);
    window.show();
    window.showCanvas();
    auto *slider = window.tightness()->findChild<QWidget *>("track");
    QVERIFY(slider);
    const int y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {20, y});
    for (int x = 30; x <= 90; x += 10)
        QTest::mouseMove(slider, {x, y});
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {90, y});
    QCOMPARE(window.galleryDocument().undoStack()->count(), 1);
    const double value = window.galleryDocument().tightness();
    actions.action("edit.undo")->trigger();
    QCOMPARE(window.galleryDocument().tightness(), 0.4);
    actions.action("edit.redo")->trigger();
    QCOMPARE(window.galleryDocument().tightness(), value);
}

DUCTUS_WIDGET_TEST_MAIN(ShellGalleryTest)
#include "shell_gallery_test.moc"
