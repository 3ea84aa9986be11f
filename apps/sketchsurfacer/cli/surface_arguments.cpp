#include "sketchsurfacer/cli/surface_arguments.h"

#include "cli/output_files.h"
#include "formats/mesh_file.h"
#include "sketchsurfacer/cli/sketch_input.h"

#include <QCommandLineParser>
#include <cmath>
#include <tuple>

namespace ductus {

namespace {

std::filesystem::path pathOf(const QString &text)
{
    return std::filesystem::path(text.toStdU16String());
}

// More than any sketch that is read can have; keeps "0-99999999" from filling the memory.
constexpr int mostStrokes = 2'000'000;

std::optional<std::vector<int>> strokeList(const QString &text)
{
    std::vector<int> ids;
    for (const QString &item : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        // "3" or a range "3-7"
        const QStringList ends = item.trimmed().split(QLatin1Char('-'));
        bool okFirst = false, okLast = false;
        const int first = ends.first().toInt(&okFirst), last = ends.last().toInt(&okLast);
        if (!okFirst || !okLast || ends.size() > 2 || first < 0 || last < first)
            return std::nullopt;
        for (int id = first; id <= last && int(ids.size()) <= mostStrokes; ++id)
            ids.push_back(id);
    }
    if (ids.empty() || int(ids.size()) > mostStrokes)
        return std::nullopt;
    return ids;
}

// "x", "y", "z" or "nx,ny,nz,d" for the plane n . x = d.
std::optional<SymmetryPlane> planeOf(const QString &text)
{
    const QString axes = QStringLiteral("xyz");
    if (text.size() == 1 && axes.contains(text.toLower()))
        return SymmetryPlane{Vec3::Unit(axes.indexOf(text.toLower())), 0.0};
    const QStringList parts = text.split(QLatin1Char(','));
    if (parts.size() != 4)
        return std::nullopt;
    double n[4];
    for (int i = 0; i < 4; ++i) {
        bool ok = false;
        n[i] = parts[i].toDouble(&ok);
        if (!ok || !std::isfinite(n[i]))
            return std::nullopt;
    }
    const Vec3 normal(n[0], n[1], n[2]);
    const double length = normal.norm();
    if (!(length > 1e-12))
        return std::nullopt;
    return SymmetryPlane{normal / length, n[3] / length};
}

class Parser
{
public:
    Parser()
    {
        mParser.setApplicationDescription(QStringLiteral(
            "Surfaces a 3D sketch: reads strokes, makes or takes a proxy, finds the smooth patches the "
            "strokes "
            "describe, and writes one manifold mesh.\n\n"
            "IN: .curves, OBJ with lines, CURVE text, x y z text, .ductus; several are taken as one sketch.\n"
            "OUT: .obj, .ply, .stl, .off, .glb, .ductus.\n"
            "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled (Ctrl-C)."));
        mParser.addPositionalArgument(QStringLiteral("IN"), QStringLiteral("The sketch, or its parts."),
                                      QStringLiteral("IN..."));
        mParser.addOptions({mHelp,       mOutput, mProxy,     mSymmetry,  mEpsilon,  mSimplicity, mSmoothness,
                            mRuns,       mSeed,   mVertices,  mTightness, mBoundary, mIgnore,     mSkeletal,
                            mTubeRadius, mParts,  mScribbles, mReport,    mPicture,  mAmbiguity,  mQuiet});
    }

