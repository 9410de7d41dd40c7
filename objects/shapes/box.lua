--- Axis-aligned box, flat sides.

local mesh = require("shapes.mesh")

--- Mesh of the box with the given extents, unit U, centred on the origin.
local function box(width, height, depth)
  local half = { width / 2, height / 2, depth / 2 }
  local builder = mesh.builder()
  for axis = 1, 3 do
    local first, second = axis % 3 + 1, (axis + 1) % 3 + 1
    for side = -1, 1, 2 do
      local direction = { 0, 0, 0 }
      direction[axis] = side
      local normal = builder.normal(direction[1], direction[2], direction[3])
      local function corner(s, t)
        local p = {}
        p[axis], p[first], p[second] = side * half[axis], s * half[first], t * side * half[second]
        return builder.vertex(p[1], p[2], p[3])
      end
      local a, b, c, d = corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)
      builder.triangle(a, b, c, normal, normal, normal)
      builder.triangle(a, c, d, normal, normal, normal)
    end
  end
  return builder.mesh
end

return box
