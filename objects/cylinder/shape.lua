--- Upright cylinder, radius 1 U, height 4 U.

local lathe = require("shapes.lathe")

local shape = {}

function shape.build()
  local profile = {
    lathe.line(0, -2, 1, -2, 3),
    lathe.line(1, -2, 1, 2, 16),
    lathe.line(1, 2, 0, 2, 3),
  }
  return lathe.turn(profile, "y", 40)
end

return shape
