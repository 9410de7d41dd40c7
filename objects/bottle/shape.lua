--- Bottle with a waist, a neck and a screw cap.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U; the axis is the Y axis.
function shape.distance()
  local body = sdf.union(0.25,
    sdf.move(0, -2.2, 0, sdf.cylinder(1.1, 1.6, 0.2)),
    sdf.move(0, -0.9, 0, sdf.cylinder(0.97, 2, 0.1)),
    sdf.move(0, 0.15, 0, sdf.cylinder(1.1, 1.0, 0.2)),
    sdf.limb({ 0, 0.25, 0 }, 1.04, { 0, 1.9, 0 }, 0.4))
  local neck = sdf.move(0, 1.9, 0, sdf.cylinder(0.42, 1.6, 0.05))
  local collar = sdf.move(0, 2.15, 0, sdf.cylinder(0.6, 0.2, 0.08))
  local cap = sdf.move(0, 2.68, 0, sdf.cylinder(0.53, 0.64, 0.08))
  local hollow = sdf.move(0, -3.35, 0, sdf.ellipsoid(0.8, 0.55, 0.8))
  return sdf.cut(0.12, sdf.union(0.1, sdf.union(0.3, body, neck), collar, cap), hollow)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 2.25, 6, 2.25 }, step = 0.085, triangles = 4000, longest = 0.4,
  })
end

return shape
