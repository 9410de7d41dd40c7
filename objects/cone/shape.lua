--- Upright cone, base radius 1.3 U, height 3 U.

local lathe = require("shapes.lathe")

local shape = {}

function shape.build()
  local profile = {
    lathe.line(0, -1.5, 1.3, -1.5, 4),
    lathe.line(1.3, -1.5, 0, 1.5, 12),
  }
  return lathe.turn(profile, "y", 40)
end

return shape
