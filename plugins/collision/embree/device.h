#pragma once

#include <memory>

#include <embree3/rtcore.h>

/// Embree's handles, released with their owner. A scene keeps its device.
using DeviceHandle = std::shared_ptr<RTCDeviceTy>;
using SceneHandle = std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)>;

/// A device that builds in the calling thread: Embree starts none of its own.
/// @throws PluginError when Embree refuses this machine
DeviceHandle open_device();

/// Throws what Embree has noted in this thread since the last call, if anything.
/// @throws std::bad_alloc, PluginError
void throw_noted(RTCDevice device);
