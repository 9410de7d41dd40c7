-- Question: which preshape lets a hand with hard, rough fingertips pivot a cube?
return preshape.scenario {
  title = "@NAME@ on a cube",
  object = "cube",
  task = "T1_2",
  contact = { "@NAME@", mu = 0.6 },
  memory = ":memory:",
  seed = 1,
}
