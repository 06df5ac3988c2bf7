package org.toqa.web.input;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Handover;
import org.toqa.accounts.Power;
import org.toqa.accounts.Session;
import org.toqa.fleet.Answer;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskView;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/**
 * The end of a user, and what becomes of his open tasks, schedules and API tokens: of each kind of
 * which he has some a person must say it, for nobody else gets them by chance.
 */
public final class UserDeletion {
  private static final String HAND_OVER = "handOver";
  private static final int PAGE = 500;

  /** How often what is left is looked for, and how long between. */
  private static final int TRIES = 50;

  private static final Duration PAUSE = Duration.ofMillis(50);

  private final Services services;
  private final Texts texts;
  private final FieldErrors errors;
  private final Account user;

  public UserDeletion(Services services, Texts texts, FieldErrors errors, Account user) {
    this.services = services;
    this.texts = texts;
    this.errors = errors;
    this.user = user;
  }

  /** How much of each kind the user has. */
  public record Belongings(int tasks, int schedules, int tokens) {}

  /**
   * What a person chose; null: he did not.
   *
   * @param tasks {@code handOver} or {@code cancel}
   * @param load where loads on board of cancelled tasks are set down, {@code here} or {@code back}
   * @param schedules {@code handOver} or {@code remove}
   * @param tokens {@code handOver} or {@code remove}
   * @param to who gets what is handed over, the id of a user
   */
  public record Choices(
      @Nullable String tasks,
      @Nullable String load,
      @Nullable String schedules,
      @Nullable String tokens,
      @Nullable String to) {}

  public Belongings belongings() {
    return new Belongings(openTasks().size(), scheduleCount(), tokenCount());
  }

  private int scheduleCount() {
    return (int)
        services.schedules().schedules().stream()
            .filter(schedule -> Long.valueOf(user.id()).equals(schedule.owner()))
            .count();
  }

  private int tokenCount() {
    return (int)
        services.sessions().sessions(user.id()).stream()
            .filter(session -> session.kind() == Session.Kind.TOKEN)
            .count();
  }

  private List<TaskView> openTasks() {
    Set<TaskState> open =
        EnumSet.allOf(TaskState.class).stream()
            .filter(state -> !state.isEnded())
            .collect(Collectors.toSet());
    Filter filter = new Filter(open, null, user.name(), null, null, null, null);
    List<TaskView> found = new ArrayList<>();
    List<TaskView> page;
    int offset = 0;
    do {
      page = services.archive().tasks(filter, Sort.NEWEST_FIRST, offset, PAGE);
      page.stream()
          .filter(task -> Long.valueOf(user.id()).equals(task.task().owner()))
          .forEach(found::add);
      offset += PAGE;
    } while (page.size() == PAGE);
    return found;
  }

  /**
   * Hands over or ends what the user has, and deletes him.
   *
   * <ol>
   *   <li>What is chosen must fit what he has; else nothing is done but errors filed.
   *   <li>He is disabled. From then on nothing new of his is stored, also of what was under way,
   *       and he is as if not logged in.
   *   <li>What he has by then is looked at again: the choices must fit what came last too.
   *   <li>His tasks are handed over or cancelled.
   *   <li>One transaction hands his schedules and tokens over, or removes them, and deletes him; it
   *       refuses while a task is left that is neither, and the last three are done again for a
   *       while.
   * </ol>
   *
   * What a crash cuts off after the second step leaves a user who may not log in and still has what
   * is not done yet: he is deleted again, to the same end.
   */
  public void run(Caller caller, Choices choices) {
    chosen(caller, choices);
    if (isLastManager()) {
      errors.add("form", texts.get("error.lastManager"));
    }
    if (!errors.isEmpty()) {
      return;
    }
    AccountStore.ChangeResult disabled =
        services.accounts().update(user.id(), user.role(), true, user, caller.name());
    UserCommands.refusal(disabled, texts).ifPresent(sentence -> errors.add("form", sentence));
    if (errors.isEmpty()) {
      UserCommands.refusal(deleteDisabled(caller, choices), texts)
          .ifPresent(sentence -> errors.add("form", sentence));
    }
  }

