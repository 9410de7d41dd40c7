--- Lying torus, major radius 1.5 U, minor radius 0.5 U.

local lathe = require("shapes.lathe")

local shape = {}

function shape.build()
  return lathe.turn({ lathe.circle(1.5, 0.5, 20) }, "y", 48)
end

return shape
