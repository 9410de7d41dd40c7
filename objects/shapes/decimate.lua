--- Fewer triangles by collapsing edges, cheapest first (quadric error).
--
-- The surface stays closed and manifold: an edge is collapsed only if its ends
-- have exactly two neighbours in common, and no triangle may turn over.

--- Symmetric 3x3 system (a00 a01 a02 a11 a12 a22) p = (b0 b1 b2), by Cramer.
local function solve(a00, a01, a02, a11, a12, a22, b0, b1, b2)
  local c00 = a11 * a22 - a12 * a12
  local c01 = a02 * a12 - a01 * a22
  local c02 = a01 * a12 - a02 * a11
  local det = a00 * c00 + a01 * c01 + a02 * c02
  local c11 = a00 * a22 - a02 * a02
  local c12 = a01 * a02 - a00 * a12
  local c22 = a00 * a11 - a01 * a01
  return (c00 * b0 + c01 * b1 + c02 * b2) / det,
    (c01 * b0 + c11 * b1 + c12 * b2) / det,
    (c02 * b0 + c12 * b1 + c22 * b2) / det
end

--- Binary heap of entries { cost, order, ... }, least first.
local function push(heap, entry)
  local i = #heap + 1
  while i > 1 do
    local up = i // 2
    local other = heap[up]
    if other[1] < entry[1] or (other[1] == entry[1] and other[2] <= entry[2]) then
      break
    end
    heap[i] = other
    i = up
  end
  heap[i] = entry
end

local function pop(heap)
  local top, count = heap[1], #heap
  local entry = heap[count]
  heap[count] = nil
  count = count - 1
  if count == 0 then
    return top
  end
  local i = 1
  while true do
    local down = 2 * i
    if down > count then
      break
    end
    local child = heap[down]
    local other = heap[down + 1]
    if other and (other[1] < child[1] or (other[1] == child[1] and other[2] < child[2])) then
      down, child = down + 1, other
    end
    if entry[1] < child[1] or (entry[1] == child[1] and entry[2] <= child[2]) then
      break
    end
    heap[i] = child
    i = down
  end
  heap[i] = entry
  return top
end

