// The nearest point of a surface, asked many times.
#pragma once

#include <memory>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

class Projector {
 public:
  explicit Projector(const Surface& surface);
  ~Projector();
  Projector(const Projector&) = delete;
  Projector& operator=(const Projector&) = delete;
  Point nearest(const Point& p) const;

 private:
  struct Locator;
  std::unique_ptr<Locator> locator_;
};

}  // namespace vallecula::pipeline
