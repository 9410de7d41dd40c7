-- Question: of the preshapes found for the shipped objects, how many can each shipped hand carry out, and why not the others?
--
-- Every object is asked for every task of the task space, with each hand: sizes are in U, so the object grows with the hand.
-- An object is learned with a memory of its own; what is served is carried out by the simulator. Prints Markdown. Run:
--
--     preshape run scripts/studies/reachability.lua > docs/reachability.md

--- What became of one preshape, as a word that the tables count.
local function outcome(simulation)
  if simulation.status == "collision" and #simulation.collisions == 0 then return "inside" end
  return simulation.status
end

local function share(n, of) return string.format("%.0f %%", 100 * n / math.max(1, of)) end

local function row(...) print("| " .. table.concat({ ... }, " | ") .. " |") end

local function rule(columns) print("|" .. ("---|"):rep(columns)) end

--- Runs every task on one object; every served preshape is given to `seen`.
local function examine(hand, object, seen)
  for _, task in ipairs(preshape.tasks()) do
    local report = preshape.run({
      object = object,
      task = task.name,
      hand = hand,
      memory = ":memory:" .. hand .. object,
      learning = { policy = "learn" },
      execution = { attempts = 4 },
    })
    if report.served then
      local simulation, other = report.simulation, report.second_try
      seen({
        hand = hand,
        object = object,
        task = task.name,
        outcome = outcome(simulation),
        reason = simulation.reason,
        second = other ~= nil and other.result ~= nil,
      })
    end
  end
end

local function count_of(all, wanted)
  local n = 0
  for _, one in ipairs(all) do
    if wanted(one) then n = n + 1 end
  end
  return n
end

local asked = #preshape.objects() * #preshape.tasks()
local all = {}
for _, hand in ipairs(preshape.hands()) do
  for _, object in ipairs(preshape.objects()) do
    examine(hand, object, function(one) all[#all + 1] = one end)
  end
end

local function of(hand, object)
  local some = {}
  for _, one in ipairs(all) do
    if one.hand == hand and (not object or one.object == object) then some[#some + 1] = one end
  end
  return some
end

local function is(word)
  return function(one) return one.outcome == word end
end

local function carried_out(one) return one.outcome == "reached" or one.second end

print("# What the hands carry out")
print()
print("Made by `preshape run scripts/studies/reachability.lua > docs/reachability.md`: the shipped objects, each in the size that the")
print(string.format("hand's U gives it, and the %d tasks of the task space, so %d questions to each hand. *Served*: a preshape whose grasp serves the", #preshape.tasks(), asked))
print("task was found. *Carried out*: the simulated hand comes, opens, closes and touches with its fingertips alone; *with a second")
print("try*: it does so there or at one of the four next-best stations. The rest are the first try's reasons: a link that runs into the")
print("object or the hand itself; a fingertip that only the object's inside leads to, as where the object is longer than the hand is")
print("wide; a contact out of reach; more contacts than fingers.")
print()
row("hand", "served", "carried out", "with a second try", "collision", "only through the object", "out of reach", "too few fingers")
rule(8)
for _, hand in ipairs(preshape.hands()) do
  local some = of(hand)
  local function part(wanted) return share(count_of(some, wanted), #some) end
  row(hand, string.format("%d of %d", #some, asked), part(is("reached")), part(carried_out), part(is("collision")), part(is("inside")),
    part(is("unreachable")), part(is("too_few_fingers")))
end

print()
print("## By object")
print()
print("How many of the served preshapes the hand carries out, with a second try where it needs one.")
print()
row("object", table.unpack(preshape.hands()))
rule(1 + #preshape.hands())
for _, object in ipairs(preshape.objects()) do
  local cells = {}
  for i, hand in ipairs(preshape.hands()) do
    local some = of(hand, object)
    cells[i] = string.format("%d of %d", count_of(some, carried_out), #some)
  end
  row(object, table.unpack(cells))
end

print()
print("## Odd cases")
print()
print("The thesis shows two grasps that its hand could not carry out, and calls them odd: one of a primitive object whose contacts its")
print("reach check refuses (figure 5.25), one of the toy plane with contacts out of reach and fingers in the object (figure 5.26).")
local thesis, plane = of("utah_mit"), of("utah_mit", "toy_plane")
print(string.format("The thesis's hand carries out %d of %d preshapes at the first try here, of the toy plane %d of %d. These are odd cases still: the",
  count_of(thesis, is("reached")), #thesis, count_of(plane, is("reached")), #plane))
print("hand does not carry them out, at the recalled station or at the four next-best ones. The reason is the first try's.")
print()
row("hand", "object", "task", "why")
rule(4)
for _, one in ipairs(all) do
  if not carried_out(one) then row(one.hand, one.object, one.task, one.reason) end
end
return all
