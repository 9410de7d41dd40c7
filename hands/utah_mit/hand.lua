-- A four-finger hand of sixteen joints like the Utah/MIT hand (thesis sec. 4.4). Frame, sources and figures: README.md.

-- Links of a finger, base to tip [U]: knuckle (abduction axis to flexion axis), proximal, middle, distal.
local length = { 0.5, 1.7, 1.0, 0.8 }
local radius = { 0.35, 0.32, 0.28, 0.25 }

-- A link's capsule, along x of the link's frame, which sits at its far end. That of the last link ends at the tip.
local function capsule(link)
  local tip_cap = link == #length and radius[link] or 0
  return { link = link, shape = "capsule", from = { -length[link], 0, 0 }, to = { -tip_cap, 0, 0 }, radius = radius[link] }
end

-- A finger whose abduction axis stands at (x, y) on the palm. Frame 0 has x along the approach axis and z along the
-- opposition axis; turned by `yaw` about the approach axis.
local function finger(name, x, y, yaw, spread)
  local function joint(suffix, link, alpha, lower, upper)
    return {
      name = name .. "_" .. suffix,
      a = length[link],
      alpha = math.rad(alpha),
      limits = { math.rad(lower), math.rad(upper) },
    }
  end
  return {
    name = name,
    role = name,
    base = { position = { x, y, 0 }, rotation = { math.rad(-90), math.rad(-90), math.rad(yaw) } },
    joints = {
      joint("abduction", 1, -90, -spread, spread),
      joint("proximal", 2, 0, -90, 45),
      joint("middle", 3, 0, 0, 110),
      joint("distal", 4, 0, 0, 90),
    },
    links = { capsule(1), capsule(2), capsule(3), capsule(4) },
  }
end

return {
  model = "dh",
  summary = "Four fingers, sixteen joints, like the Utah/MIT hand",
  unit_length = 0.03,
  lengths = "U",
  finger_spacing = 1,
  maximum_opening = 4,
  base_width = 5,
  palm = {
    { shape = "box", centre = { 0, 0, -0.4 }, half_extents = { 2.5, 1.5, 0.4 } },
  },
  fingers = {
    finger("thumb", 0, -1, 180, 45),
    finger("index", 1, 1, 0, 30),
    finger("middle", 0, 1, 0, 30),
    finger("ring", -1, 1, 0, 30),
  },
}
