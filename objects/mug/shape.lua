--- Mug: a round bowl open upwards, its handle towards +X.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U; the bowl's axis is the Y axis.
function shape.distance()
  local wall = sdf.cylinder(1.4, 3.2, 0.13)
  local handle = sdf.move(1.45, 0.05, 0, sdf.ring(0.59, 0.75, 0.16, 0.24))
  local bowl = sdf.move(0, 0.5, 0, sdf.cylinder(1.1, 3.5, 0.3))
  return sdf.cut(0.12, sdf.union(0.15, wall, handle), bowl)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 3.6, 3.2, 2.8 }, centre = { 0.4, 0, 0 },
    step = 0.085, triangles = 4000, longest = 0.4,
  })
end

return shape
