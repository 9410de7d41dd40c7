-- Question: which preshape does @NAME@ find nearest to a pivoting task on a cube?
return preshape.scenario {
  title = "@NAME@ on a cube",
  object = "cube",
  task = "T1_2",
  similarity = { "@NAME@", sharpness = 1.5 },
  thresholds = { recognition = 5.0, estimation = 2.0 }, -- on the scale of @NAME@, 0 .. 6
  memory = ":memory:",
  seed = 1,
}
