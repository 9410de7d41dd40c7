--- Sphere from an icosahedron whose triangles are split into four repeatedly.

local mesh = require("shapes.mesh")

--- Mesh of the sphere of the given radius, unit U, after `levels` splits:
-- 20 * 4^levels triangles. Three two-fold axes of the icosahedron lie along
-- X, Y and Z, hence from one split on the box is a cube.
local function icosphere(radius, levels)
  local golden = (1 + math.sqrt(5)) / 2
  local points = {}
  for axis = 1, 3 do
    for s = -1, 1, 2 do
      for t = -1, 1, 2 do
        local p = { 0, 0, 0 }
        p[axis % 3 + 1], p[(axis + 1) % 3 + 1] = s, t * golden
        points[#points + 1] = p
      end
    end
  end

  -- Corners at the edge length 2 of each other, wound outwards.
  local function near(p, q)
    local x, y, z = p[1] - q[1], p[2] - q[2], p[3] - q[3]
    return math.abs(x * x + y * y + z * z - 4) < 1e-6
  end
  local faces = {}
  for i = 1, 12 do
    for j = i + 1, 12 do
      for k = j + 1, 12 do
        local p, q, r = points[i], points[j], points[k]
        if near(p, q) and near(q, r) and near(r, p) then
          local volume = p[1] * (q[2] * r[3] - q[3] * r[2])
            + p[2] * (q[3] * r[1] - q[1] * r[3])
            + p[3] * (q[1] * r[2] - q[2] * r[1])
          faces[#faces + 1] = volume > 0 and { p, q, r } or { p, r, q }
        end
      end
    end
  end

  local function unit(x, y, z)
    local length = math.sqrt(x * x + y * y + z * z)
    return { x / length, y / length, z / length }
  end
  local function middle(p, q)
    return unit(p[1] + q[1], p[2] + q[2], p[3] + q[3])
  end

  local builder = mesh.builder()
  local function add(p, q, r, level)
    if level > 0 then
      local pq, qr, rp = middle(p, q), middle(q, r), middle(r, p)
      add(p, pq, rp, level - 1)
      add(pq, q, qr, level - 1)
      add(rp, qr, r, level - 1)
      add(pq, qr, rp, level - 1)
      return
    end
    local corner, normal = {}, {}
    for i, n in ipairs({ p, q, r }) do
      corner[i] = builder.vertex(radius * n[1], radius * n[2], radius * n[3])
      normal[i] = builder.normal(n[1], n[2], n[3])
    end
    builder.triangle(corner[1], corner[2], corner[3], normal[1], normal[2], normal[3])
  end
  for _, face in ipairs(faces) do
    local p, q, r = face[1], face[2], face[3]
    add(unit(p[1], p[2], p[3]), unit(q[1], q[2], q[3]), unit(r[1], r[2], r[3]), levels)
  end
  return builder.mesh
end

return icosphere
