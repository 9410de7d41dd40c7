--- Lengths in metres and angles in radians, from the units that drawings use.
--
--     local units = require("preshape.units")
--     return { unit = units.mm(25), approach = units.deg(30) }

local units = {}

local function number(name, value)
  if type(value) ~= "number" then
    error(name .. ": expected number, got " .. type(value), 3)
  end
  return value
end

---@param value number angle [degree]
---@return number angle [rad]
function units.deg(value)
  return math.rad(number("deg", value))
end

---@param value number length [mm]
---@return number length [m]
function units.mm(value)
  return number("mm", value) / 1000
end

---@param value number length [cm]
---@return number length [m]
function units.cm(value)
  return number("cm", value) / 100
end

---@param value number length [inch]
---@return number length [m]
function units.inch(value)
  return number("inch", value) * 0.0254
end

return units
