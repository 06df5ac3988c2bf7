package org.toqa.web.input;

import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.fleet.TemplateUse;

/**
 * The order of a task, and the template that it was made from.
 *
 * @param template null as {@code use}: it was ordered without one
 */
public record OrderedTask(
    TaskOrder order, @Nullable TaskTemplate template, @Nullable TemplateUse use) {

  static OrderedTask of(TaskOrder order) {
    return new OrderedTask(order, null, null);
  }

  /**
   * Where that field of the order was entered.
   *
   * @param prefix before the names of parameters
   */
  @Nullable String entered(@Nullable String field, String prefix) {
    return template == null || field == null
        ? field
        : OpenFields.parameterAt(template.parameters(), field)
            .map(Parameter::name)
            .map(prefix::concat)
            .orElse(TemplateFiller.TEMPLATE);
  }

  /** The same answer, whose no is filed where the field was entered. */
  public <T> Answer<T> atEntered(Answer<T> answer) {
    return answer instanceof Answer.Rejected<T>(var field, var sentence)
        ? new Answer.Rejected<>(entered(field, TemplateFiller.VALUES + "."), sentence)
        : answer;
  }
}
