// SPDX-License-Identifier: Apache-2.0
// A device that renders frames: what the rest of the renderer knows of a backend. One virtual call a frame; everything
// behind it is one template (frame_pipeline.h).
#pragma once
#include "kernels/aov_sample.h"
#include "kernels/cloud.h"
#include "kernels/motion.h"
#include "parser/scene_program.h"
#include "renderer/frame_step.h"
#include "renderer/image.h"
#include "renderer/method_record.h"

#include <array>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace proxima {

/// `automatic` is what users may ask for: float32 for a scene that float holds, see float_fit.h, and otherwise float64.
/// Renderers are given one of the two.
enum class Precision { float32, float64, automatic };

constexpr Precision chosen_precision(Precision asked, bool float_holds) {
    return asked != Precision::automatic ? asked : float_holds ? Precision::float32 : Precision::float64;
}

enum class Tolerances { exact, povray };
enum class Accelerator { automatic, grid, cloud, brute };

/// POV-Ray's antialiasing without jitter: a grid in every pixel (its threshold 0), its method 1 (by blocks of pixels)
/// or its method 2 (by squares, recursively).
struct Antialiasing {
    enum class Method { none, grid, blocks, squares };
    Method method = Method::none;
    float threshold = 0.3f;
    uint32_t depth = 3;

    friend bool operator==(const Antialiasing&, const Antialiasing&) = default;
};

/// A band of a picture, over its whole width.
struct Rows {
    /// Where bands may be cut: antialiasing by blocks looks at no more than a block, and no cut shall go through one.
    static constexpr uint32_t unit = 32;

    uint32_t first = 0; ///< a multiple of `unit`
    uint32_t count = 0; ///< 0: all

    friend bool operator==(const Rows&, const Rows&) = default;
};

struct FrameSettings {
    uint32_t width = 640;
    uint32_t height = 480;
    Rows rows;              ///< what of the picture to render: the numbers are the same however it is cut
    bool in_halves = false; ///< the image gets half-floats, rounded and repaired on the device: see HalveSamples
    AovLayers aovs;         ///< if any, the image gets a sample of all of them a pixel
    uint32_t samples = 1;   ///< rays a pixel; 1 is the pixel's centre
    Antialiasing antialiasing;
    Precision precision = Precision::float32;
    Tolerances tolerances = Tolerances::exact;
    Accelerator accelerator = Accelerator::automatic;
    std::array<uint32_t, 3> grid{0, 0, 0}; ///< voxels along x, y, z; 0 = chosen from the scene
    Metric metric = Metric::chessboard;    ///< of the cloud
    uint32_t brick = 0;                    ///< voxels along a brick of the cloud: 1, 2, 4 or 8; 0 = chosen

    Rows band() const { return rows.count ? rows : Rows{0, height}; }
    FrameSettings with_rows(Rows part) const {
        FrameSettings settings = *this;
        settings.rows = part;
        return settings;
    }
    friend bool operator==(const FrameSettings&, const FrameSettings&) = default;
};

/// What a frame took and what it was made with. Milliseconds; a step that did not run is 0.
struct FrameStatistics {
    std::string method;  ///< "grid", "cloud" or "brute"
    MethodRecord choice; ///< why
    std::array<uint32_t, 3> grid{0, 0, 0};
    std::array<uint32_t, 3> wanted_grid{0, 0, 0}; ///< not 0 if it had to be coarser than this
    uint64_t most_voxels = 0;                     ///< then: the limit
    uint64_t references = 0;                      ///< entries in all voxels' lists
    uint64_t occupied = 0;                        ///< voxels with at least one
    uint32_t outliers = 0;                        ///< primitives beside a core, which is what the grid is for
    Metric metric = Metric::chessboard;
    uint32_t brick = 0;       ///< voxels along a brick of the cloud
    double mean_distance = 0; ///< over the cloud's empty bricks, in bricks
    double motion_ms = 0, build_ms = 0, cloud_ms = 0, relay_ms = 0, trace_ms = 0, readback_ms = 0;
    uint64_t peak_device_bytes = 0;
    uint64_t camera_rays = 0;                           ///< of all moments
    uint64_t replaced_samples = 0, clamped_samples = 0; ///< of an image in halves
    std::string note;                                   ///< for the user: what went otherwise than it was to

