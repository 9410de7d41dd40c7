--- Mesh of a signed distance function: sample, thin out, even out.

local decimate = require("shapes.decimate")
local flip = require("shapes.flip")
local marching = require("shapes.marching")
local mesh = require("shapes.mesh")
local relax = require("shapes.relax")

--- Mesh of the solid f < 0. Options, lengths in U:
--   extents    { x, y, z } of the result's bounding box, met exactly
--   centre     { x, y, z } of the box in the coordinates of f (default origin)
--   step       lattice step of the sampling
--   triangles  number to thin out to
--   longest    longest edge the thinning may leave (default 0.5)
local function solid(f, options)
  local centre = options.centre or { 0, 0, 0 }
  local low, high = {}, {}
  for axis = 1, 3 do
    local half = options.extents[axis] / 2 + 2.5 * options.step
    low[axis], high[axis] = centre[axis] - half, centre[axis] + half
  end
  local vertices, triangles = marching(f, low, high, options.step)
  relax.raw(f, vertices, triangles, 2)
  vertices, triangles = decimate(vertices, triangles, options.triangles, options.longest or 0.5)
  local normals = relax.onto(f, vertices, triangles, 1)
  flip(vertices, normals, triangles, 2)
  normals = relax.onto(f, vertices, triangles, 2)
  flip(vertices, normals, triangles, 2)
  for _, t in ipairs(triangles) do
    t[4], t[5], t[6] = t[1], t[2], t[3]
  end
  local result = { vertices = vertices, normals = normals, triangles = triangles }
  return mesh.fit(result, table.unpack(options.extents))
end

return solid
