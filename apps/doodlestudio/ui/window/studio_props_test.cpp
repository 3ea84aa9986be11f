// A painting in the filmed scene, in the real window: placed, seen in the preview, offered anew when it
// changed.
#include "document/document_files.h"
#include "document/stroke_clipboard.h"
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "project/saving/project_save.h"
#include "widgets/shell/message_bar.h"

#include <QClipboard>
#include <QPushButton>

using namespace ductus;

namespace {

// A ball of one stroke.
Project ball(const Eigen::Vector3f &colour)
{
    StrokeShape shape;
    PaintedPoint point;
    point.halfWidth = 0.5f;
    point.colour = colour;
    shape.points = {point};
    const AddedStack stack = *addStack({}, "ball");
    const Painting painting =
        addElements(stack.painting, stack.substrate, {std::make_shared<const ElementShape>(shape)})->painting;
    Project project;
    project.id = *Uuid::parse("01234567-89ab-4cde-8f01-23456789abcd");
    project.documents.push_back(
        newDocument(*Uuid::parse("a1a1a1a1-b2b2-4c3c-8d4d-e5e5e5e5e5e5"), "Ball",
                    std::make_shared<const PaintingContent>(painting, UnknownPaintingMembers())));
    return project;
}

} // namespace

class StudioPropsTest : public QObject
{
    Q_OBJECT
private slots:
    void aPaintingStandsInTheClipAndIsUpdated();
    void aPaintingThatWasSentWaitsForAClip();
    void strokesArePastedOnACanvas();

private:
    static void save(const QString &path, const Eigen::Vector3f &colour)
    {
        const Result<SaveReport> saved = saveProject(ball(colour), enginePath(path));
        QVERIFY2(saved.ok(), saved ? "" : saved.error().message().c_str());
    }
    static QString clipIn(StudioUnderTest &app)
    {
        std::vector<Image> frames(4, Image(160, 90, {90, 110, 130, 255}));
        const QString path = app.folder.filePath("clip.mp4");
        writeClip(frames, path, 12.0);
        return path;
    }
    static bool isOffered(StudioUnderTest &app)
    {
        const auto &all = app.window->messages()->messages();
        return std::any_of(all.begin(), all.end(),
                           [](const Message &m) { return m.key == "links" && !m.decline.isEmpty(); });
    }
    // How many pixels of the player are as red, or green, as the ball.
    static int pixelsLike(StudioUnderTest &app, int channel)
    {
        const QImage shown = app.window->player().grabPicture().convertToFormat(QImage::Format_RGB32);
        int count = 0;
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x) {
                const QColor colour = shown.pixelColor(x, y);
                const int parts[] = {colour.red(), colour.green(), colour.blue()};
                count +=
                    parts[channel] > 200 && parts[(channel + 1) % 3] < 90 && parts[(channel + 2) % 3] < 90;
            }
        return count;
    }
};

void StudioPropsTest::aPaintingStandsInTheClipAndIsUpdated()
{
    StudioUnderTest app;
    const QString painting = app.folder.filePath("ball.ductus");
    save(painting, {1, 0, 0});
    QVERIFY(app.open(clipIn(app)));
    app.jobs.cancelKey("analyse");
    app.window->placePainting(painting);
    QTRY_COMPARE_WITH_TIMEOUT(app.window->doodle().scene().canvases.size(), std::size_t(1), 30'000);
    const Canvas &canvas = app.window->doodle().scene().canvases[0];
    QVERIFY(canvas.prop);
    QCOMPARE(app.window->state().chosen(), canvas.id);

    QTRY_VERIFY_WITH_TIMEOUT(pixelsLike(app, 0) > 300, 60'000);
    app.shot("painting-placed");
    save(painting, {0, 1, 0});
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(app), 30'000);
    app.shot("painting-offered");
    for (auto *button : app.window->messages()->findChildren<QPushButton *>())
        if (button->isVisible() && button->text() == "Update")
            QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(pixelsLike(app, 1) > 300, 60'000);
    app.window->doodle().undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(pixelsLike(app, 0) > 300, 60'000);
    app.window->doodle().undoStack()->undo();
    QVERIFY(app.window->doodle().scene().canvases.empty());
}

void StudioPropsTest::aPaintingThatWasSentWaitsForAClip()
{
    StudioUnderTest app;
    const QString painting = app.folder.filePath("ball.ductus");
    save(painting, {1, 0, 0});
    app.window->openPath(painting);
    QTRY_VERIFY_WITH_TIMEOUT(!app.window->messages()->messages().isEmpty(), 30'000);
    QVERIFY(app.window->doodle().isEmpty());
    QVERIFY(app.open(clipIn(app)));
    app.jobs.cancelKey("analyse");
    QTRY_COMPARE_WITH_TIMEOUT(app.window->doodle().scene().canvases.size(), std::size_t(1), 30'000);
    QVERIFY(app.window->doodle().scene().canvases[0].prop);
}

void StudioPropsTest::strokesArePastedOnACanvas()
{
    StudioUnderTest app;
    QVERIFY(app.open(clipIn(app)));
    app.jobs.cancelKey("analyse");
    app.dragOnPicture({{40, 20}, {80, 45}, {120, 70}});
    QCOMPARE(app.window->doodle().scene().canvases.size(), std::size_t(1));
    CopiedStrokes foreign;
    foreign.strokes.resize(2);
    foreign.strokes[0].line.points = {{0, 0, 0}, {1, 1, 3}};
    foreign.strokes[1].line.points = {{1, 0, 0}, {0, 1, 0}};
    QGuiApplication::clipboard()->setMimeData(mimeDataOf(foreign).release());
    app.window->pasteStrokes();
    const auto marks = [&] { return app.window->doodle().scene().canvases[0].doodle.frames[0].marks.size(); };
    QCOMPARE(marks(), std::size_t(2));
    app.window->copyStrokes();
    const Result<CopiedStrokes> copied = strokesFrom(QGuiApplication::clipboard()->mimeData());
    QVERIFY(copied.ok() && copied->isFlat);
    QCOMPARE(copied->strokes.size(), std::size_t(2));
    app.window->doodle().undoStack()->undo();
    QCOMPARE(marks(), std::size_t(0));
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    StudioPropsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "studio_props_test.moc"
