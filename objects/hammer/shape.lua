--- Claw hammer: handle along X, head at +X, face towards -Y, claw towards +Y.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U; the middle of the handle is the origin.
function shape.distance()
  local handle = sdf.body({
    { -2.7, 0, 0.3, 0.28 },
    { -2.2, 0, 0.36, 0.31 },
    { -1.2, 0, 0.33, 0.28 },
    { 0.2, 0, 0.25, 0.22 },
    { 2.4, 0, 0.24, 0.2 },
  })
  local eye = sdf.move(2.5, 0, 0, sdf.box(0.85, 0.9, 0.78, 0.12))
  local neck = sdf.move(2.5, -0.6, 0, sdf.cylinder(0.29, 0.8, 0.05))
  local face = sdf.move(2.5, -1.1, 0, sdf.cylinder(0.44, 0.55, 0.09))
  local prong = sdf.chain(0.2, {
    { 2.52, 0.1, 0.17, 0.28 }, { 2.48, 0.75, 0.23, 0.23 },
    { 2.25, 1.2, 0.28, 0.19 }, { 1.82, 1.5, 0.33, 0.14 },
  })
  local slot = sdf.plate({ { 1.2, 1.9 }, { 2.0, 0.75 }, { 3, 0.75 }, { 3, 1.9 } }, 0.06, 0.1)
  local claw = sdf.cut(0.06, sdf.mirror_z(prong), slot)
  return sdf.union(0.14, handle, eye, neck, face, claw)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 6, 3, 1.03 }, centre = { 0, 0.15, 0 },
    step = 0.075, triangles = 3500, longest = 0.4,
  })
end

return shape
