-- SPDX-License-Identifier: Apache-2.0
-- Prints what LuaJIT makes of the headers, as JSON, for the test that compares it with C; every
-- function must be in the library.
--   luajit declared.lua <libawd.so> <awd.i> <awd.macros>
local ffi = require("ffi")
package.path = arg[0]:gsub("[^/]*$", "") .. "?.lua;" .. package.path
local awd = require("awd")

local library_file, headers, macros = arg[1], arg[2], arg[3]
local text = awd.declare(headers)
local library = awd.load(library_file)

-- name: number of arguments
local function functions()
  local found = {}
  for name, arguments in text:gmatch("%f[%w](awd%u%w*)%s*(%b())") do
    if name ~= "awdBasisModule_v1" then
      assert(library[name] ~= nil)
      local _, commas = arguments:gsub(",", "")
      found[name] = arguments:match("^%(%s*void%s*%)$") and 0 or commas + 1
    end
  end
  return found
end

-- name: value, of enumerators and of macros that are numbers
local function constants()
  local found, bodies = {}, {}
  for body in text:gmatch("enum%s*(%b{})") do
    for name in body:gmatch("(AWD_[%w_]+)%s*=") do
      found[name] = tonumber(ffi.C[name])
    end
  end
  for line in io.lines(macros) do
    local name, body = line:match("^#define (AWD_[%w_]+) (.+)$")
    if name and not name:find("_INIT$") then bodies[name] = body end
  end
  for name, body in pairs(bodies) do
    local expression = body
    while expression:find("AWD_") do
      expression = expression:gsub("AWD_[%w_]+", bodies)
    end
    expression = expression:gsub("(%x)u%f[%W]", "%1")
    if expression:find("%d") and not expression:gsub("0x%x+", ""):find("[^%d%s()+*-]") then
      found[name] = loadstring("return " .. expression)()
    end
  end
  return found
end

local function field_names(body)
  local names = {}
  for member in body:gmatch("[^;]+") do
    local called = member:match("%(%s*%*%s*([%w_]+)%s*%)%s*%(")
    if called then
      names[#names + 1] = called
    else
      for part in member:gmatch("[^,]+") do
        names[#names + 1] = part:gsub("%b[]", ""):match("([%w_]+)%s*$")
      end
    end
  end
  return names
end

-- name: size and offsets
local function structs()
  local found = {}
  for body, name in text:gmatch("typedef struct AWD%w+%s*(%b{})%s*(AWD%w+)%s*;") do
    local fields = {}
    for _, field in ipairs(field_names(body:sub(2, -2))) do
      fields[field] = assert(ffi.offsetof(name, field))
    end
    found[name] = { size = ffi.sizeof(name), fields = fields }
  end
  return found
end

local function json(value)
  if type(value) ~= "table" then return ("%.0f"):format(value) end
  local parts = {}
  for name, item in pairs(value) do
    parts[#parts + 1] = ('"%s": %s'):format(name, json(item))
  end
  return "{" .. table.concat(parts, ", ") .. "}"
end

print(json({ functions = functions(), constants = constants(), structs = structs() }))
