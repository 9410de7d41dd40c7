--- Solids of revolution from a profile.
--
-- A profile is a list of pieces. A piece is a list of points
-- { radius, height, normal along radius, normal along height }, unit U, that
-- runs with the outside on its right; the normals are smooth along a piece and
-- break where one piece ends and the next starts.

local mesh = require("shapes.mesh")

local lathe = {}

--- Straight piece from (r0, h0) to (r1, h1), unit U, in `steps` parts.
function lathe.line(r0, h0, r1, h1, steps)
  local piece = {}
  for i = 0, steps do
    local t = i / steps
    piece[i + 1] = { r0 + (r1 - r0) * t, h0 + (h1 - h0) * t, h1 - h0, r0 - r1 }
  end
  return piece
end

--- Full circle of the given radius about (centre, 0), unit U, in `steps` parts.
function lathe.circle(centre, radius, steps)
  local piece = {}
  for i = 0, steps do
    local angle = 2 * math.pi * (i % steps) / steps
    local c, s = math.cos(angle), math.sin(angle)
    piece[i + 1] = { centre + radius * c, radius * s, c, s }
  end
  return piece
end

--- Mesh of the profile turned about an axis, "y" or "z", in `segments` parts.
function lathe.turn(profile, axis, segments)
  local builder = mesh.builder()
  local function place(r, h, turn)
    local angle = 2 * math.pi * turn / segments
    local c, s = math.cos(angle), math.sin(angle)
    if axis == "y" then
      return r * s, h, r * c
    end
    return r * c, r * s, h
  end
  local function corner(point, turn)
    return builder.vertex(place(point[1], point[2], turn))
  end
  local function normal(point, turn)
    return builder.normal(place(point[3], point[4], turn))
  end
  for _, piece in ipairs(profile) do
    for i = 1, #piece - 1 do
      local p, q = piece[i], piece[i + 1]
      for turn = 0, segments - 1 do
        -- A point on the axis takes the normal of the middle of its triangle.
        local half = turn + 0.5
        local p0, p1 = corner(p, turn), corner(p, turn + 1)
        local q0, q1 = corner(q, turn), corner(q, turn + 1)
        local on_p, on_q = p[1] == 0, q[1] == 0
        local np0 = normal(p, on_p and half or turn)
        local np1 = normal(p, on_p and half or turn + 1)
        local nq0 = normal(q, on_q and half or turn)
        local nq1 = normal(q, on_q and half or turn + 1)
        builder.triangle(p0, p1, q1, np0, np1, nq1)
        builder.triangle(p0, q1, q0, np0, nq1, nq0)
      end
    end
  end
  return builder.mesh
end

return lathe