    /// What another part of the same frame took; the grid's figures are its own.
    void add(const FrameStatistics& part) {
        const double times[6] = {motion_ms, build_ms, cloud_ms, relay_ms, trace_ms, readback_ms};
        const uint64_t peak = peak_device_bytes, replaced = replaced_samples, clamped = clamped_samples,
                       rays = camera_rays;
        *this = part;
        motion_ms += times[0];
        build_ms += times[1];
        cloud_ms += times[2];
        relay_ms += times[3];
        trace_ms += times[4];
        readback_ms += times[5];
        camera_rays += rays;
        replaced_samples += replaced;
        clamped_samples += clamped;
        peak_device_bytes = peak > peak_device_bytes ? peak : peak_device_bytes;
    }
};

/// A number of the scene has no finite value at the frame's time: the script has to be evaluated for this frame, and
/// says what is wrong or what the frame looks like.
struct MotionUndefined : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// cancel() ended the frame.
struct FrameCancelled : std::runtime_error {
    FrameCancelled() : std::runtime_error("the frame was cancelled") {}
};

/// Renders frames on one device. Throws DeviceError; a renderer that threw may not be used again, but when render()
/// was out of memory: then it has given up what a picture's size asks for, and fewer rows may fit.
class FrameRenderer {
public:
    virtual ~FrameRenderer() = default;
    /// The device as `proxima devices` names it: "cpu" or "cuda:0".
    virtual std::string name() const = 0;
    /// Takes over a scene, converted to `precision` (not automatic); it is rendered by every render() until the next
    /// call.
    virtual void set_scene(const SceneProgram& scene, Precision precision) = 0;
    /// Renders the scene into `image`, which is resized to the whole picture unless it fits; of it, the rows that the
    /// settings ask for. Bands of one moment, one after the other, share what is built for it. `settings.precision`
    /// must be the scene's. `times` are
    /// the moments that are shown, one or more; with several, the picture is their mean in linear light, and its layers
    /// are those of the middle one. For a scene without motion programs it may be empty. Throws MotionUndefined, after
    /// which the renderer may be used again.
    virtual FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) = 0;
    /// The same for a scene as the script was evaluated.
    FrameStatistics render(const FrameSettings& settings, Image& image) { return render(settings, {}, image); }

    /// Who is told of the steps of the frames to come; null for nobody. It must outlive them.
    virtual void set_watch(StepWatch*) {}
    /// From the next scene on, `builder`, a renderer of the same kind on another device, builds the grids that this one
    /// traces. When it fails, this one goes on alone, and the frame's statistics say so.
    virtual void relay_from(std::unique_ptr<FrameRenderer>) {}
    /// Any thread: makes reading back into an image that is used again and again as fast as the device can.
    virtual void lock_pages(Image&) {}
    /// Any thread: the frame that is being rendered, or else the next one, ends soon by FrameCancelled, and the
    /// renderer is of no more use.
    virtual void cancel() {}
};

struct DeviceDescription {
    std::string id;      ///< "cpu", "cuda:0", ...
    std::string name;    ///< the maker's name
    uint64_t memory = 0; ///< bytes
    std::string note;    ///< cores, compute capability
};

class MethodChoice;

/// `threads` 0 is one for each core that the process may use. `choice` is that of all renderers of the device; null
/// for one of its own.
std::unique_ptr<FrameRenderer> make_cpu_renderer(unsigned threads, std::shared_ptr<MethodChoice> choice = {});
/// Throws DeviceError when this build has no CUDA or the host has no such device.
std::unique_ptr<FrameRenderer> make_cuda_renderer(int ordinal, std::shared_ptr<MethodChoice> choice = {});

/// The CUDA devices of this host. Empty without a driver, a device, or CUDA in the build; `reason` then says which.
std::vector<DeviceDescription> list_cuda_devices(std::string& reason);
DeviceDescription describe_cpu(unsigned threads);

} // namespace proxima
