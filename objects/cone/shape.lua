--- Upright cone, base radius 1.1 U, height 3.6 U.

local lathe = require("shapes.lathe")

local shape = {}

function shape.build()
  local profile = {
    lathe.line(0, -1.8, 1.1, -1.8, 4),
    lathe.line(1.1, -1.8, 0, 1.8, 12),
  }
  return lathe.turn(profile, "y", 40)
end

return shape
