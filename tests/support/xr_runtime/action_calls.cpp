// Paths, action sets, actions and their bindings.
#include "support/xr_runtime/calls.h"
#include "support/xr_runtime/profiles.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace ductus::xr {

namespace {

// Section 2.7 and 6.2 of the specification: letters of paths and names.
bool isName(const std::string &text, bool isPath)
{
    return !text.empty() && std::ranges::all_of(text, [&](char c) {
        return std::islower(static_cast<unsigned char>(c)) || std::isdigit(static_cast<unsigned char>(c)) ||
               c == '-' || c == '.' || c == '_' || (isPath && c == '/');
    });
}

} // namespace

XrResult XRAPI_CALL stringToPath(XrInstance, const char *string, XrPath *path)
{
    return call("xrStringToPath", [&](Runtime &r) {
        if (!string || string[0] != '/' || !isName(string, true))
            return XR_ERROR_PATH_FORMAT_INVALID;
        *path = r.pathOf(string);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL pathToString(XrInstance, XrPath path, std::uint32_t capacity, std::uint32_t *count,
                                 char *buffer)
{
    return call("xrPathToString", [&](Runtime &r) {
        const std::string *text = r.textOf(path);
        if (!text)
            return XR_ERROR_PATH_INVALID;
        return enumerate(text->size() + 1, capacity, count, buffer,
                         [&](char &c, std::size_t i) { c = text->c_str()[i]; });
    });
}

XrResult XRAPI_CALL createActionSet(XrInstance, const XrActionSetCreateInfo *info, XrActionSet *set)
{
    return call("xrCreateActionSet", [&](Runtime &r) {
        const std::string name = info->actionSetName;
        if (!isName(name, false))
            return XR_ERROR_PATH_FORMAT_INVALID;
        if (info->localizedActionSetName[0] == '\0')
            return XR_ERROR_LOCALIZED_NAME_INVALID;
        for (const auto &[handle, other] : r.actionSets)
            if (other.name == name)
                return XR_ERROR_NAME_DUPLICATED;
        const std::uint64_t made = ++r.lastHandle;
        r.actionSets[made] = {name, false};
        *set = handle<XrActionSet>(made);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroyActionSet(XrActionSet set)
{
    return call("xrDestroyActionSet", [&](Runtime &r) {
        std::erase_if(r.actions, [&](const auto &action) { return action.second.set == number(set); });
        return r.actionSets.erase(number(set)) ? XR_SUCCESS : XR_ERROR_HANDLE_INVALID;
    });
}

XrResult XRAPI_CALL createAction(XrActionSet set, const XrActionCreateInfo *info, XrAction *action)
{
    return call("xrCreateAction", [&](Runtime &r) {
        const auto owner = r.actionSets.find(number(set));
        if (owner == r.actionSets.end())
            return XR_ERROR_HANDLE_INVALID;
        if (owner->second.isAttached)
            return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
        if (!isName(info->actionName, false))
            return XR_ERROR_PATH_FORMAT_INVALID;
        if (info->localizedActionName[0] == '\0')
            return XR_ERROR_LOCALIZED_NAME_INVALID;
        for (const auto &[handle, other] : r.actions)
            if (other.set == number(set) && other.name == info->actionName)
                return XR_ERROR_NAME_DUPLICATED;
        ActionObject made;
        made.set = number(set);
        made.name = info->actionName;
        made.type = info->actionType;
        for (std::uint32_t i = 0; i < info->countSubactionPaths; ++i) {
            const std::string *path = r.textOf(info->subactionPaths[i]);
            if (!path || (*path != "/user/hand/left" && *path != "/user/hand/right"))
                return XR_ERROR_PATH_UNSUPPORTED;
            made.subactions.push_back(info->subactionPaths[i]);
        }
        const std::uint64_t name = ++r.lastHandle;
        r.actions[name] = std::move(made);
        *action = handle<XrAction>(name);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroyAction(XrAction action)
{
    return call("xrDestroyAction", [&](Runtime &r) {
        return r.actions.erase(number(action)) ? XR_SUCCESS : XR_ERROR_HANDLE_INVALID;
    });
}

XrResult XRAPI_CALL suggestInteractionProfileBindings(XrInstance,
                                                      const XrInteractionProfileSuggestedBinding *suggestion)
{
    return call("xrSuggestInteractionProfileBindings", [&](Runtime &r) {
        const std::string *profile = r.textOf(suggestion->interactionProfile);
        if (!profile || !isKnownProfile(*profile))
            return XR_ERROR_PATH_UNSUPPORTED;
        if (suggestion->countSuggestedBindings == 0)
            return XR_ERROR_VALIDATION_FAILURE;
        std::vector<std::pair<std::uint64_t, XrPath>> bindings;
        for (std::uint32_t i = 0; i < suggestion->countSuggestedBindings; ++i) {
            const XrActionSuggestedBinding &one = suggestion->suggestedBindings[i];
            const auto action = r.actions.find(number(one.action));
            if (action == r.actions.end())
                return XR_ERROR_HANDLE_INVALID;
            if (r.actionSets[action->second.set].isAttached)
                return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
            const std::string *path = r.textOf(one.binding);
            if (!path || !hasPath(*profile, *path)) {
                r.recorder.line("mistake binding " + *profile + " " + (path ? *path : ""));
                return XR_ERROR_PATH_UNSUPPORTED;
            }
            bindings.emplace_back(number(one.action), one.binding);
        }
        r.suggested[*profile] = std::move(bindings);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL attachSessionActionSets(XrSession session, const XrSessionActionSetsAttachInfo *info)
{
    return sessionCall("xrAttachSessionActionSets", session, [&](Runtime &r, SessionObject &s) {
        if (s.setsAttached)
            return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
        if (info->countActionSets == 0)
            return XR_ERROR_VALIDATION_FAILURE;
        for (std::uint32_t i = 0; i < info->countActionSets; ++i) {
            const auto set = r.actionSets.find(number(info->actionSets[i]));
            if (set == r.actionSets.end())
                return XR_ERROR_HANDLE_INVALID;
            set->second.isAttached = true;
        }
        s.setsAttached = true;
        return XR_SUCCESS;
    });
}

} // namespace ductus::xr
