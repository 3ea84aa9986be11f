#include "doodling/storage/doodle_content.h"

#include "base/random.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"

#include <QtTest>

using namespace ductus;

namespace {

Shot smallShot(int frames)
{
    Random random(7);
    Shot shot;
    shot.width = 40;
    shot.height = 24;
    shot.clipWidth = 80;
    shot.clipHeight = 48;
    const auto flow = [&] {
        FlowField field{10, 6, 4.0, {}, {}};
        for (int i = 0; i < 60; ++i) {
            field.motions.emplace_back(float(random.index(2001) - 1000) / 32.0f,
                                       float(random.index(64)) / 32.0f);
            field.confidences.push_back(float(random.index(256)) / 255.0f);
        }
        return field;
    };
    for (int t = 0; t < frames; ++t) {
        ShotCamera camera{Eigen::Isometry3d::Identity(), 36.0, {20.0, 12.0}};
        camera.worldFromCamera.translation() = Vec3(0.1 * t, 0.0, 1.0 / 3.0);
        camera.worldFromCamera.linear() = Eigen::AngleAxisd(0.1 * t, Vec3::UnitY()).toRotationMatrix();
        shot.cameras.push_back(camera);
        std::vector<float> disparities;
        for (int i = 0; i < 60; ++i)
            disparities.push_back(float(0.01 + random.uniform()));
        shot.depths.push_back(depthMapOf(10, 6, 4.0, disparities));
        if (t % 2 == 0) { // frames in which nothing moves have no objects
            std::vector<std::uint8_t> objects;
            for (int i = 0; i < 60; ++i)
                objects.push_back(std::uint8_t(random.index(4)));
            shot.depths.back().objects = std::move(objects);
        }
        if (t > 0) {
            shot.forward.push_back(flow());
            shot.backward.push_back(flow());
        }
    }
    return shot;
}

Project projectWith(Shot shot, int frames)
{
    Random random(1);
    Project project;
    project.id = Uuid::from(random);
    project.documents.push_back(newDocument(
        Uuid::from(random), "clip",
        std::make_shared<const DoodleContent>(ClipReference{"films/a b.mp4", frames, 80, 48, 25.0},
                                              std::make_shared<const Shot>(std::move(shot)))));
    return project;
}

Result<Project> reread(const Bytes &bytes)
{
    ProjectReadOptions options;
    options.kinds = {doodleKind()};
    return parseProject(bytes, "test.ductus", options);
}

} // namespace

class DoodleContentTest : public QObject
{
    Q_OBJECT
private slots:
    void comesBackAsItWas_data()
    {
        QTest::addColumn<int>("frames");
        QTest::newRow("one frame") << 1;
        QTest::newRow("four") << 4;
    }
    void comesBackAsItWas()
    {
        QFETCH(int, frames);
        const Shot shot = smallShot(frames);
        const auto bytes = serializedProject(projectWith(shot, frames));
        QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().message().c_str());
        const auto project = reread(bytes->bytes);
        QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
        const auto content = doodleOf(*project);
        QVERIFY(content.ok());
        QCOMPARE((*content)->clip().path, std::string("films/a b.mp4"));
        QCOMPARE((*content)->clip().framesPerSecond, 25.0);
        const Shot &back = *(*content)->shot();
        QCOMPARE(back.clipWidth, 80);
        QCOMPARE(back.frameCount(), frames);
        for (int t = 0; t < frames; ++t) {
            QVERIFY(back.cameras[t].worldFromCamera.isApprox(shot.cameras[t].worldFromCamera, 1e-12));
            QCOMPARE(back.cameras[t].focal, 36.0);
            QVERIFY(back.depths[t].disparities == shot.depths[t].disparities);
            QVERIFY(back.depths[t].objects == shot.depths[t].objects);
            QCOMPARE(back.depths[t].mostDisparity, shot.depths[t].mostDisparity);
        }
        for (int t = 0; t + 1 < frames; ++t) {
            QVERIFY(back.forward[t].motions == shot.forward[t].motions);
            QVERIFY(back.backward[t].confidences == shot.backward[t].confidences);
        }
        const auto again = serializedProject(*project);
        QVERIFY(again.ok());
        QVERIFY(again->bytes == bytes->bytes);
    }
    void followsItsSchema()
    {
        const auto bytes = serializedProject(projectWith(smallShot(3), 3));
        const auto violations = projectSchemaViolations(bytes->bytes, "test.ductus");
        QVERIFY(violations.ok());
        QVERIFY2(violations->empty(), violations->empty() ? "" : violations->front().c_str());
        QVERIFY(!schemaText("doodle").empty());
    }
    void wrongNumbersOfFramesAreRefused()
    {
        QVERIFY(!serializedProject(projectWith(smallShot(3), 4)).ok());
        Shot shot = smallShot(3);
        shot.backward.pop_back();
        QVERIFY(!serializedProject(projectWith(shot, 3)).ok());
    }
    void damagedFilesAreRefusedOrReadAsTheyAre()
    {
        const auto bytes = serializedProject(projectWith(smallShot(3), 3));
        Random random(5);
        for (int i = 0; i < 300; ++i) {
            Bytes damaged = bytes->bytes;
            for (int k = 0; k < 3; ++k)
                damaged[std::size_t(random.index(int(damaged.size())))] = std::byte(random.index(256));
            if (i % 3 == 0)
                damaged.resize(std::size_t(random.index(int(damaged.size()))));
            const auto project = reread(damaged);
            if (project)
                (void)doodleOf(*project).ok();
            else
                QVERIFY(!project.error().problem.empty());
        }
    }
    void projectsWithoutOneSaySo() { QCOMPARE(doodleOf(Project()).error().code, ErrorCode::TooLittleData); }
};

QTEST_APPLESS_MAIN(DoodleContentTest)
#include "doodle_content_test.moc"
