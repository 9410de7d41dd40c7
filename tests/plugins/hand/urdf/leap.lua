-- The frame H and the sizes are those of hands/leap.
local lean = math.rad(10)
return {
  model = "urdf",
  file = "leap_hand_right/leap_hand_right.urdf",
  base = { link = "palm_lower", position = { -0.04, -0.0224, -0.0345 }, rotation = { math.rad(180) - lean, 0, math.rad(90) } },
  unit_length = 0.0361, finger_spacing = 0.0454, maximum_opening = 0.095, base_width = 0.12,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "thumb_tip_head" } },
    { name = "index", role = "index", tip = { link = "index_tip_head" } },
    { name = "middle", role = "middle", tip = { link = "middle_tip_head" } },
    { name = "ring", role = "ring", tip = { link = "ring_tip_head" } },
  },
}