  /** {@code DONE} also where errors are filed. */
  private AccountStore.ChangeResult deleteDisabled(Caller caller, Choices choices) {
    AccountStore.ChangeResult result = AccountStore.ChangeResult.OPEN_TASKS;
    for (int tries = 0; tries < TRIES && result == AccountStore.ChangeResult.OPEN_TASKS; tries++) {
      if (tries > 0) {
        awaitQueue();
      }
      Chosen chosen = chosen(caller, choices);
      if (!errors.isEmpty()) {
        return AccountStore.ChangeResult.DONE;
      }
      command(
          chosen.tasks(),
          chosen.giveTasks() && chosen.heir() != null
              ? new MissionEvent.HandOver(caller.name(), chosen.heir().name(), chosen.heir().id())
              : new MissionEvent.Cancel(caller.name(), chosen.load()));
      result =
          services
              .accounts()
              .delete(
                  user.id(),
                  new Handover(
                      chosen.giveSchedules() ? chosen.heir() : null,
                      chosen.giveTokens() ? chosen.heir() : null),
                  caller.name());
    }
    return result;
  }

  /** A task that was just stored is in its floor's queue a moment later. */
  private static void awaitQueue() {
    try {
      Thread.sleep(PAUSE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** What becomes of what the user has now. */
  private record Chosen(
      List<TaskView> tasks,
      boolean giveTasks,
      boolean giveSchedules,
      boolean giveTokens,
      @Nullable Account heir,
      @Nullable LoadChoice load) {}

  /** Files an error where a choice is missing or wrong, or a supervisor orders more of his. */
  private Chosen chosen(Caller caller, Choices choices) {
    List<String> supervised = services.supervisor().floorsOf(user.name());
    if (!supervised.isEmpty()) {
      errors.add("form", texts.get("error.delete.supervisor", String.join(", ", supervised)));
    }
    List<TaskView> tasks = openTasks();
    boolean giveTasks = isHandedOver("tasks", choices.tasks(), "cancel", tasks.size());
    boolean giveSchedules =
        isHandedOver("schedules", choices.schedules(), "remove", scheduleCount());
    boolean giveTokens = isHandedOver("tokens", choices.tokens(), "remove", tokenCount());
    Account heir = giveTasks || giveSchedules || giveTokens ? heir(choices.to()) : null;
    LoadChoice load =
        new TaskCommandReader(texts, errors).readCancel(caller, choices.load()).choice();
    if (!giveTasks
        && load == null
        && tasks.stream().anyMatch(task -> task.state() == TaskState.CARRYING)) {
      errors.add("load", texts.get("error.cancel.load"));
    }
    return new Chosen(tasks, giveTasks, giveSchedules, giveTokens, heir, load);
  }

  /**
   * Those that have ended meanwhile, or are delivered, need nothing any more; others are found
   * again.
   */
  private void command(List<TaskView> tasks, MissionEvent.OperatorCommand command) {
    List<CompletionStage<Answer<TaskView>>> answers =
        tasks.stream().map(task -> services.fleet().commandTask(task.id(), command)).toList();
    answers.forEach(FleetAnswers::await);
  }

  private boolean isHandedOver(String field, @Nullable String choice, String other, int count) {
    if (choice == null && count > 0) {
      errors.add(field, texts.get("error.delete." + field, count));
    } else if (choice != null && !choice.equals(HAND_OVER) && !choice.equals(other)) {
      errors.add(field, texts.get("error.delete.choice", HAND_OVER, other));
    }
    return HAND_OVER.equals(choice) && count > 0;
  }

  private @Nullable Account heir(@Nullable String id) {
    Optional<Account> heir =
        Optional.ofNullable(id)
            .filter(given -> given.matches("[1-9][0-9]{0,17}"))
            .flatMap(given -> services.accounts().account(Long.parseLong(given)))
            .filter(this::mayInherit);
    if (heir.isEmpty()) {
      errors.add("to", texts.get("error.delete.to"));
    }
    return heir.orElse(null);
  }

  /** Whether he can look after what the user had ordered. */
  public boolean mayInherit(Account account) {
    return account.id() != user.id() && !account.disabled() && account.role().has(Power.ORDER);
  }

  private boolean isLastManager() {
    return services.accounts().accounts().stream()
        .filter(account -> account.isManager() && !account.disabled())
        .allMatch(account -> account.id() == user.id());
  }
}
