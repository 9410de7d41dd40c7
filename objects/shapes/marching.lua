--- Surface of a signed distance function by marching tetrahedra.
--
-- Each lattice cell is parted into six tetrahedra around its main diagonal,
-- alike in all cells, so neighbours agree on every face. A tetrahedron has no
-- ambiguous case: the surface is closed and manifold whatever the function.

-- Tetrahedra as cell corners (bit 0 = +x, bit 1 = +y, bit 2 = +z), positive.
local tetrahedra = {
  { 0, 1, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 },
  { 0, 3, 2, 7 }, { 0, 6, 4, 7 }, { 0, 5, 1, 7 },
}
-- Even orders of the four corners: the inner ones come first.
local one_inside = { { 1, 2, 3, 4 }, { 2, 1, 4, 3 }, { 3, 1, 2, 4 }, { 4, 1, 3, 2 } }
local two_inside = {
  { 1, 2, 3, 4 }, { 1, 3, 4, 2 }, { 1, 4, 2, 3 },
  { 2, 3, 1, 4 }, { 2, 4, 3, 1 }, { 3, 4, 1, 2 },
}

-- For each of the 256 sign patterns of a cell the list of triangles, each of
-- six corners: three crossed edges (from, to).
local cases = {}
for pattern = 0, 255 do
  local list = {}
  local function add(a, b, c, d, e, f)
    list[#list + 1] = { a, b, c, d, e, f }
  end
  for _, corners in ipairs(tetrahedra) do
    local inside, count = {}, 0
    for i = 1, 4 do
      inside[i] = (pattern >> corners[i]) & 1 == 1
      count = count + (inside[i] and 1 or 0)
    end
    if count == 1 or count == 3 then
      for _, order in ipairs(one_inside) do
        if inside[order[1]] == (count == 1) then
          local i, j, k, l = corners[order[1]], corners[order[2]], corners[order[3]], corners[order[4]]
          if count == 1 then
            add(i, j, i, k, i, l)
          else
            add(i, j, i, l, i, k)
          end
        end
      end
    elseif count == 2 then
      for _, order in ipairs(two_inside) do
        if inside[order[1]] and inside[order[2]] then
          local i, j, k, l = corners[order[1]], corners[order[2]], corners[order[3]], corners[order[4]]
          add(i, k, i, l, j, l)
          add(i, k, j, l, j, k)
        end
      end
    end
  end
  cases[pattern] = list
end

--- Vertices { x, y, z } and triangles { a, b, c } of the surface f = 0 in the
-- box from `low` to `high`, lattice step `step`, all in U. The box has to
-- clear the surface by a step. Blocks whose middle is further from the surface
-- than their corners (twice, for functions that are not quite distances) are
-- not sampled.
local function marching(f, low, high, step)
  local block = 4
  local cells = {}
  for axis = 1, 3 do
    cells[axis] = math.ceil((high[axis] - low[axis]) / step / block) * block
  end
  local nx, ny, nz = cells[1] + 1, cells[2] + 1, cells[3] + 1
  local x0, y0, z0 = low[1], low[2], low[3]
  local dy, dz = nx, nx * ny

  local value, sampled, busy = {}, {}, {}
  local reach = 2 * math.sqrt(3) * step * block / 2
  for k = 0, nz - 2, block do
    for j = 0, ny - 2, block do
      for i = 0, nx - 2, block do
        local half = block / 2
        local d = f(x0 + (i + half) * step, y0 + (j + half) * step, z0 + (k + half) * step)
        local near = math.abs(d) <= reach
        if near then
          busy[#busy + 1] = { i, j, k }
        end
        for kk = k, k + block do
          for jj = j, j + block do
            for ii = i, i + block do
              local index = ii + dy * jj + dz * kk
              if near then
                -- A sampled block overrules what a neighbour assumed.
                if not sampled[index] then
                  sampled[index] = true
                  value[index] = f(x0 + ii * step, y0 + jj * step, z0 + kk * step)
                end
              elseif value[index] == nil then
                value[index] = d
              end
            end
          end
        end
      end
    end
  end

  local offset = {}
  for corner = 0, 7 do
    offset[corner] = (corner & 1) + dy * ((corner >> 1) & 1) + dz * (corner >> 2)
  end
  local vertices, triangles, known = {}, {}, {}
  -- Vertex on the edge between two corners of the cell at (i, j, k).
  local function crossing(i, j, k, index, from, to)
    local a, b = math.min(from, to), math.max(from, to)
    local key = (index + offset[a]) * 8 + (b - a)
    local found = known[key]
    if not found then
      local va, vb = value[index + offset[a]], value[index + offset[b]]
      -- Held off the ends, where vertices of several edges would meet.
      local t = math.max(0.05, math.min(0.95, va / (va - vb)))
      local edge = b - a
      found = #vertices + 1
      vertices[found] = {
        x0 + (i + (a & 1) + t * (edge & 1)) * step,
        y0 + (j + ((a >> 1) & 1) + t * ((edge >> 1) & 1)) * step,
        z0 + (k + (a >> 2) + t * (edge >> 2)) * step,
      }
      known[key] = found
    end
    return found
  end

  for _, corner in ipairs(busy) do
    for k = corner[3], corner[3] + block - 1 do
      for j = corner[2], corner[2] + block - 1 do
        for i = corner[1], corner[1] + block - 1 do
          local index = i + dy * j + dz * k
          local pattern = 0
          for c = 0, 7 do
            if value[index + offset[c]] < 0 then
              pattern = pattern | (1 << c)
            end
          end
          for _, t in ipairs(cases[pattern]) do
            triangles[#triangles + 1] = {
              crossing(i, j, k, index, t[1], t[2]),
              crossing(i, j, k, index, t[3], t[4]),
              crossing(i, j, k, index, t[5], t[6]),
            }
          end
        end
      end
    end
  end
  return vertices, triangles
end

return marching
