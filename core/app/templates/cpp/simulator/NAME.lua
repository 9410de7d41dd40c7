-- Question: does the hand reach the grasp that is found for a cube?
return preshape.scenario {
  title = "@NAME@ carries out a grasp of a cube",
  object = "cube",
  task = "T1_2",
  simulator = "@NAME@",
  memory = ":memory:",
  seed = 1,
}