    ParsedSurfaceArguments parse(const QStringList &arguments)
    {
        if (!mParser.parse(QStringList(QStringLiteral("sketchsurfacer surface")) + arguments))
            return wrong(mParser.errorText());
        if (mParser.isSet(mHelp))
            return {std::nullopt, mParser.helpText(), true};
        if (mParser.positionalArguments().isEmpty())
            return wrong(QStringLiteral("no sketch was given"));
        if (!mParser.isSet(mOutput))
            return wrong(QStringLiteral("-o OUT is missing"));

        SurfaceArguments a;
        for (const QString &input : mParser.positionalArguments())
            a.inputs.push_back(pathOf(input));
        a.output = pathOf(mParser.value(mOutput));
        a.proxy = pathOf(mParser.value(mProxy));
        a.scribbles = pathOf(mParser.value(mScribbles));
        a.report = pathOf(mParser.value(mReport));
        a.picture = pathOf(mParser.value(mPicture));
        a.ambiguity = pathOf(mParser.value(mAmbiguity));
        a.quiet = mParser.isSet(mQuiet);
        if (!isMeshExtension(a.output) && !isProjectExtension(a.output))
            return wrong(QStringLiteral("OUT must end in .obj, .ply, .stl, .off, .glb or .ductus"));

        if (!a.picture.empty() &&
            !mParser.value(mPicture).endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
            return wrong(QStringLiteral("--picture must end in .png"));
        const QString ambiguity = mParser.value(mAmbiguity);
        if (!ambiguity.isEmpty() && !ambiguity.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) &&
            !ambiguity.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
            return wrong(QStringLiteral("--ambiguity must end in .png or .json"));
        const std::filesystem::path *outputs[] = {&a.output, &a.report, &a.picture, &a.ambiguity};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j)
                if (!outputs[i]->empty() && !outputs[j]->empty() && isSameFile(*outputs[i], *outputs[j]))
                    return wrong(
                        QStringLiteral("two of OUT, --report, --picture and --ambiguity name the same file"));

        const QString symmetry = mParser.value(mSymmetry);
        if (symmetry == QLatin1String("auto") || symmetry == QLatin1String("none")) {
            if (mParser.isSet(mSymmetry))
                a.given.symmetry = {symmetry == QLatin1String("auto") ? SymmetryMode::Auto
                                                                      : SymmetryMode::None,
                                    SymmetryPlane()};
        } else {
            const std::optional<SymmetryPlane> plane = planeOf(symmetry);
            if (!plane)
                return wrong(QStringLiteral("--symmetry takes auto, none, x, y, z or nx,ny,nz,d"));
            a.given.symmetry = {SymmetryMode::Given, *plane};
        }
        for (const auto &[option, ids] :
             {std::pair(&mBoundary, &a.boundaryStrokes), std::pair(&mIgnore, &a.ignoredStrokes),
              std::pair(&mSkeletal, &a.skeletalStrokes)}) {
            if (!mParser.isSet(*option))
                continue;
            const std::optional<std::vector<int>> list = strokeList(mParser.value(*option));
            if (!list)
                return wrong(
                    QStringLiteral("--%1 takes stroke numbers such as 0,4,7-9").arg(option->names().last()));
            *ids = *list;
        }
        const QString parts = mParser.value(mParts);
        if (parts != QLatin1String("auto") && parts != QLatin1String("off"))
            return wrong(QStringLiteral("--parts takes auto or off"));
        a.findCables = parts == QLatin1String("auto");
        QString problem;
        std::optional<qlonglong> runs, seed, vertices;
        number(mEpsilon, 1e-5, 0.5, a.given.epsilon, problem);
        number(mSimplicity, 0.0, 1e6, a.given.simplicity, problem);
        number(mSmoothness, 0.0, 1e6, a.given.smoothness, problem);
        number(mTightness, 0.0, 1.0, a.given.tightness, problem);
        number(mTubeRadius, 1e-5, 0.5, a.given.tubeRadius, problem);
        wholeNumber(mRuns, 1, 1000, runs, problem);
        wholeNumber(mSeed, 0, 9007199254740992, seed, problem);
        wholeNumber(mVertices, 200, 500000, vertices, problem);
        if (!problem.isEmpty())
            return wrong(problem);
        if (runs)
            a.given.runs = int(*runs);
        if (seed)
            a.given.seed = std::uint64_t(*seed);
        if (vertices)
            a.given.proxyVertices = int(*vertices);
        a.options.segmentation.runs = 1;
        a.given.applyTo(a.options);
        return {std::move(a), {}, false};
    }

private:
    ParsedSurfaceArguments wrong(const QString &problem) const
    {
        return {
            std::nullopt,
            QStringLiteral("sketchsurfacer surface: %1. See: sketchsurfacer surface --help\n").arg(problem),
            false};
    }

    void number(const QCommandLineOption &option, double low, double high, std::optional<double> &value,
                QString &problem) const
    {
        if (!mParser.isSet(option))
            return;
        bool ok = false;
        const double given = mParser.value(option).toDouble(&ok);
        if (ok && given >= low && given <= high)
            value = given;
        else
            problem = QStringLiteral("--%1 takes a number from %2 to %3")
                          .arg(option.names().last())
                          .arg(low)
                          .arg(high);
    }

    void wholeNumber(const QCommandLineOption &option, qlonglong low, qlonglong high,
                     std::optional<qlonglong> &value, QString &problem) const
    {
        if (!mParser.isSet(option))
            return;
        bool ok = false;
        const qlonglong given = mParser.value(option).toLongLong(&ok);
        if (ok && given >= low && given <= high)
            value = given;
        else
            problem = QStringLiteral("--%1 takes a whole number from %2 to %3")
                          .arg(option.names().last())
                          .arg(low)
                          .arg(high);
    }

