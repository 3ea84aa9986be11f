// What the hands do: action states, the profile in use, haptics.
#include "support/xr_runtime/calls.h"

#include <cstdio>

namespace ductus::xr {

namespace {

// The profile the script names, else the simple one, if the program suggested bindings for it.
std::string profileInUse(const Runtime &r)
{
    const std::string simple = "/interaction_profiles/khr/simple_controller";
    if (r.suggested.contains(r.script.scene().profile))
        return r.script.scene().profile;
    return r.suggested.contains(simple) ? simple : "";
}

int handOf(const std::string &path)
{
    return path.starts_with("/user/hand/right") ? 2 : 1;
}

// A component, or the two of a stick. Components without a line in the script are at rest.
ActionState valueOf(const Scene &scene, const std::string &path)
{
    const auto read = [&](const std::string &name) {
        const auto found = scene.inputs.find(name);
        return found == scene.inputs.end() ? 0.f : float(found->second);
    };
    ActionState state;
    state.x = read(path);
    if (path.ends_with("thumbstick") || path.ends_with("trackpad")) {
        state.x = read(path + "/x");
        state.y = read(path + "/y");
    } else if (state.x == 0) { // the parent of components: its value or click
        state.x = std::max(read(path + "/value"), read(path + "/click"));
    }
    return state;
}

void syncAction(Runtime &r, std::uint64_t name, ActionObject &action, bool hasFocus)
{
    ActionState now[3];
    const auto bindings = r.suggested.find(r.session->profile);
    if (hasFocus && bindings != r.suggested.end()) {
        for (const auto &[bound, path] : bindings->second) {
            if (bound != name)
                continue;
            const std::string &text = *r.textOf(path);
            const int hand = handOf(text);
            if (!r.script.scene().tracked[std::size_t(hand - 1)])
                continue;
            ActionState value = valueOf(r.script.scene(), text);
            if (action.type == XR_ACTION_TYPE_BOOLEAN_INPUT)
                value.x = value.x > 0.5f ? 1.f : 0.f;
            for (const int i : {0, hand}) {
                now[i].isActive = true;
                if (std::abs(value.x) + std::abs(value.y) >= std::abs(now[i].x) + std::abs(now[i].y)) {
                    now[i].x = value.x;
                    now[i].y = value.y;
                }
            }
        }
    }
    for (int i = 0; i < 3; ++i) {
        now[i].changed = action.states[i].isActive && now[i].isActive &&
                         (now[i].x != action.states[i].x || now[i].y != action.states[i].y);
        now[i].changeTime = now[i].changed ? r.now : action.states[i].changeTime;
        action.states[i] = now[i];
    }
}

// What a boolean, a number and a pair tell besides their value.
template <typename State>
void tellChange(const ActionState &s, State &state)
{
    state.changedSinceLastSync = s.changed;
    state.lastChangeTime = s.changeTime;
    state.isActive = s.isActive;
}

// \a name: of the C function; the state that is asked for, or an error.
XrResult stateOf(const char *name, XrSession session, const XrActionStateGetInfo *info, XrActionType type,
                 const std::function<void(const ActionState &)> &take)
{
    return sessionCall(name, session, [&](Runtime &r, SessionObject &s) {
        const auto action = r.actions.find(number(info->action));
        if (action == r.actions.end())
            return XR_ERROR_HANDLE_INVALID;
        if (!s.setsAttached || !r.actionSets[action->second.set].isAttached)
            return XR_ERROR_ACTIONSET_NOT_ATTACHED;
        if (action->second.type != type)
            return XR_ERROR_ACTION_TYPE_MISMATCH;
        int hand = 0;
        if (info->subactionPath != XR_NULL_PATH) {
            const std::string *path = r.textOf(info->subactionPath);
            if (!path || std::ranges::find(action->second.subactions, info->subactionPath) ==
                             action->second.subactions.end())
                return XR_ERROR_PATH_UNSUPPORTED;
            hand = handOf(*path);
        }
        take(action->second.states[hand]);
        return XR_SUCCESS;
    });
}

} // namespace

XrResult XRAPI_CALL syncActions(XrSession session, const XrActionsSyncInfo *info)
{
    return sessionCall("xrSyncActions", session, [&](Runtime &r, SessionObject &s) {
        for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i) {
            const auto set = r.actionSets.find(number(info->activeActionSets[i].actionSet));
            if (set == r.actionSets.end() || !set->second.isAttached)
                return XR_ERROR_ACTIONSET_NOT_ATTACHED;
        }
        s.hasSynced = true;
        if (const std::string profile = profileInUse(r); profile != s.profile) {
            s.profile = profile;
            auto event =
                made<XrEventDataInteractionProfileChanged>(XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED);
            event.session = session;
            r.pushEvent(&event, sizeof event);
        }
        const bool hasFocus = s.state == XR_SESSION_STATE_FOCUSED;
        for (auto &[name, action] : r.actions)
            syncAction(r, name, action, hasFocus);
        return hasFocus ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
    });
}

