return {
  model = "urdf",
  file = "dclaw_gripper/dclaw_gripper.urdf",
  base = { link = "base_link", rotation = { 0, math.rad(90), 0 } },
  unit_length = 0.0685, finger_spacing = 0.1, maximum_opening = 0.15, base_width = 0.16,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "link_f3_head" } },
    { name = "index", role = "index", tip = { link = "link_f2_head" } },
    { name = "middle", role = "middle", tip = { link = "link_f1_head" } },
  },
}
