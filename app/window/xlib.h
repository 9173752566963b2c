#pragma once
// Xlib, where GLFW uses it. The program itself does not link it: a GLFW for Wayland comes without it.

#include <dlfcn.h>

namespace glint {

/// Returns a function of the Xlib that GLFW has loaded; null if there is none.
template <class Function> Function* from_xlib(const char* name) {
    static void* const xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    return xlib != nullptr ? reinterpret_cast<Function*>(::dlsym(xlib, name)) : nullptr;
}

}  // namespace glint
