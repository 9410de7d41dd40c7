-- contact `@NAME@`: a hard finger with Coulomb friction
--
-- It passes any force f = fn n + ft, ft across the inward normal n, with fn >= 0 and |ft| <= mu fn, and no moment
-- [MurrayLiSastry1994, ch. 5]. The pattern wrench is a unit normal force and the share `pull` of the friction that it
-- allows, along the part of the approach axis in the contact plane.

local function dot(x, y)
  return x[1] * y[1] + x[2] * y[2] + x[3] * y[3]
end

local function cross(x, y)
  return { x[2] * y[3] - x[3] * y[2], x[3] * y[1] - x[1] * y[3], x[1] * y[2] - x[2] * y[1] }
end

--- x + factor * y
local function sum(x, factor, y)
  return { x[1] + factor * y[1], x[2] + factor * y[2], x[3] + factor * y[3] }
end

--- A force as a wrench without moment.
local function wrench(f)
  return { f[1], f[2], f[3], 0, 0, 0 }
end

--- Two unit vectors across the normal and each other. They turn with the contact, unless the approach axis runs along
--- the normal: then any pair does.
local function tangents(C)
  local t = cross(C.n, C.a)
  if dot(t, t) < 1e-18 then
    t = cross(C.n, math.abs(C.n[1]) < 0.9 and { 1, 0, 0 } or { 0, 1, 0 })
  end
  if dot(t, t) < 1e-18 then
    return { 1, 0, 0 }, { 0, 1, 0 } -- there is no normal
  end
  t = sum({ 0, 0, 0 }, 1 / math.sqrt(dot(t, t)), t)
  return cross(t, C.n), t
end

return {
  kind = "contact",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "Hard finger: any force in the Coulomb cone, no moment",
  capabilities = { "rejects_nonfinite", "frame_covariant", "friction" },
  parameters = {
    {
      name = "mu", type = "number", default = 0.5, minimum = 0.01, maximum = 10, unit = "1",
      text = "Coulomb friction coefficient",
    },
    {
      name = "pull", type = "number", default = 0.5, minimum = 0, maximum = 1, unit = "1",
      text = "share of the friction used along the approach",
    },
  },
  new = function(p)
    return {
      basis_size = 3,
      -- C.p, C.n, C.a, C.t: three numbers each, in the object's frame
      basis = function(C)
        local first, second = tangents(C)
        return { wrench(C.n), wrench(first), wrench(second) }
      end,
      pattern = function(C)
        local across = sum(C.a, -dot(C.a, C.n), C.n)
        return wrench(sum(C.n, p.pull * p.mu, across))
      end,
      -- Edges of the friction cone, for quality measures that ask which wrenches a grasp bears.
      primitives = function(C, resolution)
        local first, second = tangents(C)
        local edges = {}
        for k = 1, resolution do
          local angle = 2 * math.pi * (k - 1) / resolution
          edges[k] = wrench(sum(sum(C.n, p.mu * math.cos(angle), first), p.mu * math.sin(angle), second))
        end
        return edges
      end,
      admits = function(C, F, tolerance)
        local fn = dot(F, C.n)
        local ft = sum(F, -fn, C.n)
        local moment = { F[4], F[5], F[6] }
        return fn >= 0 and math.sqrt(dot(ft, ft)) <= (p.mu + tolerance) * fn
          and math.sqrt(dot(moment, moment)) <= tolerance * fn
      end,
    }
  end,
}