XrResult XRAPI_CALL getCurrentInteractionProfile(XrSession session, XrPath user,
                                                 XrInteractionProfileState *state)
{
    return sessionCall("xrGetCurrentInteractionProfile", session, [&](Runtime &r, SessionObject &s) {
        if (!s.setsAttached)
            return XR_ERROR_ACTIONSET_NOT_ATTACHED;
        if (!r.textOf(user))
            return XR_ERROR_PATH_INVALID;
        state->interactionProfile = s.profile.empty() ? XR_NULL_PATH : r.pathOf(s.profile);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL getActionStateBoolean(XrSession session, const XrActionStateGetInfo *info,
                                          XrActionStateBoolean *state)
{
    return stateOf("xrGetActionStateBoolean", session, info, XR_ACTION_TYPE_BOOLEAN_INPUT,
                   [&](const ActionState &s) {
                       state->currentState = s.x > 0.5f;
                       tellChange(s, *state);
                   });
}

XrResult XRAPI_CALL getActionStateFloat(XrSession session, const XrActionStateGetInfo *info,
                                        XrActionStateFloat *state)
{
    return stateOf("xrGetActionStateFloat", session, info, XR_ACTION_TYPE_FLOAT_INPUT,
                   [&](const ActionState &s) {
                       state->currentState = s.x;
                       tellChange(s, *state);
                   });
}

XrResult XRAPI_CALL getActionStateVector2f(XrSession session, const XrActionStateGetInfo *info,
                                           XrActionStateVector2f *state)
{
    return stateOf("xrGetActionStateVector2f", session, info, XR_ACTION_TYPE_VECTOR2F_INPUT,
                   [&](const ActionState &s) {
                       state->currentState = {s.x, s.y};
                       tellChange(s, *state);
                   });
}

XrResult XRAPI_CALL getActionStatePose(XrSession session, const XrActionStateGetInfo *info,
                                       XrActionStatePose *state)
{
    return stateOf("xrGetActionStatePose", session, info, XR_ACTION_TYPE_POSE_INPUT,
                   [&](const ActionState &s) { state->isActive = s.isActive; });
}

XrResult XRAPI_CALL applyHapticFeedback(XrSession session, const XrHapticActionInfo *info,
                                        const XrHapticBaseHeader *haptic)
{
    return sessionCall("xrApplyHapticFeedback", session, [&](Runtime &r, SessionObject &s) {
        const auto action = r.actions.find(number(info->action));
        if (action == r.actions.end())
            return XR_ERROR_HANDLE_INVALID;
        if (action->second.type != XR_ACTION_TYPE_VIBRATION_OUTPUT)
            return XR_ERROR_ACTION_TYPE_MISMATCH;
        const auto *vibration = reinterpret_cast<const XrHapticVibration *>(haptic);
        if (vibration->type != XR_TYPE_HAPTIC_VIBRATION || vibration->amplitude < 0 ||
            vibration->amplitude > 1)
            return XR_ERROR_VALIDATION_FAILURE;
        if (s.state != XR_SESSION_STATE_FOCUSED)
            return XR_SESSION_NOT_FOCUSED;
        const std::string *path = r.textOf(info->subactionPath);
        char line[96];
        std::snprintf(line, sizeof line, "haptic %s %.2f %lld",
                      path ? path->substr(path->rfind('/') + 1).c_str() : "both",
                      double(vibration->amplitude),
                      static_cast<long long>(vibration->duration < 0 ? -1 : vibration->duration / 1'000'000));
        r.recorder.line(line);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL stopHapticFeedback(XrSession session, const XrHapticActionInfo *)
{
    return sessionCall("xrStopHapticFeedback", session,
                       [](Runtime &, SessionObject &) { return XR_SUCCESS; });
}

} // namespace ductus::xr
