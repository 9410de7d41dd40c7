-- Question: does @NAME@ find the contacts of a grasp of a cube?
return preshape.scenario {
  title = "@NAME@ on a cube",
  object = "cube",
  task = "T1_2",
  collision = "@NAME@",
  memory = ":memory:",
  seed = 1,
}
