--- Signed distance functions: f(x, y, z) -> distance to the surface, unit U,
-- negative inside. Primitives first, then ways to combine and move them.
--
-- Only + - * / and square roots are used on coordinates, which every IEEE 754
-- machine rounds alike: a shape comes out the same everywhere.

local sdf = {}

local sqrt, abs, max, min = math.sqrt, math.abs, math.max, math.min

local function clamp(value, low, high)
  return max(low, min(high, value))
end

--- Sine and cosine of an angle in degrees, cut to nine decimals so that the
-- last bit of the C library does not matter.
local function sine_cosine(degrees)
  local function cut(value)
    return math.floor(value * 1e9 + 0.5) / 1e9
  end
  local angle = math.rad(degrees)
  return cut(math.sin(angle)), cut(math.cos(angle))
end

-- Primitives ---------------------------------------------------------------

--- Ellipsoid with the given half axes, U. Close to the distance near the
-- surface; exact for a sphere.
function sdf.ellipsoid(a, b, c)
  local smallest = min(a, b, c)
  return function(x, y, z)
    local px, py, pz = x / a, y / b, z / c
    local k = sqrt(px * px + py * py + pz * pz)
    if k < 1e-9 then
      return -smallest
    end
    local qx, qy, qz = px / a, py / b, pz / c
    return k * (k - 1) / sqrt(qx * qx + qy * qy + qz * qz)
  end
end

--- Box with the given extents, U, its edges rounded with radius r.
function sdf.box(width, height, depth, r)
  local a, b, c = width / 2 - r, height / 2 - r, depth / 2 - r
  return function(x, y, z)
    local qx, qy, qz = abs(x) - a, abs(y) - b, abs(z) - c
    local ox, oy, oz = max(qx, 0), max(qy, 0), max(qz, 0)
    return sqrt(ox * ox + oy * oy + oz * oz) + min(max(qx, qy, qz), 0) - r
  end
end

--- Cylinder about Y, U, its rims rounded with radius r.
function sdf.cylinder(radius, height, r)
  local a, b = radius - r, height / 2 - r
  return function(x, y, z)
    local q, s = sqrt(x * x + z * z) - a, abs(y) - b
    local oq, os = max(q, 0), max(s, 0)
    return sqrt(oq * oq + os * os) + min(max(q, s), 0) - r
  end
end

--- Line from p to q, U, with a round section whose radius goes from r to s:
-- two balls and the cone touching both.
function sdf.limb(p, r, q, s)
  local px, py, pz = p[1], p[2], p[3]
  local bx, by, bz = q[1] - px, q[2] - py, q[3] - pz
  local l2 = bx * bx + by * by + bz * bz
  local rr = r - s
  local a2 = l2 - rr * rr
  local il2 = 1 / l2
  return function(x, y, z)
    local ax, ay, az = x - px, y - py, z - pz
    local along = ax * bx + ay * by + az * bz
    local back = along - l2
    local ex, ey, ez = ax * l2 - bx * along, ay * l2 - by * along, az * l2 - bz * along
    local x2 = ex * ex + ey * ey + ez * ez
    local y2, z2 = along * along * l2, back * back * l2
    local k = (rr < 0 and -1 or rr > 0 and 1 or 0) * rr * rr * x2
    if (back < 0 and -1 or 1) * a2 * z2 > k then
      return sqrt(x2 + z2) * il2 - s
    elseif (along < 0 and -1 or 1) * a2 * y2 < k then
      return sqrt(x2 + y2) * il2 - r
    end
    return (sqrt(x2 * a2 * il2) + along * rr) * il2 - r
  end
end

--- Rounded plate: the closed outline of points { u, v }, U, in the plane of
-- X and Y, grown by `r` in all directions. Its thickness is 2 r plus `flat`.
function sdf.plate(outline, r, flat)
  local count = #outline
  local us, vs = {}, {}
  for i, point in ipairs(outline) do
    us[i], vs[i] = point[1], point[2]
  end
  local h = (flat or 0) / 2
  local u0, u1 = min(table.unpack(us)), max(table.unpack(us))
  local v0, v1 = min(table.unpack(vs)), max(table.unpack(vs))
  return function(x, y, z)
    -- Far from the surrounding box its distance will do: it is the lesser one,
    -- and beyond the reach of any fillet.
    local far = max(u0 - x, x - u1, v0 - y, y - v1, abs(z) - h) - r
    if far > 0.4 then
      return far
    end
    local best, sign = math.huge, 1
    local uj, vj = us[count], vs[count]
    for i = 1, count do
      local ui, vi = us[i], vs[i]
      local eu, ev, wu, wv = uj - ui, vj - vi, x - ui, y - vi
      local t = clamp((wu * eu + wv * ev) / (eu * eu + ev * ev), 0, 1)
      local du, dv = wu - eu * t, wv - ev * t
      best = min(best, du * du + dv * dv)
      local above, below, left = y >= vi, y < vj, eu * wv > ev * wu
      if (above and below and left) or not (above or below or left) then
        sign = -sign
      end
      uj, vj = ui, vi
    end
    local d, s = sign * sqrt(best), abs(z) - h
    local od, os = max(d, 0), max(s, 0)
    return sqrt(od * od + os * os) + min(max(d, s), 0) - r
  end
