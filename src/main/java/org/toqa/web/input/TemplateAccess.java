package org.toqa.web.input;

import java.util.List;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.web.access.Caller;

/** Who may see, use and change a template of tasks. */
public final class TemplateAccess {
  private TemplateAccess() {}

  /** Its owner, a manager, and everybody where it is shared. */
  public static boolean canSee(Caller caller, TaskTemplate template) {
    return template.shared() || caller.isManager() || caller.owns(template.owner());
  }

  /** Those that he may see. */
  public static List<TaskTemplate> seenBy(Caller caller, TaskTemplateStore store) {
    return store.templates().stream().filter(template -> canSee(caller, template)).toList();
  }

  /** What everybody uses a manager changes; what is his own its owner, too. */
  public static boolean canChange(Caller caller, TaskTemplate template) {
    return caller.mayManage()
        || (caller.mayOrder() && !template.shared() && caller.owns(template.owner()));
  }

  /** Whether he may make one that everybody uses. */
  public static boolean canShare(Caller caller) {
    return caller.mayManage();
  }
}
