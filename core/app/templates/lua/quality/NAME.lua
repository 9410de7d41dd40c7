-- Question: how evenly does the preshape found for a cube bear wrenches in all directions?
return preshape.scenario {
  title = "@NAME@ of a grasp of a cube",
  object = "cube",
  task = "T1_2",
  quality = { "sta_manu", "@NAME@" },
  memory = ":memory:",
  seed = 1,
}
