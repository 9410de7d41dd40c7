--- Evens a mesh out on the surface it was sampled from.

local relax = {}

--- Gradient of f at a point by four differences.
function relax.gradient(f, x, y, z)
  local e = 1e-4
  local a, b = f(x + e, y - e, z - e), f(x - e, y - e, z + e)
  local c, d = f(x - e, y + e, z - e), f(x + e, y + e, z + e)
  local k = 1 / (4 * e)
  return (a - b - c + d) * k, (c + d - a - b) * k, (b + d - a - c) * k
end

--- Point of the surface f = 0 near (x, y, z) to a tolerance, U (default 1e-6),
-- with the unit normal there.
function relax.project(f, x, y, z, tolerance)
  tolerance = tolerance or 1e-6
  local nx, ny, nz = 0, 0, 0
  for _ = 1, 4 do
    local d = f(x, y, z)
    nx, ny, nz = relax.gradient(f, x, y, z)
    local g = nx * nx + ny * ny + nz * nz
    local step = math.max(-0.1, math.min(0.1, d / g))
    x, y, z = x - step * nx, y - step * ny, z - step * nz
    if math.abs(d) < tolerance then
      break
    end
  end
  local length = math.sqrt(nx * nx + ny * ny + nz * nz)
  return x, y, z, nx / length, ny / length, nz / length
end

--- For each vertex the list of its neighbours.
local function rings(vertices, triangles)
  local ring = {}
  for v = 1, #vertices do
    ring[v] = {}
  end
  for _, t in ipairs(triangles) do
    for corner = 1, 3 do
      local list = ring[t[corner]]
      list[#list + 1] = t[corner % 3 + 1]
    end
  end
  return ring
end

--- Moves each vertex half way to the middle of its neighbours, `rounds` times,
-- then onto f = 0: the raw lattice surface gets even triangles.
function relax.raw(f, vertices, triangles, rounds)
  local ring = rings(vertices, triangles)
  for _ = 1, rounds do
    for v, p in ipairs(vertices) do
      local sx, sy, sz, list = 0, 0, 0, ring[v]
      local count = #list
      for i = 1, count do
        local q = vertices[list[i]]
        sx, sy, sz = sx + q[1], sy + q[2], sz + q[3]
      end
      vertices[v] = { (p[1] + sx / count) / 2, (p[2] + sy / count) / 2, (p[3] + sz / count) / 2 }
    end
  end
  for v, p in ipairs(vertices) do
    local x, y, z = relax.project(f, p[1], p[2], p[3], 1e-3)
    vertices[v] = { x, y, z }
  end
end

--- Moves the vertices onto f = 0 and, where the surface is nearly flat, along
-- it towards the middle of their neighbours; `rounds` times. Returns the
-- normals, one per vertex.
function relax.onto(f, vertices, triangles, rounds)
  local ring = rings(vertices, triangles)
  local normals = {}
  local function settle(v, x, y, z)
    local nx, ny, nz
    x, y, z, nx, ny, nz = relax.project(f, x, y, z)
    vertices[v] = { x, y, z }
    normals[v] = { nx, ny, nz }
  end
  for v, p in ipairs(vertices) do
    settle(v, p[1], p[2], p[3])
  end
  for _ = 1, rounds do
    for v, p in ipairs(vertices) do
      local n, list = normals[v], ring[v]
      local sx, sy, sz, least = 0, 0, 0, 1
      for _, w in ipairs(list) do
        local q, m = vertices[w], normals[w]
        sx, sy, sz = sx + q[1], sy + q[2], sz + q[3]
        least = math.min(least, n[1] * m[1] + n[2] * m[2] + n[3] * m[3])
      end
      if least > 0.85 then
        local count = #list
        local dx, dy, dz = sx / count - p[1], sy / count - p[2], sz / count - p[3]
        local along = dx * n[1] + dy * n[2] + dz * n[3]
        settle(v, p[1] + (dx - along * n[1]) / 2, p[2] + (dy - along * n[2]) / 2,
          p[3] + (dz - along * n[3]) / 2)
      end
    end
  end
  return normals
end

return relax
