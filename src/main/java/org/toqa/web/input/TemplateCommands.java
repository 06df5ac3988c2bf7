package org.toqa.web.input;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.fleet.TemplateUse;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** Adds, replaces and deletes templates of tasks for a caller. */
public final class TemplateCommands {
  private final Services services;
  private final Texts texts;
  private final Caller caller;

  public TemplateCommands(Services services, Texts texts, Caller caller) {
    this.services = services;
    this.texts = texts;
    this.caller = caller;
  }

  /** The template as it is stored; empty: a sentence says why it is not. */
  public Optional<TaskTemplate> add(TaskTemplate template, FieldErrors errors) {
    refuseSharing(template, errors);
    if (services.templates().templates().size() >= TaskTemplate.MOST) {
      errors.add("form", texts.get("error.template.many", TaskTemplate.MOST));
    }
    if (!errors.isEmpty()) {
      return Optional.empty();
    }
    Optional<TaskTemplate> added = services.templates().add(template);
    if (added.isEmpty()) {
      refuseName(template, errors);
    }
    return added;
  }

  /**
   * Makes a template another one, with the orders of the schedules that use it.
   *
   * @return as it is stored; empty: a sentence says why it is not
   */
  public Optional<TaskTemplate> replace(
      TaskTemplate seen, TaskTemplate changed, FieldErrors errors) {
    if (!seen.shared()) {
      refuseSharing(changed, errors);
    }
    TaskTemplate stored =
        new TaskTemplate(
            seen.id(),
            changed.name(),
            changed.floor(),
            changed.order(),
            changed.parameters(),
            changed.shared(),
            seen.user(),
            seen.owner(),
            changed.changedAt());
    Map<Long, TaskOrder> orders = errors.isEmpty() ? orders(stored, errors) : Map.of();
    if (!errors.isEmpty()) {
      return Optional.empty();
    }
    switch (services.templates().replace(seen, stored, orders, caller.name())) {
      case TaskTemplateStore.Change.DONE -> {
        return services.templates().template(seen.id());
      }
      case TaskTemplateStore.Change.NAME_TAKEN -> refuseName(changed, errors);
      case TaskTemplateStore.Change.OUTDATED -> errors.add("form", texts.get("error.changed"));
    }
    return Optional.empty();
  }

  /** What each schedule that uses the template orders from now on, by its id. */
  private Map<Long, TaskOrder> orders(TaskTemplate template, FieldErrors errors) {
    Map<Long, TaskOrder> orders = new HashMap<>();
    for (Schedule schedule : services.schedules().schedules()) {
      TemplateUse use = schedule.template();
      if (use != null && use.template() == template.id()) {
        FieldErrors ofSchedule = new FieldErrors();
        orders.put(
            schedule.id(),
            TemplateFiller.again(template, use, JsonFields.empty(texts, ofSchedule)).order());
        ofSchedule.sentences().values().stream()
            .limit(1)
            .forEach(
                sentence ->
                    errors.add(
                        "form", texts.get("error.template.schedule", schedule.id(), sentence)));
      }
    }
    return orders;
  }

  /** Deletes it; a sentence where it is used. */
  public Optional<String> delete(TaskTemplate template) {
    List<Long> schedules = services.templates().delete(template, caller.name());
    return schedules.isEmpty()
        ? Optional.empty()
        : Optional.of(
            texts.get(
                "error.template.used",
                template.name(),
                schedules.stream().map(String::valueOf).collect(Collectors.joining(", "))));
  }

  private void refuseSharing(TaskTemplate template, FieldErrors errors) {
    if (template.shared() && !TemplateAccess.canShare(caller)) {
      errors.add("shared", texts.get("error.template.shared"));
    }
  }

  private void refuseName(TaskTemplate template, FieldErrors errors) {
    errors.add("name", texts.get("error.template.name", template.name()));
  }
}
