#include "device.h"

#include <new>
#include <string>

#include "preshape/base/error.h"

void throw_noted(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  const char* why = error == RTC_ERROR_UNSUPPORTED_CPU ? "it does not support this processor" : "it failed";
  throw preshape::PluginError("Embree cannot be used: " + std::string(why) + " (its error " +
                              std::to_string(error) + "); choose collision = \"fcl\"");
}

DeviceHandle open_device() {
  // All threads are ours to bring: fewer in number (threads=1) would bind the whole process, TBB's other
  // users too.
  DeviceHandle device(rtcNewDevice("threads=0,user_threads=1024"), [](RTCDevice opened) {
    if (opened) rtcReleaseDevice(opened);
  });
  throw_noted(device.get());
  return device;
}
