// SPDX-License-Identifier: Apache-2.0
// What the program does, one function a command. They print what was asked for and throw what stops them; the exit code
// is main.cpp's.
#pragma once
#include "renderer/options.h"

namespace proxima {

/// Renders every requested frame to its file. Throws SceneRejected, UsageError, FileError, DeviceError, Interrupted.
void render_command(const RenderOptions& options);

/// Reads and evaluates the scene for every frame, prints its mistakes, and counts what is in it.
/// Throws SceneRejected, FileError, Interrupted.
void check_command(const CheckOptions& options);

/// Looks whether every frame that render_command would write is there, whole and the same. Prints those that are not.
/// Throws FramesIncomplete, and what reading a scene throws.
void verify_command(const VerifyOptions& options);

/// Reads and evaluates the scene as rendering its first frame would, and prints how the frames would be made.
/// Throws SceneRejected, FileError.
void plan_command(const PlanOptions& options);

/// Compares two pictures, two sets of pictures, or POV-Ray's pictures of a scene with ours, and prints the figures.
/// Throws PicturesDiffer unless all are equal within the tolerance, FileError when one cannot be read, UsageError, and
/// when it renders what render_command throws.
void compare_command(const CompareOptions& options);

/// Measures time and error of the settings that trade them, writes tables, a chart and a page, and prints the table.
/// Throws what render_command throws.
void tradeoff_command(const TradeoffOptions& options);

/// Measures the experiments of a name, prints them as a table, and writes tables and charts into a folder.
/// Throws FileError, DeviceError, Interrupted, and PicturesDiffer when two methods did not make the same picture.
void bench_command(const BenchOptions& options);

/// Prints the devices as a table or as JSON.
void devices_command(const DevicesOptions& options);

} // namespace proxima
