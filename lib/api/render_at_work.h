// SPDX-License-Identifier: Apache-2.0
// A render during its passes.
#pragma once

#include "api/handles.h"
#include "render/render.h"

namespace awd {

/// With its field, which the passes record in.
class RenderAtWork {
 public:
  explicit RenderAtWork(Render& render)
      : render_(&render, "render"), field_(render.field().get(), "the render's field") {}
  Render* operator->() const { return &*render_; }

 private:
  AtWork<Render> render_;
  AtWork<Field> field_;
};

/// For what sees both, or changes them without calling the host.
inline Render& idleWithField(AWDRender handle) {
  Render& render = idle(handle, "render");
  if (render.field() && render.field()->isAtWork()) failAtWork("the render's field");
  return render;
}

}  // namespace awd
