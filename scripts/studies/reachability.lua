-- Question: of the preshapes found for the shipped objects, how many can each shipped hand carry out, and why not the others?
--
-- Objects are scaled to each hand's U. Every object is learned with a hand of its own memory and the policy "learn"; what is
-- served is carried out by the simulator. Prints Markdown. Run:
--
--     preshape run scripts/studies/reachability.lua > docs/reachability.md

local tasks = { "T1_1", "T1_5", "T2_3", "T2_6", "T3_2", "T3_4", "T4_1", "T4_6" }

local function examine(hand)
  local count = { asked = 0, served = 0, reached = 0, second = 0, collision = 0, unreachable = 0, too_few_fingers = 0 }
  for _, object in ipairs(preshape.objects()) do
    for _, task in ipairs(tasks) do
      local report = preshape.run({
        object = object,
        task = task,
        hand = hand,
        memory = ":memory:" .. hand .. object,
        learning = { policy = "learn" },
        execution = { attempts = 2 },
      })
      count.asked = count.asked + 1
      if report.served then
        count.served = count.served + 1
        local status = report.simulation.status
        count[status] = count[status] + 1
        if report.second_try and report.second_try.result then count.second = count.second + 1 end
      end
    end
  end
  return count
end

print("# What the hands carry out")
print()
print("Made by `preshape run scripts/studies/reachability.lua > docs/reachability.md`: the shipped objects, scaled to each hand's U,")
print(string.format("and %d tasks of the task space (%s). *Served*: a preshape was found;", #tasks, table.concat(tasks, ", ")))
print("*reached*: the simulated hand carries the recalled preshape out; *second try*: one of the two next-best stations instead; the")
print("others fail as told. What cannot be reached is the thesis's odd cases of figures 5.25 and 5.26, and told as such.")
print()
print("| hand | served | reached | with a second try | collision | out of reach | too few fingers |")
print("|---|---|---|---|---|---|---|")
local results = {}
for _, hand in ipairs(preshape.hands()) do
  local c = examine(hand)
  results[hand] = c
  local function share(n) return string.format("%.0f %%", 100 * n / math.max(1, c.served)) end
  print(string.format("| %s | %d of %d | %s | %s | %s | %s | %s |", hand, c.served, c.asked, share(c.reached),
    share(c.reached + c.second), share(c.collision), share(c.unreachable), share(c.too_few_fingers)))
end
return results
