return {
  model = "urdf",
  file = "dg3f_m/urdf/dg3f_m.urdf",
  base = { link = "l_dg_base", position = { 0, 0, 0.1 }, rotation = { 0, 0, math.rad(90) } },
  unit_length = 0.0434, finger_spacing = 0.046, maximum_opening = 0.1, base_width = 0.1,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "l_dg_1_tip" } },
    { name = "index", role = "index", tip = { link = "l_dg_2_tip" } },
    { name = "middle", role = "middle", tip = { link = "l_dg_3_tip" } },
  },
}
