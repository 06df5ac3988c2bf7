package org.toqa.allocation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.OpenTasks.TeamTask;
import org.toqa.allocation.RoundTable.Filling;

/**
 * Which robots get which tasks, those for several robots among them, at the least cost over all:
 * first as many robots at work as can be, then the least energy, less what it is worth that tasks
 * have waited.
 *
 * <p>Branch and bound. A {@link RoundTable} fills the rows of teams like all others, which is a
 * bound for what is possible; what it breaks is branched on, the most promising branch first: a
 * team has all its robots or none, they are strong enough together, and nobody else is sent to its
 * places. So without such tasks it is one assignment, and the first answer that breaks nothing is
 * the best. After {@link #MOST_FILLINGS} the best so far counts; the first one lets the oldest
 * teams have the nearest robots.
 */
final class JointAssignment {
  private static final int MOST_FILLINGS = 120;

  private static final Comparator<Filling> BETTER =
      Comparator.comparingInt((Filling filling) -> -filling.working())
          .thenComparingDouble(Filling::joules);

  private static final Comparator<Node> MOST_PROMISING =
      Comparator.comparing(Node::filling, BETTER).thenComparingInt(Node::number);

  private final RoundTable table;
  private final List<TeamTask> teams;
  private final TeamChoices root;
  private final PriorityQueue<Node> open = new PriorityQueue<>(MOST_PROMISING);
  private final Set<TeamChoices> seen = new HashSet<>();
  private int fillings;

  /**
   * @param number counted from the first, so that the search is the same every time
   */
  private record Node(TeamChoices choices, Filling filling, int number) {}

  JointAssignment(RoundTable table, OpenTasks tasks) {
    this.table = table;
    teams = tasks.teams();
    root = tasks.isFirstTeamOldest() ? TeamChoices.NONE.choosing(0) : TeamChoices.NONE;
  }

  /** Each team has all its robots or none. */
  Filling best() {
    Optional<Filling> best = teams.isEmpty() ? Optional.empty() : oldestTeamsFirst();
    branch(root);
    while (!open.isEmpty()) {
      Node node = open.remove();
      if (best.isPresent() && BETTER.compare(best.get(), node.filling()) <= 0) {
        break; // nothing that is left can be better
      }
      int broken = firstBroken(node);
      if (broken < 0) {
        return node.filling();
      }
      if (fillings >= MOST_FILLINGS) {
        break;
      }
      branchOn(node, broken);
    }
    return best.or(() -> table.fill(droppingAll())).orElseThrow();
  }

  private void branchOn(Node node, int team) {
    if (node.choices().isOpen(team)) {
      branch(node.choices().choosing(team));
      branch(node.choices().dropping(team));
      return;
    }
    for (int robot : members(node.filling(), team)) {
      branch(node.choices().excluding(team, robot));
    }
  }

  private void branch(TeamChoices choices) {
    if (seen.add(choices)) {
      fillings++;
      table.fill(choices).ifPresent(filling -> open.add(new Node(choices, filling, fillings)));
    }
  }

  private List<Integer> members(Filling filling, int team) {
    return filling.robots().get(table.firstTeam() + team);
  }

  /** The oldest team that is filled in part, is too weak, or gets in another's way; -1: none. */
  private int firstBroken(Node node) {
    return IntStream.range(0, teams.size())
        .filter(team -> isBroken(node, team))
        .findFirst()
        .orElse(-1);
  }

  private boolean isBroken(Node node, int team) {
    List<Integer> members = members(node.filling(), team);
    if (members.isEmpty()) {
      return false;
    }
    return members.size() < table.size(team)
        || !table.isStrongEnough(team, members)
        || (node.choices().isOpen(team) && isInTheWay(node.filling(), team));
  }

  private boolean isInTheWay(Filling filling, int team) {
    int task = table.firstTeam() + team;
    return IntStream.range(0, table.taskCount())
        .filter(other -> other != task && table.holder(other).isEmpty())
        .anyMatch(other -> !filling.robots().get(other).isEmpty() && table.isConflict(task, other));
  }

  /** One after the other has the nearest robots that are left. */
  private Optional<Filling> oldestTeamsFirst() {
    TeamChoices choices = TeamChoices.NONE;
    Set<String> taken = new HashSet<>();
    List<Integer> chosen = new ArrayList<>();
    for (int i = 0; i < teams.size(); i++) {
      int team = table.firstTeam() + i;
      List<Candidate> members = nearest(teams.get(i), taken);
      boolean isPossible =
          members != null
              && chosen.stream().noneMatch(t -> table.isConflict(table.firstTeam() + t, team));
      choices = isPossible ? choices.choosing(i) : choices.dropping(i);
      if (members != null && isPossible) {
        chosen.add(i);
        members.forEach(robot -> taken.add(robot.robot()));
        for (int robot = 0; robot < table.robotCount(); robot++) {
          choices = members.contains(table.robot(robot)) ? choices : choices.excluding(i, robot);
        }
      }
    }
    return table.fill(choices);
  }

  private static @Nullable List<Candidate> nearest(TeamTask team, Set<String> taken) {
    List<Candidate> left =
        IntStream.range(0, team.able().size())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> team.quotes().get(i).approach()))
            .map(i -> team.able().get(i))
            .filter(robot -> !taken.contains(robot.robot()))
            .toList();
    List<Candidate> members = TeamSize.first(team.task().load(), team.size(), left);
    return members.size() == team.size() && TeamSize.isStrongEnough(team.task().load(), members)
        ? members
        : null;
  }

  private TeamChoices droppingAll() {
    TeamChoices choices = TeamChoices.NONE;
    for (int team = 0; team < teams.size(); team++) {
      choices = choices.dropping(team);
    }
    return choices;
  }
}
