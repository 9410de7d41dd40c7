-- The LEAP hand, right: four fingers of four joints. Frame, sources and figures: README.md.

-- H in the palm's frame P (-z out of the palm, x along the stretched fingers): origin on the palm's surface, +Z leaning
-- by `lean` from the palm's normal towards the fingers.
local lean = math.rad(10)
local origin = { -0.04, -0.0224, -0.0345 }
local palm_in_H = { math.rad(180), -lean, math.rad(90) }
local c, s = math.cos(lean), math.sin(lean)
local function to_H(x, y, z)
  x, y, z = x - origin[1], y - origin[2], z - origin[3]
  return { y, c * x + s * z, s * x - c * z }
end

local quarter = 1.57079  -- a right angle with the digits of the published figures
local half = 3.14159

local function joint(name, position, rotation, lower, upper)
  return { name = name, position = position, rotation = rotation, axis = { 0, 0, -1 }, limits = { lower, upper }, torque_limit = 0.95 }
end

local function box(link, centre, half_extents)
  return { link = link, shape = "box", centre = centre, half_extents = half_extents }
end

-- The last link's capsule ends at the tip, 15 mm beside the frame's origin.
local function fingertip(length, z)
  return { link = 4, from = { 0, -0.004, z }, to = { 0, -(length - 0.0105), z }, radius = 0.0105 }
end

-- A forefinger whose flexion axis stands at (x, y, -0.0187) in P: it flexes first and abducts after.
local function forefinger(name, x, y, distal)
  return {
    name = name,
    role = name,
    base = { position = to_H(x, y, -0.0187), rotation = palm_in_H },
    joints = {
      joint(name .. "_proximal", { 0, 0, 0 }, { quarter, quarter, 0 }, -0.314, 2.23),
      joint(name .. "_abduction", { -0.0122, 0.0381, 0.0145 }, { -quarter, 0, quarter }, -1.047, 1.047),
      joint(name .. "_middle", { 0.015, 0.0143, -0.013 }, { quarter, -quarter, 0 }, -0.506, 1.885),
      joint(name .. "_distal", { 0, distal, 0.0002 }, { 0, 0, 0 }, -0.366, 2.042),
    },
    tip = { 0, -0.048, 0.015 },
    links = {
      box(1, { -0.0135, 0.028, 0.0147 }, { 0.0235, 0.025, 0.017 }),
      box(2, { 0.0075, -0.0002, -0.011 }, { 0.017, 0.013, 0.011 }),
      box(3, { 0.0035, -0.02, 0.015 }, { 0.0165, 0.026, 0.016 }),
      fingertip(0.048, 0.015),
    },
  }
end

local thumb = {
  name = "thumb",
  role = "thumb",
  base = { position = to_H(-0.0693, -0.0012, -0.0216), rotation = palm_in_H },
  joints = {
    joint("thumb_opposition", { 0, 0, 0 }, { 0, quarter, 0 }, -0.349, 2.094),
    joint("thumb_rotation", { 0, 0.0143, -0.013 }, { quarter, -quarter, 0 }, -0.47, 2.443),
    joint("thumb_proximal", { 0, 0.0145, -0.017 }, { -quarter, 0, 0 }, -1.2, 1.9),
    joint("thumb_distal", { 0, 0.0466, 0.0002 }, { 0, 0, half }, -1.34, 1.88),
  },
  tip = { 0, -0.06, -0.015 },
  links = {
    box(1, { 0.0075, -0.0002, -0.011 }, { 0.017, 0.013, 0.011 }),
    box(2, { 0, 0, -0.0115 }, { 0.009, 0.017, 0.0115 }),
    box(3, { -0.004, 0.021, -0.014 }, { 0.0145, 0.031, 0.0165 }),
    fingertip(0.06, -0.015),
  },
}

local function palm(centre, half_extents)
  return { shape = "box", centre = to_H(table.unpack(centre)), rotation = palm_in_H, half_extents = half_extents }
end

return {
  model = "dh",
  summary = "LEAP hand, right: four fingers, sixteen joints",
  unit_length = 0.0361,
  finger_spacing = 0.0454,
  maximum_opening = 0.095,
  base_width = 0.12,
  palm = {
    palm({ -0.009, 0.008, -0.011 }, { 0.011, 0.013, 0.017 }),
    palm({ -0.009, -0.037, -0.011 }, { 0.011, 0.013, 0.017 }),
    palm({ -0.009, -0.082, -0.011 }, { 0.011, 0.013, 0.017 }),
    palm({ -0.04, -0.034, -0.0115 }, { 0.02, 0.059, 0.023 }),
    palm({ -0.078, -0.053, -0.0115 }, { 0.022, 0.026, 0.023 }),
    palm({ -0.078, -0.003, 0.0035 }, { 0.022, 0.028, 0.0085 }),
  },
  fingers = {
    thumb,
    forefinger("index", -0.007, 0.023, -0.0361),
    forefinger("middle", -0.0071, -0.0224, -0.0361),
    forefinger("ring", -0.00709, -0.0678, -0.03609),
  },
}
