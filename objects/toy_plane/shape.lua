--- Toy plane: propeller towards +X, fin towards +Y.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U.
function shape.distance()
  local fuselage = sdf.body({
    { -2.65, 0.22, 0.16, 0.14 },
    { -1.5, 0.1, 0.3, 0.26 },
    { 0, 0, 0.48, 0.44 },
    { 1.2, -0.02, 0.5, 0.48 },
    { 2.2, -0.02, 0.42, 0.42 },
  })
  local canopy = sdf.move(0.45, 0.46, 0, sdf.ellipsoid(0.62, 0.3, 0.3))
  local wing = sdf.plate(sdf.outline({
    { 1.35, 0 }, { 1.3, 1.2 }, { 1.12, 2.4 }, { 0.85, 2.72 }, { 0.45, 2.4 }, { 0.22, 1.2 }, { 0.1, 0 },
    { 0.22, -1.2 }, { 0.45, -2.4 }, { 0.85, -2.72 }, { 1.12, -2.4 }, { 1.3, -1.2 },
  }, 2), 0.14)
  local tailplane = sdf.plate(sdf.outline({
    { -2.05, 0 }, { -2.25, 0.6 }, { -2.5, 1.05 }, { -2.78, 0.95 }, { -2.75, 0 },
    { -2.78, -0.95 }, { -2.5, -1.05 }, { -2.25, -0.6 },
  }, 2), 0.13)
  local fin = sdf.plate(sdf.outline({
    { -1.95, 0.3 }, { -2.3, 0.75 }, { -2.5, 1.22 }, { -2.75, 1.25 }, { -2.75, 0.7 }, { -2.7, 0.2 },
  }, 2), 0.13)
  local blade = sdf.move(2.72, -0.02, 0, sdf.turn("x", 35, sdf.chain(0.1, {
    { 0, -0.92, 0, 0.17 }, { 0, 0, 0, 0.13 }, { 0, 0.92, 0, 0.17 },
  })))
  local spinner = sdf.limb({ 2.3, -0.02, 0 }, 0.3, { 2.85, -0.02, 0 }, 0.15)
  local body = sdf.union(0.15, fuselage,
    sdf.move(0, -0.16, 0, sdf.turn("x", 90, wing)),
    sdf.move(0, 0.24, 0, sdf.turn("x", 90, tailplane)),
    fin)
  return sdf.union(0.1, body, canopy, spinner, blade)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 6, 2.35, 5.75 }, centre = { 0, 0.24, 0 },
    step = 0.085, triangles = 4500, longest = 0.4,
  })
end

return shape
