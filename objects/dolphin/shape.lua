--- Dolphin in a leap: snout towards +X, back towards +Y.

local sdf = require("shapes.sdf")
local solid = require("shapes.solid")

local shape = {}

--- Signed distance, U.
function shape.distance()
  local trunk = sdf.body({
    { -2.45, -0.42, 0.17, 0.15 },
    { -1.9, -0.22, 0.26, 0.20 },
    { -1.2, 0.05, 0.45, 0.38 },
    { -0.3, 0.25, 0.66, 0.62 },
    { 0.5, 0.26, 0.71, 0.69 },
    { 1.2, 0.17, 0.65, 0.63 },
  })
  local snout = sdf.limb({ 1.9, -0.16, 0 }, 0.24, { 2.8, -0.42, 0 }, 0.15)
  local melon = sdf.move(1.65, -0.03, 0, sdf.turn("z", -22, sdf.ellipsoid(0.75, 0.48, 0.46)))
  local head = sdf.union(0.15, sdf.union(0.25, trunk, melon), snout)

  -- Outlines in the plane of X and Y; plates of thickness 0.26.
  local dorsal = sdf.plate(sdf.outline({
    { 0.55, 0.8 }, { 0.2, 1.18 }, { -0.28, 1.5 }, { -0.44, 1.52 },
    { -0.28, 1.25 }, { -0.25, 0.8 }, { 0.1, 0.6 },
  }, 3), 0.13)
  local flipper = sdf.plate(sdf.outline({
    { 0.28, 0.1 }, { 0.25, -0.5 }, { -0.02, -0.88 }, { -0.26, -1.08 },
    { -0.33, -1.0 }, { -0.2, -0.5 }, { -0.2, 0.1 },
  }, 3), 0.13)
  local fluke = sdf.plate(sdf.outline({
    { 0.42, 0.06 }, { 0.1, 0.45 }, { -0.3, 0.98 }, { -0.55, 1.2 },
    { -0.62, 1.12 }, { -0.45, 0.55 }, { -0.3, 0.12 }, { -0.3, -0.12 },
    { -0.45, -0.55 }, { -0.62, -1.12 }, { -0.55, -1.2 },
    { -0.3, -0.98 }, { 0.1, -0.45 }, { 0.42, -0.06 },
  }, 2), 0.13)
  local tail = sdf.move(-2.35, -0.42, 0, sdf.turn("z", 22, sdf.turn("x", 90, fluke)))
  local arm = sdf.move(1.0, -0.12, 0.45, sdf.turn("z", -8, sdf.turn("x", -48, flipper)))
  local fins = sdf.union(0.1, dorsal, sdf.mirror_z(arm))
  return sdf.union(0.2, head, tail, fins)
end

function shape.build()
  return solid(shape.distance(), {
    extents = { 6, 2.6, 2.8 }, centre = { 0, 0.36, 0 },
    step = 0.08, triangles = 4500, longest = 0.4,
  })
end

return shape
