--- Verifies that a mesh bounds one solid: closed, wound outwards, one piece.

local mesh = require("shapes.mesh")

local inspect = {}

local function cross_of(p, q, r)
  local ux, uy, uz = q[1] - p[1], q[2] - p[2], q[3] - p[3]
  local vx, vy, vz = r[1] - p[1], r[2] - p[2], r[3] - p[3]
  return uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
end

--- Enclosed volume by the divergence theorem, unit U^3.
function inspect.volume(self)
  local sum = 0
  for _, t in ipairs(self.triangles) do
    local p = self.vertices[t[1]]
    local x, y, z = cross_of(p, self.vertices[t[2]], self.vertices[t[3]])
    sum = sum + p[1] * x + p[2] * y + p[3] * z
  end
  return sum / 6
end

--- Findings about the mesh as { faults = list of texts, volume = U^3,
-- genus = number of handles }. No faults: the mesh bounds one solid.
function inspect.solid(self)
  local faults = {}
  local vertices, normals, triangles = self.vertices, self.normals, self.triangles
  local count = #vertices
  local function fault(...)
    faults[#faults + 1] = string.format(...)
  end

  -- Positions are distinct, normals have unit length.
  local seen = {}
  for index, v in ipairs(vertices) do
    local key = v[1] .. " " .. v[2] .. " " .. v[3]
    if seen[key] then
      fault("vertices %d and %d coincide", seen[key], index)
    end
    seen[key] = index
  end
  for index, n in ipairs(normals) do
    if math.abs(n[1] * n[1] + n[2] * n[2] + n[3] * n[3] - 1) > 1e-5 then
      fault("normal %d is not of unit length", index)
    end
  end

  -- Every directed edge lies in one triangle and its reverse in another.
  -- after[v][w] = u says that the fan of v passes from w to u.
  local after = {}
  for index = 1, count do
    after[index] = {}
  end
  for index, t in ipairs(triangles) do
    for corner = 1, 3 do
      local v, w, u = t[corner], t[corner % 3 + 1], t[(corner + 1) % 3 + 1]
      if after[v][w] then
        fault("edge %d-%d is run through twice in the same direction", v, w)
      end
      after[v][w] = u
    end
    local x, y, z = cross_of(vertices[t[1]], vertices[t[2]], vertices[t[3]])
    local area = math.sqrt(x * x + y * y + z * z) / 2
    if area < 1e-8 then
      fault("triangle %d is degenerate", index)
    end
    for corner = 4, 6 do
      local n = normals[t[corner]]
      if n[1] * x + n[2] * y + n[3] * z <= 0 then
        fault("triangle %d faces away from its normals", index)
        break
      end
    end
  end
  local edges = 0
  for v = 1, count do
    local degree, start = 0, nil
    for w in pairs(after[v]) do
      degree = degree + 1
      start = math.min(start or w, w)
      if not after[w][v] then
        fault("edge %d-%d is open", v, w)
      end
    end
    edges = edges + degree
    if degree == 0 then
      fault("vertex %d is in no triangle", v)
    else
      -- The triangles around a vertex form one fan.
      local steps, w = 0, start
      repeat
        w = after[v][w]
        steps = steps + 1
      until not w or w == start or steps > degree
      if steps ~= degree then
        fault("vertex %d joins several fans", v)
      end
    end
  end

  -- One piece: everything is reached from the first vertex.
  local reached, stack, total = { [1] = true }, { 1 }, 1
  while #stack > 0 do
    local v = table.remove(stack)
    for w in pairs(after[v]) do
      if not reached[w] then
        reached[w] = true
        total = total + 1
        stack[#stack + 1] = w
      end
    end
  end
  if total ~= count then
    fault("%d of %d vertices hang together", total, count)
  end

  local volume = inspect.volume(self)
  if not (volume > 0) then
    fault("volume %g is not positive", volume)
  end
  local low, high = mesh.bounds(self)
  for axis = 1, 3 do
    if math.abs(low[axis] + high[axis]) > 1e-5 then
      fault("axis %d is off centre by %g U", axis, (low[axis] + high[axis]) / 2)
    end
  end
  local euler = count - edges // 2 + #triangles
  return { faults = faults, volume = volume, genus = (2 - euler) // 2 }
end

return inspect
