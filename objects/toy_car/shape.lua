--- Toy car: bonnet towards +X, roof towards +Y.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U.
function shape.distance()
  local lower = sdf.move(0, -0.15, 0, sdf.box(4.3, 0.8, 1.8, 0.2))
  local cabin = sdf.plate({ { -1.45, 0.1 }, { 0.75, 0.1 }, { 0.2, 0.78 }, { -1.15, 0.78 } }, 0.14, 1.26)
  local bonnet = sdf.move(1.35, 0.2, 0, sdf.turn("z", -4, sdf.box(1.4, 0.3, 1.3, 0.12)))
  local body = sdf.union(0.12, lower, cabin, bonnet)

  -- Windows are shallow dents in the cabin.
  local side = sdf.plate({ { -1.2, 0.38 }, { 0.35, 0.38 }, { 0.08, 0.7 }, { -1.03, 0.7 } }, 0.05, 0.2)
  local post = sdf.move(-0.45, 0.5, 0.85, sdf.box(0.16, 0.9, 0.5, 0.05))
  local window = sdf.cut(0.05, sdf.move(0, 0, 0.82, side), post)
  body = sdf.cut(0.06, body, sdf.mirror_z(window))
  local front = sdf.move(0.58, 0.59, 0, sdf.turn("z", -51, sdf.box(0.42, 0.2, 1.1, 0.05)))
  local rear = sdf.move(-1.45, 0.57, 0, sdf.turn("z", 66, sdf.box(0.4, 0.2, 1.1, 0.05)))
  body = sdf.cut(0.06, sdf.cut(0.06, body, front), rear)

  local wing = sdf.turn("x", 90, sdf.cylinder(0.66, 0.42, 0.08))
  local arch = sdf.mirror_x(sdf.mirror_z(sdf.move(1.3, -0.42, 0.75, wing)))
  local tyre = sdf.turn("x", 90, sdf.cylinder(0.5, 0.5, 0.1))
  local dish = sdf.move(0, 0, 0.26, sdf.turn("x", 90, sdf.cylinder(0.32, 0.24, 0.05)))
  local hub = sdf.move(0, 0, 0.1, sdf.ellipsoid(0.16, 0.16, 0.15))
  local wheel = sdf.union(0.04, sdf.cut(0.06, tyre, dish), hub)
  local wheels = sdf.mirror_x(sdf.mirror_z(sdf.move(1.3, -0.48, 0.88, wheel)))

  local bumper = sdf.mirror_x(sdf.move(2.12, -0.32, 0, sdf.box(0.26, 0.26, 1.7, 0.1)))
  local lamp = sdf.mirror_z(sdf.move(2.1, 0.04, 0.6, sdf.ellipsoid(0.17, 0.15, 0.15)))
  return sdf.union(0.08, body, arch, wheels, bumper, lamp)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 4.5, 1.98, 2.25 }, centre = { 0, -0.07, 0 },
    step = 0.065, triangles = 6000, longest = 0.4,
  })
end

return shape
