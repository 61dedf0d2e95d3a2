// What the tests say to the stand-in and ask of it (control.h).
#include "tests/device/stand_in_hd/stand_in_state.h"

using namespace stand_in;

extern "C" {

void vallecula_standin_reset() {
  const Lock lock(mutex);
  for (State& s : states) {
    const bool open = s.open, output = s.output;
    const HHD handle = s.handle;
    s = State();
    s.open = open;
    s.output = output;
    s.handle = handle;
  }
  errors.clear();
  errors.reserve(64);
  violations = 0;
  start_error = 0;
  violation.clear();
  manual = false;
  hangs = false;
}
void vallecula_standin_manual(int by_hand) { manual = by_hand != 0; }
int vallecula_standin_turn(int turns) {
  for (int i = 0; i < turns; ++i) {
    if (!running) return i;
    turn();
  }
  return turns;
}
void vallecula_standin_hang(int hang) { hangs = hang != 0; }
void vallecula_standin_transform(int device, const double* transform) {
  const Lock lock(mutex);
  copy(transform, 16, states[device].transform);
}
void vallecula_standin_buttons(int device, int buttons) {
  const Lock lock(mutex);
  states[device].buttons = buttons;
}
void vallecula_standin_temperature(int device, int motor, double temperature) {
  const Lock lock(mutex);
  states[device].temperature[motor] = temperature;
}
void vallecula_standin_calibration(int device, unsigned int status) {
  const Lock lock(mutex);
  states[device].calibration = status;
}
void vallecula_standin_plugged(int device, int plugged) {
  const Lock lock(mutex);
  states[device].plugged = plugged != 0;
}
void vallecula_standin_held_elsewhere(int device, int held) {
  const Lock lock(mutex);
  states[device].held_elsewhere = held != 0;
}
void vallecula_standin_init_error(int device, unsigned int code) {
  const Lock lock(mutex);
  states[device].init_error = code;
}
void vallecula_standin_start_error(unsigned int code) {
  const Lock lock(mutex);
  start_error = code;
}
void vallecula_standin_frame_error(int device, unsigned int code) {
  const Lock lock(mutex);
  states[device].frame_error = code;
}
void vallecula_standin_error(int device, unsigned int code) {
  const Lock lock(mutex);
  push(code, device < 0 ? kInvalid : states[device].handle);
}
void vallecula_standin_given(int device, double* force_n) {
  const Lock lock(mutex);
  copy(states[device].given, 3, force_n);
}
int vallecula_standin_open(int device) {
  const Lock lock(mutex);
  return states[device].open ? 1 : 0;
}
int vallecula_standin_output(int device) {
  const Lock lock(mutex);
  return states[device].output ? 1 : 0;
}
int vallecula_standin_switched_off(int device) {
  const Lock lock(mutex);
  return states[device].switched_off;
}
long vallecula_standin_frames(int device) {
  const Lock lock(mutex);
  return states[device].frames;
}
int vallecula_standin_running() { return running ? 1 : 0; }
int vallecula_standin_callbacks() {
  const Lock lock(mutex);
  return static_cast<int>(callbacks.size());
}
int vallecula_standin_violations(const char** last) {
  const Lock lock(mutex);
  *last = violation.c_str();
  return violations;
}

}  // extern "C"
