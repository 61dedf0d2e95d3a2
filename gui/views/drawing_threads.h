// The threads of an OpenGL driver without a graphics card (Mesa's llvmpipe), which would take the haptic loop's turn.
#pragma once

namespace vallecula::gui {

/// Before OpenGL starts: one for every two cores, at most four; LP_NUM_THREADS, where it is set, is kept. On two cores
/// a second one draws no more frames beside a running trial, and twice as many ticks come late where the haptic threads
/// have no real-time priority.
void limit_drawing_threads();

/// Once OpenGL has started: they give way to every other thread that has work. Not where the haptic threads can have
/// real-time priority, which puts them first anyhow: on a crowded machine the picture would stand for seconds.
void put_drawing_threads_behind();

}  // namespace vallecula::gui
