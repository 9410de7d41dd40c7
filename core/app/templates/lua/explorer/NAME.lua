-- Question: which station of a dolphin, unknown at first, does @NAME@ find for a pivoting task?
return preshape.scenario {
  title = "@NAME@ explores a dolphin",
  object = "dolphin",
  task = "T1_5",
  explorer = { "@NAME@", starts = 60 },
  memory = ":memory:",
  seed = 1,
}
