-- Question: which preshape does @NAME@ find nearest to a pivoting task on a cube?
return preshape.scenario {
  title = "@NAME@ on a cube",
  object = "cube",
  task = "T1_2",
  similarity = { "@NAME@", rotation = 2 },
  thresholds = { recognition = 8.0, estimation = 4.0 }, -- on the scale of @NAME@ with these weights, 0 .. 9
  memory = ":memory:",
  seed = 1,
}
