#include "layerpainter/vr/actions/hand_actions.h"

#include "layerpainter/vr/actions/profile_bindings.h"
#include "layerpainter/vr/session/headset_session.h"
#include "layerpainter/vr/session/xr_words.h"

#include <algorithm>
#include <cstdio>

namespace ductus {

namespace {

constexpr const char *entering = "Entering VR";
constexpr const char *painting = "Painting in VR";

struct ActionName
{
    HandAction action;
    const char *name, *shown;
    XrActionType type;
};

// The shown names appear in the headset software's own binding editor, which knows no languages of ours.
constexpr ActionName names[] = {
    {HandAction::Grip, "grip", "Hand", XR_ACTION_TYPE_POSE_INPUT},
    {HandAction::Aim, "aim", "Brush and pointer", XR_ACTION_TYPE_POSE_INPUT},
    {HandAction::Trigger, "trigger", "Paint, choose, press", XR_ACTION_TYPE_FLOAT_INPUT},
    {HandAction::Squeeze, "squeeze", "Grab the canvas", XR_ACTION_TYPE_FLOAT_INPUT},
    {HandAction::Stick, "stick", "Undo, redo, brush size, turn panels", XR_ACTION_TYPE_VECTOR2F_INPUT},
    {HandAction::Primary, "primary", "Delete; the other hand: paint or select", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {HandAction::Secondary, "secondary", "Pick colour; the other hand: panels", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {HandAction::Haptic, "haptic", "Feeling", XR_ACTION_TYPE_VIBRATION_OUTPUT},
};

constexpr XrPosef here{{0, 0, 0, 1}, {0, 0, 0}};

} // namespace

Result<std::unique_ptr<HandActions>> HandActions::create(const HeadsetRuntime &runtime,
                                                         const HeadsetSession &session)
{
    std::unique_ptr<HandActions> actions(new HandActions(runtime, session));
    actions->mHands[0] = runtime.path("/user/hand/left");
    actions->mHands[1] = runtime.path("/user/hand/right");
    for (Result<void> (HandActions::*step)() :
         {&HandActions::createActions, &HandActions::suggestBindings, &HandActions::createSpaces})
        if (Result<void> done = (actions.get()->*step)(); !done)
            return done.error();
    auto attach = xrStruct<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    attach.countActionSets = 1;
    attach.actionSets = &actions->mSet;
    if (const XrResult done = xrAttachSessionActionSets(session.handle(), &attach); XR_FAILED(done))
        return xrError(entering, "xrAttachSessionActionSets", done);
    return actions;
}

HandActions::~HandActions()
{
    for (const XrSpace space : {mGrips[0], mGrips[1], mAims[0], mAims[1]})
        if (space != XR_NULL_HANDLE)
            xrDestroySpace(space);
    if (mSet != XR_NULL_HANDLE)
        xrDestroyActionSet(mSet);
}

Result<void> HandActions::createActions()
{
    auto set = xrStruct<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::snprintf(set.actionSetName, sizeof set.actionSetName, "painting");
    std::snprintf(set.localizedActionSetName, sizeof set.localizedActionSetName, "Painting");
    if (const XrResult made = xrCreateActionSet(mRuntime.instance(), &set, &mSet); XR_FAILED(made))
        return xrError(entering, "xrCreateActionSet", made);
    for (const ActionName &name : names) {
        auto info = xrStruct<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
        std::snprintf(info.actionName, sizeof info.actionName, "%s", name.name);
        std::snprintf(info.localizedActionName, sizeof info.localizedActionName, "%s", name.shown);
        info.actionType = name.type;
        info.countSubactionPaths = 2;
        info.subactionPaths = mHands;
        if (const XrResult made = xrCreateAction(mSet, &info, &mActions[int(name.action)]); XR_FAILED(made))
            return xrError(entering, "xrCreateAction", made);
    }
    return {};
}

// A runtime may not know a controller; it is enough if one of them is known.
Result<void> HandActions::suggestBindings()
{
    XrResult last = XR_SUCCESS;
    bool isAnyTaken = false;
    for (const ControllerProfile &profile : controllerProfiles()) {
        std::vector<XrActionSuggestedBinding> bindings;
        for (const SuggestedBinding &binding : profile.bindings)
            bindings.push_back({mActions[int(binding.action)], mRuntime.path(binding.path)});
        auto suggestion =
            xrStruct<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
        suggestion.interactionProfile = mRuntime.path(profile.path);
        suggestion.countSuggestedBindings = std::uint32_t(bindings.size());
        suggestion.suggestedBindings = bindings.data();
        const XrResult taken = xrSuggestInteractionProfileBindings(mRuntime.instance(), &suggestion);
        isAnyTaken |= XR_SUCCEEDED(taken);
        if (XR_FAILED(taken))
            last = taken;
    }
    if (!isAnyTaken)
        return xrError(entering, "xrSuggestInteractionProfileBindings", last);
    return {};
}

Result<void> HandActions::createSpaces()
{
    for (int hand = 0; hand < 2; ++hand) {
        const std::pair<HandAction, XrSpace *> wanted[] = {{HandAction::Grip, &mGrips[hand]},
                                                           {HandAction::Aim, &mAims[hand]}};
        for (const auto &[action, space] : wanted) {
            auto info = xrStruct<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
            info.action = mActions[int(action)];
            info.subactionPath = mHands[hand];
            info.poseInActionSpace = here;
            if (const XrResult made = xrCreateActionSpace(mSession.handle(), &info, space); XR_FAILED(made))
                return xrError(entering, "xrCreateActionSpace", made);
        }
    }
    return {};
}

Result<void> HandActions::read(XrTime time, HandsInput &input)
{
    input.hands = {};
    const XrActiveActionSet active{mSet, XR_NULL_PATH};
    auto info = xrStruct<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
    info.countActiveActionSets = 1;
    info.activeActionSets = &active;
    const XrResult synced = xrSyncActions(mSession.handle(), &info);
    if (XR_FAILED(synced))
        return xrError(painting, "xrSyncActions", synced);
    if (synced == XR_SESSION_NOT_FOCUSED)
        return {};
    for (int hand = 0; hand < 2; ++hand)
        if (Result<void> done = readHand(hand, time, input.hands[std::size_t(hand)]); !done)
            return done;
    return {};
}

namespace {

// Whether the place is known.
Result<bool> locate(XrSpace space, XrSpace room, XrTime time, RoomPose &pose)
{
    auto location = xrStruct<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
    if (const XrResult located = xrLocateSpace(space, room, time, &location); XR_FAILED(located))
        return xrError(painting, "xrLocateSpace", located);
    constexpr XrSpaceLocationFlags needed =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    if ((location.locationFlags & needed) != needed)
        return false;
    const XrPosef &p = location.pose;
    pose.position = {p.position.x, p.position.y, p.position.z};
    pose.orientation =
        Eigen::Quaterniond(p.orientation.w, p.orientation.x, p.orientation.y, p.orientation.z).normalized();
    return true;
}

} // namespace

Result<void> HandActions::readHand(int hand, XrTime time, HandInput &input)
{
    const XrSession session = mSession.handle();
    auto info = xrStruct<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    info.subactionPath = mHands[hand];
    const auto of = [&](HandAction action) {
        info.action = mActions[int(action)];
        return &info;
    };
    auto pose = xrStruct<XrActionStatePose>(XR_TYPE_ACTION_STATE_POSE);
    XrResult got = xrGetActionStatePose(session, of(HandAction::Aim), &pose);
    if (XR_FAILED(got))
        return xrError(painting, "xrGetActionStatePose", got);
    if (!pose.isActive)
        return {};
    const Result<bool> aims = locate(mAims[hand], mSession.room(), time, input.aim);
    const Result<bool> grips = locate(mGrips[hand], mSession.room(), time, input.grip);
    for (const Result<bool> *known : {&aims, &grips})
        if (!*known)
            return known->error();
    if (!*aims || !*grips)
        return {};
    input.isTracked = true;
    for (const auto &[action, value] :
         {std::pair(HandAction::Trigger, &input.trigger), std::pair(HandAction::Squeeze, &input.squeeze)}) {
        auto state = xrStruct<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
        if (got = xrGetActionStateFloat(session, of(action), &state); XR_FAILED(got))
            return xrError(painting, "xrGetActionStateFloat", got);
        *value = state.isActive ? std::clamp(double(state.currentState), 0.0, 1.0) : 0;
    }
    auto stick = xrStruct<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
    if (got = xrGetActionStateVector2f(session, of(HandAction::Stick), &stick); XR_FAILED(got))
        return xrError(painting, "xrGetActionStateVector2f", got);
    if (stick.isActive)
        input.stick = {stick.currentState.x, stick.currentState.y};
    for (const auto &[action, value] : {std::pair(HandAction::Primary, &input.primary),
                                        std::pair(HandAction::Secondary, &input.secondary)}) {
        auto state = xrStruct<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
        if (got = xrGetActionStateBoolean(session, of(action), &state); XR_FAILED(got))
            return xrError(painting, "xrGetActionStateBoolean", got);
        *value = state.isActive && state.currentState;
    }
    return {};
}

void HandActions::tick(Hand hand, double strength, double seconds)
{
    auto vibration = xrStruct<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    vibration.amplitude = float(std::clamp(strength, 0.0, 1.0));
    vibration.duration = seconds > 0 ? XrDuration(seconds * 1e9) : XR_MIN_HAPTIC_DURATION;
    vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
    auto info = xrStruct<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
    info.action = mActions[int(HandAction::Haptic)];
    info.subactionPath = mHands[hand == Hand::Left ? 0 : 1];
    // A tick that cannot be felt is no reason to stop painting.
    (void)xrApplyHapticFeedback(mSession.handle(), &info,
                                reinterpret_cast<const XrHapticBaseHeader *>(&vibration));
}

std::string HandActions::profile(Hand hand) const
{
    auto state = xrStruct<XrInteractionProfileState>(XR_TYPE_INTERACTION_PROFILE_STATE);
    const XrResult got =
        xrGetCurrentInteractionProfile(mSession.handle(), mHands[hand == Hand::Left ? 0 : 1], &state);
    return XR_SUCCEEDED(got) ? mRuntime.text(state.interactionProfile) : std::string();
}

} // namespace ductus
