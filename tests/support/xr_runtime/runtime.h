// The simulated runtime's state: one instance, one system, at most one session, and all that hangs on it.
// OpenXR is a C interface without a place for state, so there is one Runtime a process; Debian's loader
// supports one instance at a time as well.
#pragma once

#include "support/xr_runtime/recorder.h"
#include "support/xr_runtime/script.h"

#include <X11/Xlib.h>
#include <epoxy/gl.h>
#include <epoxy/glx.h>

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace ductus::xr {

/// Two, one for each eye.
inline constexpr std::uint32_t viewCount = 2;
inline constexpr XrTime framePeriod = 11'111'111; // nanoseconds, 90 a second
inline constexpr double eyeDistance = 0.064;      // metres
inline constexpr double localHeight = 1.6;        // LOCAL's origin above STAGE's, metres

struct SpaceObject
{
    XrReferenceSpaceType reference = XR_REFERENCE_SPACE_TYPE_STAGE;
    std::uint64_t action = 0; // a pose action's instead
    int hand = 0;             // 0 left, 1 right
    Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();
};

struct SwapchainObject
{
    int width = 0, height = 0;
    std::int64_t format = 0;
    std::vector<GLuint> textures;
    int next = 0;
    int acquired = -1; // not yet released
    bool waited = false;
    int released = -1; // what a frame shows
};

struct ActionState
{
    bool isActive = false, changed = false;
    float x = 0, y = 0;
    XrTime changeTime = 0;
};

struct ActionObject
{
    std::uint64_t set = 0;
    std::string name;
    XrActionType type{};
    std::vector<XrPath> subactions;
    ActionState states[3]; // any hand, left, right
};

struct ActionSetObject
{
    std::string name;
    bool isAttached = false;
};

struct SessionObject
{
    XrSessionState state = XR_SESSION_STATE_UNKNOWN;
    XrSessionState goal = XR_SESSION_STATE_FOCUSED; // while running
    bool isRunning = false;
    bool isLeaving = false; // after STOPPING comes EXITING, not READY
    bool isWaited = false;  // xrWaitFrame without xrBeginFrame yet
    bool isBegun = false;   // xrBeginFrame without xrEndFrame yet
    std::int64_t frame = 0; // xrWaitFrame calls
    int callsLeft = -1;     // frames until all calls fail, once lost
    bool setsAttached = false;
    bool hasSynced = false;
    std::string profile; // the bindings in use
};

struct Runtime
{
    Runtime() { reload(); }
    /// Script and record anew, as the environment names them: for the next instance.
    void reload();

    std::mutex mutex;
    std::condition_variable frameBegun;
    Script script;
    Recorder recorder;
    std::size_t toldMistakes = 0;

    bool hasInstance = false;
    int instanceCallsLeft = -1;
    bool requirementsAsked = false;
    XrTime now = 1'000'000'000;
    std::deque<XrEventDataBuffer> events;
    std::vector<Order> failures;

    std::vector<std::string> paths; // XrPath is the place in it, plus 1
    std::uint64_t lastHandle = 0;
    std::uint64_t sessionHandle = 0;
    std::unique_ptr<SessionObject> session;
    std::map<std::uint64_t, SpaceObject> spaces;
    std::map<std::uint64_t, SwapchainObject> swapchains;
    std::map<std::uint64_t, ActionSetObject> actionSets;
    std::map<std::uint64_t, ActionObject> actions;
    std::map<std::string, std::vector<std::pair<std::uint64_t, XrPath>>> suggested; // by profile

    XrPath pathOf(const std::string &text);
    const std::string *textOf(XrPath path) const;
    void setState(XrSessionState state);
    void pushEvent(const void *event, std::size_t size);
    /// The script's orders and one step towards the goal; before each frame.
    void step();
    /// Where a space stands in STAGE; none if what it hangs on is not tracked.
    std::optional<Eigen::Isometry3d> placeOf(const SpaceObject &space) const;
    void destroyAll();
};

Runtime &runtime();

/// A call of the program: locked, told to fail if the script says so, refused where instance or session are
/// lost, written down if it is wrong.
XrResult call(const char *name, const std::function<XrResult(Runtime &)> &body);
/// The same for calls that need the session.
XrResult sessionCall(const char *name, XrSession session,
                     const std::function<XrResult(Runtime &, SessionObject &)> &body);

template <typename Handle>
std::uint64_t number(Handle handle)
{
    return reinterpret_cast<std::uint64_t>(handle);
}
template <typename Handle>
Handle handle(std::uint64_t number)
{
    return reinterpret_cast<Handle>(number);
}

/// An OpenXR struct of that type, all else zero.
template <typename T>
T made(XrStructureType type)
{
    T value{};
    value.type = type;
    return value;
}

/// The two calls of an enumeration: how many, then all.
template <typename T, typename Fill>
XrResult enumerate(std::size_t count, std::uint32_t capacity, std::uint32_t *countOut, T *items, Fill fill)
{
    if (!countOut)
        return XR_ERROR_VALIDATION_FAILURE;
    *countOut = std::uint32_t(count);
    if (capacity == 0)
        return XR_SUCCESS;
    if (!items)
        return XR_ERROR_VALIDATION_FAILURE;
    if (capacity < count)
        return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::size_t i = 0; i < count; ++i)
        fill(items[i], i);
    return XR_SUCCESS;
}

std::optional<Eigen::Isometry3d> isometryOf(const XrPosef &pose); // none if it is not normalised
XrPosef poseOf(const Eigen::Isometry3d &place);

/// The address of a function of this runtime, null for others.
PFN_xrVoidFunction functionOf(const std::string &name);

/// Writes what a released image shows. Leaves the context's state as it was.
void dumpImage(const SwapchainObject &swapchain, const XrRect2Di &part, const std::string &file);

} // namespace ductus::xr
