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

  local function length2(p, q)
    local x, y, z = p[1] - q[1], p[2] - q[2], p[3] - q[3]
    return x * x + y * y + z * z
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

  --- Forgets the dead triangles at a vertex and returns the live ones.
  local function fan(v)
    local list, count = around[v], 0
    for i = 1, #list do
      local t = list[i]
      if not t.dead then
        count = count + 1
        list[count] = t
      end
    end
    for i = #list, count + 1, -1 do
      list[i] = nil
    end
    return list
  end

  -- marked[w] = mark says that w was met in the present round.
  local mark, marked = 0, {}
  for v = 1, #vertices do
    marked[v] = 0
  end

  --- Number of neighbours the vertices a and b have in common.
  local function shared(a, b)
    mark = mark + 1
    for _, t in ipairs(fan(a)) do
      marked[t[1]], marked[t[2]], marked[t[3]] = mark, mark, mark
    end
    local met = mark
    mark = mark + 1
    marked[a], marked[b] = mark, mark
    local count = 0
    for _, t in ipairs(fan(b)) do
      for corner = 1, 3 do
        local w = t[corner]
        if marked[w] == met then
          count = count + 1
          marked[w] = mark
        end
      end
    end
    return count
  end

  --- Cost of drawing the edge a-b together, and the point to draw it to.
  local function merge(a, b)
    local p, q = vertices[a], vertices[b]
    local side2 = length2(p, q)
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
    return math.max(off, 0) + 1e-4 * side2 * side2, x, y, z
  end

  local heap, order = {}, 0
  local function consider(a, b)
    order = order + 1
    push(heap, { (merge(a, b)), order, a, b, version[a], version[b] })
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
        local side2 = math.max(length2(q, r), length2(r, s), length2(s, q))
        if side2 > longest * longest or new < 0.04 * side2 * side2 and new < old then
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
    if version[a] == entry[5] and version[b] == entry[6] and shared(a, b) == 2 and live > 4 then
      local _, x, y, z = merge(a, b)
      local p = { x, y, z }
      if survives(a, b, p) and survives(b, a, p) then
        vertices[a] = p
        local s, t = quadric[a], quadric[b]
        for i = 1, 10 do
          s[i] = s[i] + t[i]
        end
        local list = around[a]
        for _, u in ipairs(around[b]) do
          if u[1] == a or u[2] == a or u[3] == a then
            u.dead = true
            live = live - 1
          else
            for corner = 1, 3 do
              if u[corner] == b then
                u[corner] = a
              end
            end
            list[#list + 1] = u
          end
        end
        version[b] = -1
        version[a] = version[a] + 1
        mark = mark + 1
        local met = mark
        marked[a] = met
        for _, u in ipairs(fan(a)) do
          for corner = 1, 3 do
            local w = u[corner]
            if marked[w] ~= met then
              marked[w] = met
              consider(a, w)
            end
          end
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
