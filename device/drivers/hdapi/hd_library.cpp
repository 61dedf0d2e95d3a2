#include "device/drivers/hdapi/hd_library.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

namespace vallecula::device::hdapi {
namespace {

constexpr const char* kVariable = "VALLECULA_LIBHD";

/// How a path is told to a person: what the variable names may lie in someone's home.
std::string told(const std::string& path) {
  const char* chosen = std::getenv(kVariable);
  return chosen != nullptr && path == chosen ? std::string("$") + kVariable : path;
}

/// The loader's reason without the path it begins with.
std::string reason(const std::string& path) {
  const char* text = dlerror();
  std::string why = text != nullptr ? text : "unknown reason";
  if (why.rfind(path + ": ", 0) == 0) why.erase(0, path.size() + 2);
  // For a library of another kind of processor the loader, too, says that there is no such file.
  const bool absent = why.find("No such file") != std::string::npos && why.rfind("cannot open", 0) == 0;
  std::error_code error;
  if (absent && !std::filesystem::exists(path, error)) return "not there";
  if (absent || why.find("ELF") != std::string::npos) {
    why = (absent ? std::string() : why + ": ") + "no library for this kind of processor, or a damaged file";
  }
  return why;
}

template <class Function>
void resolve(void* library, const char* name, Function*& function, std::string& missing) {
  function = reinterpret_cast<Function*>(dlsym(library, name));
  if (function == nullptr) missing += std::string(missing.empty() ? "" : ", ") + name;
}

}  // namespace

std::vector<std::string> library_paths() {
  std::vector<std::string> paths;
  if (const char* chosen = std::getenv(kVariable); chosen != nullptr && *chosen != '\0') paths.emplace_back(chosen);
  for (const char* path : {"libHD.so", "libHD.so.3.4", "libHD.so.3", "/usr/lib/libHD.so", "/usr/lib/libHD.so.3.4.0",
                           "/usr/lib64/libHD.so", "/usr/lib/x86_64-linux-gnu/libHD.so", "/usr/local/lib/libHD.so",
                           "/opt/OpenHaptics/Developer/3.4-0/lib64/libHD.so", "/opt/OpenHaptics/lib/libHD.so",
                           "/opt/geomagic_touch_device_driver/lib/libHD.so"}) {
    paths.emplace_back(path);
  }
  return paths;
}

Functions load_library(const std::vector<std::string>& paths) {
  void* library = nullptr;
  std::string found, tried;
  for (const std::string& path : paths) {
    dlerror();
    library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) {
      found = path;
      break;
    }
    tried += (tried.empty() ? "" : "; ") + told(path) + ": " + reason(path);
  }
  if (library == nullptr) {
    throw HdError("the device's library libHD.so cannot be loaded",
                  std::string("Install OpenHaptics and the Touch driver from 3D Systems, or let ") + kVariable +
                      " name the library's file (tried " + tried + ")");
  }
  Functions hd;
  std::string missing;
  resolve(library, "hdInitDevice", hd.init_device, missing);
  resolve(library, "hdDisableDevice", hd.disable_device, missing);
  resolve(library, "hdMakeCurrentDevice", hd.make_current, missing);
  resolve(library, "hdBeginFrame", hd.begin_frame, missing);
  resolve(library, "hdEndFrame", hd.end_frame, missing);
  resolve(library, "hdGetError", hd.get_error, missing);
  resolve(library, "hdGetErrorString", hd.error_text, missing);
  resolve(library, "hdEnable", hd.enable, missing);
  resolve(library, "hdDisable", hd.disable, missing);
  resolve(library, "hdGetIntegerv", hd.get_integers, missing);
  resolve(library, "hdGetDoublev", hd.get_doubles, missing);
  resolve(library, "hdSetDoublev", hd.set_doubles, missing);
  resolve(library, "hdGetString", hd.get_string, missing);
  resolve(library, "hdCheckCalibration", hd.check_calibration, missing);
  resolve(library, "hdUpdateCalibration", hd.update_calibration, missing);
  resolve(library, "hdScheduleAsynchronous", hd.schedule, missing);
  resolve(library, "hdUnschedule", hd.unschedule, missing);
  resolve(library, "hdStartScheduler", hd.start_scheduler, missing);
  resolve(library, "hdStopScheduler", hd.stop_scheduler, missing);
  if (!missing.empty()) {
    throw HdError("the library " + told(found) + " is not OpenHaptics' HDAPI, or too old a one; it lacks " + missing,
                  "Install OpenHaptics 3.4 or newer");
  }
  return hd;
}

}  // namespace vallecula::device::hdapi
