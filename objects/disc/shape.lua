--- Flat disc facing Z, radius 2 U, thickness 0.5 U.

local lathe = require("shapes.lathe")

local shape = {}

function shape.build()
  local profile = {
    lathe.line(0, -0.25, 2, -0.25, 6),
    lathe.line(2, -0.25, 2, 0.25, 2),
    lathe.line(2, 0.25, 0, 0.25, 6),
  }
  return lathe.turn(profile, "z", 48)
end

return shape
