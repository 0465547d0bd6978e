// SPDX-License-Identifier: Apache-2.0
//
// libawd for C++17, on top of the C interface: header-only, and nothing at run time but the C
// calls. All of the interface but that of basis plugins (awd/basis.h).
//
//   awd::Device device = awd::Device::create();
//   awd::Field field = awd::Field::create(device);
//   AWDDirectionSample sample = field.sample(patch, normal, uniforms);
//
// - Objects own a reference: copies share what they stand for, moved-from ones are empty.
// - A call that fails throws an awd::Error. Where AWD_NO_EXCEPTIONS is defined, or the compiler has
//   none, it returns an awd::Result instead: the value, or the Error.
// - Arrays go in and out as views (awd::View, awd::Pixels, AWDBuffer), which copy nothing.
// - Members that are const may be called from any thread at any time (but not while a field or
//   density adapts); others want that nothing else uses the object. What each of them does is said
//   in the C header of the same name, at the function that it calls.
// - What is missing here can be done in C with get(), adopt() and share().
#ifndef AWD_AWD_HPP
#define AWD_AWD_HPP

#include "awd/cpp/buffer.hpp"
#include "awd/cpp/callbacks.hpp"
#include "awd/cpp/density.hpp"
#include "awd/cpp/device.hpp"
#include "awd/cpp/error.hpp"
#include "awd/cpp/field.hpp"
#include "awd/cpp/handle.hpp"
#include "awd/cpp/image.hpp"
#include "awd/cpp/render.hpp"
#include "awd/cpp/scene.hpp"
#include "awd/cpp/settings.hpp"
#include "awd/cpp/summands.hpp"
#include "awd/cpp/view.hpp"

#endif