--- Vertices and triangles with at most `target` triangles, if that can be had
-- with no edge longer than `longest`, U. The arguments are used up.
local function decimate(vertices, triangles, target, longest)
  local around = {} -- triangles at a vertex, some of them stale
  local quadric = {} -- a00 a01 a02 a11 a12 a22 b0 b1 b2 c
  local version = {}
  for v = 1, #vertices do
    around[v], version[v] = {}, 0
    quadric[v] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
  end

  local function cross(p, q, r)
    local ux, uy, uz = q[1] - p[1], q[2] - p[2], q[3] - p[3]
    local vx, vy, vz = r[1] - p[1], r[2] - p[2], r[3] - p[3]
    return uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
  end

  for _, t in ipairs(triangles) do
    local p = vertices[t[1]]
    local x, y, z = cross(p, vertices[t[2]], vertices[t[3]])
    local length = math.sqrt(x * x + y * y + z * z)
    if length > 0 then
      local w = length / 2
      x, y, z = x / length, y / length, z / length
      local d = x * p[1] + y * p[2] + z * p[3]
      local add = { x * x, x * y, x * z, y * y, y * z, z * z, x * d, y * d, z * d, d * d }
      for corner = 1, 3 do
        local q = quadric[t[corner]]
        for i = 1, 10 do
          q[i] = q[i] + w * add[i]
        end
      end
    end
    for corner = 1, 3 do
      local list = around[t[corner]]
      list[#list + 1] = t
    end
  end

  --- Live triangles at a vertex; forgets the stale ones.
  local function fan(v)
    local list, kept = around[v], {}
    for i = 1, #list do
      local t = list[i]
      if not t.dead then
        kept[#kept + 1] = t
      end
    end
    around[v] = kept
    return kept
  end

  --- Neighbours of a vertex in the order they are met, and as a set.
  local function neighbours(v)
    local list, set = {}, {}
    for _, t in ipairs(fan(v)) do
      for corner = 1, 3 do
        local w = t[corner]
        if w ~= v and not set[w] then
          set[w] = true
          list[#list + 1] = w
        end
      end
    end
    return list, set
  end

  local heap, order = {}, 0
  local function consider(a, b)
    local p, q = vertices[a], vertices[b]
    local dx, dy, dz = p[1] - q[1], p[2] - q[2], p[3] - q[3]
    local length2 = dx * dx + dy * dy + dz * dz
    local s, t = quadric[a], quadric[b]
    local a00, a01, a02 = s[1] + t[1], s[2] + t[2], s[3] + t[3]
    local a11, a12, a22 = s[4] + t[4], s[5] + t[5], s[6] + t[6]
    local b0, b1, b2, c = s[7] + t[7], s[8] + t[8], s[9] + t[9], s[10] + t[10]
    local mx, my, mz = (p[1] + q[1]) / 2, (p[2] + q[2]) / 2, (p[3] + q[3]) / 2
    -- The best point, drawn towards the middle where planes leave it open.
    local pull = 0.01 * (a00 + a11 + a22) + 1e-12
    local x, y, z = solve(a00 + pull, a01, a02, a11 + pull, a12, a22 + pull,
      b0 + pull * mx, b1 + pull * my, b2 + pull * mz)
    local off = a00 * x * x + a11 * y * y + a22 * z * z + 2 * (a01 * x * y + a02 * x * z + a12 * y * z)
      - 2 * (b0 * x + b1 * y + b2 * z) + c
    -- Where the surface is flat the short edges go first.
    local cost = math.max(off, 0) + 3e-4 * length2 * length2
    order = order + 1
    push(heap, { cost, order, a, b, version[a], version[b], x, y, z })
  end

  for _, t in ipairs(triangles) do
    for corner = 1, 3 do
      local a, b = t[corner], t[corner % 3 + 1]
      if a < b then
        consider(a, b)
      end
    end
  end

  --- Would the triangles at v but not at w survive v moving to p?
  local function survives(v, w, p)
    for _, t in ipairs(around[v]) do
      if t[1] ~= w and t[2] ~= w and t[3] ~= w then
        local q, r, s = vertices[t[1]], vertices[t[2]], vertices[t[3]]
        local x, y, z = cross(q, r, s)
        if t[1] == v then
          q = p
        elseif t[2] == v then
          r = p
        else
          s = p
        end
        local nx, ny, nz = cross(q, r, s)
        local dot = x * nx + y * ny + z * nz
        local old, new = x * x + y * y + z * z, nx * nx + ny * ny + nz * nz
        if dot <= 0 or dot * dot < 0.3 * old * new then
          return false
        end
        -- No needles: area against the longest side.
        local longest2 = 0
        for _, side in ipairs({ { q, r }, { r, s }, { s, q } }) do
          local ex, ey, ez = side[1][1] - side[2][1], side[1][2] - side[2][2], side[1][3] - side[2][3]
          longest2 = math.max(longest2, ex * ex + ey * ey + ez * ez)
        end
        if longest2 > longest * longest or new < 0.04 * longest2 * longest2 and new < old then
          return false
        end
      end
    end
    return true
  end

  local live = #triangles
  while live > target and #heap > 0 do
    local entry = pop(heap)
    local a, b = entry[3], entry[4]
    if version[a] == entry[5] and version[b] == entry[6] then
      local _, at_a = neighbours(a)
      local list_b = neighbours(b)
      local shared = 0
      for _, w in ipairs(list_b) do
        if at_a[w] then
          shared = shared + 1
        end
      end
      local p = { entry[7], entry[8], entry[9] }
      if shared == 2 and live > 4 and survives(a, b, p) and survives(b, a, p) then
        vertices[a] = p
        for i = 1, 10 do
          quadric[a][i] = quadric[a][i] + quadric[b][i]
        end
        for _, t in ipairs(around[b]) do
          local both = t[1] == a or t[2] == a or t[3] == a
          if both then
            t.dead = true
            live = live - 1
          else
            for corner = 1, 3 do
              if t[corner] == b then
                t[corner] = a
              end
            end
            around[a][#around[a] + 1] = t
          end
        end
        version[b] = -1
        version[a] = version[a] + 1
        for _, w in ipairs((neighbours(a))) do
          consider(a, w)
        end
      end
    end
  end

  -- Number the survivors anew.
  local place, kept_vertices, kept_triangles = {}, {}, {}
  for _, t in ipairs(triangles) do
    if not t.dead then
      local new = {}
      for corner = 1, 3 do
        local v = t[corner]
        if not place[v] then
          place[v] = #kept_vertices + 1
          kept_vertices[place[v]] = vertices[v]
        end
        new[corner] = place[v]
      end
      kept_triangles[#kept_triangles + 1] = new
    end
  end
  return kept_vertices, kept_triangles
end

return decimate
