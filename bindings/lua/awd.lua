-- SPDX-License-Identifier: Apache-2.0
-- libawd in LuaJIT: the C functions under their own names, from the preprocessed headers.
local ffi = require("ffi")

local awd = {
  loaded = {}, -- never to be unloaded before what it made has been released
}

-- Declares what the file of headers has (preprocess.sh writes it), unchanged; returns its text.
function awd.declare(headers)
  local file = assert(io.open(headers))
  local text = file:read("*a")
  file:close()
  ffi.cdef(text)
  return text
end

-- The library in a file, or libawd as the system finds it.
function awd.load(file)
  local library = ffi.load(file or "awd")
  awd.loaded[#awd.loaded + 1] = library

  -- Raises the library's message unless the call that gave this result succeeded.
  local function check(result)
    if result ~= ffi.C.AWD_SUCCESS then
      error(ffi.string(library.awdGetLastErrorMessage()), 2)
    end
  end

  -- What `new` makes of its arguments, released when it is collected.
  local function make(type, new, ...)
    local arguments = { ... }
    local output = ffi.new("AWD" .. type .. "[1]")
    arguments[select("#", ...) + 1] = output
    check(new(unpack(arguments, 1, select("#", ...) + 1)))
    return ffi.gc(output[0], library["awdRelease" .. type])
  end

  return library, check, make
end

-- A struct with its structSize set and all else zero: "the default" in every struct that is asked
-- for but AWDCamera.
function awd.struct(type, fields)
  local struct = ffi.new(type, fields or {})
  struct.structSize = ffi.sizeof(type)
  return struct
end

return awd
