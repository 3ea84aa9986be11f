#include "support/xr_runtime/runtime.h"

#include "support/xr_runtime/loader_interface.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace ductus::xr {

namespace {

const char *environment(const char *name)
{
    const char *value = std::getenv(name);
    return value ? value : "";
}

constexpr int framesUntilLost = 5;

std::optional<XrSessionState> stateOf(const std::string &word)
{
    if (word == "focused")
        return XR_SESSION_STATE_FOCUSED;
    if (word == "visible")
        return XR_SESSION_STATE_VISIBLE;
    if (word == "synchronized")
        return XR_SESSION_STATE_SYNCHRONIZED;
    if (word == "stopping" || word == "exiting")
        return XR_SESSION_STATE_STOPPING;
    if (word == "ready")
        return XR_SESSION_STATE_READY;
    return std::nullopt;
}

} // namespace

Runtime &runtime()
{
    static Runtime one;
    return one;
}

void Runtime::reload()
{
    script = Script(environment("DUCTUS_XR_SCRIPT"));
    recorder = Recorder(environment("DUCTUS_XR_RECORD"));
    toldMistakes = 0;
}

XrPath Runtime::pathOf(const std::string &text)
{
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (paths[i] == text)
            return i + 1;
    paths.push_back(text);
    return paths.size();
}

const std::string *Runtime::textOf(XrPath path) const
{
    return path >= 1 && path <= paths.size() ? &paths[path - 1] : nullptr;
}

void Runtime::pushEvent(const void *event, std::size_t size)
{
    XrEventDataBuffer buffer{};
    std::memcpy(&buffer, event, size);
    events.push_back(buffer);
}

void Runtime::setState(XrSessionState state)
{
    session->state = state;
    auto event = made<XrEventDataSessionStateChanged>(XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED);
    event.session = handle<XrSession>(sessionHandle);
    event.state = state;
    event.time = now;
    pushEvent(&event, sizeof event);
    recorder.line("state " + std::to_string(int(state)));
}

void Runtime::step()
{
    for (const Order &order : script.takeOrders()) {
        if (order.kind == Order::Kind::Fail) {
            failures.push_back(order);
        } else if (order.kind == Order::Kind::LoseInstance) {
            auto event = made<XrEventDataInstanceLossPending>(XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING);
            event.lossTime = now + framesUntilLost * framePeriod;
            pushEvent(&event, sizeof event);
            instanceCallsLeft = framesUntilLost;
        } else if (session && order.kind == Order::Kind::LoseSession) {
            setState(XR_SESSION_STATE_LOSS_PENDING);
            session->callsLeft = framesUntilLost;
        } else if (const auto goal = stateOf(order.word); session && goal) {
            if (*goal == XR_SESSION_STATE_READY && session->state == XR_SESSION_STATE_IDLE)
                setState(XR_SESSION_STATE_READY);
            session->goal = *goal == XR_SESSION_STATE_READY ? XR_SESSION_STATE_FOCUSED : *goal;
            session->isLeaving = order.word == "exiting";
        } else if (order.kind == Order::Kind::State) {
            recorder.line("mistake state " + order.word);
        }
    }
    if (!session || !session->isRunning || session->state == XR_SESSION_STATE_LOSS_PENDING)
        return;
    // The states stand one above the other, but for STOPPING, which lies below SYNCHRONIZED.
    const auto height = [](XrSessionState state) {
        return state == XR_SESSION_STATE_STOPPING ? int(XR_SESSION_STATE_READY) : int(state);
    };
    const int is = height(session->state), wanted = height(session->goal);
    if (session->state == XR_SESSION_STATE_STOPPING || is == wanted)
        return;
    const int next = is < wanted ? is + 1 : is - 1;
    setState(next == int(XR_SESSION_STATE_READY) ? XR_SESSION_STATE_STOPPING : XrSessionState(next));
}

std::optional<Eigen::Isometry3d> Runtime::placeOf(const SpaceObject &space) const
{
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    const auto put = [&place](const Pose &pose) {
        place.linear() = pose.orientation.toRotationMatrix();
        place.translation() = pose.position;
    };
    if (space.action) {
        if (!script.scene().tracked[std::size_t(space.hand)])
            return std::nullopt;
        put(script.scene().hands[std::size_t(space.hand)]);
    } else if (space.reference == XR_REFERENCE_SPACE_TYPE_LOCAL) {
        place.translation() = Eigen::Vector3d(0, localHeight, 0);
    } else if (space.reference == XR_REFERENCE_SPACE_TYPE_VIEW) {
        put(script.scene().head);
    }
    return place * space.offset;
}