end

--- Long body along X with a section that varies: stations
-- { x, centre y, half height, half width }, U, joined by smooth curves and
-- closed by half ellipsoids at both ends.
function sdf.body(stations)
  local count = #stations
  local first, last = stations[1][1], stations[count][1]
  -- Cubic Hermite pieces with the slopes of the neighbours.
  local slope = {}
  for i = 1, count do
    local p, q = stations[max(i - 1, 1)], stations[min(i + 1, count)]
    slope[i] = {}
    for k = 2, 4 do
      slope[i][k] = (q[k] - p[k]) / (q[1] - p[1])
      -- Level at the ends, where the ellipsoids take over.
      if i == 1 or i == count then
        slope[i][k] = 0
      end
    end
  end
  return function(x, y, z)
    local cx = clamp(x, first, last)
    local i = 1
    while i < count - 1 and cx > stations[i + 1][1] do
      i = i + 1
    end
    local p, q, sp, sq = stations[i], stations[i + 1], slope[i], slope[i + 1]
    local length = q[1] - p[1]
    local t = (cx - p[1]) / length
    local u = 1 - t
    local hp, hq, gp, gq = (1 + 2 * t) * u * u, t * t * (3 - 2 * t), t * u * u * length, -t * t * u * length
    local centre = hp * p[2] + hq * q[2] + gp * sp[2] + gq * sq[2]
    local high = hp * p[3] + hq * q[3] + gp * sp[3] + gq * sq[3]
    local wide = hp * p[4] + hq * q[4] + gp * sp[4] + gq * sq[4]
    local least = min(high, wide)
    local dx, dy, dz = (x - cx) / least, (y - centre) / high, z / wide
    return (sqrt(dx * dx + dy * dy + dz * dz) - 1) * least
  end
end

--- Ring in the plane of X and Y whose axis is stretched into a stadium:
-- centre-line radius `major`, straight parts of length `straight` along Y;
-- section half widths `a` in the plane and `b` along Z, U.
function sdf.ring(major, straight, a, b)
  local h, least = straight / 2, min(a, b)
  return function(x, y, z)
    local v = y - clamp(y, -h, h)
    local p, q = (sqrt(x * x + v * v) - major) / a, z / b
    return (sqrt(p * p + q * q) - 1) * least
  end
end

-- Combinations ---------------------------------------------------------------

--- Union of all arguments after k; a fillet of width about k, U, joins them.
function sdf.union(k, ...)
  local parts = { ... }
  local count = #parts
  return function(x, y, z)
    local d = parts[1](x, y, z)
    for i = 2, count do
      local e = parts[i](x, y, z)
      local h = max(k - abs(d - e), 0)
      d = min(d, e) - h * h / (4 * k)
    end
    return d
  end
end

--- Shape a without shape b; the new edge is rounded over about k, U.
function sdf.cut(k, a, b)
  return function(x, y, z)
    local d, e = a(x, y, z), -b(x, y, z)
    local h = max(k - abs(d - e), 0)
    return max(d, e) + h * h / (4 * k)
  end
end

-- Placement ------------------------------------------------------------------

--- Shape moved by (dx, dy, dz), U.
function sdf.move(dx, dy, dz, f)
  return function(x, y, z)
    return f(x - dx, y - dy, z - dz)
  end
end

--- Shape turned by degrees about the axis "x", "y" or "z", right-handed.
function sdf.turn(axis, degrees, f)
  local s, c = sine_cosine(degrees)
  if axis == "x" then
    return function(x, y, z)
      return f(x, c * y + s * z, c * z - s * y)
    end
  elseif axis == "y" then
    return function(x, y, z)
      return f(c * x - s * z, y, s * x + c * z)
    end
  end
  return function(x, y, z)
    return f(c * x + s * y, c * y - s * x, z)
  end
end

--- Shape for z >= 0 and its mirror image for z < 0.
function sdf.mirror_z(f)
  return function(x, y, z)
    return f(x, y, abs(z))
  end
end

--- Shape for x >= 0 and its mirror image for x < 0.
function sdf.mirror_x(f)
  return function(x, y, z)
    return f(abs(x), y, z)
  end
end

--- Limbs through a list of points { x, y, z, radius }, U, joined over k.
function sdf.chain(k, points)
  local parts = {}
  for i = 1, #points - 1 do
    local p, q = points[i], points[i + 1]
    parts[i] = sdf.limb(p, p[4], q, q[4])
  end
  return sdf.union(k, table.unpack(parts))
end

--- Closed smooth outline through the points { u, v }, U, with `steps` points
-- on each side (Catmull-Rom); for sdf.plate.
function sdf.outline(points, steps)
  local result, count = {}, #points
  local function at(i)
    return points[(i - 1) % count + 1]
  end
  for i = 1, count do
    local a, b, c, d = at(i - 1), at(i), at(i + 1), at(i + 2)
    for step = 0, steps - 1 do
      local t = step / steps
      local function curve(k)
        local p, q, r, s = a[k], b[k], c[k], d[k]
        return (2 * q + t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * q - p - 3 * r + s)))) / 2
      end
      result[#result + 1] = { curve(1), curve(2) }
    end
  end
  return result
end

return sdf
