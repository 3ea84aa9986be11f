// What happens to the simulated headset: poses, buttons, state changes and faults, a line of text each. The
// file named by DUCTUS_XR_SCRIPT is read to its end before every frame, so a test may go on writing while the
// program runs.
//
//     [FROM[-TO] | +FRAMES] WORD ARGUMENTS      # a comment
//
// Without numbers a line holds at once, with one from that frame on; with two, or over
// so many frames from now, the values go there evenly.
//
//     head X Y Z [QX QY QZ QW]        poses in STAGE space: metres, w of a quaternion last
//     left X Y Z [QX QY QZ QW]        likewise right
//     input right/input/trigger/value 0.7        a component below /user/hand/
//     tracked left 0                  the hand is lost
//     state visible                   what the session goes to, step by step: focused, visible,
//                                     synchronized, stopping (ready: starts again), exiting
//     lose session | instance         loss pending; a few frames later calls fail
//     fail xrWaitFrame -12 [3]        the next call (calls) fail with that code
//     profile /interaction_profiles/valve/index_controller
//     formats 0x8058 0x881A           swapchain formats offered, in this order
//     extensions none                 no XR_KHR_opengl_enable
//     headset 0                       xrGetSystem: form factor unavailable
//     stage 0                         STAGE space is not offered
//     size 128 128                    recommended size of a view
//     pace 11                         xrWaitFrame sleeps that many milliseconds
//     dump FOLDER | off               submitted views are written as frame-N-view-V.png
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ductus::xr {

struct Pose
{
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// The simulated world at a frame.
struct Scene
{
    Pose head{{0, 1.6, 0}, Eigen::Quaterniond::Identity()};
    std::array<Pose, 2> hands{Pose{{-0.2, 1.2, -0.3}, Eigen::Quaterniond::Identity()},
                              Pose{{0.2, 1.2, -0.3}, Eigen::Quaterniond::Identity()}}; // left, right
    std::array<bool, 2> tracked{true, true};
    std::map<std::string, double> inputs; // "/user/hand/right/input/trigger/value"
    std::string profile = "/interaction_profiles/oculus/touch_controller";
    std::vector<std::int64_t> formats{0x805B, 0x881A, 0x8C43, 0x8058, 0x8CAC, 0x88F0};
    bool hasOpenGl = true;
    bool hasHeadset = true;
    bool hasStage = true;
    int width = 128, height = 128;
    int paceMilliseconds = 0;
    std::string dumpFolder; // empty: nothing is written
};

/// What a line asks the session for.
struct Order
{
    enum class Kind { State, LoseSession, LoseInstance, Fail };
    Kind kind = Kind::State;
    std::string word; // the state, or the function that fails
    int code = 0;
    int times = 1;
};

class Script
{
public:
    /// No file: an empty one. Lines that are not understood are kept as mistakes().
    explicit Script(std::filesystem::path file = {});

    /// The script's new lines, and everything up to \a frame.
    void advance(std::int64_t frame);
    const Scene &scene() const { return mScene; }
    /// Orders that have come up since the last call.
    std::vector<Order> takeOrders();
    const std::vector<std::string> &mistakes() const { return mMistakes; }

    /// One line, as if it stood in the file.
    void add(const std::string &line);

private:
    struct Line
    {
        std::int64_t from = 0, to = 0;
        std::string word;
        std::vector<std::string> arguments;
        std::vector<double> begin; // values when a ramp began
    };

    void readNewLines();
    void run(Line &line, std::int64_t frame);
    bool setValues(Line &line, double share);
    bool setOption(const Line &line);
    std::optional<std::vector<double>> numbersOf(const Line &line, std::size_t first) const;

    std::filesystem::path mFile;
    std::uintmax_t mRead = 0; // bytes
    std::vector<Line> mWaiting;
    Scene mScene;
    std::vector<Order> mOrders;
    std::vector<std::string> mMistakes;
    std::int64_t mFrame = 0;
};

} // namespace ductus::xr
