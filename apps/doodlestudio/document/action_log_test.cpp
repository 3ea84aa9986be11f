// What is written down, as JSON, and what is not while the log is off.
#include "doodlestudio/document/action_log.h"

#include "doodlestudio/document/placing.h"
#include "doodling/canvas/edit_scene.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace ductus;

class ActionLogTest : public QObject
{
    Q_OBJECT
private slots:
    void everyActIsALine();
    void nothingWhileItIsOff();
};

namespace {

struct Logged
{
    DoodleDocument document;
    ActionCatalogue actions;
    int frame = 0;
    ActionLog log{document, actions, [this] { return LogPlace{QStringLiteral("Canvas 1"), frame}; }};

    Logged()
    {
        document.start(QStringLiteral("clip.mp4"), {"clip.mp4", 10, 160, 90, 25.0});
        actions.add({"play.toggle", "Play", "", {}, {}, "Play"});
    }
    void add()
    {
        document.edit("Add canvas",
                      withCanvas(document.scene(),
                                 canvasInBox(*document.sceneShot(), 0, {10, 10}, {60, 40}, "Canvas 1")));
    }
    void opacity(double value, quint64 drag)
    {
        Canvas canvas = document.scene().canvases.back();
        canvas.opacity = value;
        document.editCanvas("Change opacity", canvas, drag);
    }
    QList<QJsonObject> lines() const
    {
        QList<QJsonObject> lines;
        for (const QByteArray &line : log.text().split('\n'))
            if (!line.isEmpty())
                lines << QJsonDocument::fromJson(line).object();
        return lines;
    }
    QStringList told() const
    {
        QStringList told;
        for (const QJsonObject &line : lines())
            told << line["kind"].toString() + ' ' + line["action"].toString();
        return told;
    }
};

} // namespace

void ActionLogTest::everyActIsALine()
{
    Logged app;
    app.log.setOn(true);
    app.add();
    app.frame = 7;
    app.actions.action("play.toggle")->trigger();
    app.opacity(0.5, 3);
    QTest::qWait(20);
    app.opacity(0.4, 3); // the same drag
    app.document.undoStack()->undo();
    app.document.undoStack()->redo();
    app.document.undoStack()->undo();
    app.opacity(0.2, 4); // takes the place of what was undone
    QCOMPARE(app.told(), (QStringList{"edit Add canvas", "command play.toggle", "edit Change opacity",
                                      "undo Change opacity", "redo Change opacity", "undo Change opacity",
                                      "edit Change opacity"}));
    const QList<QJsonObject> lines = app.lines();
    QCOMPARE(lines[0]["frame"].toInt(), 0);
    QCOMPARE(lines[1]["frame"].toInt(), 7);
    QCOMPARE(lines[1]["canvas"].toString(), QStringLiteral("Canvas 1"));
    const auto time = [&](int i, const char *end) {
        return QDateTime::fromString(lines[i][QLatin1String(end)].toString(), Qt::ISODateWithMs);
    };
    QVERIFY(time(2, "from").isValid());
    QVERIFY(time(2, "from").msecsTo(time(2, "until")) >= 15); // a drag lasts
    for (int i = 1; i < lines.size(); ++i)
        QVERIFY(time(i - 1, "from") <= time(i, "from"));
}

void ActionLogTest::nothingWhileItIsOff()
{
    Logged app;
    app.add();
    QCOMPARE(app.log.length(), 0);
    app.log.setOn(true);
    app.document.undoStack()->undo();
    app.log.setOn(false);
    app.document.undoStack()->redo();
    QCOMPARE(app.told(), QStringList{"undo Add canvas"});
    app.log.setOn(true); // a new one
    QCOMPARE(app.log.length(), 0);
}

QTEST_MAIN(ActionLogTest)
#include "action_log_test.moc"
