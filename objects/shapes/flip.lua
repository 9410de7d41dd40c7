--- Better triangles by swapping the diagonal of two neighbours.

--- Goodness of a triangle: how well it faces along its vertex normals plus how
-- even its sides are, -1 to 1.25.
local function goodness(p, q, r, n, m, o)
  local ux, uy, uz = q[1] - p[1], q[2] - p[2], q[3] - p[3]
  local vx, vy, vz = r[1] - p[1], r[2] - p[2], r[3] - p[3]
  local wx, wy, wz = vx - ux, vy - uy, vz - uz
  local x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
  local length = math.sqrt(x * x + y * y + z * z)
  if length < 1e-9 then
    return -1
  end
  local along = math.min(
    n[1] * x + n[2] * y + n[3] * z, m[1] * x + m[2] * y + m[3] * z, o[1] * x + o[2] * y + o[3] * z)
  local sides = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz + wx * wx + wy * wy + wz * wz
  return along / length + math.sqrt(3) / 2 * length / sides
end

--- Swaps edges in place, where that makes the worse of the two triangles
-- better, in `rounds` sweeps. normals holds one per vertex.
local function flip(vertices, normals, triangles, rounds)
  local stride = #vertices + 1
  local facing, degree = {}, {} -- triangle by directed edge; triangles at a vertex
  for v = 1, #vertices do
    degree[v] = 0
  end
  for _, t in ipairs(triangles) do
    for corner = 1, 3 do
      facing[t[corner] * stride + t[corner % 3 + 1]] = t
      degree[t[corner]] = degree[t[corner]] + 1
    end
  end
  local function score(a, b, c)
    return goodness(vertices[a], vertices[b], vertices[c], normals[a], normals[b], normals[c])
  end
  for _ = 1, rounds do
    for _, t in ipairs(triangles) do
      for corner = 1, 3 do
        local a, b, c = t[corner], t[corner % 3 + 1], t[(corner + 1) % 3 + 1]
        local u = facing[b * stride + a]
        local d = u[1] + u[2] + u[3] - a - b
        if degree[a] > 3 and degree[b] > 3 and not facing[c * stride + d] and not facing[d * stride + c] then
          local before = math.min(score(a, b, c), score(b, a, d))
          local after = math.min(score(a, d, c), score(d, b, c))
          if after > before + 0.03 then
            t[1], t[2], t[3] = a, d, c
            u[1], u[2], u[3] = d, b, c
            facing[a * stride + b], facing[b * stride + a] = nil, nil
            facing[a * stride + d], facing[d * stride + c], facing[c * stride + a] = t, t, t
            facing[d * stride + b], facing[b * stride + c], facing[c * stride + d] = u, u, u
            degree[a], degree[b] = degree[a] - 1, degree[b] - 1
            degree[c], degree[d] = degree[c] + 1, degree[d] + 1
            break
          end
        end
      end
    end
  end
end

return flip