void Runtime::destroyAll()
{
    session.reset();
    spaces.clear();
    swapchains.clear();
    actionSets.clear();
    actions.clear();
    suggested.clear();
    events.clear();
    failures.clear();
    hasInstance = requirementsAsked = false;
    instanceCallsLeft = -1;
}

XrResult call(const char *name, const std::function<XrResult(Runtime &)> &body)
{
    Runtime &r = runtime();
    const std::lock_guard lock(r.mutex);
    if (r.instanceCallsLeft == 0 && std::string_view(name).find("Destroy") == std::string_view::npos)
        return XR_ERROR_INSTANCE_LOST;
    for (Order &order : r.failures)
        if (order.word == name && order.times > 0) {
            --order.times;
            return XrResult(order.code);
        }
    const XrResult result = body(r);
    if (XR_FAILED(result))
        r.recorder.line("error " + std::string(name) + " " + std::to_string(result));
    return result;
}

XrResult sessionCall(const char *name, XrSession given,
                     const std::function<XrResult(Runtime &, SessionObject &)> &body)
{
    bool isLost = false;
    const XrResult result = call(name, [&](Runtime &r) {
        if (!r.session || number(given) != r.sessionHandle)
            return XR_ERROR_HANDLE_INVALID;
        isLost = r.session->callsLeft == 0;
        return isLost ? XR_SUCCESS : body(r, *r.session);
    });
    return isLost ? XR_ERROR_SESSION_LOST : result;
}

std::optional<Eigen::Isometry3d> isometryOf(const XrPosef &pose)
{
    const Eigen::Quaterniond q(pose.orientation.w, pose.orientation.x, pose.orientation.y,
                               pose.orientation.z);
    const Eigen::Vector3d at(pose.position.x, pose.position.y, pose.position.z);
    if (!(std::abs(q.norm() - 1) < 0.01) || !at.allFinite())
        return std::nullopt;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.linear() = q.normalized().toRotationMatrix();
    place.translation() = at;
    return place;
}

XrPosef poseOf(const Eigen::Isometry3d &place)
{
    const Eigen::Quaterniond q(place.linear());
    const Eigen::Vector3d &at = place.translation();
    return {{float(q.x()), float(q.y()), float(q.z()), float(q.w())},
            {float(at.x()), float(at.y()), float(at.z())}};
}

namespace {

XrResult XRAPI_CALL getInstanceProcAddr(XrInstance, const char *name, PFN_xrVoidFunction *function)
{
    if (!name || !function)
        return XR_ERROR_VALIDATION_FAILURE;
    *function = std::string_view(name) == "xrGetInstanceProcAddr"
                    ? reinterpret_cast<PFN_xrVoidFunction>(&getInstanceProcAddr)
                    : functionOf(name);
    return *function ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
}

} // namespace

} // namespace ductus::xr

XrResult xrNegotiateLoaderRuntimeInterface(const ductus::xr::LoaderInfo *loader,
                                           ductus::xr::RuntimeRequest *request)
{
    using namespace ductus::xr;
    const bool understood =
        loader && request && loader->structType == loaderInfoType && loader->structVersion == 1 &&
        loader->structSize == sizeof(LoaderInfo) && request->structType == runtimeRequestType &&
        request->structVersion == 1 && request->structSize == sizeof(RuntimeRequest) &&
        loader->minInterfaceVersion <= interfaceVersion && loader->maxInterfaceVersion >= interfaceVersion &&
        loader->minApiVersion <= XR_CURRENT_API_VERSION && loader->maxApiVersion >= XR_CURRENT_API_VERSION;
    if (!understood)
        return XR_ERROR_INITIALIZATION_FAILED;
    request->runtimeInterfaceVersion = interfaceVersion;
    request->runtimeApiVersion = XR_CURRENT_API_VERSION;
    request->getInstanceProcAddr = &getInstanceProcAddr;
    return XR_SUCCESS;
}
