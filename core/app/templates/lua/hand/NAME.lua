-- Question: which preshape of a gripper with long forefingers pivots a cube?
return preshape.scenario {
  title = "@NAME@ and a cube",
  object = "cube",
  hand = { model = "@NAME@", forefingers = 2, distal = 0.05 },
  task = "T1_2",
  memory = ":memory:",
  seed = 1,
}
