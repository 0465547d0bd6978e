-- SPDX-License-Identifier: Apache-2.0
-- Learns a density and renders a small picture.
--   luajit example.lua <awd.i> [<libawd.so>]
local ffi = require("ffi")
package.path = arg[0]:gsub("[^/]*$", "") .. "?.lua;" .. package.path
local awd = require("awd")

awd.declare(arg[1])
local C, check, make = awd.load(arg[2])
local device = make("Device", C.awdNewDevice, nil)

-- The integral of exp(-4 (x + y)) over the unit square, the square of (1 - exp(-4)) / 4.
local function integrate()
  math.randomseed(1)
  local count = 4096
  local uniforms, points = ffi.new("double[?]", 2 * count), ffi.new("double[?]", 2 * count)
  local pdfs, values = ffi.new("double[?]", count), ffi.new("double[?]", count)
  local density = make("Density", C.awdNewDensity, device,
    awd.struct("AWDDensityDesc", { dimensions = 2 }))
  for _ = 1, 4 do
    for i = 0, 2 * count - 1 do uniforms[i] = math.random() end
    check(C.awdSampleDensity(density, count, uniforms, points, pdfs, nil))
    for i = 0, count - 1 do
      values[i] = math.exp(-4 * (points[2 * i] + points[2 * i + 1]))
    end
    check(C.awdRecordDensity(density, count, points, pdfs, nil, values))
    check(C.awdAdaptDensity(density, nil))
  end
  local estimate = awd.struct("AWDDensityEstimate")
  check(C.awdGetDensityEstimate(density, estimate))
  return estimate.integral, ((1 - math.exp(-4)) / 4) ^ 2
end

-- A floor under a lamp, 16 x 16 pixels; their mean radiance.
local function render()
  local vertices = ffi.new("float[24]", { -1, 0, 1, 1, 0, 1, 1, 0, -1, -1, 0, -1,
    -0.5, 1, -0.5, 0.5, 1, -0.5, 0.5, 1, 0.5, -0.5, 1, 0.5 })
  local indices = ffi.new("uint32_t[12]", { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7 })
  local materials = ffi.new("uint32_t[4]", { 0, 0, 1, 1 })
  local scene = make("Scene", C.awdNewScene, device)
  for _, emission in ipairs({ 0, 4 }) do
    local grey, light = { 0.5, 0.5, 0.5 }, { emission, emission, emission }
    check(C.awdAddMaterial(scene,
      awd.struct("AWDMaterialDesc", { albedo = grey, emission = light }), nil))
  end
  check(C.awdAddMesh(scene, awd.struct("AWDMeshDesc", {
    vertices = { data = vertices, count = 8, format = ffi.C.AWD_FORMAT_FLOAT3 },
    indices = { data = indices, count = 4, format = ffi.C.AWD_FORMAT_UINT3 },
    materials = { data = materials, count = 4, format = ffi.C.AWD_FORMAT_UINT },
  }), nil))
  check(C.awdCommitScene(scene))

  local camera = awd.struct("AWDCamera", { eye = { 0, 0.5, 4 }, lookDir = { 0, 0, -1 },
    up = { 0, 1, 0 }, tanHalfFovX = 0.5, width = 16, height = 16 })
  local desc = awd.struct("AWDRenderDesc", { camera = camera })
  local picture = make("Render", C.awdNewRender, scene, nil, desc)
  check(C.awdRenderPasses(picture, awd.struct("AWDSchedule", { totalSamples = 8 })))
  local pixels, sum = ffi.new("float[?]", 16 * 16 * 3), 0
  check(C.awdReadFilm(picture, ffi.C.AWD_FILM_RADIANCE, pixels, 0, 0))
  for i = 0, 16 * 16 * 3 - 1 do sum = sum + pixels[i] end
  return sum / (16 * 16 * 3)
end

local integral, truth = integrate()
assert(math.abs(integral - truth) < 0.05 * truth, "the integral is wrong")
local radiance = render()
assert(radiance > 0 and radiance < 4, "no picture")
assert(not pcall(make, "Density", C.awdNewDensity, device, awd.struct("AWDDensityDesc")),
  "a density without dimensions")
print(("integral %.4f, in truth %.4f; mean radiance %.3f"):format(integral, truth, radiance))