    static QCommandLineOption option(const char *name, const char *description, const char *value = "",
                                     const char *defaultValue = "")
    {
        QString text = QString::fromUtf8(description);
        if (*defaultValue) // Qt's help leaves them out
            text += QStringLiteral(" Default: %1.").arg(QString::fromLatin1(defaultValue));
        return QCommandLineOption(QString::fromLatin1(name).split(QLatin1Char('/')), text,
                                  QString::fromLatin1(value), QString::fromLatin1(defaultValue));
    }

    QCommandLineParser mParser;
    QCommandLineOption mHelp = option("h/help", "Shows this help.");
    QCommandLineOption mOutput = option("o/output", "The mesh to write.", "OUT");
    QCommandLineOption mProxy = option("proxy",
                                       "A rough mesh of the shape to read the strokes on; made automatically "
                                       "without it.",
                                       "MESH");
    QCommandLineOption mSymmetry = option("symmetry",
                                          "Mirror plane: auto, none, x, y, z or nx,ny,nz,d. Half of the "
                                          "sketch is solved and mirrored.",
                                          "PLANE", "none");
    QCommandLineOption mEpsilon = option("epsilon",
                                         "How loosely strokes are followed, share of the sketch's box "
                                         "diagonal.",
                                         "E", "0.01");
    QCommandLineOption mSimplicity = option("simplicity", "Larger: fewer and simpler patches.", "W", "0.01");
    QCommandLineOption mSmoothness =
        option("smoothness", "Larger: patch borders keep closer to strokes.", "W", "10");
    QCommandLineOption mRuns = option("runs", "Runs of which the best is kept.", "N", "1");
    QCommandLineOption mSeed = option("seed", "Same seed, same bytes.", "S", "1");
    QCommandLineOption mVertices = option("proxy-vertices", "Size of the remeshed proxy.", "V", "12000");
    QCommandLineOption mTightness = option("tightness",
                                           "How tightly strokes are wrapped when the proxy is made, 0 to "
                                           "1; chosen automatically without it.",
                                           "T");
    QCommandLineOption mBoundary = option("boundary",
                                          "Strokes along the border of an open surface, counted from 0 as "
                                          "in the file: 0,4,7-9.",
                                          "IDS");
    QCommandLineOption mIgnore = option("ignore", "Strokes to leave out, counted from 0.", "IDS");
    QCommandLineOption mSkeletal = option("skeletal",
                                          "Strokes that stand for a thin tube, a cable or a stem, counted "
                                          "from 0. Each becomes a closed tube beside the surface.",
                                          "IDS");
    QCommandLineOption mTubeRadius = option("tube-radius",
                                            "Radius of such tubes, share of the sketch's box diagonal; where "
                                            "the file has pressure, at half of it.",
                                            "R", "0.005");
    QCommandLineOption mParts = option("parts",
                                       "auto or off: whether cables are found by themselves, made tubes of, "
                                       "and what they join surfaced apart. Not for projects and "
                                       "not with --proxy: there it is decided.",
                                       "HOW", "auto");
    QCommandLineOption mScribbles = option("scribbles",
                                           "Corrections to the regions as a designer would draw them, JSON; "
                                           "the manual describes it.",
                                           "S.json");
    QCommandLineOption mReport =
        option("report", "Writes timings, energies, regions and deviations as JSON.", "R.json");
    QCommandLineOption mPicture =
        option("picture", "Writes a picture of sketch and surface; needs no display.", "P.png");
    QCommandLineOption mAmbiguity = option("ambiguity",
                                           "Writes where the sketch leaves more than one surface open, as a "
                                           "picture (.png) or in numbers (.json). Takes a while.",
                                           "A");
    QCommandLineOption mQuiet = option("q/quiet", "No progress on stderr.");
};

} // namespace

void GivenOptions::applyTo(SurfaceOptions &options) const
{
    const auto set = [](const auto &given, auto &option) {
        if (given)
            option = *given;
    };
    if (symmetry)
        std::tie(options.symmetry, options.symmetryPlane) = *symmetry;
    set(epsilon, options.segmentation.epsilon);
    set(simplicity, options.segmentation.simplicity);
    set(smoothness, options.segmentation.smoothness);
    set(tightness, options.proxy.wrap.tightness);
    set(tubeRadius, options.skeletal.radius);
    set(runs, options.segmentation.runs);
    set(proxyVertices, options.proxy.targetVertices);
    set(seed, options.segmentation.seed);
}

ParsedSurfaceArguments parseSurfaceArguments(const QStringList &arguments)
{
    return Parser().parse(arguments);
}

} // namespace ductus
