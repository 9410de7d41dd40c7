-- Question: which tasks does each shipped object's memory serve, before and after learning, and how near do the recalled
-- grasps come to the best that an exhaustive search finds?
--
-- Each object has a memory of its own, pretrained on the cube. Every task of the signed task space is first estimated
-- (modes 0 and 1, nothing learned), then run with the policy "learn", then, when all have been run, estimated again.
--
--   preshape run scripts/studies/coverage.lua > docs/coverage.md
local tasks = preshape.tasks(true)
local threshold = 3.0

local function scenario(object, task)
  return {
    object = object,
    task = task.name,
    memory = ":memory:" .. object,
    learning = { policy = "learn" },
    simulator = "none", -- the question is what is recalled
    seed = 1,
  }
end

--- The similarity of an estimate: of its best grasp, 0 where there is none.
local function score(report)
  return report.result and report.result.similarity.first or 0
end

--- What an exhaustive search finds, 0 where no station has a grasp.
local function best_score(object, task)
  local description = scenario(object, task)
  description.explorer = "exhaustive"
  local best = preshape.best(description)
  return best and best.first or 0
end

local function examine(object)
  local rows = {}
  for i, task in ipairs(tasks) do
    local report = preshape.estimate(scenario(object, task))
    rows[i] = {
      object = object, task = task.name, best = best_score(object, task),
      before = score(report), before_mode = report.served and report.mode or -1,
    }
  end
  for i, task in ipairs(tasks) do
    local report = preshape.run(scenario(object, task))
    rows[i].status, rows[i].mode = report.status, report.mode
  end
  for i, task in ipairs(tasks) do
    local report = preshape.estimate(scenario(object, task))
    rows[i].after, rows[i].after_mode = score(report), report.served and report.mode or -1
  end
  return rows
end

--- Counts and mean ratios over the tasks that some grasp of the object serves.
local function summarise(rows)
  local s = { servable = 0, before = 0, after = 0, ratio_before = 0, ratio_after = 0, taught = 0, kept = 0, ratio_taught = 0 }
  for _, row in ipairs(rows) do
    if row.status == "learned" then
      s.taught = s.taught + 1
      s.kept = s.kept + (row.after_mode >= 0 and 1 or 0)
      s.ratio_taught = s.ratio_taught + row.after / row.best
    end
    if row.best >= threshold then
      s.servable = s.servable + 1
      s.before = s.before + (row.before_mode >= 0 and 1 or 0)
      s.after = s.after + (row.after_mode >= 0 and 1 or 0)
      s.ratio_before = s.ratio_before + row.before / row.best
      s.ratio_after = s.ratio_after + row.after / row.best
    end
  end
  if s.servable > 0 then
    s.ratio_before = s.ratio_before / s.servable
    s.ratio_after = s.ratio_after / s.servable
  end
  if s.taught > 0 then
    s.ratio_taught = s.ratio_taught / s.taught
  end
  return s
end

local function mode_text(mode)
  return mode >= 0 and tostring(mode) or "-"
end

local function ratio_text(value, best)
  return best > 0 and string.format("%.2f", value / best) or "-"
end

print("# Coverage of the task space\n")
print("Made by `preshape run scripts/studies/coverage.lua > docs/coverage.md`. The 84 tasks are the 24 of the task space with all")
print("their sign variants. *Servable*: an exhaustive search finds a grasp with a TFVADI of at least " .. threshold .. ".")
print("*Ratio*: TFVADI of the recalled grasp (modes 0 and 1) over that of the exhaustive search, mean over the servable tasks.\n")
print("*Taught*: tasks that were not served as they came and were learned; *kept*: how many of them are served at the end.\n")
print("A task that was served without being taught is not in the memory, so a later lesson may change what is recalled for it;")
print("what was taught itself stays. Tasks that are not servable end in mode 3 as a deadlock, or in mode 2 on a known object.\n")
print("| object | servable | served before | served after | ratio before | ratio after | taught | kept | ratio of the taught |")
print("|---|---|---|---|---|---|---|---|---|")
local all = {}
for _, object in ipairs(preshape.objects()) do
  local rows = examine(object)
  local s = summarise(rows)
  print(string.format("| %s | %d | %d | %d | %.2f | %.2f | %d | %d | %.2f |", object, s.servable, s.before, s.after,
    s.ratio_before, s.ratio_after, s.taught, s.kept, s.ratio_taught))
  for _, row in ipairs(rows) do
    all[#all + 1] = row
  end
end

print("\n## Every task\n")
print("*Before* and *after* are the mode (0, 1, or - where the task was not served) and the TFVADI of what is recalled before")
print("anything was learned and after all 84 tasks were run; *run* is how the run in between ended.\n")
print("| object | task | before | TFVADI | ratio | run | after | TFVADI | ratio | best |")
print("|---|---|---|---|---|---|---|---|---|---|")
for _, row in ipairs(all) do
  print(string.format("| %s | %s | %s | %.2f | %s | %s (%d) | %s | %.2f | %s | %.2f |", row.object, row.task,
    mode_text(row.before_mode), row.before, ratio_text(row.before, row.best), row.status, row.mode,
    mode_text(row.after_mode), row.after, ratio_text(row.after, row.best), row.best))
end
return all
